// What happened so far: impacts, notes, hops that were left out, times of events.
//
// Whoever reads it names a time up to which it is wanted, since the search may be further.
#pragma once

#include "collision/broad_phase.h"
#include "motion/impacts.h"
#include "motion/lost_hops.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace simulation {

class CollisionRecord {
public:
    using Pair = collision::Pair;

    void addImpact(const Impact& impact, double found) { impacts_.add(impact, found); }
    void addLostHop(const LostHop& hop) { lostHops_.add(hop); }
    // One event at least happened then. In order of time.
    void addEvent(double time);
    // Once for each pair; a body alone is a pair with itself.
    void addNote(const Pair& pair, double time, const std::string& sentence);
    // At the start; once for each pair.
    void addOverlap(const Pair& pair, double depth);
    // One of them met the other where its motion had ended.
    void addBlocked(const Pair& pair, double time) { blocked_.push_back({pair, time}); }

    [[nodiscard]] bool haveMet(const Pair& pair, double since) const {
        return impacts_.haveMet(pair, since);
    }
    [[nodiscard]] bool hasEventAt(double time) const;
    [[nodiscard]] Impacts impacts(double until) const { return impacts_.upTo(until); }
    [[nodiscard]] std::vector<LostHop> lostHops(double until) const {
        return lostHops_.upTo(until);
    }
    [[nodiscard]] std::vector<std::string> notes(double until) const;
    // Those at the start, with their depths.
    [[nodiscard]] const std::map<Pair, double>& overlaps() const { return overlaps_; }
    [[nodiscard]] std::vector<Pair> blocked(double until) const;
    [[nodiscard]] std::size_t bytesBefore(double t) const { return impacts_.bytesBefore(t); }

private:
    struct Note {
        double time = 0;
        std::string sentence;
    };
    struct Blocked {
        Pair pair;
        double time = 0;
    };
    ImpactRecord impacts_;
    LostHops lostHops_;
    std::set<Pair> noted_;
    std::vector<Note> notes_;
    std::map<Pair, double> overlaps_;
    std::vector<Blocked> blocked_;
    std::vector<double> events_; // times
};

} // namespace simulation
