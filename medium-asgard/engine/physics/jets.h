// Expressions of a motion with their first and second rates along it.
//
// Points and directions that bodies carry are jets; products of jets are jets, by the product rule.
// So a condition on places gives its rates without a derivation of its own.
#pragma once

#include "physics/body_symbols.h"

namespace physics {

struct Jet {
    Node value, rate, second;
};
struct JetVector {
    NodeVector value, rate, second;
};

// How a body's velocity and spin change: along the axes of its unknowns.
struct BodyRates {
    NodeVector acceleration, spinRate;
};

[[nodiscard]] JetVector constantJet(Graph& g, const Vector& v);
// Of the centre of mass.
[[nodiscard]] JetVector centreJet(const BodySymbols& body, const BodyRates& rates);
// A vector that the body carries, given along the body's axes.
[[nodiscard]] JetVector carriedJet(Graph& g, const BodySymbols& body, const BodyRates& rates,
                                   const Vector& v);
// Angular velocity along the world's axes, and its rate; no second rate.
[[nodiscard]] JetVector spinJet(Graph& g, const BodySymbols& body, const BodyRates& rates);

[[nodiscard]] JetVector difference(Graph& g, const JetVector& a, const JetVector& b);
[[nodiscard]] JetVector sum(Graph& g, const JetVector& a, const JetVector& b);
[[nodiscard]] JetVector cross(Graph& g, const JetVector& a, const JetVector& b);
[[nodiscard]] Jet product(Graph& g, const JetVector& a, const JetVector& b); // scalar product
[[nodiscard]] Jet product(Graph& g, const Jet& a, const Jet& b);
[[nodiscard]] Jet root(Graph& g, const Jet& a); // square root
[[nodiscard]] Jet length(Graph& g, const JetVector& v);
[[nodiscard]] Jet sum(Graph& g, const Jet& a, const Jet& b);
[[nodiscard]] Jet difference(Graph& g, const Jet& a, const Jet& b);
[[nodiscard]] Jet scaled(Graph& g, double factor, const Jet& jet);
[[nodiscard]] Jet constantJet(Graph& g, double value);

} // namespace physics
