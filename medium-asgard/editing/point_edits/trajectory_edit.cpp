#include "point_edits/trajectory_edit.h"

#include "editing/lines.h"
#include "editing/number_text.h"
#include "editing/origin.h"

#include "scene/curves.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace editing {

using geometry::Vector;
using scene::BezierCurve;

namespace {

std::string vectorText(const Vector& v) {
    return numberText(v.x(), 0) + " " + numberText(v.y(), 0) + " " + numberText(v.z(), 0);
}

std::string pointText(double time, const Vector& place) {
    return "{" + numberText(time, 0) + " " + vectorText(place) + "}";
}

std::string curveText(const BezierCurve& curve) {
    std::string text = "{" + numberText(curve.from, 0) + " " + numberText(curve.to, 0);
    for (const Vector& p : curve.control)
        text += " {" + vectorText(p) + "}";
    return text + "}";
}

double timeOf(const BezierCurve& curve, std::size_t index) {
    const std::size_t degree = curve.control.size() - 1;
    if (degree == 0)
        return curve.from;
    return index == degree ? curve.to
                           : curve.from + static_cast<double>(index) / static_cast<double>(degree) *
                                              (curve.to - curve.from);
}

bool meet(const BezierCurve& before, const BezierCurve& after) {
    return before.to == after.from && before.control.size() > 1 && after.control.size() > 1 &&
           before.control.back() == after.control.front();
}

// The slope with which a curve ends or begins.
Vector slopeAtEnd(const BezierCurve& curve) {
    const std::size_t n = curve.control.size() - 1;
    return static_cast<double>(n) * (curve.control[n] - curve.control[n - 1]) /
           (curve.to - curve.from);
}

Vector slopeAtStart(const BezierCurve& curve) {
    return static_cast<double>(curve.control.size() - 1) * (curve.control[1] - curve.control[0]) /
           (curve.to - curve.from);
}

bool meetSmoothly(const BezierCurve& before, const BezierCurve& after) {
    if (!meet(before, after))
        return false;
    const Vector a = slopeAtEnd(before), b = slopeAtStart(after);
    return (a - b).norm() <= 1e-9 * std::max(a.norm(), b.norm()); // as numbers are written
}

// A sum as an author would write it, 0.3 for 0.1 + 0.2: to 15 digits of the larger of the two.
double sum(double a, double b) {
    const double scale = std::max(std::abs(a), std::abs(b));
    const int decimals = scale > 0 ? 14 - static_cast<int>(std::floor(std::log10(scale))) : 0;
    if (a == 0 || b == 0 || decimals < 0)
        return a + b;
    std::array<char, 700> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), a + b,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    double result = a + b;
    std::from_chars(text.data(), end, result);
    return result + 0.0; // no minus of a zero
}

Vector sum(const Vector& a, const Vector& b) {
    return {sum(a.x(), b.x()), sum(a.y(), b.y()), sum(a.z(), b.z())};
}

// A tangent keeps its slope over an interval of another length.
void stretch(BezierCurve& curve, double from, double to) {
    const double share = (to - from) / (curve.to - curve.from);
    if (curve.control.size() == 4 && share != 1) {
        auto& p = curve.control;
        p[1] = sum(p[0], share * (p[1] - p[0]));
        p[2] = sum(p[3], share * (p[2] - p[3]));
    }
    curve.from = from;
    curve.to = to;
}

} // namespace

std::vector<ControlPoint> controlPointsOf(const std::vector<BezierCurve>& curves) {
    std::vector<ControlPoint> points;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const bool continues = c > 0 && meet(curves[c - 1], curves[c]);
        const std::size_t last = curves[c].control.size() - 1;
        for (std::size_t i = continues ? 1 : 0; i <= last; ++i) {
            const bool joins = i == last && c + 1 < curves.size() && meet(curves[c], curves[c + 1]);
            points.push_back(
                {c, i, timeOf(curves[c], i), curves[c].control[i], i == 0 || i == last, joins});
        }
    }
    return points;
}

Wish TrajectoryEdits::wishOf(std::size_t point) const {
    const ControlPoint& p = points_[point];
    Wish wish = fromPoints_ ? this->wish("-points", {knotOf(point)},
                                         {p.time, p.place.x(), p.place.y(), p.place.z()})
                            : this->wish("-bezier", {placeInText(p.curve), 2 + p.index},
                                         {p.place.x(), p.place.y(), p.place.z()});
    wish.now = wish.values;
    return wish;
}

TrajectoryEdits::TrajectoryEdits(std::string text, std::shared_ptr<const scene::Scene> scene,
                                 std::size_t trajectory)
    : text_(std::move(text)), scene_(std::move(scene)), trajectory_(trajectory),
      mapper_(text_, scene_), fromPoints_(!this->trajectory().points.empty()),
      points_(controlPointsOf(this->trajectory().curves)) {}

// --- moving ------------------------------------------------------------------------------------

// A curve of one point stays there from its beginning to its end.
double TrajectoryEdits::allowedTime(std::size_t point, double time, double leastInterval) const {
    if (time == points_[point].time)
        return time; // however near its neighbours are
    const auto constantUntil = [&](std::size_t i) {
        const BezierCurve& curve = trajectory().curves[points_[i].curve];
        return curve.control.size() == 1 ? std::optional(curve.to) : std::nullopt;
    };
    for (std::size_t i = point; i-- > 0;)
        if (points_[i].onCurve) {
            time = std::max(time, constantUntil(i).value_or(points_[i].time + leastInterval));
            break;
        }
    if (const auto end = constantUntil(point))
        time = std::min(time, *end - leastInterval);
    for (std::size_t i = point + 1; i < points_.size(); ++i)
        if (points_[i].onCurve) {
            time = std::min(time, points_[i].time - leastInterval);
            break;
        }
    return time;
}

TrajectoryEdits::Curves TrajectoryEdits::moved(std::size_t point, double time, const Vector& place,
                                               double leastInterval, bool breaks) const {
    Curves curves = trajectory().curves;
    const ControlPoint& p = points_[point];
    BezierCurve& curve = curves[p.curve];
    const std::size_t last = curve.control.size() - 1;
    if (!p.onCurve) {
        const Vector delta = place - p.place;
        curve.control[p.index] = place;
        // Its opposite, where the curves met smoothly.
        const auto turn = [&](const BezierCurve& changed, BezierCurve& other, bool before) {
            const double n = static_cast<double>(other.control.size() - 1);
            const double length = (other.to - other.from) / n;
            if (before)
                other.control[other.control.size() - 2] =
                    sum(other.control.back(), -length * slopeAtStart(changed));
            else
                other.control[1] = sum(other.control.front(), length * slopeAtEnd(changed));
        };
        const Curves& old = trajectory().curves;
        if (!breaks && delta != Vector::Zero()) {
            if (p.index == 1 && p.curve > 0 && meetSmoothly(old[p.curve - 1], old[p.curve]) &&
                old[p.curve - 1].control.size() > 2)
                turn(curve, curves[p.curve - 1], true);
            if (p.index + 1 == last && p.curve + 1 < curves.size() &&
                meetSmoothly(old[p.curve], old[p.curve + 1]) && old[p.curve + 1].control.size() > 2)
                turn(curve, curves[p.curve + 1], false);
        }
        return curves;
    }
    const double now = allowedTime(point, time, leastInterval);
    if (fromPoints_) {
        auto points = trajectory().points;
        points[knotOf(point)] = {now, place};
        return scene::smoothCurves(points);
    }
    const Vector delta = place - p.place;
    const auto carry = [&](BezierCurve& one, std::size_t end, std::size_t tangent) {
        if (one.control.size() == 4)
            one.control[tangent] = sum(one.control[tangent], delta);
        one.control[end] = place;
    };
    if (last == 0) {
        curve.from = now;
        curve.control[0] = place;
        return curves;
    }
    if (p.index == 0) {
        carry(curve, 0, 1);
        stretch(curve, now, curve.to);
        return curves;
    }
    carry(curve, last, last - 1);
    stretch(curve, curve.from, now);
    if (p.joins) {
        BezierCurve& next = curves[p.curve + 1];
        carry(next, 0, 1);
        stretch(next, now, next.to);
    }
    return curves;
}

std::size_t TrajectoryEdits::knotOf(std::size_t point) const {
    return static_cast<std::size_t>(
        std::count_if(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(point),
                      [](const ControlPoint& p) { return p.onCurve; }));
}

Answer TrajectoryEdits::move(std::size_t point, double time, const Vector& place,
                             double leastInterval, bool breaks) const {
    const ControlPoint& p = points_[point];
    if (fromPoints_ && p.onCurve)
        return mapper_.answer(
            wish("-points", {knotOf(point)},
                 {allowedTime(point, time, leastInterval), place.x(), place.y(), place.z()}));
    const Curves curves = moved(point, time, place, leastInterval, breaks);
    if (curves == trajectory().curves)
        return {};
    return fromPoints_ ? rewritten(curves) : numbersOf(curves);
}

Wish TrajectoryEdits::wish(std::string option, std::vector<std::size_t> path,
                           std::vector<double> values) const {
    return {.element = {Kind::trajectory, trajectory_},
            .option = std::move(option),
            .path = std::move(path),
            .values = std::move(values)};
}

Answer TrajectoryEdits::numbersOf(const Curves& curves) const {
    const Curves& old = trajectory().curves;
    std::vector<Wish> wishes;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        if (curves[c] == old[c])
            continue;
        const std::size_t there = placeInText(c);
        if (curves[c].from != old[c].from || curves[c].to != old[c].to)
            wishes.push_back(wish("-bezier", {there}, {curves[c].from, curves[c].to}));
        for (std::size_t i = 0; i < curves[c].control.size(); ++i)
            if (const Vector& p = curves[c].control[i]; p != old[c].control[i])
                wishes.push_back(wish("-bezier", {there, 2 + i}, {p.x(), p.y(), p.z()}));
    }
    return mapper_.answer(wishes);
}

// --- lists that become others ------------------------------------------------------------------

std::size_t TrajectoryEdits::placeInText(std::size_t curve) const {
    const Curves& curves = trajectory().curves;
    const double from = curves[curve].from;
    // A wish for what it is already changes nothing; of no other curve is this the start.
    const auto isAt = [&](std::size_t c) {
        const Answer answer = mapper_.answer(wish("-bezier", {c}, {from}));
        return answer.possible() && answer.edits.empty();
    };
    if (isAt(curve)) // as most are written
        return curve;
    for (std::size_t c = 0; c < curves.size(); ++c)
        if (c != curve && isAt(c))
            return c;
    return curve;
}

Answer TrajectoryEdits::place(const std::string& option, std::size_t index,
                              scene::Range& range) const {
    // Whether it can be changed at all is what any wish finds out, in its words.
    const double first =
        option == "-points" ? trajectory().points[index].first : trajectory().curves[index].from;
    const std::size_t there = option == "-points" ? index : placeInText(index);
    const double other = first == 0 ? 1 : first / 2; // of any size; 1e17 + 1 is 1e17
    Answer answer = mapper_.answer(wish(option, {there}, {other}));
    if (!answer.possible())
        return answer;
    assert(!answer.edits.empty() && "another time is another text");
    const auto opening = text_.find_last_not_of(" \t\r\n", answer.edits.front().range.from - 1);
    if (opening == std::string::npos || text_[opening] != '{') {
        answer.reason = option + " of " + mapper_.nameOf({Kind::trajectory, trajectory_}) +
                        " is not written as lists in braces.";
        answer.cause = {answer.edits.front().range.from, answer.edits.front().range.to};
        answer.edits.clear();
        return answer;
    }
    std::size_t end = opening;
    for (int depth = 0; end < text_.size(); ++end) {
        depth += text_[end] == '{' ? 1 : text_[end] == '}' ? -1 : 0;
        if (depth == 0)
            break;
    }
    range = {opening, end + 1};
    return {};
}

Answer TrajectoryEdits::insertAt(const std::string& option, std::size_t before, std::size_t count,
                                 const std::string& element) const {
    scene::Range here, next;
    const bool atEnd = before == count;
    if (Answer no = place(option, atEnd ? count - 1 : before, here); !no.possible())
        return no;
    // Apart from its neighbour as its neighbours are from each other.
    std::string space = " ";
    const std::size_t neighbour = atEnd || before > 0 ? (atEnd ? count - 2 : before - 1) : 1;
    if (count > 1 && place(option, neighbour, next).possible()) {
        const auto [a, b] = std::minmax(here.from, next.from);
        const std::size_t from = a == here.from ? here.to : next.to;
        const std::string between = b > from ? text_.substr(from, b - from) : std::string();
        if (between.find_first_not_of(" \t\r\n") == std::string::npos && !between.empty())
            space = between;
    }
    Answer answer;
    if (atEnd)
        answer.edits = {{{here.to, here.to}, space + element}};
    else
        answer.edits = {{{here.from, here.from}, element + space}};
    return answer;
}

Answer TrajectoryEdits::removeAt(const std::string& option, std::size_t index,
                                 std::size_t count) const {
    scene::Range here;
    if (Answer no = place(option, index, here); !no.possible())
        return no;
    // With the space that parted it from the one before; the first with that after it.
    std::size_t from = here.from, to = here.to;
    if (index > 0)
        from = text_.find_last_not_of(" \t\r\n", here.from - 1) + 1;
    else if (count > 1)
        to = std::min(text_.find_first_not_of(" \t\r\n", here.to), text_.size());
    Answer answer;
    answer.edits = {{{from, to}, ""}};
    return answer;
}

Answer TrajectoryEdits::rewritten(const Curves& curves) const {
    scene::Range first;
    if (Answer no = place("-points", 0, first); !no.possible())
        return no;
    const scene::Source& source = trajectory().source;
    const script::Structure structure = script::structureOf(text_);
    const script::Command* command = structure.startingAt(source.command.from);
    Answer answer;
    for (const scene::Argument& argument : source.arguments)
        for (std::size_t w = 1; argument.option == "-points" && w < command->words.size(); ++w) {
            const script::Word& word = command->words[w];
            if (!(word.range == argument.word))
                continue;
            std::string list;
            for (const BezierCurve& curve : curves)
                list += (list.empty()        ? ""
                         : curves.size() > 2 ? lineBreakOf(text_) + "    "
                                             : " ") +
                        curveText(curve);
            answer.edits = {
                {command->words[w - 1].range.from, command->words[w - 1].range.to, "-bezier"},
                {word.range.from, word.range.to, "{" + list + "}"}};
        }
    if (answer.edits.empty()) {
        answer.reason = "-points of " + mapper_.nameOf({Kind::trajectory, trajectory_}) +
                        " does not stand in its command.";
        answer.cause = source.command;
    }
    return answer;
}

// --- adding and removing -----------------------------------------------------------------------

Answer TrajectoryEdits::add(double time, const Vector& place) const {
    Answer answer;
    if (fromPoints_) {
        const auto& points = trajectory().points;
        const auto next =
            std::ranges::find_if(points, [&](const auto& point) { return point.first >= time; });
        if (next != points.end() && next->first == time)
            answer.reason = "There is a point at that time already.";
        else
            return insertAt("-points", static_cast<std::size_t>(next - points.begin()),
                            points.size(), pointText(time, place));
        return answer;
    }
    const Curves& curves = trajectory().curves;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        if (time <= curves[c].from || time >= curves[c].to)
            continue;
        auto [left, right] = scene::split(curves[c], time);
        const Vector delta = place - left.control.back();
        for (BezierCurve* half : {&left, &right})
            if (half->control.size() == 4)
                half->control[half == &left ? 2 : 1] += delta;
        left.control.back() = right.control.front() = place;
        scene::Range here;
        if (Answer no = this->place("-bezier", c, here); !no.possible())
            return no;
        answer.edits = {{{here.from, here.to}, curveText(left) + " " + curveText(right)}};
        return answer;
    }
    // Outside of all: a straight way from the nearest end.
    const auto straight = [&](double t0, const Vector& p0, double t1, const Vector& p1) {
        return curveText({t0, t1, {p0, p0 + (p1 - p0) / 3, p1 - (p1 - p0) / 3, p1}});
    };
    if (time > curves.back().to)
        return insertAt("-bezier", curves.size(), curves.size(),
                        straight(curves.back().to, curves.back().control.back(), time, place));
    if (time < curves.front().from)
        return insertAt("-bezier", 0, curves.size(),
                        straight(time, place, curves.front().from, curves.front().control.front()));
    answer.reason = "There is a point at that time already, or a gap of the trajectory.";
    return answer;
}

Answer TrajectoryEdits::remove(std::size_t point) const {
    const ControlPoint& p = points_[point];
    Answer answer;
    const auto knots = static_cast<std::size_t>(
        std::ranges::count_if(points_, [](const ControlPoint& one) { return one.onCurve; }));
    if (!p.onCurve) {
        answer.reason = "A tangent goes with its point.";
    } else if (knots <= 2) {
        answer.reason = mapper_.nameOf({Kind::trajectory, trajectory_}) +
                        " needs two points; the trajectory itself can be deleted.";
    } else if (fromPoints_) {
        return removeAt("-points", knotOf(point), knots);
    } else if (!p.joins) {
        return removeAt("-bezier", p.curve, trajectory().curves.size());
    } else {
        const BezierCurve& left = trajectory().curves[p.curve];
        const BezierCurve& right = trajectory().curves[p.curve + 1];
        scene::Range a, b;
        if (Answer no = place("-bezier", p.curve, a); !no.possible())
            return no;
        if (Answer no = place("-bezier", p.curve + 1, b); !no.possible())
            return no;
        if (left.control.size() != 4 || right.control.size() != 4 || b.from < a.to) {
            answer.reason = "Only a point between two cubic curves, written one after the other, "
                            "can be removed.";
            return answer;
        }
        BezierCurve first = left, second = right;
        const double length = right.to - left.from;
        stretch(first, left.from, left.from + length);
        stretch(second, right.to - length, right.to);
        const BezierCurve one{
            left.from,
            right.to,
            {first.control[0], first.control[1], second.control[2], second.control[3]}};
        answer.edits = {{{a.from, b.to}, curveText(one)}};
    }
    return answer;
}

} // namespace editing
