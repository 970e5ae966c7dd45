#include "framing/joint_places.h"

#include "framing/body_places.h"

#include <cmath>

namespace render {

using scene::JointType;

JointPlaces::JointPlaces(const scene::Scene& scene, const simulation::Motion* motion)
    : scene_(scene), motion_(motion) {
    if (!scene.joints.empty())
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            bodies_.emplace(scene.bodies[i].name, i);
}

Vector JointPlaces::centerOf(std::size_t body) const {
    const bool isKnown = motion_ != nullptr && body < motion_->bodies();
    return isKnown ? motion_->centroid(body) : Vector::Zero();
}

std::optional<JointEnd> JointPlaces::endOn(const std::string& body, double time) const {
    const auto found = bodies_.find(body);
    if (found == bodies_.end())
        return std::nullopt;
    JointEnd end;
    end.body = found->second;
    end.pose = poseOf(scene_, motion_, *end.body, time);
    end.start = poseOf(scene_, nullptr, *end.body, time);
    end.offset = centerOf(*end.body);
    return end;
}

std::optional<JointPlace> JointPlaces::at(const scene::Joint& joint, double time) const {
    JointPlace place;
    auto& [first, second] = place.ends;
    const auto one = endOn(joint.body1, time);
    const auto two = joint.body2 ? endOn(*joint.body2, time) : std::optional<JointEnd>(JointEnd{});
    if (!one || !two)
        return std::nullopt;
    first = *one;
    second = *two;
    const Vector center = first.start.toWorld(first.offset);
    first.offset = joint.offset1.value_or(first.offset);
    const Vector start = first.start.toWorld(first.offset);
    if (joint.offset2)
        second.offset = *joint.offset2;
    else if (joint.type != JointType::distance)
        second.offset = second.start.toLocal(start);
    first.point = first.pose.toWorld(first.offset);
    second.point = second.pose.toWorld(second.offset);
    place.apart = start - second.start.toWorld(second.offset);
    place.towards = center - start;
    if (joint.axis.norm() > 0)
        place.axis = first.start.attitude * joint.axis.normalized();
    else if (joint.type == JointType::hinge || joint.type == JointType::planar)
        place.axis = first.start.attitude * Vector::UnitZ();
    return place;
}

Vector JointPlace::unturned() const {
    const Vector across = towards - axis * axis.dot(towards);
    return across.norm() > 1e-9 * (1 + towards.norm()) ? across.normalized() : acrossOf(axis);
}

Vector acrossOf(const Vector& n) {
    Eigen::Index least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vector axis = Vector::Unit(least);
    return (axis - n * n.dot(axis)).normalized();
}

double gapOf(const scene::Joint& joint, const JointPlace& place) {
    const auto& [first, second] = place.ends;
    const Vector axis = second.carried(place.axis);
    const auto kept = [&](const Vector& d, const Vector& n) -> double {
        switch (joint.type) {
        case JointType::slider:
        case JointType::cylindrical:
        case JointType::screw:
            return (d - n * n.dot(d)).norm();
        case JointType::planar:
            return std::abs(n.dot(d));
        case JointType::distance:
            return joint.coordinates.empty() || !joint.coordinates[0].isGiven ? d.norm() : 0;
        default:
            return d.norm();
        }
    };
    return std::abs(kept(first.point - second.point, axis) - kept(place.apart, place.axis));
}

std::vector<Vector> jointAnchorsOf(const scene::Scene& scene, const simulation::Motion* motion) {
    std::vector<Vector> anchors;
    const JointPlaces places(scene, motion);
    for (const scene::Joint& joint : scene.joints)
        if (const auto place = joint.body2 ? std::nullopt : places.at(joint, 0))
            anchors.push_back(place->ends[1].point);
    std::erase_if(anchors, [](const Vector& anchor) { return !anchor.allFinite(); });
    return anchors;
}

} // namespace render
