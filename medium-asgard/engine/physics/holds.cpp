#include "physics/holds.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace physics {
namespace {

struct ActiveHold {
    const scene::Constraint* constraint;
    std::vector<HoldInterval> intervals;
    const ScopeTrajectory* trajectory;

    [[nodiscard]] bool holdsAt(double t) const {
        return std::ranges::any_of(intervals,
                                   [t](const HoldInterval& i) { return i.from <= t && t < i.to; });
    }
};

std::vector<ActiveHold> holdsOf(const scene::Scene& scene, const Scope& scope, std::size_t body) {
    std::vector<ActiveHold> holds;
    for (const scene::Constraint& constraint : scene.constraints) {
        const auto trajectory =
            std::ranges::find(scene.trajectories, constraint.trajectory, &scene::Trajectory::name);
        if (constraint.body != scene.bodies[body].name || trajectory == scene.trajectories.end())
            continue;
        const auto index = static_cast<std::size_t>(trajectory - scene.trajectories.begin());
        holds.push_back(
            {&constraint, intervalsOf(constraint, *trajectory), &scope.trajectory(index)});
    }
    return holds;
}

// All times at which something begins, ends, or passes to another piece.
std::set<double> cutsOf(const std::vector<ActiveHold>& holds) {
    std::set<double> cuts{-std::numeric_limits<double>::infinity()};
    for (const ActiveHold& hold : holds)
        for (const HoldInterval& interval : hold.intervals) {
            cuts.insert({interval.from, interval.to});
            for (const TrajectoryPiece& piece : hold.trajectory->pieces)
                if (interval.from < piece.from && piece.from < interval.to)
                    cuts.insert(piece.from);
        }
    cuts.erase(std::numeric_limits<double>::infinity());
    return cuts;
}

std::string numberText(double value) {
    Graph graph;
    return print(graph, graph.constant(value));
}

class SegmentMaker {
public:
    SegmentMaker(const std::string& body, std::vector<std::string>& faults)
        : body_(body), faults_(faults) {}

    HoldSegment make(double from, const std::vector<ActiveHold>& holds) {
        HoldSegment segment;
        segment.from = from;
        for (const ActiveHold& hold : holds)
            if (hold.holdsAt(from))
                add(segment, hold.constraint->held, pieceAt(hold.trajectory->pieces, from).value);
        return segment;
    }

private:
    void add(HoldSegment& segment, scene::Held held, const NodeVector& value) {
        switch (held) {
        case scene::Held::position:
        case scene::Held::velocity:
            for (std::size_t i = 0; i < 3; ++i)
                addLinear(segment, i, held == scene::Held::velocity, value[i]);
            return;
        case scene::Held::attitude:
        case scene::Held::angularVelocity:
            if (segment.angular)
                return tellTwice(segment.from, "rotation");
            segment.angular = {held == scene::Held::angularVelocity, value};
            return;
        case scene::Held::x:
        case scene::Held::y:
        case scene::Held::z:
            return addLinear(
                segment, static_cast<std::size_t>(held) - static_cast<std::size_t>(scene::Held::x),
                false, value[0]);
        case scene::Held::dx:
        case scene::Held::dy:
        case scene::Held::dz:
            return addLinear(
                segment, static_cast<std::size_t>(held) - static_cast<std::size_t>(scene::Held::dx),
                true, value[0]);
        }
    }

    void addLinear(HoldSegment& segment, std::size_t i, bool isVelocity, Node value) {
        if (segment.linear[i])
            return tellTwice(segment.from, "position");
        segment.linear[i] = {isVelocity, value};
    }

    void tellTwice(double time, const std::string& what) {
        if (std::exchange(hasTold_, true))
            return;
        faults_.push_back("body \"" + body_ + "\": two trajectories hold its " + what +
                          " at one time, from t = " + numberText(time) + " on");
    }

    const std::string& body_;
    std::vector<std::string>& faults_;
    bool hasTold_ = false;
};

} // namespace

// Without -from and -to the trajectory's own curves hold, and its gaps leave the body free; with
// one of them it holds throughout, the other end being the trajectory's own.
std::vector<HoldInterval> intervalsOf(const scene::Constraint& constraint,
                                      const scene::Trajectory& trajectory) {
    std::vector<HoldInterval> intervals;
    if (trajectory.curves.empty())
        return intervals;
    if (constraint.from || constraint.to) {
        const HoldInterval whole{constraint.from.value_or(trajectory.curves.front().from),
                                 constraint.to.value_or(trajectory.curves.back().to)};
        if (whole.from < whole.to)
            intervals.push_back(whole);
        return intervals;
    }
    intervals.reserve(trajectory.curves.size());
    for (const scene::BezierCurve& curve : trajectory.curves)
        intervals.push_back({curve.from, curve.to});
    return intervals;
}

std::vector<HoldSegment> segmentsOf(const scene::Scene& scene, const Scope& scope, std::size_t body,
                                    std::span<const double> cuts,
                                    std::vector<std::string>& faults) {
    const std::vector<ActiveHold> holds = holdsOf(scene, scope, body);
    SegmentMaker maker(scene.bodies[body].name, faults);
    std::set<double> times = cutsOf(holds);
    times.insert(cuts.begin(), cuts.end());
    std::vector<HoldSegment> segments;
    segments.reserve(times.size());
    for (const double time : times)
        segments.push_back(maker.make(time, holds));
    return segments;
}

} // namespace physics
