#include "placing/placing.h"

#include "placing/overlaps.h"
#include "scene/part_of.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace simulation {
namespace {

using Moved = physics::Assembly::Moved;
using Poses = std::vector<geometry::Pose>;

constexpr double untold = 1e-5; // of the scene's size, as a joint may miss

// None: a body has no shape, which is told elsewhere.
std::optional<std::vector<geometry::Shape>> shapesOf(const scene::Scene& scene) {
    scene::ShapeReader reader;
    std::vector<geometry::Shape> shapes;
    for (const scene::Body& body : scene.bodies) {
        const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
        if (!set)
            return std::nullopt;
        const auto& made = reader.of(*set);
        if (!std::holds_alternative<geometry::Shape>(made))
            return std::nullopt;
        shapes.push_back(std::get<geometry::Shape>(made));
    }
    return shapes;
}

// Bodies that hang together, or overlap, with all that are fixed; in the scene's order.
std::vector<std::vector<std::size_t>> clustersOf(const scene::Version& version,
                                                 const std::vector<physics::PartGap>& overlaps) {
    const scene::Scene& scene = *version.scene;
    std::vector<std::size_t> cluster = version.connections.group;
    std::vector<char> isMoved(scene.bodies.size(), 0);
    for (const physics::PartGap& of : overlaps) {
        if (!scene.bodies[of.first].fixed && !scene.bodies[of.second].fixed)
            std::ranges::replace(cluster, std::size_t{cluster[of.second]}, cluster[of.first]);
        isMoved[of.first] = isMoved[of.second] = 1;
    }
    std::map<std::size_t, std::vector<std::size_t>> bodies;
    for (std::size_t b = 0; b < cluster.size(); ++b)
        if (isMoved[b] != 0 && !scene.bodies[b].fixed)
            bodies[cluster[b]];
    for (std::size_t b = 0; b < cluster.size(); ++b)
        for (auto& [root, of] : bodies)
            if (scene.bodies[b].fixed || cluster[b] == root)
                of.push_back(b);
    std::vector<std::vector<std::size_t>> all;
    for (auto& [root, of] : bodies)
        all.push_back(std::move(of));
    return all;
}

std::vector<Moved> movedIn(const scene::Scene& scene) {
    const auto shapes = shapesOf(scene);
    const physics::EquationsOfMotion equations(scene, {}, nullptr,
                                               physics::EquationsOfMotion::Start::mayMiss);
    if (!shapes || !equations.faults.empty())
        return {};
    Overlaps overlaps(scene, equations, *shapes);
    physics::Assembly made = physics::assembled(scene, nullptr, [&](const Poses& poses) {
        return overlaps.at(poses, Overlaps::Depth::little);
    });
    return made.reason.empty() ? std::move(made.moved) : std::vector<Moved>();
}

} // namespace

std::string overlapSentence(const scene::Scene& scene, const collision::Pair& bodies, double depth,
                            Begin begin) {
    const auto [first, second] =
        scene.bodies[bodies.first].fixed ? collision::Pair(bodies.second, bodies.first) : bodies;
    char by[40];
    std::snprintf(by, sizeof by, "%.3g", depth);
    return "Bodies \"" + scene.bodies[first].name + "\" and \"" + scene.bodies[second].name +
           "\" overlap by " + by + " at the start, and " +
           (begin == Begin::movedApart
                ? std::string("begin moved apart by that; ") + physics::partButton +
                      " writes it into the text."
                : "pass through each other until they are apart; " + physics::partAdvice() + ".");
}

std::vector<std::string> overlapSentences(const scene::Scene& scene) {
    std::vector<std::string> sentences;
    const auto shapes = scene.simulator.collisions ? shapesOf(scene) : std::nullopt;
    const physics::EquationsOfMotion equations(scene, {}, nullptr,
                                               physics::EquationsOfMotion::Start::mayMiss);
    if (!shapes || !equations.faults.empty())
        return sentences;
    Overlaps overlaps(scene, equations, *shapes);
    const Poses poses = overlaps.startPoses();
    std::map<collision::Pair, double> little, all;
    for (auto* depths : {&little, &all})
        for (const physics::PartGap& of :
             overlaps.at(poses, depths == &little ? Overlaps::Depth::little : Overlaps::Depth::any))
            (*depths)[{of.first, of.second}] = std::max((*depths)[{of.first, of.second}], -of.gap);
    for (const auto& [bodies, depth] : all) {
        const bool isLittle = little.contains(bodies) && little[bodies] == depth;
        if (!isLittle || depth > untold * overlaps.size())
            sentences.push_back(overlapSentence(
                scene, bodies, depth, isLittle ? Begin::movedApart : Begin::throughEachOther));
    }
    return sentences;
}

physics::Assembly placed(const scene::Scene& scene, const std::function<bool()>& cancelled) {
    const auto shapes = scene.simulator.collisions ? shapesOf(scene) : std::nullopt;
    if (!shapes)
        return physics::assembled(scene, cancelled);
    const physics::EquationsOfMotion equations(scene, {}, nullptr,
                                               physics::EquationsOfMotion::Start::mayMiss);
    Overlaps overlaps(scene, equations, *shapes);
    return physics::assembled(scene, cancelled, [&](const Poses& poses) {
        return overlaps.at(poses, Overlaps::Depth::any);
    });
}

Touching touching(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                  const std::vector<geometry::Shape>& shapes) {
    Overlaps overlaps(scene, equations, shapes);
    const auto found = overlaps.at(overlaps.startPoses(), Overlaps::Depth::little);
    Touching all;
    if (found.empty())
        return all;
    std::vector<char> isMoved(scene.bodies.size(), 0);
    const scene::Version version(std::make_shared<const scene::Scene>(scene));
    for (const std::vector<std::size_t>& bodies : clustersOf(version, found)) {
        for (Moved moved : movedIn(scene::partOf(version, bodies))) {
            moved.body = bodies[moved.body];
            isMoved[moved.body] = 1;
            all.moved.push_back(moved);
        }
    }
    for (const physics::PartGap& of : found)
        if (-of.gap > untold * overlaps.size() && (isMoved[of.first] || isMoved[of.second]))
            all.notes.push_back(
                overlapSentence(scene, {of.first, of.second}, -of.gap, Begin::movedApart));
    return all;
}

} // namespace simulation
