// A set of first-order differential equations: physics makes one, solution consumes it.
//
// Each unknown is known by its symbol in the graph. Over its phases an unknown is differential (its
// derivative is an expression of unknowns and time), given (its value is an expression of time and
// of other unknowns; a trajectory holds it), or a multiplier (its value is the one that keeps a
// condition; a joint's force). Phases follow each other without gaps from the start of time; at the
// start of a phase the value may jump.
#pragma once

#include "expression/graph.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace expression {

// The condition that a multiplier keeps, in its three forms along the equations in force:
//
//     gap(q, t) = 0      rate(q, v, t) = 0      and, as the phase's derivative, their second rate,
//
// which is linear in the multipliers. The multipliers are those for which all second rates are 0.
// States are moved back onto gap and rate by what the multipliers act on, in proportion to it.
//
// A multiplier may have bounds; at a bound its condition does not hold. With a gap it is a stop:
// gap >= 0, multiplier >= 0, one of both 0; a gap that closes is a blow with that restitution. Of
// velocities alone it is a brake or a motor: the force is `low` while the rate is positive, and
// `high` while it is negative. Without gap and rate the derivative is the multiplier less a value:
// a force that may be released.
//
// A contact is a stop that a source of events has made and ends: a gap that closes, one that opens
// beyond `leaving`, and a place at which a function of `valid` falls below 0 are events. Friction
// is a condition of velocities without bounds of its own: the forces of one disc (`rows`, this one
// among them) are together at most a coefficient times the sum of some multipliers, `normals`, at
// the centre of these (complementarity/laws.h).
struct Friction {
    std::vector<Node> rows, normals; // symbols of multipliers
    double sticking = 0, sliding = 0;
    // Of each normal: the rates at its point of the rows but the last, where that one's is 1. None:
    // all act at one point.
    std::vector<std::vector<Node>> levers = {};
};

// The second rate of a condition in parts, where many conditions read the same states:
//
//     second rate = steady + sum of by * (the rate of its state)
//
// and its multiplier adds push * multiplier to the rates of states. All that multipliers add to
// rates are such pushes.
struct ConditionParts {
    struct Factor {
        Node state, factor;
    };
    Node owner; // a symbol: conditions with the same one are of one thing, as of a contact
    Node steady;
    std::vector<Factor> by, pushes;
};

// The initial value of a multiplier whose condition is gone from the start on.
inline constexpr double goneFromStart = 4;

struct Condition {
    std::optional<Node> gap; // none: the condition is one of velocities
    // None: the multiplier is in the gap's rate, which is the derivative. With a gap, a tie: it is
    // kept between steps alone, and within them the multiplier is 0.
    std::optional<Node> rate;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double restitution = 0; // of a stop
    double resolution = 0;  // of a stop: gaps and hops lower than that are none
    // Symbol of a given unknown: from its first value that is not 0 on the condition is gone.
    std::optional<Node> release = {};
    std::optional<double> leaving = {}; // of a contact
    double hop = 0;                     // of a contact: hops lower than that are left out
    // Of a contact: the first of the multipliers of its points. More than three points of one patch
    // are redundant, but for a tilt that the conditions keep from growing.
    std::optional<Node> patch = {};
    std::vector<Node> valid = {}; // of a contact
    std::optional<Friction> friction = {};
    std::optional<ConditionParts> parts = {}; // of a contact
    // A value that is 0 where the other rows of its friction bring nothing to it: they do where
    // normal forces press aside.
    std::optional<Node> brought = {};
};

struct Phase {
    double from = -std::numeric_limits<double>::infinity(); // the phase begins at this time
    Node derivative;                                        // d unknown / dt; of a multiplier above
    std::optional<Node> given; // the value itself, when it is held; derivative is then d given / dt
    // A new value at `from` of a differential phase (release, reset), computed with the values of
    // all unknowns just before. Without one the unknown goes on from its own last value.
    std::optional<Node> jump;
    std::optional<Condition> condition; // of a multiplier
};

struct Unknown {
    std::string name; // "rod1.x", "rod1.dx", "rod1.qw", ...
    Node symbol;
    double initial = 0;
    std::vector<Phase> phases; // ordered by `from`; not empty
    // How far a unit of this unknown moves a point of its body: 1 for a position, twice the
    // body's radius for an entry of an attitude's quaternion. 0: not a position (velocities);
    // controlled relative to its own size.
    double lengthPerUnit = 0;
    // Index of the unknown that this one is the derivative of in every phase (v of x), if any.
    std::optional<std::size_t> integralOf;
};

// A value that follows from the unknowns and that no equation reads, as the force of a contact: it
// is read of the motion. Events make it another one.
struct Reading {
    struct Value {
        double from = -std::numeric_limits<double>::infinity();
        Node node; // of unknowns and the time
    };
    Node symbol;
    std::vector<Value> values; // ordered by `from`; not empty

    [[nodiscard]] const Value& valueAt(double time) const {
        std::size_t i = values.size() - 1;
        while (i > 0 && values[i].from > time)
            --i;
        return values[i];
    }
};

struct EquationSet {
    Graph graph;
    Node time; // the symbol "t"
    std::vector<Unknown> unknowns;
    // Groups of four unknowns that form a unit quaternion, renormalised after each step.
    std::vector<std::array<std::size_t, 4>> quaternions;
    std::vector<Reading> readings;
};

} // namespace expression
