// A scene as differential equations: Newton's and Euler's, one scalar equation for each unknown.
//
//     x' = v                 m v' = sum of the forces
//     q' = q w / 2           I w' = sum of the torques - w x I w
//
// about the centre of mass, with w and the torques along the body's axes; a body whose inertia is
// the same about every axis has w along the world's axes instead, and then
//     q' = w q / 2           I w' = sum of the torques.
// A force F at an arm d from the centre of mass turns by d x F; a couple makes no net force.
//
// Differences from the equations that the dissertation prints (5.1.1, 5.1.2), each with its test:
// docs/numerics.md, "Differences from the dissertation".
#pragma once

#include "expression/equations.h"
#include "physics/holds.h"
#include "physics/scope.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physics {

// Positions in a body's thirteen unknowns.
enum BodyUnknown : std::size_t { x, y, z, dx, dy, dz, qw, qx, qy, qz, w1, w2, w3, bodyUnknowns };

// The coordinates that a trajectory holds from a time on; collisions meet infinite mass there.
struct Held {
    double from = 0;
    std::array<bool, 3> position{}; // along the world's axes
    bool attitude = false;
};

// The state of a body in the world, whatever its unknowns are.
struct BodyValues {
    Vector position = Vector::Zero(); // of the centre of mass
    Vector velocity = Vector::Zero();
    Quaternion attitude = Quaternion::Identity();
    Vector angularVelocity = Vector::Zero(); // world axes
};

struct BodyMotion {
    std::string name;
    bool isFixed = false;
    BodyMass mass; // the shape's own, even when the body is fixed (and so counts as infinite)
    // To points of joints outside the shape's bounding sphere; body frame, from the centre of mass.
    std::vector<Vector> arms;
    BodySymbols symbols;
    geometry::Pose start;         // centre of mass; of a fixed body at all times
    std::size_t firstUnknown = 0; // thirteen in a row (see BodyUnknown); not for a fixed body
    std::vector<Held> held;       // from the start of time, in order; never empty
    // Where nothing holds it; spin along its own axes (see BodySymbols).
    NodeVector acceleration, spinRate;

    [[nodiscard]] const Held& heldAt(double time) const;
    [[nodiscard]] std::size_t unknown(BodyUnknown which) const { return firstUnknown + which; }

    // Between the values of the thirteen unknowns and the state in the world.
    [[nodiscard]] BodyValues valuesOf(std::span<const double, bodyUnknowns> unknowns) const;
    [[nodiscard]] std::array<double, bodyUnknowns> unknownsOf(const BodyValues& values) const;
};

// The terms that one force, one end of a link, or a joint adds to a body.
struct Contribution {
    enum class Kind { force, link, joint, gear, rope };
    Kind kind = Kind::force;
    std::size_t element = 0; // index into Scene::forces, links, joints, gears or ropes
    std::size_t body = 0;
    NodeVector force;  // world axes
    NodeVector torque; // along the axes of the body's spin
    // The scene's own expressions: a force's components, a link's place.
    std::optional<NodeVector> written;
};

struct LinkNodes {
    std::size_t link = 0; // index into Scene::links
    NodeVector extension; // first point less second, world
    NodeVector speed;     // its rate
    double damping = 0;   // given or critical
    Node energy;          // that it holds
};

// The part of a condition's rate that a body's velocity has: J of that body, in world axes.
struct JointPush {
    std::size_t body = 0;
    NodeVector linear, angular;
};

struct JointRow {
    std::size_t multiplier = 0; // unknown
    std::vector<JointPush> pushes;
    // Of a stop or a rope, which holds where its gap is not over this, and pushes only.
    std::optional<Node> gap = {};
    double resolution = 0;
};

// A wheel between two spans of a rope: wrapped by  start + sign (out - in), or lifted off under 0.
struct RopeWrap {
    std::string rope, body;
    std::optional<std::size_t> in, out; // unknowns; none: an angle that stays
    double start = 0, sign = 1;
};

// How a span lies at a wheel: how far the way between the centres of its ends leads out of the
// wheel's plane, how long that way is, and how long it is within the plane at least.
struct RopeLean {
    std::size_t rope = 0, body = 0; // of the scene; of the wheel
    Node out, way;
    double least = 0;
};

// A given unknown that reads contacts, and its value with their symbols.
struct ContactReader {
    std::size_t unknown = 0;
    Node value;
};

struct EquationsOfMotion {
    // Of many bodies it takes a while: `meanwhile` is called now and then, and may throw to end it.
    // `shapes`: of this scene, where they are wanted for more than masses; may be null.
    // mayMiss: joints that their bodies miss at the start, too, for those who close them.
    enum class Start { closes, mayMiss };
    explicit EquationsOfMotion(const scene::Scene& scene,
                               const std::function<void()>& meanwhile = {},
                               scene::ShapeReader* shapes = nullptr, Start start = Start::closes);

    expression::EquationSet set;
    std::vector<BodyMotion> bodies; // as Scene::bodies
    std::vector<Contribution> contributions;
    std::vector<LinkNodes> links;
    // Times, in order, at which a trajectory takes hold, lets go or passes to its next piece.
    std::vector<double> breakpoints;
    // By unknown the body that it tells of. Behind those of bodies stand angles and multipliers of
    // joints (joints.h), each told of one of its bodies.
    std::vector<std::size_t> owners;
    // Conditions that joints, gears and drives put on velocities: of each the bodies that move.
    std::vector<JointRow> jointRows;
    std::vector<Node> jointEnergies; // of the springs of joints
    std::vector<RopeWrap> ropeWraps;
    std::vector<RopeLean> ropeLeans;
    std::vector<ContactReader> contactReaders;
    std::vector<std::string> notes; // what is not as it was written, as sentences
    // Why the scene has no equations: sentences. Empty: it has.
    std::vector<std::string> faults;
    std::optional<Scope>
        scope; // names for further expressions (quantities, views); none with faults
};

// The phase of an unknown at a time.
[[nodiscard]] const expression::Phase& phaseAt(const expression::Unknown& unknown, double time);

// The coordinates of a body that impacts and contacts do not change. A hold makes no hinge
// (docs/scene-language.md): a body that is held at a place beside its centre of mass takes no spin,
// as if its attitude were held.
[[nodiscard]] Held unyieldingAt(const EquationsOfMotion& equations, std::size_t body, double time);

} // namespace physics
