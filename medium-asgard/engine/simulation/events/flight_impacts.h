// Impacts of balls in flight that touch nothing else, in closed form; on the spot, where the solver
// agrees and nobody reads them.
#pragma once

#include "events/body_readers.h"
#include "events/collision_record.h"
#include "events/flight_view.h"
#include "events/instant.h"
#include "events/meeting_counts.h"
#include "events/outcome.h"

#include <optional>

namespace simulation {

class FlightImpacts {
public:
    // All must outlive this.
    FlightImpacts(const Colliders& world, EncounterSearch& search, const BodyReaders& readers,
                  CollisionRecord& record)
        : view_{world, search}, search_(search), readers_(readers), record_(record) {}

    void use(solution::Turns& turns) { turns_ = &turns; }

    struct Hit {
        // None: both were turned on the spot, and the search must go on after them (goOn()).
        std::optional<solution::Event> event;
    };
    // Two balls, or a ball and a face, that touch nothing else. None: they are something else.
    [[nodiscard]] std::optional<Hit> meet(const Instant& instant, const Pair& pair,
                                          Outcome& outcome);

private:
    [[nodiscard]] bool touchesMore(const Instant& instant, const Present& one, const Present& met);
    void readVelocity(const Instant& instant, Present& present) const;
    void record(const Pair& pair, const collision::FlightContact& contact, double impulse,
                double time);
    [[nodiscard]] bool turn(const Pair& pair, double time, const std::array<Vector, 2>& before,
                            const std::array<Vector, 2>& after);
    void announce(const Pair& pair, const std::array<Vector, 2>& before,
                  const std::array<Vector, 2>& after, solution::Event& event, Outcome& outcome);

    FlightView view_;
    EncounterSearch& search_;
    const BodyReaders& readers_;
    CollisionRecord& record_;
    solution::Turns* turns_ = nullptr;
};

} // namespace simulation
