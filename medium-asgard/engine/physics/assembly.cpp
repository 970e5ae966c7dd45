#include "physics/assembly.h"

#include "complementarity/convex.h"
#include "physics/linkage.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace physics {
namespace {

// Along what opens nothing, back towards where the bodies were.
void shorten(Linkage& linkage, const std::function<bool()>& cancelled) {
    constexpr int most = 60;
    for (int k = 0; k < most && !cancelled(); ++k) {
        const Eigen::MatrixXd jacobian = linkage.jacobian();
        const Eigen::VectorXd way = linkage.movement();
        const Eigen::VectorXd along = way - linkage.solver().solve(Eigen::VectorXd(jacobian * way));
        if (!(along.norm() > 1e-9 * way.norm()))
            return;
        const std::vector<double> before = linkage.values();
        linkage.step(-along);
        if (!linkage.close(cancelled) || !(linkage.movement().norm() < way.norm()))
            return linkage.setValues(before);
    }
}

std::string openJoints(Linkage& linkage) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "the joints do not close by moving the bodies that are free to move; a gap of "
                  "%.4g is left",
                  linkage.largestGap());
    return text;
}

// Bodies that no condition reads do not turn: where two faces overlap, no corner goes ahead.
void holdTurns(Linkage& linkage) {
    std::vector<char> held;
    for (std::size_t i = 0; i < linkage.bodies().size(); ++i)
        held.insert(held.end(), {0, 0, 0, 1, 1, 1});
    for (const Linkage::Reads& condition : linkage.reads())
        for (const std::size_t place : condition.places)
            std::fill_n(held.begin() + static_cast<std::ptrdiff_t>(6 * place), 6, 0);
    linkage.hold(std::move(held));
}

// The derivatives of these gaps by a movement.
Eigen::MatrixXd openingsOf(const Linkage& linkage, const std::vector<PartGap>& gaps,
                           const std::vector<geometry::Pose>& poses) {
    const auto places = static_cast<Eigen::Index>(linkage.bodies().size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(gaps.size()), 6 * places);
    for (Eigen::Index i = 0; i < places; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const std::size_t body = linkage.bodies()[place];
        for (std::size_t k = 0; k < gaps.size(); ++k) {
            if (gaps[k].first != body && gaps[k].second != body)
                continue;
            const Vector normal = gaps[k].first == body ? gaps[k].normal : -gaps[k].normal;
            const Vector turn =
                (gaps[k].at - poses[body].position).cross(normal) / linkage.radiusOf(place);
            all.row(static_cast<Eigen::Index>(k)).segment<3>(6 * i) = normal.transpose();
            all.row(static_cast<Eigen::Index>(k)).segment<3>(6 * i + 3) = turn.transpose();
        }
    }
    for (std::size_t c = 0; c < linkage.held().size(); ++c)
        if (linkage.held()[c] != 0)
            all.col(static_cast<Eigen::Index>(c)).setZero();
    return all;
}

// The step to the least movement that closes the joints and opens these gaps. None: no such one.
std::optional<Eigen::VectorXd> partingStep(Linkage& linkage, const Eigen::MatrixXd& openings,
                                           const Eigen::VectorXd& gaps) {
    const Eigen::VectorXd before = linkage.movement();
    Eigen::VectorXd movement = Eigen::VectorXd::Zero(openings.cols());
    Eigen::MatrixXd along = openings.transpose();
    if (const Eigen::MatrixXd jacobian = linkage.jacobian(); jacobian.rows() > 0) {
        const Linkage::Solver solver = linkage.solver();
        movement = solver.solve(Eigen::VectorXd(jacobian * before - linkage.gaps()));
        along -= Eigen::MatrixXd(solver.solve(Eigen::MatrixXd(jacobian * along)));
    }
    const Eigen::VectorXd left = gaps + openings * (movement - before);
    if (const double size = left.size() > 0 ? left.lpNorm<Eigen::Infinity>() : 0; size > 0) {
        complementarity::Laws laws;
        for (Eigen::Index k = 0; k < gaps.size(); ++k)
            complementarity::addUnilateral(laws);
        const auto answer = complementarity::solveConvex(openings * along, left / size, laws);
        if (!answer)
            return std::nullopt;
        movement += along * (size * answer->forces);
    }
    return movement - before;
}

// Places at which parts overlapped before, carried along with both bodies. Of two parts one place
// is told, the deepest: a box that turns about one corner would lower the one that it had lifted.
class FormerPlaces {
public:
    // The gaps of these places at these poses. A place is forgotten when it is among the `told`, or
    // when these part its two parts along another direction.
    [[nodiscard]] std::vector<PartGap> at(const std::vector<geometry::Pose>& poses,
                                          const std::vector<PartGap>& told) {
        std::vector<PartGap> gaps;
        std::erase_if(all_, [&](const Place& place) {
            PartGap now = place.of;
            const Vector first = poses[now.first].toWorld(place.onFirst);
            now.normal = poses[now.second].attitude * place.normal;
            now.gap += now.normal.dot(first - poses[now.second].toWorld(place.onSecond));
            now.at = first;
            if (std::ranges::any_of(told, [&](const PartGap& of) { return replaces(of, now); }))
                return true;
            gaps.push_back(now);
            return false;
        });
        return gaps;
    }
    void add(const std::vector<geometry::Pose>& poses, const std::vector<PartGap>& told) {
        constexpr std::size_t most = 400;
        for (const PartGap& of : told)
            if (all_.size() < most)
                all_.push_back({of, poses[of.first].toLocal(of.at), poses[of.second].toLocal(of.at),
                                poses[of.second].attitude.conjugate() * of.normal});
    }

private:
    struct Place {
        PartGap of;
        Vector onFirst;          // in the frame of the first body
        Vector onSecond, normal; // in that of the second
    };
    [[nodiscard]] static bool replaces(const PartGap& told, const PartGap& former) {
        constexpr double alike = 0.9;     // cosine
        constexpr double rounding = 1e-9; // of places
        const double depth = std::abs(told.gap) + std::abs(former.gap);
        const auto parts = [](const PartGap& of) {
            return std::tuple(of.first, of.firstPart, of.second, of.secondPart);
        };
        return parts(told) == parts(former) &&
               (told.normal.dot(former.normal) < alike ||
                (told.at - former.at).norm() <= 2 * depth + rounding * told.at.norm());
    }
    std::vector<Place> all_;
};

// Gaps of parts of which a body can move.
struct Open {
    std::vector<PartGap> parts;
    std::size_t told = 0; // so many of them are told now; behind them are former places
    Eigen::MatrixXd by;   // how they change with a movement
    [[nodiscard]] Eigen::VectorXd gaps() const {
        Eigen::VectorXd all(by.rows());
        for (Eigen::Index k = 0; k < all.size(); ++k)
            all[k] = parts[static_cast<std::size_t>(k)].gap;
        return all;
    }
};

Open openOf(const Linkage& linkage, const PartGaps& gapsAt, FormerPlaces* former) {
    const std::vector<geometry::Pose> poses = linkage.poses();
    Open open{gapsAt(poses), 0, {}};
    const auto stands = [&](const PartGap& of) {
        return openingsOf(linkage, {of}, poses).isZero(0);
    };
    std::erase_if(open.parts, stands);
    open.told = open.parts.size();
    if (former) {
        const std::vector<PartGap> before = former->at(poses, open.parts);
        former->add(poses, open.parts);
        open.parts.insert(open.parts.end(), before.begin(), before.end());
    }
    open.by = openingsOf(linkage, open.parts, poses);
    return open;
}

// The deepest of those that overlap by more than rounding.
const PartGap* deepest(std::span<const PartGap> parts, double size) {
    constexpr double rounding =
        1e-11; // of places and radii: parts touch at a thousand times as much
    const PartGap* found = nullptr;
    for (const PartGap& of : parts)
        if (of.gap < -rounding * std::max(of.at.norm(), size) && (!found || of.gap < found->gap))
            found = &of;
    return found;
}

std::string roomless(const scene::Scene& scene, const PartGap& parts) {
    char depth[40];
    std::snprintf(depth, sizeof depth, "%.4g", -parts.gap);
    return "bodies \"" + scene.bodies[parts.first].name + "\" and \"" +
           scene.bodies[parts.second].name + "\" have no room to move apart; an overlap of " +
           depth + " is left";
}

// "": they have parted. Pairs of which no body is free to move stay as they are. `former`: places
// that are not to overlap again; none: only what overlaps now counts.
std::string partBy(const scene::Scene& scene, Linkage& linkage, const PartGaps& gapsAt,
                   FormerPlaces* former, const std::function<bool()>& cancelled) {
    constexpr int most = 60;
    constexpr double stays = 1e-14; // of the largest radius
    constexpr std::size_t mostPlaces = 400;
    holdTurns(linkage);
    Open open = openOf(linkage, gapsAt, former);
    for (int k = 0; k < most && !open.parts.empty() && !cancelled(); ++k) {
        if (open.told > mostPlaces)
            return "bodies overlap at too many places to move them all apart: begin with some of "
                   "them";
        const auto step = partingStep(linkage, open.by, open.gaps());
        if (!step)
            break;
        linkage.step(*step);
        open = openOf(linkage, gapsAt, former);
        const bool hasTightened = linkage.tighten(); // a rope on which a body has moved
        if (!hasTightened && step->norm() <= stays * linkage.size())
            break;
    }
    const PartGap* left = deepest(std::span(open.parts).first(open.told), linkage.size());
    return left ? roomless(scene, *left) : linkage.isClosed() ? "" : openJoints(linkage);
}

// Most bodies part by the least movement from where they overlap now.
std::string partAll(const scene::Scene& scene, Linkage& linkage, const PartGaps& gapsAt,
                    const std::function<bool()>& cancelled) {
    const std::vector<double> before = linkage.values();
    std::string why = partBy(scene, linkage, gapsAt, nullptr, cancelled);
    if (why.empty() || cancelled())
        return why;
    linkage.setValues(before);
    linkage.slacken();
    FormerPlaces former;
    return partBy(scene, linkage, gapsAt, &former, cancelled);
}

} // namespace

// A coordinate counts from the start, wherever that is: its drive is no gap.
Assembly assembled(const scene::Scene& written, const std::function<bool()>& cancelled,
                   const PartGaps& gaps) {
    scene::Scene scene = written;
    for (scene::Joint& joint : scene.joints)
        for (scene::JointCoordinate& coordinate : joint.coordinates)
            coordinate.position.reset();
    EquationsOfMotion equations(scene, {}, nullptr, EquationsOfMotion::Start::mayMiss);
    Assembly made;
    if (!equations.faults.empty()) {
        made.reason = equations.faults.front();
        return made;
    }
    const auto isCancelled = [&] {
        made.cancelled = made.cancelled || (cancelled && cancelled());
        return made.cancelled;
    };
    Linkage linkage(scene, equations);
    if (linkage.bodies().empty()) {
        if (!linkage.isClosed())
            made.reason = openJoints(linkage);
        return made;
    }
    if (!linkage.close(isCancelled)) {
        if (!isCancelled())
            made.reason = openJoints(linkage);
        return made;
    }
    shorten(linkage, isCancelled);
    if (gaps)
        made.reason = partAll(scene, linkage, gaps, isCancelled);
    if (!isCancelled() && made.reason.empty())
        made.moved = linkage.moved();
    return made;
}

std::optional<std::string> madeAtOnce(const scene::Scene& scene,
                                      const std::vector<std::size_t>& bodies) {
    const auto isOneOfSeveral = [&](std::size_t b) {
        const scene::Body& body = scene.bodies[b];
        return body.source.runs > 1 && !body.fixed &&
               std::ranges::find(scene.constraints, body.name, &scene::Constraint::body) ==
                   scene.constraints.end();
    };
    const auto one = std::ranges::find_if(bodies, isOneOfSeveral);
    if (one == bodies.end())
        return std::nullopt;
    const scene::Body& body = scene.bodies[*one];
    return "line " + std::to_string(body.source.line) + " makes \"" + body.name +
           "\" and other bodies at once";
}

std::string closeAdvice(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
    const auto why = madeAtOnce(scene, bodies);
    return why ? "place them so that the joint closes, by hand, since " + *why : closeAdvice();
}

std::string partAdvice(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
    const auto why = madeAtOnce(scene, bodies);
    return why ? "place them apart, by hand, since " + *why : partAdvice();
}

} // namespace physics
