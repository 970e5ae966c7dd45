// The names of a scene's expressions as nodes: state symbols, constants and trajectories.
#pragma once

#include "physics/body_symbols.h"
#include "physics/trajectory_expression.h"
#include "scene/names.h"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace physics {

struct SpringNodes {
    Node length;
    Node force; // positive: it pulls
};

struct ScopeTrajectory {
    std::vector<TrajectoryPiece> pieces;
    NodeVector value, rate; // at all times
};

// The nodes of scene.energy and the like, for expressions that may read them.
struct SceneNodes {
    Node energy;
    NodeVector momentum;
    NodeVector angularMomentum; // about the origin
    Node collisions;            // the symbol "events.collisions", which has no equation
};

// The nodes of a joint's names (scene/names.h). Forces are what it does to its first body, in world
// axes, about its point; `point`: as the second body, or the ground, carries it.
struct JointNodes {
    std::vector<Node> q, dq, motor; // by coordinate
    NodeVector force, couple, point;
};

// A rope's names; tension of each span between wheels or ends.
struct RopeNodes {
    Node length;
    std::vector<Node> tension;
};

// The symbols of a contact's readings (expression/equations.h), of all contacts of its pair: what
// they do to its first body, in world axes, about the centre of mass of the body that moves.
struct ContactNodes {
    Node normal;
    NodeVector force, couple;
    NodeVector moment;                 // of the normal forces: each times its place from there
    NodeVector slip;                   // mean velocity along each other
    std::size_t moving = 0, other = 0; // bodies

    [[nodiscard]] std::vector<Node> symbols() const {
        std::vector<Node> all{normal};
        for (const NodeVector* vector : {&force, &couple, &moment, &slip})
            all.insert(all.end(), vector->begin(), vector->end());
        return all;
    }
};

// Keeps nodes of one graph; it may be used with that graph and with its copies.
class Scope {
public:
    // `masses` and `bodies` in the order of the scene's bodies.
    Scope(Graph& g, const scene::Scene& scene, std::vector<BodyMass> masses,
          std::vector<BodySymbols> bodies);

    [[nodiscard]] Node time() const { return time_; }
    [[nodiscard]] const BodySymbols& body(std::size_t i) const { return bodies_[i]; }
    // The integrals of its angular velocity, world axes; none: no expression reads them.
    [[nodiscard]] const std::optional<NodeVector>& turns(std::size_t i) const { return turns_[i]; }
    [[nodiscard]] const BodyMass& mass(std::size_t i) const { return masses_[i]; }
    [[nodiscard]] const ScopeTrajectory& trajectory(std::size_t i) const {
        return trajectories_[i];
    }
    // The trajectories (indices, in order) whose choices by time some of these nodes read.
    [[nodiscard]] std::vector<std::size_t> trajectoriesReadBy(const Graph& g,
                                                              std::span<const Node> nodes) const;
    // The values of these trajectories from `time` to the next of their pieces, for substitute(): a
    // choice by time becomes the one piece.
    [[nodiscard]] std::unordered_map<std::uint32_t, Node>
    piecesFrom(const Graph& g, std::span<const std::size_t> trajectories, double time) const;
    void setJoints(std::vector<JointNodes> joints) { joints_ = std::move(joints); }
    void setContacts(std::vector<std::optional<ContactNodes>> contacts) {
        contacts_ = std::move(contacts);
    }
    [[nodiscard]] const std::vector<std::optional<ContactNodes>>& contacts() const {
        return contacts_;
    }
    void setRopes(std::vector<RopeNodes> ropes) { ropes_ = std::move(ropes); }
    // A spring's quantities, by index into Scene::links; set before an expression may read them.
    void setSpring(std::size_t link, const SpringNodes& nodes) { springs_[link] = nodes; }
    void setSceneNodes(const SceneNodes& nodes) { sceneNodes_ = nodes; }

    // From the centre of mass to a point given from the reference point (none: the centre).
    [[nodiscard]] Vector armTo(std::size_t body, const std::optional<Vector>& offset) const;

    [[nodiscard]] std::variant<Node, expression::SyntaxError> parse(Graph& g, std::string_view text,
                                                                    scene::Reading reading) const;

private:
    [[nodiscard]] expression::Meaning meaning(Graph& g, std::string_view name,
                                              std::span<const Node> arguments, bool isCall,
                                              scene::Reading reading) const;
    [[nodiscard]] Node bodyQuantity(Graph& g, const scene::BodyName& name,
                                    std::span<const Node> arguments) const;
    [[nodiscard]] Node bodyPoint(Graph& g, const scene::BodyName& name,
                                 std::span<const Node> arguments) const;
    [[nodiscard]] Node jointQuantity(const scene::JointName& name) const;
    [[nodiscard]] Node contactQuantity(Graph& g, const scene::ContactName& name) const;
    [[nodiscard]] Node sceneQuantity(scene::SceneQuantity quantity) const;

    scene::Names names_;
    Node time_;
    std::vector<double> parameters_;
    std::vector<BodyMass> masses_;
    std::vector<BodySymbols> bodies_;
    std::vector<std::optional<NodeVector>> turns_; // none: they are not counted
    std::vector<ScopeTrajectory> trajectories_;
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> choices_; // whose value or rate
    std::vector<JointNodes> joints_;
    std::vector<RopeNodes> ropes_;
    std::vector<std::optional<ContactNodes>> contacts_; // none: without a name, or not all there
    std::unordered_map<std::size_t, SpringNodes> springs_;
    SceneNodes sceneNodes_;
};

} // namespace physics
