#include "physics/joint_frames.h"

#include "scene/joint_types.h"

#include <algorithm>
#include <cmath>

namespace physics {

using scene::JointType;

namespace {

// The same beside it: what rounding makes of a direction that is along an axis.
Vector cleaned(Vector v) {
    constexpr double rounding = 1e-15;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(v[i]) < rounding)
            v[i] = 0;
    return v;
}

} // namespace

Vector acrossOf(const Vector& n) {
    Eigen::Index least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vector axis = Vector::Unit(least);
    return cleaned((axis - n * n.dot(axis)).normalized());
}

JointFrames::JointFrames(Graph& g, const scene::Scene& scene, const Scope& scope,
                         std::span<const BodyMotion> bodies, std::vector<std::string>& faults)
    : scope_(scope), bodies_(bodies), faults_(faults), start_(g, scene, scope) {
    for (const scene::Joint& joint : scene.joints)
        frames_.push_back(frameOf(joint));
    for (std::size_t j = 0; j < frames_.size() && faults_.empty(); ++j)
        findStart(g, j, scene.joints[j]);
}

std::optional<std::size_t> JointFrames::bodyNamed(const std::string& name) const {
    const auto found = std::ranges::find(bodies_, name, &BodyMotion::name);
    return found == bodies_.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - bodies_.begin()));
}

geometry::Pose JointFrames::poseOf(const JointEnd& end) {
    return end.body ? start_.poseOf(*end.body)
                    : geometry::Pose{Vector::Zero(), Quaternion::Identity()};
}

JointFrame JointFrames::frameOf(const scene::Joint& joint) {
    JointFrame frame;
    auto& [first, second] = frame.ends;
    const auto find = [&](JointEnd& end, const std::string& name) {
        end.body = bodyNamed(name);
        if (!end.body)
            faults_.push_back("joint \"" + joint.name + "\": no body named \"" + name + "\"");
    };
    find(first, joint.body1);
    if (joint.body2)
        find(second, *joint.body2);
    if (!faults_.empty())
        return frame;
    first.arm = scope_.armTo(*first.body, joint.offset1);
    const geometry::Pose one = poseOf(first), two = poseOf(second);
    const Vector point = one.position + one.attitude * first.arm;
    if (joint.offset2)
        second.arm = second.body ? scope_.armTo(*second.body, joint.offset2) : *joint.offset2;
    else if (joint.type != JointType::distance)
        second.arm = cleaned(two.attitude.conjugate() * (point - two.position));
    findAxes(joint, frame);
    frame.size = sizeOf(frame);
    return frame;
}

// docs/scene-language.md, "Joints": which axis belongs to which body.
void JointFrames::findAxes(const scene::Joint& joint, JointFrame& frame) {
    auto& [first, second] = frame.ends;
    const Quaternion one = poseOf(first).attitude, two = poseOf(second).attitude;
    first.axis = joint.axis.isZero(0) ? Vector(Vector::UnitZ()) : Vector(joint.axis.normalized());
    Vector axis = cleaned(one * first.axis);
    const auto refuseParallel = [&](const Vector& other) {
        constexpr double parallel = 1e-6;
        if (axis.cross(other).norm() < parallel)
            faults_.push_back(
                "joint \"" + joint.name + "\": -axis and -axis2 are parallel, and a " +
                std::string(scene::traitsOf(joint.type).name) + " joint wants two directions");
    };
    if (joint.type == JointType::universal) {
        const Vector other =
            joint.axis2 ? cleaned(two * joint.axis2->normalized()) : acrossOf(axis);
        refuseParallel(other);
        second.axis = cleaned(two.conjugate() * other);
        first.across = cleaned(one.conjugate() * other);
        second.across = cleaned(two.conjugate() * axis);
        return;
    }
    if (joint.axis2 && joint.type != JointType::planar)
        axis = cleaned(two * joint.axis2->normalized());
    Vector across = acrossOf(axis);
    if (joint.type == JointType::planar) {
        Vector along = joint.axis2 ? Vector(two * *joint.axis2) : Vector(two * Vector::UnitX());
        if (!joint.axis2 && along.cross(axis).norm() < 1e-9)
            along = two * Vector::UnitY();
        refuseParallel(along.normalized());
        across = cleaned((along - axis * axis.dot(along)).normalized());
    }
    const Vector third = cleaned(axis.cross(across));
    second.axis = cleaned(two.conjugate() * axis);
    for (JointEnd* const end : {&first, &second}) {
        const Quaternion back = poseOf(*end).attitude.conjugate();
        end->across = cleaned(back * across);
        end->third = cleaned(back * third);
    }
}

double JointFrames::sizeOf(const JointFrame& frame) {
    constexpr double ofDistance = 1e-4; // from the origin
    double size = 0;
    for (const JointEnd& end : frame.ends) {
        if (end.body)
            size = std::max({size, bodies_[*end.body].mass.radius, end.arm.norm()});
        const geometry::Pose pose = poseOf(end);
        size = std::max(size, ofDistance * (pose.position + pose.attitude * end.arm).norm());
    }
    return size;
}

std::vector<std::size_t> JointFrames::moving(std::size_t joint) const {
    const JointFrame& frame = frames_[joint];
    std::vector<std::size_t> moving;
    for (const JointEnd& end : frame.ends)
        if (end.body && !bodies_[*end.body].isFixed)
            moving.push_back(*end.body);
    return moving;
}

// The symbols of its angles, and what its lengths are at the start.
void JointFrames::findStart(Graph& g, std::size_t joint, const scene::Joint& said) {
    JointFrame& frame = frames_[joint];
    const auto kinds = scene::traitsOf(said.type).coordinates;
    const auto& [first, second] = frame.ends;
    const geometry::Pose one = poseOf(first), two = poseOf(second);
    const Vector d =
        one.position + one.attitude * first.arm - two.position - two.attitude * second.arm;
    frame.start.assign(std::max<std::size_t>(kinds.size(), 1), 0);
    if (said.type == JointType::distance) {
        frame.start[0] = d.norm();
        if (!(frame.start[0] > 0))
            faults_.push_back("joint \"" + said.name +
                              "\": its points are in one place, and their distance has no "
                              "direction; a joint of type ball holds two points together");
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const bool isAngle = kinds[k] == scene::CoordinateKind::angle;
        const bool isOwnUnknown = isAngle && said.type != JointType::ball;
        frame.angles.push_back(
            isOwnUnknown && !moving(joint).empty()
                ? g.symbol(said.name + ".q" + scene::coordinateSuffix(said.type, k))
                : g.constant(0));
        const bool isInPlane = said.type == JointType::planar;
        const Vector direction = isInPlane && k == 0   ? second.across
                                 : isInPlane && k == 1 ? second.third
                                                       : second.axis;
        if (said.type != JointType::distance && !isAngle)
            frame.start[k] = (two.attitude * direction).dot(d);
    }
    if (said.type == JointType::screw)
        frame.start[0] = (two.attitude * second.axis).dot(d);
}

} // namespace physics
