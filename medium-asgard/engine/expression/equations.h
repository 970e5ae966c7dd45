// A set of first-order differential equations: physics makes one, solution consumes it.
//
// Each unknown is known by its symbol in the graph. Over its phases an unknown is either
// differential (its derivative is an expression of unknowns and time) or given (its value is an
// expression of time and of other unknowns; a trajectory holds it). Phases follow each other
// without gaps from the start of time; at the start of a phase the value may jump.
#pragma once

#include "expression/graph.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace expression {

struct Phase {
    double from = -std::numeric_limits<double>::infinity(); // the phase begins at this time
    Node derivative;                                        // d unknown / dt
    std::optional<Node> given; // the value itself, when it is held; derivative is then d given / dt
    // A new value at `from` of a differential phase (release, reset), computed with the values of
    // all unknowns just before. Without one the unknown goes on from its own last value.
    std::optional<Node> jump;
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

struct EquationSet {
    Graph graph;
    Node time; // the symbol "t"
    std::vector<Unknown> unknowns;
    // Groups of four unknowns that form a unit quaternion, renormalised after each step.
    std::vector<std::array<std::size_t, 4>> quaternions;
};

} // namespace expression
