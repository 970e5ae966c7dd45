#include "physics/jets.h"

namespace physics {

JetVector constantJet(Graph& g, const Vector& v) {
    const NodeVector zero = constant(g, Vector::Zero());
    return {constant(g, v), zero, zero};
}

Jet constantJet(Graph& g, double value) {
    return {g.constant(value), g.constant(0), g.constant(0)};
}

JetVector centreJet(const BodySymbols& body, const BodyRates& rates) {
    return {body.position, body.velocity, rates.acceleration};
}

// R v;  w x R v;  w' x R v + w x (w x R v).
JetVector carriedJet(Graph& g, const BodySymbols& body, const BodyRates& rates, const Vector& v) {
    const NodeVector arm = constant(g, v);
    JetVector jet;
    jet.value = body.toWorld(g, arm);
    jet.rate = body.velocityOfArm(g, arm);
    if (body.isSpinInWorldAxes)
        jet.second = add(g, cross(g, rates.spinRate, jet.value), cross(g, body.spin, jet.rate));
    else
        jet.second = body.toWorld(g, add(g, cross(g, rates.spinRate, arm),
                                         cross(g, body.spin, cross(g, body.spin, arm))));
    return jet;
}

// The spin's own change of axes adds nothing to the rate: w x w = 0.
JetVector spinJet(Graph& g, const BodySymbols& body, const BodyRates& rates) {
    return {body.worldSpin(g),
            body.isSpinInWorldAxes ? rates.spinRate : body.toWorld(g, rates.spinRate),
            constant(g, Vector::Zero())};
}

JetVector difference(Graph& g, const JetVector& a, const JetVector& b) {
    return {subtract(g, a.value, b.value), subtract(g, a.rate, b.rate),
            subtract(g, a.second, b.second)};
}

JetVector sum(Graph& g, const JetVector& a, const JetVector& b) {
    return {add(g, a.value, b.value), add(g, a.rate, b.rate), add(g, a.second, b.second)};
}

JetVector cross(Graph& g, const JetVector& a, const JetVector& b) {
    const NodeVector twice = scaled(g, g.constant(2), cross(g, a.rate, b.rate));
    return {cross(g, a.value, b.value),
            add(g, cross(g, a.rate, b.value), cross(g, a.value, b.rate)),
            add(g, add(g, cross(g, a.second, b.value), cross(g, a.value, b.second)), twice)};
}

Jet product(Graph& g, const JetVector& a, const JetVector& b) {
    const Node twice = g.multiply(g.constant(2), dot(g, a.rate, b.rate));
    return {dot(g, a.value, b.value), g.add(dot(g, a.rate, b.value), dot(g, a.value, b.rate)),
            g.add(g.add(dot(g, a.second, b.value), dot(g, a.value, b.second)), twice)};
}

Jet product(Graph& g, const Jet& a, const Jet& b) {
    const Node twice = g.multiply(g.constant(2), g.multiply(a.rate, b.rate));
    return {g.multiply(a.value, b.value),
            g.add(g.multiply(a.rate, b.value), g.multiply(a.value, b.rate)),
            g.add(g.add(g.multiply(a.second, b.value), g.multiply(a.value, b.second)), twice)};
}

Jet root(Graph& g, const Jet& a) {
    const Node two = g.constant(2), s = g.apply(Op::sqrt, a.value);
    const Node rate = g.divide(a.rate, g.multiply(two, s));
    const Node left = g.subtract(a.second, g.multiply(two, g.multiply(rate, rate)));
    return {s, rate, g.divide(left, g.multiply(two, s))};
}

Jet length(Graph& g, const JetVector& v) {
    const Node size = g.apply(Op::sqrt, dot(g, v.value, v.value));
    const Node rate = g.divide(dot(g, v.value, v.rate), size);
    const Node outwards = g.add(dot(g, v.rate, v.rate), dot(g, v.value, v.second));
    return {size, rate, g.divide(g.subtract(outwards, g.multiply(rate, rate)), size)};
}

Jet sum(Graph& g, const Jet& a, const Jet& b) {
    return {g.add(a.value, b.value), g.add(a.rate, b.rate), g.add(a.second, b.second)};
}

Jet difference(Graph& g, const Jet& a, const Jet& b) {
    return {g.subtract(a.value, b.value), g.subtract(a.rate, b.rate),
            g.subtract(a.second, b.second)};
}

Jet scaled(Graph& g, double factor, const Jet& jet) {
    const Node f = g.constant(factor);
    return {g.multiply(f, jet.value), g.multiply(f, jet.rate), g.multiply(f, jet.second)};
}

} // namespace physics
