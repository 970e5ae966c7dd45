// The meaning of names in a scene's expressions, and the wrong names.
//
// The rules of docs/scene-language.md, "Expressions", in one place: script/ reports wrong names
// when a text is read, physics/ turns right ones into equations.
#pragma once

#include "expression/parse.h"
#include "scene/scene.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scene {

enum class BodyQuantity {
    x,
    y,
    z,
    dx,
    dy,
    dz,
    wx,
    wy,
    wz,
    qw,
    qx,
    qy,
    qz,
    rx, // integrals of wx, wy, wz from the start: in a plane the angle turned, not wrapped
    ry,
    rz,
    mass,
    ixx,
    iyy,
    izz,
    ixy,
    ixz,
    iyz,
    px,
    py,
    pz,
    pdx,
    pdy,
    pdz, // calls with the body point's three coordinates
};

// In the order of BodyQuantity, of SpringQuantity.
[[nodiscard]] const std::vector<std::string>& bodyQuantityNames();
[[nodiscard]] const std::vector<std::string>& springQuantityNames();
[[nodiscard]] inline bool isTurn(BodyQuantity q) {
    return q >= BodyQuantity::rx && q <= BodyQuantity::rz;
}

enum class SpringQuantity { length, force };

// The names that a rope has after its dot: "length", "tension" (of the first span between wheels or
// ends), "tension1", ...
[[nodiscard]] std::vector<std::string> ropeQuantityNames(const Rope& rope);
// How many spans between wheels or ends a rope has: each has a tension of its own.
[[nodiscard]] std::size_t spansOf(const Rope& rope);

// fx to tz: what the joint does to body 1, in world axes, at its point; motor: along a coordinate;
// px to pz: the place of its point, as body 2 or the ground carries it.
enum class JointQuantity { q, dq, motor, fx, fy, fz, tx, ty, tz, px, py, pz };

// The names that a joint of that type has after its dot: "q", "dq", "motor", or "q1", ..., "fx",
// ...
[[nodiscard]] std::vector<std::string> jointQuantityNames(JointType type);

// Of all contacts of its pair together. n: normal force; fx to tz: what they do to body 1, in world
// axes, about the centre of pressure, which is at px py pz; slip: the speed of body 1 along body 2
// there; state: 0 open, 1 sticks, 2 slips.
enum class ContactQuantity { n, fx, fy, fz, tx, ty, tz, px, py, pz, slip, state };
[[nodiscard]] const std::vector<std::string>& contactQuantityNames();

enum class SceneQuantity { energy, px, py, pz, lx, ly, lz, collisions };

struct TimeName {};
struct ParameterName {
    std::size_t parameter = 0; // index into Scene::parameters
};
struct BodyName {
    std::size_t body = 0;
    BodyQuantity quantity = BodyQuantity::x;
};
struct TrajectoryName {
    std::size_t trajectory = 0;
    int component = 0;   // 0..2
    bool isRate = false; // T.dx
};
struct JointName {
    std::size_t joint = 0; // index into Scene::joints
    JointQuantity quantity = JointQuantity::q;
    std::size_t coordinate = 0; // of q, dq and motor, from 0
};
struct SpringName {
    std::size_t link = 0; // index into Scene::links
    SpringQuantity quantity = SpringQuantity::length;
};
struct RopeName {
    std::size_t rope = 0;            // index into Scene::ropes
    std::optional<std::size_t> span; // whose tension it is, from 0; none: the length
};
struct ContactName {
    std::size_t contact = 0; // index into Scene::contacts
    ContactQuantity quantity = ContactQuantity::n;
};
struct SceneName {
    SceneQuantity quantity = SceneQuantity::energy; // events.collisions among them
};
struct NameFault {
    std::string message, suggestion;
};
using Named = std::variant<TimeName, ParameterName, BodyName, TrajectoryName, JointName, SpringName,
                           RopeName, ContactName, SceneName, NameFault>;

// The quantities that an expression may read.
enum class Reading {
    state,      // of bodies, joints, trajectories, parameters, time, lengths of springs and ropes
    positions,  // a link's point, a joint's -position: places and attitudes; no velocities, lengths
    release,    // -release: also the forces of joints, springs, ropes and contacts
    quantities, // to chart or print: also scene.energy, events.collisions, ...
};

class Names {
public:
    explicit Names(const Scene& scene); // keeps only names

    // `arguments`: how many a call has; none when the name stands alone.
    [[nodiscard]] Named find(std::string_view name, std::optional<std::size_t> arguments,
                             Reading reading) const;

private:
    enum class Kind { body, trajectory, parameter, joint, gear, spring, rope, contact };
    struct Owner {
        Kind kind;
        std::size_t index;
    };
    [[nodiscard]] Named findAlone(std::string_view name) const;
    [[nodiscard]] Named findOfBody(std::string_view name, std::size_t body,
                                   std::string_view quantity, std::optional<std::size_t> arguments,
                                   Reading reading) const;
    [[nodiscard]] Named findOfTrajectory(std::size_t trajectory, std::string_view quantity) const;
    [[nodiscard]] Named findOfJoint(std::string_view name, std::size_t joint,
                                    std::string_view quantity, Reading reading) const;
    [[nodiscard]] static Named findOfSpring(std::string_view name, std::size_t link,
                                            std::string_view quantity, Reading reading);
    [[nodiscard]] Named findOfRope(std::string_view name, std::size_t rope,
                                   std::string_view quantity, Reading reading) const;
    [[nodiscard]] static Named findOfContact(std::string_view name, std::size_t contact,
                                             std::string_view quantity, Reading reading);
    [[nodiscard]] NameFault unknownOwner(std::string_view owner, std::string_view quantity) const;

    std::map<std::string, Owner, std::less<>> owners_; // all that share the one set of names
    std::vector<JointType> joints_;
    std::vector<std::vector<std::string>> ropes_; // their quantities
};

// --- every expression of a scene ------------------------------------------------------------

struct ExpressionPlace {
    const Expression* text = nullptr; // in the scene
    const Source* source = nullptr;   // of its element
    std::string option;               // "-x"
    std::size_t index = 0;            // which value of the option, where it has several
    Reading reading = Reading::state;
};

[[nodiscard]] std::vector<ExpressionPlace> expressionsOf(const Scene& scene);

// Bytes [from, to) of one expression are wrong.
struct ExpressionFault {
    ExpressionPlace place;
    std::size_t from = 0, to = 0;
    std::string message, suggestion;
};

// Bodies of which one of these expressions reads a turn count it from now on.
void countTurns(Scene& scene, const std::vector<std::string>& expressions);

// All faults, one for each wrong expression, in the order of expressionsOf().
[[nodiscard]] std::vector<ExpressionFault> checkExpressions(const Scene& scene);

} // namespace scene
