#include "physics/scope.h"

#include <algorithm>
#include <set>

namespace physics {

using scene::BodyQuantity;

Scope::Scope(Graph& g, const scene::Scene& scene, std::vector<BodyMass> masses,
             std::vector<BodySymbols> bodies)
    : names_(scene), time_(g.symbol("t")), masses_(std::move(masses)), bodies_(std::move(bodies)) {
    for (const scene::Body& body : scene.bodies)
        if (body.fixed)
            turns_.emplace_back(constant(g, Vector::Zero()));
        else if (body.countsTurns)
            turns_.emplace_back(NodeVector{g.symbol(body.name + ".rx"), g.symbol(body.name + ".ry"),
                                           g.symbol(body.name + ".rz")});
        else
            turns_.emplace_back();
    for (const scene::Parameter& parameter : scene.parameters)
        parameters_.push_back(parameter.value);
    for (const scene::Trajectory& trajectory : scene.trajectories) {
        ScopeTrajectory made;
        made.pieces = piecesOf(g, time_, trajectory);
        made.value = valueOf(g, time_, made.pieces);
        made.rate = differentiated(g, made.value, time_);
        for (const NodeVector& roots : {made.value, made.rate})
            for (const Node root : roots)
                if (g.op(root) == Op::select)
                    choices_[root.index].push_back(trajectories_.size());
        trajectories_.push_back(std::move(made));
    }
}

Vector Scope::armTo(std::size_t body, const std::optional<Vector>& offset) const {
    return offset ? Vector(*offset - masses_[body].centroid) : Vector(Vector::Zero());
}

std::vector<std::size_t> Scope::trajectoriesReadBy(const Graph& g,
                                                   std::span<const Node> nodes) const {
    std::set<std::size_t> found;
    std::set<Node> seen;
    std::vector<Node> pending(nodes.begin(), nodes.end());
    while (!choices_.empty() && !pending.empty()) {
        const Node n = pending.back();
        pending.pop_back();
        if (!seen.insert(n).second)
            continue;
        const auto choice = choices_.find(n.index);
        if (choice != choices_.end()) {
            found.insert(choice->second.begin(), choice->second.end());
            continue;
        }
        const auto arguments = g.arguments(n);
        pending.insert(pending.end(), arguments.begin(), arguments.end());
    }
    return {found.begin(), found.end()};
}

std::unordered_map<std::uint32_t, Node>
Scope::piecesFrom(const Graph& g, std::span<const std::size_t> trajectories, double time) const {
    std::unordered_map<std::uint32_t, Node> replacements;
    const auto replace = [&](Node root, Node piece) {
        if (g.op(root) == Op::select)
            replacements.emplace(root.index, piece);
    };
    for (const std::size_t index : trajectories) {
        const ScopeTrajectory& trajectory = trajectories_[index];
        const TrajectoryPiece& piece = pieceAt(trajectory.pieces, time);
        for (std::size_t i = 0; i < 3; ++i) {
            replace(trajectory.value[i], piece.value[i]);
            replace(trajectory.rate[i], piece.rate[i]);
        }
    }
    return replacements;
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
    if (const auto* body = std::get_if<scene::BodyName>(&named);
        body && scene::isTurn(body->quantity) && !turns_[body->body])
        return {std::nullopt,
                std::string(name) + " is not counted, since the scene does not read it",
                "a plot of the scene that reads it lets it be counted"};
    if (const auto* body = std::get_if<scene::BodyName>(&named))
        return {bodyQuantity(g, *body, arguments), "", ""};
    if (const auto* quantity = std::get_if<scene::SceneName>(&named))
        return {sceneQuantity(quantity->quantity), "", ""};
    if (const auto* joint = std::get_if<scene::JointName>(&named))
        return {jointQuantity(*joint), "", ""};
    if (const auto* read = std::get_if<scene::TrajectoryName>(&named)) {
        const ScopeTrajectory& trajectory = trajectories_[read->trajectory];
        const auto component = static_cast<std::size_t>(read->component);
        return {(read->isRate ? trajectory.rate : trajectory.value)[component], "", ""};
    }
    if (const auto* rope = std::get_if<scene::RopeName>(&named)) {
        const RopeNodes& nodes = ropes_[rope->rope];
        return {rope->span ? nodes.tension[*rope->span] : nodes.length, "", ""};
    }
    if (const auto* contact = std::get_if<scene::ContactName>(&named))
        return {contactQuantity(g, *contact), "", ""};
    if (const auto* spring = std::get_if<scene::SpringName>(&named)) {
        const auto nodes = springs_.find(spring->link);
        if (nodes == springs_.end())
            return {std::nullopt, "this spring has no ends", ""};
        const bool isForce = spring->quantity == scene::SpringQuantity::force;
        return {isForce ? nodes->second.force : nodes->second.length, "", ""};
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
    if (scene::isTurn(name.quantity))
        return (*turns_[name.body])[after(BodyQuantity::rx)];
    if (name.quantity < BodyQuantity::rx)
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

Node Scope::jointQuantity(const scene::JointName& name) const {
    using enum scene::JointQuantity;
    const JointNodes& nodes = joints_[name.joint];
    const auto after = [&](scene::JointQuantity first) {
        return static_cast<std::size_t>(name.quantity) - static_cast<std::size_t>(first);
    };
    switch (name.quantity) {
    case q:
        return nodes.q[name.coordinate];
    case dq:
        return nodes.dq[name.coordinate];
    case motor:
        return nodes.motor[name.coordinate];
    case fx:
    case fy:
    case fz:
        return nodes.force[after(fx)];
    case tx:
    case ty:
    case tz:
        return nodes.couple[after(tx)];
    case px:
    case py:
    case pz:
        break;
    }
    return nodes.point[after(px)];
}

// While nothing touches there is no centre of pressure: 0/0.
Node Scope::contactQuantity(Graph& g, const scene::ContactName& name) const {
    using enum scene::ContactQuantity;
    if (!contacts_[name.contact])
        return g.constant(0);
    const ContactNodes& nodes = *contacts_[name.contact];
    const auto after = [&](scene::ContactQuantity first) {
        return static_cast<std::size_t>(name.quantity) - static_cast<std::size_t>(first);
    };
    const auto lengthOf = [&](const NodeVector& v) { return g.apply(Op::sqrt, dot(g, v, v)); };
    const Node touches = g.apply(Op::less, g.constant(0), nodes.normal);
    const NodeVector arm = scaled(g, g.divide(g.constant(1), nodes.normal), nodes.moment);
    if (name.quantity == n)
        return nodes.normal;
    if (name.quantity < tx)
        return nodes.force[after(fx)];
    if (name.quantity < px)
        return g.apply(Op::select, touches,
                       subtract(g, nodes.couple, cross(g, arm, nodes.force))[after(tx)],
                       g.constant(0));
    if (name.quantity < slip)
        return g.add(bodies_[nodes.moving].position[after(px)], arm[after(px)]);
    if (name.quantity == slip)
        return lengthOf(nodes.slip);
    constexpr double rounding = 1e-12; // of the velocities
    constexpr double leastSpeed =
        1e-3; // radii a second: bodies at rest have velocities of rounding
    Node fastest = g.constant(leastSpeed * masses_[nodes.moving].radius);
    for (const std::size_t body : {nodes.moving, nodes.other})
        fastest = g.add(fastest, g.add(lengthOf(bodies_[body].velocity),
                                       g.multiply(g.constant(masses_[body].radius),
                                                  lengthOf(bodies_[body].spin))));
    const Node slips =
        g.apply(Op::less, g.multiply(g.constant(rounding), fastest), lengthOf(nodes.slip));
    return g.apply(Op::select, touches, g.apply(Op::select, slips, g.constant(2), g.constant(1)),
                   g.constant(0));
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
