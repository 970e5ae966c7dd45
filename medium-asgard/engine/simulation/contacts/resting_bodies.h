// Which bodies rest or slide now, on what, until when, and by which equations?
//
// A body comes to rest where an impact leaves a contact that does not part, or where it is pressed
// onto what it touches (collision_source.h sees both). From then on its equations have the contacts
// as constraints. Along the motion the question of rest.h is asked again: at the ends of the
// solver's steps, and wherever the forces have changed by more than a little since it was asked
// last; between an answer that agrees and one that does not, the instant is found by bisection.
//
// Where forces are constant and nothing moves below the body, looks are rarer. One is just before a
// piece of what drives the support ends, where the push may jump.
//
// LIMIT: forces are looked at every half millisecond, from 2 s on 2048 times while the time
// doubles: a force that lifts a body for less than that and puts it down again between two looks is
// passed over.
#pragma once

#include "collision/contact.h"
#include "contacts/colliders.h"
#include "contacts/contact_set.h"
#include "contacts/rest.h"
#include "expression/tape.h"
#include "solution/event_source.h"

#include <algorithm>
#include <map>
#include <span>

namespace simulation {

// Who may come near a body, and for how long that is known.
class Neighbours {
public:
    virtual ~Neighbours() = default;
    // Bodies that this one may meet during its window, in order, but for those that ended; none for
    // fixed bodies, whom the others list.
    [[nodiscard]] virtual std::vector<std::size_t> partners(std::size_t body) const = 0;
    // The motion from the front on that was looked at.
    [[nodiscard]] virtual double windowEnd(std::size_t body) const = 0;
};

class RestingBodies {
public:
    // The colliders must outlive this.
    RestingBodies(const Colliders& world, double finish);
    // The motion is wanted for longer than before.
    void lengthen(double finish) { finish_ = finish; }

    [[nodiscard]] bool isAnyResting() const { return !resting_.empty() || !contacts_.empty(); }
    [[nodiscard]] bool isResting(std::size_t body) const {
        return resting_.contains(body) || contacts_.isIn(body);
    }
    [[nodiscard]] const ContactSet& contacts() const { return contacts_; }
    [[nodiscard]] ContactSet& contacts() { return contacts_; }
    // The supports of each body that rests now, each support once.
    [[nodiscard]] std::map<std::size_t, std::vector<std::size_t>> supports() const;
    // These parts are in touch for as long as the body rests.
    [[nodiscard]] bool isFooting(std::size_t a, std::size_t partA, std::size_t b,
                                 std::size_t partB) const;
    [[nodiscard]] bool hasFooting(std::size_t a, std::size_t b) const;
    // A resting body lies on its footing to the limits' gap, and no better: of all that it meets.
    // A body that gives way to nothing, as a floor, stands exactly where it is, whoever lies on it.
    [[nodiscard]] collision::Slack slack(std::size_t a, std::size_t b, double time) const {
        const auto of = [&](std::size_t body) {
            return isResting(body) && canGiveWay(body, time) ? world_.resolution[body].gap : 0;
        };
        return std::max(of(a), of(b));
    }

    using States = std::map<std::size_t, BodyState>; // of bodies that an impact just changed
    [[nodiscard]] Rest restAt(const solution::Histories& histories, std::size_t body, double time,
                              std::span<const std::size_t> partners,
                              const States& changed = {}) const;
    [[nodiscard]] Placed placed(const solution::Histories& histories, std::size_t body, double time,
                                const States& changed = {}) const;
    [[nodiscard]] physics::ImpactBody impactBody(std::size_t body, double time,
                                                 const BodyState& state) const;
    // The state of a body; where it bears, without what the integration errs there.
    [[nodiscard]] BodyState bearingState(const solution::Histories& histories, std::size_t body,
                                         double time) const;
    // Blows can change how the body moves: along an axis along which nothing holds it, or by
    // turning it. A ball that is held in place turns by no blow, since all go through its centre.
    [[nodiscard]] bool canGiveWay(std::size_t body, double time) const;
    // The coordinates of a body that impacts and contacts do not change. A hold to the finish holds
    // there, too.
    [[nodiscard]] physics::Held heldOf(std::size_t body, double time) const;
    // Nothing holds its attitude.
    [[nodiscard]] bool turnsFreely(std::size_t body, double time) const {
        return !world_.equations.bodies[body].heldAt(time).attitude;
    }
    // Nothing holds its place: it gives way along all axes.
    [[nodiscard]] bool isFree(std::size_t body, double time) const;
    // When a trajectory next takes hold of the body, bends or lets go, after `time`, infinity:
    // never; and when one last did, the start if none has.
    [[nodiscard]] double nextPhase(std::size_t body, double time) const;
    [[nodiscard]] double lastPhase(std::size_t body, double time) const;
    // Two free elastic balls never come to rest on each other (side_by_side.h).
    [[nodiscard]] bool hopForEver(std::size_t a, std::size_t b, double time) const;

    // From `time` on the body rests like this, or is free.
    void set(std::size_t body, double time, const Rest& rest);
    void forget(std::size_t body) { resting_.erase(body); }
    [[nodiscard]] bool restsAlone(std::size_t body) const { return resting_.contains(body); }
    // Looks along the motion of all that rest; the first instant, not after `until`, at which an
    // answer changes. Each is looked at to the end of its own window, or as far as is known.
    struct Change {
        double time = 0;
        std::size_t body = 0;
    };
    [[nodiscard]] std::optional<Change> firstChange(const solution::Histories& histories,
                                                    double until, double known,
                                                    const Neighbours& neighbours);
    // An event cut the motion of these bodies: looks beyond it no longer hold.
    void lookAgain(std::span<const std::size_t> bodies, double time);

    // Equations and velocities of a body from `time` on, as set() said.
    void write(const solution::Histories& histories, std::size_t body, double time,
               const BodyState& state, const Rest& rest, expression::EquationSet& equations,
               solution::Changes& changes) const;

private:
    struct Watch {
        Rest rest;
        double from = 0, seenUntil = 0;
        double ends = 0; // a trajectory takes hold, lets go or bends: all is asked anew
        std::optional<double> change;
    };
    [[nodiscard]] bool isCarried(const Watch& watch) const; // by what moves
    [[nodiscard]] Acceleration freeAcceleration(const solution::Histories& histories,
                                                std::size_t body, double time,
                                                const BodyState& state) const;
    [[nodiscard]] bool agrees(const solution::Histories& histories, std::size_t body, double time,
                              std::span<const std::size_t> partners, const Watch& watch) const;
    void look(const solution::Histories& histories, std::size_t body, double until,
              std::span<const std::size_t> partners, Watch& watch) const;
    [[nodiscard]] std::vector<double> timesOf(const solution::Histories& histories,
                                              std::size_t body, double from, double until) const;
    [[nodiscard]] bool turns(std::size_t body, double time, const BodyState& state,
                             const Acceleration& acceleration) const;

    struct Free { // acceleration without contacts, as numbers
        expression::Tape tape;
        std::vector<std::size_t> reads; // unknowns; then time
        bool isConstant = false;
    };

    const Colliders& world_;
    double finish_;
    std::vector<std::string> names_;
    std::map<std::size_t, Watch> resting_;
    ContactSet contacts_{world_};
    mutable std::map<std::size_t, Free> free_;
};

} // namespace simulation
