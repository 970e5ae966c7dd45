// When do bodies meet, and what happens then? Collisions as the solver's source of events.
//
// The front is the time up to which every pair has been looked at. From it, windows no longer than
// a body takes to cross its own size are searched as the motion becomes known:
//
//     next(known):
//         while front < known:
//             window = [front, min(known, front + window length)]
//             pairs whose boxes overlap in the window  ->  time of impact of each, kept per pair
//             the earliest hit in the window: move the front there;
//                 gather all that touches at that instant, solve the impact
//                 some impulse: that is the event; else go on
//             what a body rests on changes before that: an event of its own (resting_bodies.h)
//             neither: front = end of the window
//
// The windows say which pairs are looked at, and no more. A pair is searched in cells that follow
// from the motion of its two bodies alone, so that what a body does far away moves no bit of a hit
// here: that is what lets an edit keep what it does not concern (resimulation.h).
//
// Pairs keep what was found beyond an event that does not concern them (dissertation 5.2.3).
// Bouncing under restitution < 1 whose next hop is lower than RestLimits::hopHeight ends in a
// plastic impact, and then the body rests; so does one that is pressed onto what it touches. Where
// meeting has no end in finite time (a ball between walls that close in), the motion ends with a
// sentence after a thousand meetings within 1e-5 of the motion's length.
// encounters.cpp has what happens, collision_source.cpp when.
#pragma once

#include "collision/broad_phase.h"
#include "collision/time_of_impact.h"
#include "physics/equations_of_motion.h"
#include "physics/impact.h"
#include "simulation/resting_bodies.h"
#include "solution/event_source.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace simulation {

class CollisionSource final : public solution::EventSource {
public:
    // `equations` must outlive the source. A refusal (a shape that is none) is told by the caller's
    // own reading of the scene: shapes are valid here.
    CollisionSource(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                    std::vector<geometry::Shape> shapes, double start, double finish,
                    const RestLimits& limits);
    ~CollisionSource() override;

    [[nodiscard]] std::optional<solution::Event> next(const solution::Histories& histories,
                                                      double known) override;
    void apply(const solution::Histories& histories, const solution::Event& event,
               solution::EquationsInForce& equations, solution::Changes& changes) override;

    [[nodiscard]] const std::vector<Impact>& impacts() const { return impacts_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    [[nodiscard]] std::size_t pairTests() const { return pairTests_; }
    // Pairs of bodies, the lesser first, that came near each other.
    [[nodiscard]] std::set<collision::Pair> candidates() const {
        std::set<collision::Pair> pairs;
        for (const auto& [pair, found] : found_)
            pairs.insert(pair);
        return pairs;
    }

private:
    using Pair = collision::Pair;
    struct Found { // of one pair
        double testedUntil = 0;
        double since = -solution::infinity;           // the last hit that changed nothing
        std::pair<std::size_t, std::size_t> versions; // of the two motions that were tested
        std::optional<collision::Hit> hit;
    };
    struct Cluster { // all that touches at one instant, through bodies that can give way
        std::vector<std::size_t> bodies;              // indices into the scene's
        std::vector<physics::ImpactContact> contacts; // with indices into `bodies`
        std::vector<physics::ImpactContact> corners;  // of the patches
    };
    struct Outcome { // of the event that next() answered last
        struct Resting {
            std::size_t body;
            BodyState state;
            Rest rest;
        };
        std::vector<solution::Changes::Jump> jumps;
        std::vector<solution::Changes::End> ends;
        std::vector<Resting> rests;
    };
    struct Meetings { // of one body, to see that they have no end
        std::size_t count = 0, atOnce = 0;
        double last = -solution::infinity, markedAt = -solution::infinity;
    };

    [[nodiscard]] bool mayMeet(std::size_t a, std::size_t b) const;
    [[nodiscard]] std::optional<solution::Event> announced(solution::Event event);
    void forgetAfterEvent(const solution::Event& event);
    void findDependents();
    void lookAtWindow(const solution::Histories& histories, double until);
    void updateCandidates(double until);
    void testPair(const Pair& pair, double until);
    [[nodiscard]] bool testCell(const Pair& pair, Found& found, collision::Interval cell);
    [[nodiscard]] collision::Interval cellAt(const Pair& pair, double since, double t) const;
    [[nodiscard]] double slackOf(std::size_t body) const;
    void keepHit(const Pair& pair, Found& found, std::optional<collision::Hit> hit);
    void dropHit(const Pair& pair);
    [[nodiscard]] std::optional<solution::Event>
    handle(const solution::Histories& histories, const Pair& pair, const collision::Hit& hit);
    [[nodiscard]] std::optional<solution::Event> meet(const solution::Histories& histories,
                                                      const Pair& pair, double time);
    [[nodiscard]] std::optional<solution::Event> press(const solution::Histories& histories,
                                                       const Pair& pair, double time);
    [[nodiscard]] solution::Event stir(const solution::Histories& histories, std::size_t body,
                                       double time);
    void settle(const solution::Histories& histories, std::size_t body, double time,
                const RestingBodies::States& states, solution::Event& event);
    [[nodiscard]] std::string leaning(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool isWithoutEnd(std::size_t body, double time);
    [[nodiscard]] solution::Event end(const Pair& pair, double time, const std::string& sentence);
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const Pair& pair, double time) const;
    [[nodiscard]] Cluster clusterAt(const solution::Histories& histories, const Pair& pair,
                                    double time);
    void addContacts(const solution::Histories& histories, Cluster& cluster, std::size_t a,
                     std::size_t b, double time);
    // The longest time in which the hops that were cut off would have ended; negative: none was.
    [[nodiscard]] double softenLastHops(const solution::Histories& histories, Cluster& cluster,
                                        std::span<const physics::ImpactBody> bodies,
                                        double time) const;
    void resolveCorners(const Cluster& cluster, physics::ImpactResult& result) const;
    [[nodiscard]] physics::ImpactBody impactBody(const solution::Histories& histories,
                                                 std::size_t body, double time) const;
    void record(const Cluster& cluster, const physics::ImpactResult& result, double time,
                double settling);
    void noteOnce(const Pair& pair, const std::string& sentence);
    [[nodiscard]] double windowLength(const solution::Histories& histories) const;

    const scene::Scene& scene_;
    const physics::EquationsOfMotion& equations_;
    std::vector<BodyRecord> records_;
    std::vector<MovingBody> bodies_;
    std::vector<bool> ended_;
    double start_, finish_;
    RestLimits limits_;

    double front_;
    std::vector<double> boxUntil_; // boxes_[b] holds the motion from the front up to here
    std::vector<geometry::Box> boxes_;
    std::vector<std::set<std::size_t>> partners_; // whose boxes overlap
    std::map<Pair, Found> found_;
    std::set<std::tuple<double, std::size_t, std::size_t>> hits_; // of found_
    std::map<Pair, double> passingUntil_; // pairs that cannot give way, let through each other
    std::set<Pair> linked_;
    std::set<Pair> noted_;
    std::vector<std::set<std::size_t>> dependents_; // bodies that read a body, also through others
    std::vector<std::size_t> bodyOf_;               // by unknown
    std::vector<std::size_t> version_; // of each body's motion: one more after each cut
    std::vector<double> cutAt_;        // the last one

    RestingBodies resting_;
    std::map<std::size_t, Meetings> meetings_;
    Outcome outcome_;
    std::vector<Impact> impacts_;
    std::vector<std::string> notes_;
    std::size_t pairTests_ = 0;
};

} // namespace simulation
