// Joints and gears as conditions on places and velocities, which multipliers keep
// (expression/equations.h).
//
// A condition g(q, t) = 0 with the rate  g' = J v + ...  pushes the bodies by J' m, so that it does
// no work; m is a force (conditions on angles are lengths: the angle times the joint's size). With
// d the first point less the second, n the axis and e, f two directions across it, each carried by
// the body (1 or 2) that its index says:
//
//     fixed         d,  n1.e2,  n1.f2,  e1.f2          planar     n1.e2,  n1.f2,  n2.d
//     hinge         d,  n1.e2,  n1.f2                  ball       d
//     slider        e2.d,  f2.d,  n1.e2,  n1.f2, e1.f2 universal  d,  n1.a2   (a2: -axis2)
//     cylindrical   e2.d,  f2.d,  n1.e2,  n1.f2        distance   |d| - its value at the start
//     screw         as cylindrical, and  n2.d - P q / 2 pi
//
// A coordinate is its -from and how far the joint has gone since the start; screws and gears keep
// the latter.
//
// Angles that are not wrapped are unknowns of their own, q' = n2.(w1 - w2), kept with the attitudes
// between steps by a tie (expression/equations.h): c sin q - s cos q = 0, with c = e1.e2 and
// s = e1.f2.
//
// Stops, brakes and motors of limited force are multipliers with bounds.
//
// Contract: docs/scene-language.md, "Joints".
#pragma once

#include "physics/joint_kinematics.h"
#include "physics/joint_multipliers.h"

namespace physics {

class JointReader {
public:
    // Names of joints mean something in the scope from here on.
    JointReader(Graph& g, const scene::Scene& scene, Scope& scope,
                std::span<const BodyMotion> bodies, JointMultipliers& multipliers,
                std::vector<std::string>& faults);

    // Adds the forces of joints to bodies: multipliers, motors, springs.
    void contribute(std::vector<Contribution>& contributions);
    // Of the bodies, to points of their joints.
    void addArms(std::span<BodyMotion> bodies) const;
    // Of the springs of joints.
    [[nodiscard]] const std::vector<Node>& energies() const { return energies_; }

private:
    struct Coordinate {
        std::size_t joint, place;
    };
    void nameJoint(std::size_t joint);
    void keepJoint(std::size_t joint);
    void addForce(std::size_t joint, std::span<const Contribution> contributions);
    void drive(const Coordinate& c);
    [[nodiscard]] Node springOf(const Coordinate& c, const Jet& jet);
    void hold(const Coordinate& c, const Jet& jet);
    void limit(const Coordinate& c);
    void brake(const Coordinate& c, const Jet& jet);
    void keepGear(std::size_t gear);
    void tie(const Coordinate& c);
    void push(Node rate, Node force) { multipliers_.push(*contributions_, from_, rate, force); }
    [[nodiscard]] std::optional<Node> parsed(const Coordinate& c, const scene::Expression& text,
                                             const char* option, scene::Reading reading);
    [[nodiscard]] const scene::JointCoordinate& said(const Coordinate& c) const {
        return scene_.joints[c.joint].coordinates[c.place];
    }
    [[nodiscard]] std::string optionOf(const Coordinate& c, const char* option) const;

    Graph& g_;
    const scene::Scene& scene_;
    Scope& scope_;
    std::span<const BodyMotion> bodies_;
    std::vector<std::string>& faults_;
    JointFrames frames_;
    JointKinematics kinematics_;
    JointMultipliers& multipliers_;
    std::vector<JointNodes> nodes_; // by joint
    std::vector<Node> energies_;
    Contribution from_; // kind and element of what is pushed now
    std::vector<Contribution>* contributions_ = nullptr;
};

} // namespace physics
