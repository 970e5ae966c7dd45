#include "placing/overlaps.h"

#include "collision/box_tree.h"
#include "collision/contact_points.h"
#include "collision/separation.h"
#include "physics/carried_points.h"
#include "scene/connections.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using geometry::Part;
using geometry::Pose;
using geometry::Vector;
using physics::PartGap;

constexpr double touches = 1e-8; // of the smaller part
constexpr double little = 1e-3;  // of the smaller part

constexpr std::size_t mostPlaces = 8; // of a patch

// Of the body's frame.
Pose frameOf(const physics::BodyMotion& body, const Pose& centre) {
    return {centre.position - centre.attitude * body.mass.centroid, centre.attitude};
}

geometry::Box boxOf(const geometry::Shape& shape, const Pose& frame) {
    if (std::ranges::any_of(shape.parts, &Part::isPlane))
        return {Vector::Constant(-collision::everywhere), Vector::Constant(collision::everywhere)};
    return geometry::bounds(shape, frame);
}

double sizeOf(const Part& part) {
    return part.isPlane() ? HUGE_VAL : geometry::bounds(geometry::Shape{{part}}).diagonal().norm();
}

} // namespace

std::vector<char> looseBodies(const scene::Scene& scene,
                              const physics::EquationsOfMotion& equations) {
    const scene::Connections connections(scene);
    std::vector<char> all;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const physics::BodyMotion& body = equations.bodies[b];
        const physics::Held& held = body.heldAt(scene.simulator.start);
        const bool isHeld = held.attitude || std::ranges::count(held.position, true) > 0;
        all.push_back(!body.isFixed && !isHeld && connections.joints.of(b).empty() &&
                      connections.gears.of(b).empty() && connections.ropes.of(b).empty());
    }
    return all;
}

Overlaps::Overlaps(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                   const std::vector<geometry::Shape>& shapes)
    : scene_(scene), equations_(equations), shapes_(shapes), mayMeet_(scene) {}

std::vector<Pose> Overlaps::startPoses() const {
    const double start = scene_.simulator.start;
    std::vector<Pose> poses;
    bool isAnyHeld = false;
    for (const physics::BodyMotion& body : equations_.bodies) {
        poses.push_back(body.start);
        const auto* held = body.isFixed ? nullptr : &body.heldAt(start);
        isAnyHeld =
            isAnyHeld || (held && (held->attitude || std::ranges::count(held->position, true) > 0));
    }
    if (!isAnyHeld)
        return poses;
    std::vector<double> values{start};
    for (const expression::Unknown& unknown : equations_.set.unknowns)
        values.push_back(unknown.initial);
    physics::putGiven(equations_.set.graph, equations_.set, start, values);
    for (std::size_t b = 0; b < poses.size(); ++b)
        if (const physics::BodyMotion& body = equations_.bodies[b]; !body.isFixed) {
            const auto of = body.valuesOf(
                std::span(values).subspan(1 + body.firstUnknown).first<physics::bodyUnknowns>());
            poses[b] = {of.position, of.attitude};
        }
    return poses;
}

std::pair<collision::Posed, collision::Posed>
Overlaps::posed(const Parts& parts, const std::vector<Pose>& poses) const {
    const auto [a, i, b, j] = parts;
    const Vector origin = poses[b].position;
    const auto of = [&](const Part& part, std::size_t body) {
        const Pose frame = frameOf(equations_.bodies[body], poses[body]);
        return collision::Posed{&part, frame.attitude.toRotationMatrix(), frame.position - origin};
    };
    return {of(shapes_[a].parts[i], a), of(shapes_[b].parts[j], b)};
}

void Overlaps::look(const Parts& parts, const std::vector<Pose>& poses, Depth depth,
                    std::vector<PartGap>& found) {
    const auto [a, i, b, j] = parts;
    const Part &first = shapes_[a].parts[i], &second = shapes_[b].parts[j];
    if (first.isPlane() && second.isPlane())
        return;
    const auto [one, other] = posed(parts, poses);
    collision::WarmStart warm;
    const collision::Separation apart = collision::separate(one, other, warm);
    const double size = std::min(sizeOf(first), sizeOf(second));
    const double most = depth == Depth::any ? HUGE_VAL : little * size;
    const bool isNew = !told_.contains(parts);
    if (isNew && !(apart.gap < -touches * size && apart.gap >= -most))
        return;
    if (isNew)
        told_.insert(parts);
    std::vector<Vector> places;
    if (apart.touch)
        places.push_back(*apart.touch);
    else
        places = collision::contactPoints(one, other, std::abs(apart.gap)).points;
    const std::size_t step = 1 + places.size() / mostPlaces;
    for (std::size_t k = 0; k < places.size(); k += step)
        found.push_back({a, b, apart.gap, apart.normal, poses[b].position + places[k], i, j});
}

std::vector<PartGap> Overlaps::at(const std::vector<Pose>& poses, Depth depth) {
    std::vector<PartGap> found;
    const std::set<Parts> before = told_;
    for (const Parts& parts : before)
        look(parts, poses, depth, found);
    collision::BoxTree tree(poses.size());
    std::vector<std::size_t> near;
    for (std::size_t b = 0; b < poses.size(); ++b) {
        const geometry::Box box = boxOf(shapes_[b], frameOf(equations_.bodies[b], poses[b]));
        near.clear();
        tree.overlapping(box, near);
        std::ranges::sort(near);
        for (const std::size_t a : near)
            if (mayMeet_(a, b))
                for (std::size_t i = 0; i < shapes_[a].parts.size(); ++i)
                    for (std::size_t j = 0; j < shapes_[b].parts.size(); ++j)
                        if (const Parts parts{a, i, b, j}; !before.contains(parts))
                            look(parts, poses, depth, found);
        tree.put(b, box);
    }
    return found;
}

std::vector<PartGap> Overlaps::nearGaps(const std::vector<Pose>& poses, Near near,
                                        const Asked& isAsked) const {
    std::vector<PartGap> found;
    const auto look = [&](std::size_t a, std::size_t b) {
        for (std::size_t i = 0; i < shapes_[a].parts.size(); ++i)
            for (std::size_t j = 0; j < shapes_[b].parts.size(); ++j) {
                const Part &first = shapes_[a].parts[i], &second = shapes_[b].parts[j];
                if (first.isPlane() && second.isPlane())
                    continue;
                const auto [one, other] = posed({a, i, b, j}, poses);
                collision::WarmStart warm;
                const collision::Separation apart = collision::separate(one, other, warm);
                const double size = std::min(sizeOf(first), sizeOf(second));
                const double least = near == Near::apart ? touches : -little;
                if (apart.gap <= least * size || apart.gap > little * size)
                    continue;
                const auto places =
                    collision::contactPoints(one, other, std::abs(apart.gap)).points;
                const Vector at = apart.touch      ? *apart.touch
                                  : places.empty() ? Vector(Vector::Zero())
                                                   : places.front();
                found.push_back({a, b, apart.gap, apart.normal, poses[b].position + at, i, j});
            }
    };
    collision::BoxTree tree(poses.size());
    std::vector<std::size_t> beside;
    for (std::size_t b = 0; b < poses.size(); ++b) {
        geometry::Box box = boxOf(shapes_[b], frameOf(equations_.bodies[b], poses[b]));
        const Vector margin = Vector::Constant(little * box.diagonal().norm());
        box = geometry::Box(box.min() - margin, box.max() + margin);
        beside.clear();
        tree.overlapping(box, beside);
        std::ranges::sort(beside);
        for (const std::size_t a : beside)
            if (mayMeet_(a, b) && isAsked(a, b))
                look(a, b);
        tree.put(b, box);
    }
    return found;
}

} // namespace simulation
