#include "gestures/joined.h"

#include <algorithm>

namespace gestures {

using editing::Kind;
using editing::Wish;
using geometry::Vector;
using physics::Pulling;

Joined::Joined(const scene::Scene& scene, std::size_t body, const Vector& grabbed)
    : scene_(scene), body_(body), grabbed_(grabbed), pulling_(scene, body, grabbed) {}

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
    return made->pulling_.state() == Pulling::State::free ? nullptr : std::move(made);
}

std::string Joined::holderOf() const {
    for (const scene::Joint& joint : scene_.joints)
        if (joint.body1 == name() || joint.body2 == name())
            return "joint \"" + joint.name + "\"";
    return "a rope";
}

std::string Joined::together() const {
    return "\"" + name() + "\" hangs together with " + std::to_string(bodies().size() - 1) +
           " other bodies";
}

std::string Joined::whyNotPulled() const {
    if (!areTooMany())
        return {};
    return together() + ": a hand pulls " + std::to_string(Pulling::most) +
           " at most. Along an axis all of them move (x, y or z).";
}

std::string Joined::whyNotTurned(char axis) const {
    if (areTooMany())
        return together() + ": a hand turns " + std::to_string(Pulling::most) + " at most.";
    return "\"" + name() + "\" is held by " + holderOf() + ": it does not turn so about " + axis +
           ".";
}

std::string Joined::whyNotThrown() const {
    if (areTooMany())
        return together() + ": a hand throws " + std::to_string(Pulling::most) + " at most.";
    if (pulling_.isStuck())
        return "\"" + name() + "\" is held by " + holderOf() + ": nothing lets it go anywhere.";
    if (movesAsOne() && !isLoose())
        return "\"" + name() + "\" is held by " + holderOf() +
               " where it is taken: take it further away from there.";
    return {};
}

void Joined::pull(const Vector& way) {
    way_.reset();
    pulling_.pullTo(grabbed_ + way);
    if (!isRight_)
        return;
    if (isRight_(*this)) {
        rightWay_ = way;
        return;
    }
    Vector wrong = way;
    for (int halvings = 24; halvings > 0; --halvings) {
        const Vector middle = (rightWay_ + wrong) / 2;
        pulling_.pullTo(grabbed_ + middle);
        (isRight_(*this) ? rightWay_ : wrong) = middle;
    }
    pulling_.pullTo(grabbed_ + rightWay_);
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

std::vector<Pulling::Velocity> Joined::writtenVelocities() const {
    std::vector<Pulling::Velocity> velocities;
    for (const std::size_t body : pulling_.bodies()) {
        const scene::Body& said = scene_.bodies[body];
        velocities.push_back({body, said.initialVelocity, said.initialAngularVelocity});
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
    const auto before = writtenVelocities();
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
    for (const Pulling::Velocity& one : pulling_.velocities(writtenVelocities(), ofHand))
        places.push_back({one.body, poseOf(one.body), true, {{one.linear, one.angular}}});
    return places;
}

bool Joined::moves(const std::string& body) const {
    const auto isIt = [&](std::size_t one) { return scene_.bodies[one].name == body; };
    return std::ranges::any_of(bodies(), isIt) || std::ranges::any_of(others_, isIt);
}

Wish Joined::holdOf(const editing::Element& element, const char* option,
                    const std::optional<std::string>& body, const Vector& now) const {
    Vector way = *way_;
    if (body)
        if (const scene::Body* stays = scene::findBody(scene_, *body))
            way = stays->initialAttitude.conjugate() * way;
    const Vector place = now + way;
    return {.element = element,
            .option = option,
            .path = {},
            .values = {place.x(), place.y(), place.z()},
            .absent = {now.x(), now.y(), now.z()},
            .now = {now.x(), now.y(), now.z()},
            .offers = false};
}

// The points of the world, and of bodies that stay, that joints and ropes hold them by.
void Joined::addHolds(std::vector<Wish>& wishes) const {
    for (std::size_t k = 0; k < scene_.joints.size(); ++k) {
        const scene::Joint& joint = scene_.joints[k];
        const bool first = moves(joint.body1), second = joint.body2 && moves(*joint.body2);
        // Without it the point of the second body is where that of the first is.
        const bool hasSecond =
            joint.offset2 || (joint.body2 && joint.type == scene::JointType::distance);
        if (first && !second && hasSecond)
            wishes.push_back(
                holdOf({Kind::joint, k}, "-offset2", joint.body2,
                       joint.offset2 ? *joint.offset2 : pulling_.centreOf(*joint.body2)));
        else if (second && !first)
            wishes.push_back(
                holdOf({Kind::joint, k}, "-offset1", joint.body1,
                       joint.offset1 ? *joint.offset1 : pulling_.centreOf(joint.body1)));
    }
    addRopeHolds(wishes);
}

void Joined::addRopeHolds(std::vector<Wish>& wishes) const {
    for (std::size_t k = 0; k < scene_.ropes.size(); ++k) {
        const auto& points = scene_.ropes[k].points;
        if (!scene_.ropes[k].length || std::ranges::none_of(points, [&](const auto& point) {
                return point.body && moves(*point.body);
            }))
            continue;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!points[i].place || (points[i].body && moves(*points[i].body)))
                continue;
            Wish wish = holdOf({Kind::rope, k}, "-points", points[i].body, *points[i].place);
            wish.path = {i};
            if (points[i].body)
                wish.path.push_back(1);
            wishes.push_back(std::move(wish));
        }
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
