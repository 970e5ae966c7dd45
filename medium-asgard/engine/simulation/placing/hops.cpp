#include "placing/hops.h"

#include "physics/carried_points.h"
#include "physics/linkage.h"
#include "placing/least_ways.h"
#include "placing/overlaps.h"
#include "placing/told_heaps.h"
#include "scene/connections.h"
#include "scene/contact_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <tuple>
#include <variant>

namespace simulation {
namespace {

using geometry::Vector;
using physics::PartGap;

// By body: the acceleration of its weight. None of those that something holds.
std::vector<Vector> pullsOf(const scene::Scene& scene, const std::vector<char>& isLoose) {
    std::vector<Vector> pulls(scene.bodies.size(), Vector::Zero());
    for (const scene::Force& force : scene.forces)
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
            for (std::size_t b = 0; b < scene.bodies.size(); ++b)
                if (scene.bodies[b].name == force.body && isLoose[b])
                    pulls[b] += weight->acceleration;
    return pulls;
}

// By body: whether its weights alone pull it.
std::vector<char> onlyWeighs(const scene::Scene& scene) {
    const scene::Connections connections(scene);
    std::vector<char> all;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        all.push_back(connections.firstEnds.of(b).empty() && connections.secondEnds.of(b).empty() &&
                      std::ranges::all_of(connections.forces.of(b), [&](std::size_t force) {
                          return std::holds_alternative<scene::GravitationalForce>(
                              scene.forces[force].kind);
                      }));
    return all;
}

bool isAnyDriven(const scene::Scene& scene) {
    return std::ranges::any_of(scene.joints, [](const scene::Joint& joint) {
        return std::ranges::any_of(joint.coordinates, [](const scene::JointCoordinate& of) {
            return of.speed || of.position;
        });
    });
}

// How bodies move at the start.
class StartMotions {
public:
    StartMotions(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                 const std::vector<char>& isLoose)
        : scene_(scene), motions_(equations.bodies.size()), isDriven_(motions_.size(), 1) {
        const double start = scene.simulator.start;
        std::vector<double> values{start};
        for (const expression::Unknown& unknown : equations.set.unknowns)
            values.push_back(unknown.initial);
        physics::putGiven(equations.set.graph, equations.set, start, values);
        for (std::size_t b = 0; b < motions_.size(); ++b)
            if (const physics::BodyMotion& body = equations.bodies[b]; body.isFixed)
                motions_[b].position = body.start.position;
            else
                motions_[b] = body.valuesOf(std::span(values)
                                                .subspan(1 + body.firstUnknown)
                                                .first<physics::bodyUnknowns>());
        const scene::Connections connections(scene);
        bool mayChange = isAnyDriven(scene);
        for (std::size_t b = 0; b < motions_.size(); ++b)
            mayChange = mayChange || (isLoose[b] == 0 && (!motions_[b].velocity.isZero(0) ||
                                                          !motions_[b].angularVelocity.isZero(0)));
        for (std::size_t b = 0; b < motions_.size() && mayChange; ++b)
            isDriven_[b] = equations.bodies[b].isFixed ||
                           (connections.joints.of(b).empty() && connections.gears.of(b).empty() &&
                            connections.ropes.of(b).empty());
    }

    // The bodies of the gap neither meet nor part there.
    [[nodiscard]] bool isStill(const PartGap& of) {
        constexpr double still = 1e-9; // of their speeds
        const Vector one = velocityAt(of.first, of.at), other = velocityAt(of.second, of.at);
        return std::abs(of.normal.dot(one - other)) <= still * (one.norm() + other.norm());
    }

private:
    Vector velocityAt(std::size_t body, const Vector& at) {
        if (isDriven_[body] == 0)
            drive(body);
        const physics::BodyValues& of = motions_[body];
        return of.velocity + of.angularVelocity.cross(at - of.position);
    }

    // Drives and joints change the velocities of the bodies that hang together as little as they
    // can: that takes no time, and is no blow.
    void drive(std::size_t body) {
        isDriven_[body] = 1;
        if (!own_)
            own_ = std::make_unique<physics::EquationsOfMotion>(
                scene_, std::function<void()>(), nullptr,
                physics::EquationsOfMotion::Start::mayMiss);
        physics::Linkage linkage(scene_, *own_, body);
        const physics::Linkage::Rates rates = linkage.rates();
        const auto& bodies = linkage.bodies();
        for (const std::size_t of : bodies)
            isDriven_[of] = 1;
        Eigen::VectorXd moves(6 * static_cast<Eigen::Index>(bodies.size()));
        for (std::size_t i = 0; i < bodies.size(); ++i)
            moves.segment<6>(6 * static_cast<Eigen::Index>(i)) << motions_[bodies[i]].velocity,
                linkage.radiusOf(i) * motions_[bodies[i]].angularVelocity;
        Eigen::VectorXd missed = rates.by * moves + rates.led;
        Eigen::MatrixXd by = rates.by;
        for (Eigen::Index row = 0; row < missed.size(); ++row)
            if (rates.isRope[static_cast<std::size_t>(row)] != 0) { // may part
                missed[row] = 0;
                by.row(row).setZero();
            }
        if (missed.size() == 0)
            return;
        moves -= physics::Linkage::solverOf(by).solve(missed);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const auto first = 6 * static_cast<Eigen::Index>(i);
            motions_[bodies[i]].velocity = moves.segment<3>(first);
            motions_[bodies[i]].angularVelocity = moves.segment<3>(first + 3) / linkage.radiusOf(i);
        }
    }

    const scene::Scene& scene_;
    std::vector<physics::BodyValues> motions_;
    std::vector<char> isDriven_; // by body: what drives and joints make of its motion is in it
    std::unique_ptr<physics::EquationsOfMotion> own_;
};

// Those that would bear if they were closed.
std::vector<PartGap> bearing(const std::vector<PartGap>& gaps, const std::vector<char>& isLoose,
                             const std::vector<Vector>& pulls) {
    constexpr int sweeps = 1000;
    constexpr double none = 1e-6; // of the pulls
    const auto pullOf = [&](const PartGap& of) {
        return pulls[of.first].norm() + pulls[of.second].norm();
    };
    std::vector<PartGap> rates = gaps;
    for (PartGap& of : rates)
        of.gap = of.normal.dot(pulls[of.first] - pulls[of.second]);
    const LeastWays least = leastWays(rates, isLoose, sweeps,
                                      [&](const PartGap& of) { return 1e-3 * none * pullOf(of); });
    std::vector<PartGap> bear;
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (least.forces[k] > none * pullOf(gaps[k]))
            bear.push_back(gaps[k]);
    return bear;
}

// `upper`, by pair: the one that is pulled onto the other.
std::vector<std::string> sentencesOf(const scene::Scene& scene,
                                     const std::map<collision::Pair, double>& hops,
                                     const std::map<collision::Pair, std::size_t>& upper) {
    std::vector<std::string> sentences;
    for (const ToldHeap& heap : toldHeaps(scene, hops)) {
        const std::string& above = scene.bodies[upper.at(heap.first)].name;
        sentences.push_back(
            bodiesOf(scene, heap.first) + " are " + lengthOf(heap.size) +
            " apart at the start, and " + othersOf(scene, heap, "no farther") +
            "bounce without loss: they hop for ever; with -restitution 0 " +
            (heap.others.empty() ? "body \"" + above + "\" hops no more." : "they hop no more."));
    }
    return sentences;
}

} // namespace

std::vector<std::string> hopSentences(const scene::Scene& scene,
                                      const physics::EquationsOfMotion& equations,
                                      const std::vector<geometry::Shape>& shapes) {
    const scene::ContactPairs laws(scene);
    const std::vector<char> isLoose = looseBodies(scene, equations);
    const std::vector<Vector> pulls = pullsOf(scene, isLoose);
    const Overlaps overlaps(scene, equations, shapes);
    const std::vector<geometry::Pose> poses = overlaps.startPoses();
    const std::vector<char> isKnown = onlyWeighs(scene);
    const auto isPulled = [&](std::size_t body) { return !pulls[body].isZero(0); };
    const auto mayHop = [&](std::size_t first, std::size_t second) {
        return isKnown[first] && isKnown[second] && (isPulled(first) || isPulled(second)) &&
               laws.restitutionOf(first, second) == 1;
    };
    const auto narrow = overlaps.nearGaps(poses, Overlaps::Near::apart, mayHop);
    if (narrow.empty())
        return {};
    auto gaps = overlaps.nearGaps(
        poses, Overlaps::Near::apartOrTouching, [&](std::size_t first, std::size_t second) {
            return isKnown[first] && isKnown[second] && (isLoose[first] || isLoose[second]);
        });
    StartMotions motions(scene, equations, isLoose);
    std::erase_if(gaps, [&](const PartGap& of) { return !motions.isStill(of); });
    const auto partsOf = [](const PartGap& of) {
        return std::tuple(of.first, of.firstPart, of.second, of.secondPart);
    };
    std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> mayBear;
    for (const PartGap& of : narrow)
        mayBear.insert(partsOf(of));
    std::map<collision::Pair, double> hops;
    std::map<collision::Pair, std::size_t> upper;
    for (const PartGap& of : bearing(gaps, isLoose, pulls))
        if (mayBear.contains(partsOf(of))) {
            const collision::Pair pair = std::minmax(of.first, of.second);
            const bool isFirst = of.normal.dot(pulls[of.first]) <= -of.normal.dot(pulls[of.second]);
            hops[pair] = std::max(hops[pair], of.gap);
            upper[pair] = isFirst ? of.first : of.second;
        }
    return sentencesOf(scene, hops, upper);
}

} // namespace simulation
