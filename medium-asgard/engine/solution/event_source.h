// Events that no equation announces, such as collisions: a source is shown what is known so far and
// answers with the earliest instant at which something happens.
//
// Protocol, one thread:
//
//     known advances                       all unknowns that did not stop are known up to `known`
//     next(histories, known) -> none       nothing happens up to `known`: the source need never
//                                          look at that interval again
//     next(histories, known) -> event      event.time in [time of the last event, known]: what it
//                                          touches, and what reads that, is cut at its time, and
//                                          apply() is asked
//     apply(histories, event, changes)     states just before the event are still there
//                                          (pieceBefore, and piece too); write jumps and equations
//                                          into `changes`
//     next(histories, known)               again, with known = event.time or later: there may be
//                                          another event at the same instant
//
// Events are handled in order of time, so none is ever undone by a later discovery; unknowns that
// an event does not touch, and that read nothing it touches, keep every step they made.
#pragma once

#include "dense/histories.h"
#include "equations/equations_in_force.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace solution {

struct Event {
    double time = 0;
    std::vector<std::size_t>
        touched;           // unknowns that restart here, whether or not their values jump
    std::uint64_t tag = 0; // the source's own
};

struct Changes {
    struct Jump {
        std::size_t unknown;
        double value;
    };
    struct Equation {
        std::size_t unknown;
        expression::Phase phase; // in force from the event on, in place of all later phases,
                                 // which `later` may list again
        std::vector<expression::Phase> later;
    };
    // Ends the motion of these unknowns (and of all in their components) at the event.
    struct End {
        std::vector<std::size_t> unknowns;
        std::string sentence;
    };
    // An unknown more, which stands behind all others from the event on: a multiplier, as a rule.
    // Before the event its value is 0. One of `equations` gives it its phase.
    struct Addition {
        expression::Unknown unknown;
        std::size_t like; // an unknown of the same body
    };
    struct Reading {
        std::size_t reading; // of the set's
        expression::Node node;
    };
    std::vector<Addition> additions;
    std::vector<Reading> readings; // what they are from the event on
    std::vector<Jump> jumps;       // of differential unknowns; others are ignored
    std::vector<Equation> equations;
    std::vector<End> ends;
};

// A body in flight: the rates of its places are the velocities, the rates of these are constants,
// and nothing else reads them. An event of it needs new values only, so a source may settle it at
// once within next() and go on to the next event.
struct Turn {
    std::array<std::size_t, 3> places, velocities; // unknowns
    std::array<bool, 3> jumps;                     // these velocities become others
    std::array<double, 3> place, velocity;         // as the source has them; then as they became
};

// What a source may ask of the solver within next().
class Turns {
public:
    virtual ~Turns() = default;
    // An event of these unknowns is to be at `time`. Nothing: their values there are on the
    // conditions of their multipliers, no shorter step would bring them nearer, or another event
    // has just been. Else their steps, and those of all that read them, now end at the time of the
    // answer, from where the source must look again. That is a hundredth of the step before `time`.
    // `isBefore`: with the values of an earlier time the event is yet to come. Where the conditions
    // have moved the values beyond the event, steps end earlier still. It is asked during the call
    // alone. LIMIT: no earlier than two thirds of the step; there the event may have passed.
    using Values = std::function<double(std::size_t unknown)>;
    using IsBefore = std::function<bool(double at, const Values& values)>;
    [[nodiscard]] virtual std::optional<double>
    approach(double time, std::span<const std::size_t> unknowns, const IsBefore& isBefore) = 0;
    // At `time`, which is that of an event. True: it is done, and the values are what they became.
    // False: the source must announce the event, as if it had not asked.
    [[nodiscard]] virtual bool turn(double time, std::span<Turn> turns) = 0;
};

class EventSource {
public:
    virtual ~EventSource() = default;
    // The object that takes turns during next(), from now on.
    virtual void use(Turns& /*turns*/) {}
    [[nodiscard]] virtual std::optional<Event> next(const Histories& histories, double known) = 0;
    // New nodes go into the graph of `equations`; the equations in force now are read there too.
    virtual void apply(const Histories& histories, const Event& event, EquationsInForce& equations,
                       Changes& changes) = 0;
    // The bytes that it keeps of events before t, for readers of the motion.
    [[nodiscard]] virtual std::size_t bytesBefore(double /*t*/) const { return 0; }
};

} // namespace solution
