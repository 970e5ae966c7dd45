#include "placing/placing.h"

#include "placing/hops.h"
#include "placing/least_ways.h"
#include "placing/overlaps.h"
#include "placing/told_heaps.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <cmath>
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

// The places of bodies that are moved apart, one heap of bodies that overlap after the other.
class Heaps {
public:
    Heaps(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
          const Poses& start)
        : isLoose_(looseBodies(scene, equations)), start_(start), poses_(start) {
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

    // False: the ways have not come to an end.
    bool openHeap(const std::vector<physics::PartGap>& gaps) {
        constexpr int most = 4000;
        constexpr double rounding = 1e-16; // of sizes
        const LeastWays least = leastWays(gaps, isLoose_, most,
                                          [this](const auto& of) { return rounding * sizeOf(of); });
        for (const auto& [body, way] : least.ways)
            poses_[body].position += way;
        return least.isDone;
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

std::vector<std::string> overlapSentences(const scene::Scene& scene,
                                          const std::map<collision::Pair, double>& depths,
                                          Begin begin) {
    std::vector<std::string> sentences;
    for (const ToldHeap& heap : toldHeaps(scene, depths)) {
        const std::string sentence = bodiesOf(scene, heap.first) + " overlap by " +
                                     lengthOf(heap.size) + " at the start, and " +
                                     othersOf(scene, heap, "no deeper");
        const auto stands = [&](const collision::Pair& pair) {
            return isHeld(scene, pair.first) && isHeld(scene, pair.second);
        };
        const std::vector<std::size_t> bodies = bodiesIn(heap);
        if (begin == Begin::movedApart) {
            const auto why = physics::madeAtOnce(scene, bodies);
            sentences.push_back(
                sentence + "begin moved apart; " +
                (why ? "the text stays as it is, since " + *why
                     : physics::partButton + std::string(" writes it into the text")) +
                ".");
        } else {
            sentences.push_back(sentence + "pass through each other until they are apart" +
                                (stands(heap.first) && std::ranges::all_of(heap.others, stands)
                                     ? "."
                                     : "; " + physics::partAdvice(scene, bodies) + "."));
        }
    }
    return sentences;
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
    std::ranges::copy(overlapSentences(scene, depthsOf(overlaps.at(poses, Overlaps::Depth::any)),
                                       Begin::throughEachOther),
                      std::back_inserter(sentences));
    std::ranges::copy(hopSentences(scene, equations, *shapes), std::back_inserter(sentences));
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
    auto told = depthsOf(mended);
    std::erase_if(told, [&](const auto& of) {
        const auto& [bodies, depth] = of;
        return depth <= untold * std::min(radiusOf(bodies.first), radiusOf(bodies.second));
    });
    all.notes = overlapSentences(scene, told, Begin::movedApart);
    return all;
}

} // namespace simulation
