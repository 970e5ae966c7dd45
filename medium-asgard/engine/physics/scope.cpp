#include "physics/scope.h"

#include <algorithm>

namespace physics {

using scene::BodyQuantity;

Scope::Scope(Graph& g, const scene::Scene& scene, std::vector<BodyMass> masses,
             std::vector<BodySymbols> bodies)
    : names_(scene), time_(g.symbol("t")), masses_(std::move(masses)), bodies_(std::move(bodies)) {
    for (const scene::Parameter& parameter : scene.parameters)
        parameters_.push_back(parameter.value);
    for (const scene::Trajectory& trajectory : scene.trajectories) {
        ScopeTrajectory made;
        made.pieces = piecesOf(g, time_, trajectory);
        made.value = valueOf(g, time_, made.pieces);
        made.rate = differentiated(g, made.value, time_);
        trajectories_.push_back(std::move(made));
    }
}

Vector Scope::armTo(std::size_t body, const std::optional<Vector>& offset) const {
    return offset ? Vector(*offset - masses_[body].centroid) : Vector(Vector::Zero());
}

std::unordered_map<std::uint32_t, Node> Scope::piecesFrom(Graph& g, double time) const {
    std::unordered_map<std::uint32_t, Node> replacements;
    for (const ScopeTrajectory& trajectory : trajectories_) {
        const NodeVector value = pieceAt(trajectory.pieces, time).value;
        for (std::size_t i = 0; i < 3; ++i) {
            if (g.op(trajectory.value[i]) == Op::select)
                replacements.emplace(trajectory.value[i].index, value[i]);
            if (g.op(trajectory.rate[i]) == Op::select)
                replacements.emplace(trajectory.rate[i].index, differentiate(g, value[i], time_));
        }
    }
    return replacements;
}

std::vector<double> Scope::piecesReadBy(Graph& g, std::span<const Node> nodes) const {
    std::vector<double> times;
    const auto isRead = [&](const NodeVector& roots) {
        std::unordered_map<std::uint32_t, Node> gone;
        for (const Node root : roots)
            if (g.op(root) == Op::select)
                gone.emplace(root.index, time_);
        return !gone.empty() &&
               std::ranges::any_of(nodes, [&](Node n) { return substitute(g, n, gone) != n; });
    };
    for (const ScopeTrajectory& trajectory : trajectories_)
        if (isRead(trajectory.value) || isRead(trajectory.rate))
            for (const TrajectoryPiece& piece : std::span(trajectory.pieces).subspan(1))
                times.push_back(piece.from);
    return times;
}

std::variant<Node, expression::SyntaxError> Scope::parse(Graph& g, std::string_view text,
                                                         scene::Reading reading) const {
    return expression::parse(
        g, text,
        [&](Graph& graph, std::string_view name, std::span<const Node> arguments, bool isCall) {
            return meaning(graph, name, arguments, isCall, reading);
        });
}

expression::Meaning Scope::meaning(Graph& g, std::string_view name, std::span<const Node> arguments,
                                   bool isCall, scene::Reading reading) const {
    const auto count = isCall ? std::optional(arguments.size()) : std::nullopt;
    const scene::Named named = names_.find(name, count, reading);
    if (const auto* fault = std::get_if<scene::NameFault>(&named))
        return {std::nullopt, fault->message, fault->suggestion};
    if (const auto* parameter = std::get_if<scene::ParameterName>(&named))
        return {g.constant(parameters_[parameter->parameter]), "", ""};
    if (const auto* body = std::get_if<scene::BodyName>(&named))
        return {bodyQuantity(g, *body, arguments), "", ""};
    if (const auto* quantity = std::get_if<scene::SceneName>(&named))
        return {sceneQuantity(quantity->quantity), "", ""};
    if (const auto* read = std::get_if<scene::TrajectoryName>(&named)) {
        const ScopeTrajectory& trajectory = trajectories_[read->trajectory];
        const auto component = static_cast<std::size_t>(read->component);
        return {(read->isRate ? trajectory.rate : trajectory.value)[component], "", ""};
    }
    return {time_, "", ""};
}

Node Scope::bodyQuantity(Graph& g, const scene::BodyName& name,
                         std::span<const Node> arguments) const {
    const BodySymbols& body = bodies_[name.body];
    const BodyMass& mass = masses_[name.body];
    const auto after = [&](BodyQuantity first) {
        return static_cast<std::size_t>(name.quantity) - static_cast<std::size_t>(first);
    };
    if (name.quantity >= BodyQuantity::px)
        return bodyPoint(g, name, arguments);
    if (name.quantity < BodyQuantity::dx)
        return body.position[after(BodyQuantity::x)];
    if (name.quantity < BodyQuantity::wx)
        return body.velocity[after(BodyQuantity::dx)];
    if (name.quantity < BodyQuantity::qw)
        return body.worldSpin(g)[after(BodyQuantity::wx)];
    if (name.quantity < BodyQuantity::mass)
        return body.attitude[after(BodyQuantity::qw)];
    if (name.quantity == BodyQuantity::mass)
        return g.constant(mass.mass);
    static constexpr std::pair<int, int> entries[] = {{0, 0}, {1, 1}, {2, 2},
                                                      {0, 1}, {0, 2}, {1, 2}};
    const auto [row, column] = entries[after(BodyQuantity::ixx)];
    return g.constant(mass.inertia(row, column));
}

// The place or velocity of a point given from the reference point along the body's axes.
Node Scope::bodyPoint(Graph& g, const scene::BodyName& name,
                      std::span<const Node> arguments) const {
    const BodySymbols& body = bodies_[name.body];
    const NodeVector offset{arguments[0], arguments[1], arguments[2]};
    const NodeVector arm = subtract(g, offset, constant(g, masses_[name.body].centroid));
    const bool isVelocity = name.quantity >= BodyQuantity::pdx;
    const auto first = isVelocity ? BodyQuantity::pdx : BodyQuantity::px;
    const auto i = static_cast<std::size_t>(name.quantity) - static_cast<std::size_t>(first);
    return isVelocity ? g.add(body.velocity[i], body.velocityOfArm(g, arm)[i])
                      : g.add(body.position[i], body.toWorld(g, arm)[i]);
}

Node Scope::sceneQuantity(scene::SceneQuantity quantity) const {
    using enum scene::SceneQuantity;
    switch (quantity) {
    case energy:
        return sceneNodes_.energy;
    case px:
        return sceneNodes_.momentum[0];
    case py:
        return sceneNodes_.momentum[1];
    case pz:
        return sceneNodes_.momentum[2];
    case lx:
        return sceneNodes_.angularMomentum[0];
    case ly:
        return sceneNodes_.angularMomentum[1];
    case lz:
        return sceneNodes_.angularMomentum[2];
    case collisions:
        break;
    }
    return sceneNodes_.collisions;
}

} // namespace physics
