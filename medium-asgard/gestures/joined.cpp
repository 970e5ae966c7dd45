#include "gestures/joined.h"

#include <algorithm>

namespace gestures {

using editing::Kind;
using editing::Wish;
using geometry::Vector;
using physics::Pulling;

Joined::Joined(const scene::Scene& scene, std::size_t body, const Vector& grabbed)
    : scene_(scene), grabbed_(grabbed), pulling_(scene, body, grabbed) {}

std::unique_ptr<Joined> Joined::of(const scene::Scene& scene, std::size_t body,
                                   const Vector& grabbed) {
    const std::string& name = scene.bodies[body].name;
    const bool isNamed =
        std::ranges::any_of(scene.joints,
                            [&](const scene::Joint& joint) {
                                return joint.body1 == name || joint.body2 == name;
                            }) ||
        std::ranges::any_of(scene.ropes, [&](const scene::Rope& rope) {
            return std::ranges::find(rope.points, name, &scene::Rope::Point::body) !=
                   rope.points.end();
        });
    if (!isNamed)
        return nullptr;
    std::unique_ptr<Joined> made(new Joined(scene, body, grabbed));
    return made->pulling_.isJoined() ? std::move(made) : nullptr;
}

void Joined::pull(const Vector& way) {
    way_.reset();
    pulling_.pullTo(grabbed_ + way);
}

void Joined::moveAll(const Vector& way) { way_ = way; }

geometry::Pose Joined::poseOf(std::size_t body) const {
    geometry::Pose pose{scene_.bodies[body].initialPosition, scene_.bodies[body].initialAttitude};
    if (way_) {
        pose.position += *way_;
        return pose;
    }
    for (const physics::Assembly::Moved& moved : pulling_.moved())
        if (moved.body == body)
            return moved.pose;
    return pose;
}

std::vector<Pulling::Velocity> Joined::turnedVelocities() const {
    std::vector<Pulling::Velocity> velocities;
    for (const std::size_t body : pulling_.bodies()) {
        const scene::Body& said = scene_.bodies[body];
        const geometry::Quaternion turn = poseOf(body).attitude * said.initialAttitude.conjugate();
        velocities.push_back(
            {body, turn * said.initialVelocity, turn * said.initialAngularVelocity});
    }
    return velocities;
}

std::vector<editing::NewPlace> Joined::places() {
    std::vector<editing::NewPlace> places;
    if (way_) {
        for (const std::size_t body : pulling_.bodies())
            places.push_back({body, poseOf(body)});
        return places;
    }
    for (const physics::Assembly::Moved& moved : pulling_.moved())
        places.push_back({moved.body, moved.pose, moved.turns});
    const auto before = turnedVelocities();
    const bool rests = std::ranges::all_of(before, [](const Pulling::Velocity& one) {
        return one.linear.isZero(0) && one.angular.isZero(0);
    });
    if (rests)
        return places;
    const auto after = pulling_.velocities(before, std::nullopt);
    for (editing::NewPlace& place : places)
        for (const Pulling::Velocity& one : after)
            if (one.body == place.body)
                place.velocity = {one.linear, one.angular};
    return places;
}

std::vector<editing::NewPlace> Joined::thrown(const std::optional<Vector>& ofHand) {
    std::vector<editing::NewPlace> places;
    for (const Pulling::Velocity& one : pulling_.velocities(turnedVelocities(), ofHand))
        places.push_back({one.body, poseOf(one.body), true, {{one.linear, one.angular}}});
    return places;
}

// The points of the world, and of bodies that stay, that joints hold them by.
void Joined::addHolds(std::vector<Wish>& wishes) const {
    const auto& bodies = pulling_.bodies();
    const auto moves = [&](const std::string& name) {
        return std::ranges::any_of(
            bodies, [&](std::size_t body) { return scene_.bodies[body].name == name; });
    };
    const auto add = [&](std::size_t joint, const char* option, const scene::Body* stays,
                         const Vector& now) {
        const Vector way = stays ? Vector(stays->initialAttitude.conjugate() * *way_) : *way_;
        const Vector place = now + way;
        wishes.push_back({.element = {Kind::joint, joint},
                          .option = option,
                          .path = {},
                          .values = {place.x(), place.y(), place.z()},
                          .absent = {now.x(), now.y(), now.z()},
                          .offers = false});
    };
    for (std::size_t k = 0; k < scene_.joints.size(); ++k) {
        const scene::Joint& joint = scene_.joints[k];
        const bool first = moves(joint.body1), second = joint.body2 && moves(*joint.body2);
        if (first && !second && joint.offset2)
            add(k, "-offset2", joint.body2 ? scene::findBody(scene_, *joint.body2) : nullptr,
                *joint.offset2);
        else if (second && !first && joint.offset1)
            add(k, "-offset1", scene::findBody(scene_, joint.body1), *joint.offset1);
    }
}

std::vector<Wish> Joined::wishes(const editing::Mapper& mapper) {
    std::vector<Wish> wishes;
    for (const editing::NewPlace& place : places())
        std::ranges::move(editing::wishesOf(mapper, place), std::back_inserter(wishes));
    if (way_)
        addHolds(wishes);
    return wishes;
}

} // namespace gestures
