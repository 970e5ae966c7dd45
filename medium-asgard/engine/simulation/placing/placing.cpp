#include "placing/placing.h"

#include "placing/overlaps.h"
#include "scene/connections.h"
#include "scene/contact_pairs.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <variant>

namespace simulation {
namespace {

using geometry::Vector;
using Moved = physics::Assembly::Moved;
using Poses = std::vector<geometry::Pose>;

constexpr double untold = 1e-5; // of the radius of the smaller body

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

// By body: it may be moved, and hangs on nothing.
std::vector<char> looseOf(const scene::Scene& scene, const physics::EquationsOfMotion& equations) {
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

// The places of bodies that are moved apart, one heap of bodies that overlap after the other.
class Heaps {
public:
    Heaps(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
          const Poses& start)
        : isLoose_(looseOf(scene, equations)), start_(start), poses_(start) {
        for (const physics::BodyMotion& body : equations.bodies)
            radii_.push_back(body.mass.radius);
    }

    [[nodiscard]] const Poses& poses() const { return poses_; }
    [[nodiscard]] bool isLoose(std::size_t body) const { return isLoose_[body] != 0; }
    [[nodiscard]] bool isStuck(const physics::PartGap& of) const {
        return stuck_.contains(of.first) || stuck_.contains(of.second);
    }
    [[nodiscard]] bool isStuck(std::size_t body) const { return stuck_.contains(body); }

    // False: nothing overlaps. `isLast`: heaps in which something does are stuck.
    bool open(std::vector<physics::PartGap> gaps, bool isLast) {
        std::erase_if(gaps, [this](const physics::PartGap& of) {
            return (!isLoose(of.first) && !isLoose(of.second)) || isStuck(of);
        });
        bool isAny = false;
        for (const auto& [root, heap] : heapsOf(gaps)) {
            const bool overlaps = std::ranges::any_of(heap, [this](const physics::PartGap& of) {
                constexpr double rounding = 1e-14; // of sizes
                return of.gap < -rounding * sizeOf(of);
            });
            isAny = isAny || overlaps;
            if (overlaps && (isLast || !openHeap(heap)))
                leave(heap);
        }
        return isAny;
    }

private:
    // Of places and of the bodies that move: what rounding is a part of.
    [[nodiscard]] double sizeOf(const physics::PartGap& of) const {
        double size = of.at.norm();
        for (const std::size_t body : {of.first, of.second})
            if (isLoose(body))
                size = std::max(size, radii_[body]);
        return size;
    }
    void leave(const std::vector<physics::PartGap>& heap) {
        for (const physics::PartGap& of : heap)
            for (const std::size_t body : {of.first, of.second})
                if (isLoose(body)) {
                    stuck_.insert(body);
                    poses_[body] = start_[body];
                }
    }
    // By the least of the loose bodies that they connect.
    [[nodiscard]] std::map<std::size_t, std::vector<physics::PartGap>>
    heapsOf(const std::vector<physics::PartGap>& gaps) const {
        std::vector<std::size_t> above(isLoose_.size());
        std::iota(above.begin(), above.end(), 0);
        const auto rootOf = [&](std::size_t body) {
            while (above[body] != body)
                body = above[body];
            return body;
        };
        for (const physics::PartGap& of : gaps)
            if (isLoose(of.first) && isLoose(of.second)) {
                const std::size_t a = rootOf(of.first), b = rootOf(of.second);
                above[std::max(a, b)] = std::min(a, b);
            }
        std::map<std::size_t, std::vector<physics::PartGap>> heaps;
        for (const physics::PartGap& of : gaps)
            heaps[rootOf(isLoose(of.first) ? of.first : of.second)].push_back(of);
        return heaps;
    }

    // Hildreth's method: ways as short as they can be, by one force after the other. False: they
    // have not come to an end.
    bool openHeap(const std::vector<physics::PartGap>& gaps) {
        constexpr int most = 4000;
        constexpr double rounding = 1e-16; // of sizes
        std::vector<double> forces(gaps.size(), 0);
        std::map<std::size_t, Vector> ways;
        for (const physics::PartGap& of : gaps)
            for (const std::size_t body : {of.first, of.second})
                if (isLoose(body))
                    ways.emplace(body, Vector::Zero());
        const auto wayOf = [&](std::size_t body) {
            const auto found = ways.find(body);
            return found == ways.end() ? Vector(Vector::Zero()) : found->second;
        };
        bool isOpen = false;
        for (int sweep = 0; sweep < most && !isOpen; ++sweep) {
            isOpen = true;
            for (std::size_t k = 0; k < gaps.size(); ++k) {
                const physics::PartGap& of = gaps[k];
                const double sides = isLoose(of.first) && isLoose(of.second) ? 2 : 1;
                const double left = of.gap + of.normal.dot(wayOf(of.first) - wayOf(of.second));
                const double change = std::max(-left / sides, -forces[k]);
                isOpen = isOpen && std::abs(change) <= rounding * sizeOf(of);
                forces[k] += change;
                if (isLoose(of.first))
                    ways[of.first] += change * of.normal;
                if (isLoose(of.second))
                    ways[of.second] -= change * of.normal;
            }
        }
        for (const auto& [body, way] : ways)
            poses_[body].position += way;
        return isOpen;
    }

    std::vector<char> isLoose_;
    std::vector<double> radii_;
    Poses start_, poses_;
    std::set<std::size_t> stuck_; // loose bodies of heaps without room
};

// The deepest of each pair.
std::map<collision::Pair, double> depthsOf(const std::vector<physics::PartGap>& gaps) {
    std::map<collision::Pair, double> depths;
    for (const physics::PartGap& of : gaps)
        if (double& depth = depths[{of.first, of.second}]; - of.gap > depth)
            depth = -of.gap;
    return depths;
}

} // namespace

std::string overlapSentence(const scene::Scene& scene, const collision::Pair& bodies, double depth,
                            Begin begin) {
    const auto [first, second] =
        scene.bodies[bodies.first].fixed ? collision::Pair(bodies.second, bodies.first) : bodies;
    const auto stands = [&](std::size_t body) {
        return scene.bodies[body].fixed ||
               std::ranges::any_of(scene.constraints, [&](const scene::Constraint& of) {
                   return of.body == scene.bodies[body].name;
               });
    };
    char by[40];
    std::snprintf(by, sizeof by, "%.3g", depth);
    const std::string sentence = "Bodies \"" + scene.bodies[first].name + "\" and \"" +
                                 scene.bodies[second].name + "\" overlap by " + by +
                                 " at the start, and ";
    if (begin == Begin::movedApart)
        return sentence + "begin moved apart; " + physics::partButton + " writes it into the text.";
    return sentence + "pass through each other until they are apart" +
           (stands(first) && stands(second) ? "." : "; " + physics::partAdvice() + ".");
}

std::vector<std::string> startSentences(const scene::Scene& scene) {
    std::vector<std::string> sentences;
    const auto shapes = scene.simulator.collisions ? shapesOf(scene) : std::nullopt;
    const physics::EquationsOfMotion equations(scene, {}, nullptr,
                                               physics::EquationsOfMotion::Start::mayMiss);
    if (!shapes || !equations.faults.empty())
        return sentences;
    const Touching begun = touching(scene, equations, *shapes);
    sentences = begun.notes;
    Overlaps overlaps(scene, equations, *shapes);
    Poses poses = overlaps.startPoses();
    for (const Moved& moved : begun.moved)
        poses[moved.body].position +=
            moved.pose.position - scene.bodies[moved.body].initialPosition;
    for (const auto& [bodies, depth] : depthsOf(overlaps.at(poses, Overlaps::Depth::any)))
        sentences.push_back(overlapSentence(scene, bodies, depth, Begin::throughEachOther));
    std::ranges::copy(hopSentences(scene, equations, *shapes), std::back_inserter(sentences));
    return sentences;
}

std::vector<std::string> hopSentences(const scene::Scene& scene,
                                      const physics::EquationsOfMotion& equations,
                                      const std::vector<geometry::Shape>& shapes) {
    const scene::ContactPairs laws(scene);
    const std::vector<char> isLoose = looseOf(scene, equations);
    std::vector<Vector> pulls(scene.bodies.size(), Vector::Zero());
    for (const scene::Force& force : scene.forces)
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
            for (std::size_t b = 0; b < scene.bodies.size(); ++b)
                if (scene.bodies[b].name == force.body && isLoose[b])
                    pulls[b] += weight->acceleration;
    const auto isPulled = [&](std::size_t body) { return !pulls[body].isZero(0); };
    const Overlaps overlaps(scene, equations, shapes);
    const Poses poses = overlaps.startPoses();
    const auto speedOf = [&](std::size_t body, const Vector& at) -> Vector {
        const scene::Body& said = scene.bodies[body];
        if (said.fixed)
            return Vector::Zero();
        return said.initialVelocity + said.initialAngularVelocity.cross(at - poses[body].position);
    };
    std::map<collision::Pair, double> hops;
    for (const physics::PartGap& of :
         overlaps.narrowGaps(poses, [&](std::size_t first, std::size_t second) {
             return (isPulled(first) || isPulled(second)) && laws.restitutionOf(first, second) == 1;
         })) {
        constexpr double still = 1e-9; // of their speeds
        const Vector one = speedOf(of.first, of.at), other = speedOf(of.second, of.at);
        const bool isDrawn = of.normal.dot(pulls[of.first] - pulls[of.second]) < 0;
        if (isDrawn && std::abs(of.normal.dot(one - other)) <= still * (one.norm() + other.norm()))
            hops[isPulled(of.first) ? collision::Pair(of.first, of.second)
                                    : collision::Pair(of.second, of.first)] = of.gap;
    }
    std::vector<std::string> sentences;
    for (const auto& [bodies, gap] : hops) {
        char by[40];
        std::snprintf(by, sizeof by, "%.3g", gap);
        const std::string& name = scene.bodies[bodies.first].name;
        sentences.push_back("Bodies \"" + name + "\" and \"" + scene.bodies[bodies.second].name +
                            "\" are " + by +
                            " apart at the start, and bounce without loss: they hop for ever; "
                            "with -restitution 0 body \"" +
                            name + "\" rests.");
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
    constexpr int most = 12; // times
    Overlaps overlaps(scene, equations, shapes);
    const Poses start = overlaps.startPoses();
    const auto first = overlaps.at(start, Overlaps::Depth::little);
    Touching all;
    if (first.empty())
        return all;
    // A movement may make an overlap of any depth; those that are deep at the start are the
    // author's.
    const auto little = depthsOf(first),
               before = depthsOf(overlaps.at(start, Overlaps::Depth::any));
    const auto isDeep = [&](const physics::PartGap& of) {
        const collision::Pair pair{of.first, of.second};
        return before.contains(pair) && !little.contains(pair);
    };
    Heaps heaps(scene, equations, start);
    auto gaps = first;
    for (int k = 0; k <= most && heaps.open(gaps, k == most); ++k) {
        gaps = overlaps.at(heaps.poses(), Overlaps::Depth::any);
        std::erase_if(gaps, isDeep);
    }
    for (std::size_t b = 0; b < start.size(); ++b) {
        const Vector way = heaps.poses()[b].position - start[b].position;
        if (!heaps.isStuck(b) && !way.isZero(0))
            all.moved.push_back(
                {b,
                 {scene.bodies[b].initialPosition + way, scene.bodies[b].initialAttitude},
                 way.norm(),
                 false});
    }
    std::vector<physics::PartGap> mended;
    for (const physics::PartGap& of : first)
        if (!heaps.isStuck(of) && (heaps.isLoose(of.first) || heaps.isLoose(of.second)))
            mended.push_back(of);
    const auto radiusOf = [&](std::size_t body) {
        const double radius = equations.bodies[body].mass.radius;
        return radius > 0 ? radius : HUGE_VAL; // of a half space
    };
    for (const auto& [bodies, depth] : depthsOf(mended))
        if (depth > untold * std::min(radiusOf(bodies.first), radiusOf(bodies.second)))
            all.notes.push_back(overlapSentence(scene, bodies, depth, Begin::movedApart));
    return all;
}

} // namespace simulation
