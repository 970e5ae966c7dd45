// trajectory and constrain.
#include "script/scene_maker.h"

#include "scene/curves.h"
#include "script/numbers.h"
#include "script/suggestion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace script {

using geometry::Vector;

void SceneMaker::smoothCurves(Arguments& arguments, scene::Trajectory& trajectory) {
    constexpr std::string_view wants = "a list of points {t x y z}";
    const Value* value = arguments.find("-points");
    const auto list = arguments.listIn("-points", *value, wants);
    if (!list)
        return;
    auto& points = trajectory.points;
    for (const Value& word : *list) {
        const auto n = arguments.numbersIn("-points", word, wants);
        if (!n)
            return;
        if (n->size() != 4) {
            arguments.wrong("-points", word.range, wants,
                            "and " + quoted(word.text) + " is not four numbers");
            return;
        }
        if (!points.empty() && !((*n)[0] > points.back().first)) {
            arguments.wrong("-points", word.range, "times that increase",
                            "and " + numberText((*n)[0], true) + " does not come after " +
                                numberText(points.back().first, true));
            return;
        }
        points.emplace_back((*n)[0], Vector((*n)[1], (*n)[2], (*n)[3]));
    }
    if (points.size() < 2) {
        arguments.wrong("-points", value->range, "at least two points",
                        "and gets " + std::to_string(points.size()));
        return;
    }
    trajectory.curves = scene::smoothCurves(points);
}

void SceneMaker::bezierCurves(Arguments& arguments, scene::Trajectory& trajectory) {
    constexpr std::string_view wants = "a list of curves {t0 t1 {x y z} ...}";
    constexpr std::size_t mostControlPoints = 32; // LIMIT: higher degrees lose their digits
    const Value* value = arguments.find("-bezier");
    const auto list = arguments.listIn("-bezier", *value, wants);
    if (!list)
        return;
    if (list->empty())
        arguments.wrong("-bezier", value->range, wants, "and gets none");
    for (const Value& word : *list) {
        const auto parts = arguments.listIn("-bezier", word, wants);
        if (!parts)
            return;
        if (parts->size() < 3 || parts->size() > 2 + mostControlPoints) {
            arguments.wrong("-bezier", word.range,
                            "two times and from one to 32 control points in each curve",
                            "not " + quoted(word.text));
            return;
        }
        scene::BezierCurve curve;
        const auto from = arguments.numberIn("-bezier", (*parts)[0], Sign::any, wants);
        const auto to = arguments.numberIn("-bezier", (*parts)[1], Sign::any, wants);
        if (!from || !to)
            return;
        curve.from = *from;
        curve.to = *to;
        if (!(curve.to > curve.from)) {
            arguments.wrong("-bezier", (*parts)[1].range, "curves that end after they start",
                            "not from " + numberText(curve.from, true) + " to " +
                                numberText(curve.to, true));
            return;
        }
        for (std::size_t i = 2; i < parts->size(); ++i) {
            const auto p =
                arguments.vectorIn("-bezier", (*parts)[i], "control points of three numbers");
            if (!p)
                return;
            curve.control.push_back(*p);
        }
        trajectory.curves.push_back(std::move(curve));
    }
    orderCurves(arguments, *list, trajectory);
}

// In the order of time; two that meet are reported at the one written later.
void SceneMaker::orderCurves(Arguments& arguments, const std::vector<Value>& words,
                             scene::Trajectory& trajectory) {
    std::vector<std::size_t> order(trajectory.curves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return trajectory.curves[a].from < trajectory.curves[b].from;
    });
    std::vector<scene::BezierCurve> ordered;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && trajectory.curves[order[i]].from < ordered.back().to)
            arguments.wrong("-bezier", words[std::max(order[i - 1], order[i])].range,
                            "intervals that do not overlap", "and this one meets another");
        ordered.push_back(trajectory.curves[order[i]]);
    }
    trajectory.curves = std::move(ordered);
}

void SceneMaker::trajectory(Call& call) {
    scene::Trajectory trajectory;
    trajectory.name = newName(call, Kind::trajectory);
    if (trajectory.name.empty())
        return;
    Arguments arguments(faults_, call, "trajectory " + quoted(trajectory.name), 2,
                        {"-points", "-bezier"});
    const bool one = arguments.atMostOne({"-points", "-bezier"});
    if (!arguments.attempted("-points") && !arguments.attempted("-bezier"))
        arguments.wrongElement("wants -points or -bezier");
    else if (one && arguments.has("-points"))
        smoothCurves(arguments, trajectory);
    else if (one && arguments.has("-bezier"))
        bezierCurves(arguments, trajectory);
    else if (one)
        arguments.wrong(
            arguments.attempted("-points") ? "-points" : "-bezier",
            arguments.optionRange(arguments.attempted("-points") ? "-points" : "-bezier"), "a list",
            "and nothing follows it");
    trajectory.source = call.source;
    made_.scene.trajectories.push_back(std::move(trajectory));
}

// --- what trajectories hold -----------------------------------------------------------------

namespace {

struct HeldOption {
    std::string_view option;
    scene::Held held;
    unsigned axes; // what of the body's motion it determines: x y z, rotation
};
constexpr HeldOption heldOptions[] = {
    {"-pos", scene::Held::position, 7},  {"-rot", scene::Held::attitude, 8},
    {"-dpos", scene::Held::velocity, 7}, {"-drot", scene::Held::angularVelocity, 8},
    {"-x", scene::Held::x, 1},           {"-y", scene::Held::y, 2},
    {"-z", scene::Held::z, 4},           {"-dx", scene::Held::dx, 1},
    {"-dy", scene::Held::dy, 2},         {"-dz", scene::Held::dz, 4}};

unsigned axesOf(scene::Held held) {
    for (const HeldOption& option : heldOptions)
        if (option.held == held)
            return option.axes;
    return 0;
}

using Interval = std::pair<double, double>;

std::vector<Interval> intervalsOf(const scene::Constraint& constraint,
                                  const scene::Trajectory& trajectory) {
    if (trajectory.curves.empty())
        return {};
    if (constraint.from || constraint.to)
        return {{constraint.from.value_or(trajectory.curves.front().from),
                 constraint.to.value_or(trajectory.curves.back().to)}};
    std::vector<Interval> intervals;
    for (const scene::BezierCurve& curve : trajectory.curves)
        intervals.emplace_back(curve.from, curve.to);
    return intervals;
}

} // namespace

void SceneMaker::constrain(Call& call) {
    if (call.words.size() < 2 || call.words[1].text.starts_with('-')) {
        faults_.error(call.words[0].range, "constrain wants the name of a body first");
        return;
    }
    const std::string body = call.words[1].text;
    call.source.arguments.push_back({"", call.words[1].range, call.words[1].exact});
    Arguments arguments(
        faults_, call, "the constraint on body " + quoted(body), 2,
        {"-pos", "-rot", "-dpos", "-drot", "-x", "-y", "-z", "-dx", "-dy", "-dz", "-from", "-to"});
    if (!exists(Kind::body, body)) {
        faults_.error(call.words[1].range, "constrain: no body named " + quoted(body),
                      suggest(Kind::body, body));
    } else if (const scene::Body* found = scene::findBody(made_.scene, body);
               found && found->fixed) {
        faults_.error(call.words[1].range,
                      "body " + quoted(body) + " is -fixed, and no trajectory can move it");
    }
    const auto from = arguments.number("-from");
    const auto to = arguments.number("-to");
    if (from && to && !(*to > *from))
        faults_.error(arguments.find("-to")->range,
                      arguments.subject() + " ends at " + numberText(*to, true) +
                          ", which is not after its start at " + numberText(*from, true));
    bool any = false;
    for (const HeldOption& option : heldOptions) {
        if (!arguments.attempted(option.option))
            continue;
        any = true;
        const auto name = reference(arguments, option.option, Kind::trajectory);
        if (!name)
            continue;
        scene::Constraint constraint{body, option.held, *name, from, to, call.source};
        holds_.push_back(
            {arguments.optionRange(option.option), std::string(option.option), constraint});
        made_.scene.constraints.push_back(std::move(constraint));
    }
    if (!any)
        arguments.wrongElement("wants what it holds: one of -pos -rot -dpos -drot -x -y -z -dx "
                               "-dy -dz with a trajectory");
}

namespace {

// Where two lists of disjoint intervals, both ordered, first meet. Counts its steps.
std::optional<double> meeting(const std::vector<Interval>& a, const std::vector<Interval>& b,
                              std::size_t& steps) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); ++steps) {
        if (a[i].first < b[j].second && b[j].first < a[i].second)
            return std::max(a[i].first, b[j].first);
        ++(a[i].second <= b[j].second ? i : j);
    }
    return std::nullopt;
}

} // namespace

// Each part of a body's motion is held by one trajectory at a time.
// LIMIT: a scene with more constraints than can be compared in a moment is not checked to the end.
void SceneMaker::checkHolds() {
    constexpr std::size_t mostSteps = 20'000'000;
    std::map<std::string, const scene::Trajectory*> trajectories;
    for (const scene::Trajectory& trajectory : made_.scene.trajectories)
        trajectories.emplace(trajectory.name, &trajectory);
    struct Held {
        const Hold* hold;
        std::vector<Interval> intervals;
    };
    std::map<std::string, std::vector<Held>> byBody;
    std::size_t steps = 0;
    for (const Hold& hold : holds_) {
        const auto trajectory = trajectories.find(hold.constraint.trajectory);
        if (trajectory == trajectories.end())
            continue;
        Held held{&hold, intervalsOf(hold.constraint, *trajectory->second)};
        std::vector<Held>& before = byBody[hold.constraint.body];
        for (const Held& other : before) {
            if (++steps > mostSteps)
                return;
            if ((axesOf(other.hold->constraint.held) & axesOf(hold.constraint.held)) == 0)
                continue;
            if (const auto when = meeting(other.intervals, held.intervals, steps)) {
                faults_.error(hold.range, hold.option + " and " + other.hold->option +
                                              " hold body " + quoted(hold.constraint.body) +
                                              " at one time, from t = " + numberText(*when, true));
                break;
            }
        }
        steps += held.intervals.size();
        before.push_back(std::move(held));
    }
}

namespace {

// Whether intervals leave nothing out from `from` to `to`.
bool cover(std::vector<Interval> intervals, double from, double to) {
    std::ranges::sort(intervals);
    for (const Interval& interval : intervals)
        if (interval.first <= from)
            from = std::max(from, interval.second);
    return !intervals.empty() && from >= to;
}

} // namespace

// A body with a half space is held in place and attitude all the time.
void SceneMaker::checkPlanes() {
    for (const auto& [body, range] : planes_) {
        std::array<std::vector<Interval>, 4> held; // by axis, as in axesOf()
        for (const Hold& hold : holds_) {
            const scene::Trajectory* trajectory =
                scene::findTrajectory(made_.scene, hold.constraint.trajectory);
            if (hold.constraint.body != body || !trajectory)
                continue;
            for (std::size_t axis = 0; axis < held.size(); ++axis)
                if ((axesOf(hold.constraint.held) >> axis & 1U) != 0)
                    for (const Interval& one : intervalsOf(hold.constraint, *trajectory))
                        held[axis].push_back(one);
        }
        const scene::Simulator& simulator = made_.scene.simulator;
        if (!std::ranges::all_of(held, [&](const std::vector<Interval>& intervals) {
                return cover(intervals, simulator.start, simulator.finish);
            }))
            faults_.error(range, "body " + quoted(body) +
                                     " has a -plane, which reaches everywhere and cannot be moved: "
                                     "it wants -fixed 1, or trajectories that hold its place and "
                                     "attitude from the start to the end");
    }
}

} // namespace script
