// Where must the next step of a component end at the latest?
//
// At the end of the phases in force, at the next event of an input, at the end of an input that
// stopped, or eight steps of an input ahead, whichever comes first: dense output is only as smooth
// as its joints allow, and upstream components need not be solved far beyond what anyone asked for.
#pragma once

#include "dense/histories.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class Boundary {
public:
    // The phases in force began at `from`, and end at `until`.
    void setPhases(double from, double until);
    [[nodiscard]] double phasesFrom() const { return phasesFrom_; }
    [[nodiscard]] double phasesUntil() const { return phasesUntil_; }

    struct Wish {
        double time;     // of the component
        double until;    // where its next step would end; infinite: not known
        bool isOnePiece; // it looks at one piece of each input only
    };
    // The boundary of the next step, from what is known of the inputs. An unknown: it must be known
    // for longer before that.
    [[nodiscard]] std::optional<std::size_t>
    find(const Histories& histories, std::span<const std::size_t> inputs, const Wish& wish);
    [[nodiscard]] double limit() const { return limit_; }
    [[nodiscard]] bool restarts() const { return restarts_; } // an input, at the limit
    [[nodiscard]] std::optional<std::size_t> ends() const { return ends_; } // that input's motion

private:
    // `near`: the input's step that holds the time, where it is looked for first.
    [[nodiscard]] std::optional<std::size_t> look(const Histories& histories, std::size_t unknown,
                                                  const Wish& wish, std::size_t& near);
    void mayEndAt(double t, bool restarts);

    double phasesFrom_ = 0, phasesUntil_ = infinity;
    double limit_ = infinity;
    bool restarts_ = false;
    std::optional<std::size_t> ends_;
    std::vector<std::size_t> lookedAt_; // of each input, the step that the last one began in
};

} // namespace solution
