#include "physics/scene_quantities.h"

#include <algorithm>

namespace physics {
namespace {

NodeVector angularMomentumInSpinAxes(Graph& g, const BodyMotion& body) {
    NodeMatrix rows;
    for (int i = 0; i < 3; ++i)
        rows[static_cast<std::size_t>(i)] = constant(g, body.mass.inertia.row(i));
    return times(g, rows, body.symbols.spin);
}

// 1 while nothing holds the body, else 0.
Node isFree(Graph& g, Node time, const BodyMotion& body) {
    Node free = g.constant(1);
    for (const Held& held : body.held) { // each replaces what was said of the time before
        const bool isHeld = held.attitude || std::ranges::count(held.position, true) > 0;
        const Node said = g.constant(isHeld ? 0 : 1);
        const bool isFirst = &held == &body.held.front();
        free = isFirst ? said
                       : g.apply(Op::select, g.apply(Op::less, time, g.constant(held.from)), free,
                                 said);
    }
    return free;
}

// v while the body is free, else 0: chosen, not multiplied, so that no held value shows through.
Node whileFree(Graph& g, Node free, Node v) { return g.apply(Op::select, free, v, g.constant(0)); }

void addBody(Graph& g, Node time, const BodyMotion& body, SceneNodes& scene) {
    const BodySymbols& s = body.symbols;
    const Node mass = g.constant(body.mass.mass), half = g.constant(0.5);
    const NodeVector spinMomentum = angularMomentumInSpinAxes(g, body);
    const NodeVector momentum = scaled(g, mass, s.velocity);
    const Node kinetic = g.multiply(half, g.add(g.multiply(mass, dot(g, s.velocity, s.velocity)),
                                                dot(g, s.spin, spinMomentum)));
    const NodeVector own = s.isSpinInWorldAxes ? spinMomentum : s.toWorld(g, spinMomentum);
    const NodeVector angular = add(g, cross(g, s.position, momentum), own);
    const Node free = isFree(g, time, body);
    scene.energy = g.add(scene.energy, whileFree(g, free, kinetic));
    for (std::size_t i = 0; i < 3; ++i) {
        scene.momentum[i] = g.add(scene.momentum[i], whileFree(g, free, momentum[i]));
        scene.angularMomentum[i] = g.add(scene.angularMomentum[i], whileFree(g, free, angular[i]));
    }
}

// -m g.r
Node weightEnergy(Graph& g, const Scope& scope, std::size_t body, const scene::Force& force,
                  const Vector& acceleration) {
    const BodySymbols& s = scope.body(body);
    const NodeVector arm = constant(g, scope.armTo(body, force.offset));
    const NodeVector point = add(g, s.position, s.toWorld(g, arm));
    return dot(g, constant(g, -scope.mass(body).mass * acceleration), point);
}

} // namespace

SceneNodes sceneNodes(EquationsOfMotion& motion, const scene::Scene& scene) {
    Graph& g = motion.set.graph;
    SceneNodes nodes;
    nodes.energy = g.constant(0);
    nodes.momentum = nodes.angularMomentum = constant(g, Vector::Zero());
    nodes.collisions = g.symbol("events.collisions");
    for (const BodyMotion& body : motion.bodies)
        if (!body.isFixed)
            addBody(g, motion.set.time, body, nodes);
    for (const Contribution& c : motion.contributions) {
        if (c.kind != Contribution::Kind::force || scene.forces[c.element].couple)
            continue;
        const scene::Force& force = scene.forces[c.element];
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
            nodes.energy = g.add(
                nodes.energy, weightEnergy(g, *motion.scope, c.body, force, weight->acceleration));
    }
    for (const LinkNodes& link : motion.links)
        nodes.energy = g.add(nodes.energy, link.energy);
    for (const Node energy : motion.jointEnergies)
        nodes.energy = g.add(nodes.energy, energy);
    return nodes;
}

} // namespace physics
