// Scenes and equations for tests.
#pragma once

#include "physics/equations_of_motion.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace physics::testing {

inline scene::ShapeSet sphere(const std::string& name, double radius) {
    scene::ShapeSet set;
    set.name = name;
    set.parts.resize(1);
    set.parts[0].shape = scene::SphereShape{radius};
    return set;
}

inline scene::ShapeSet box(const std::string& name, const Vector& edges) {
    scene::ShapeSet set;
    set.name = name;
    set.parts.resize(1);
    set.parts[0].shape = scene::BoxShape{edges};
    return set;
}

inline scene::Body body(const std::string& name, const std::string& shape, double mass) {
    scene::Body made;
    made.name = name;
    made.shape = shape;
    made.mass = mass;
    return made;
}

inline scene::Force force(const std::string& bodyName, const std::string& fx, const std::string& fy,
                          const std::string& fz) {
    scene::Force made;
    made.body = bodyName;
    made.kind = scene::ComponentForce{{fx, fy, fz}, scene::Frame::world};
    return made;
}

// A sphere "ball" of mass 2 and radius 0.5, and a box "rod" of mass 3 and edges 2 1 1, whose
// moments are 0.5 about its first axis and 1.25 about the others.
inline scene::Scene ballAndRod() {
    scene::Scene scene;
    scene.shapeSets = {sphere("ball1", 0.5), box("rod1", {2, 1, 1})};
    scene.bodies = {body("ball", "ball1", 2), body("rod", "rod1", 3)};
    return scene;
}

inline const expression::Unknown& unknown(const EquationsOfMotion& motion, std::string_view name) {
    for (const expression::Unknown& u : motion.set.unknowns)
        if (u.name == name)
            return u;
    throw std::invalid_argument("no unknown " + std::string(name));
}

// "d derivative" or "= given", each phase after the first with its time and jump:
//     dx | from 1: = t^2, dx = 2*t | from 2 at x0: dx
inline std::string equation(const EquationsOfMotion& motion, std::string_view name) {
    const expression::Graph& g = motion.set.graph;
    std::string text;
    for (const expression::Phase& phase : unknown(motion, name).phases) {
        if (!text.empty())
            text += " | from " + print(g, expression::Graph(g).constant(phase.from));
        if (phase.jump)
            text += " at " + print(g, *phase.jump);
        text += text.empty() ? "" : ": ";
        if (phase.given)
            text += "= " + print(g, *phase.given) + ", rate ";
        text += print(g, phase.derivative);
    }
    return text;
}

// How hand-derived text prints once it has been read and simplified.
inline std::string asPrinted(const EquationsOfMotion& motion, std::string_view text) {
    expression::Graph g = motion.set.graph;
    const expression::Names anything = [](expression::Graph& graph, std::string_view name,
                                          std::span<const Node>, bool) {
        return expression::Meaning{graph.symbol(name), "", ""};
    };
    const auto made = expression::parse(g, text, anything);
    if (const auto* error = std::get_if<expression::SyntaxError>(&made))
        throw std::invalid_argument(std::string(text) + ": " + error->message);
    return print(g, std::get<Node>(made));
}

// The value of a node at a state (in the order of the unknowns) and time.
inline double valueOf(const EquationsOfMotion& motion, Node node, std::span<const double> state,
                      double time) {
    std::unordered_map<std::uint32_t, Node> numbers;
    expression::Graph g = motion.set.graph;
    for (std::size_t i = 0; i < state.size(); ++i)
        numbers.emplace(motion.set.unknowns[i].symbol.index, g.constant(state[i]));
    numbers.emplace(motion.set.time.index, g.constant(time));
    const Node result = substitute(g, node, numbers);
    if (g.op(result) != Op::constant)
        throw std::logic_error("not a number: " + print(g, result));
    return g.value(result);
}

} // namespace physics::testing
