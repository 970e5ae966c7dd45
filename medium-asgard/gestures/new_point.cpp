#include "gestures/new_point.h"

#include "editing/number_text.h"

#include <algorithm>
#include <utility>

namespace gestures {

using editing::ControlPoint;
using geometry::Vector;

namespace {

// The neighbour on the curve, or the point itself at an end.
std::size_t neighbour(const std::vector<ControlPoint>& points, std::size_t of, bool later) {
    for (std::size_t i = of; later ? i + 1 < points.size() : i > 0;) {
        i = later ? i + 1 : i - 1;
        if (points[i].onCurve)
            return i;
    }
    return of;
}

} // namespace

namespace {

// Written with -points only those on the curve are handles.
std::size_t pointOf(const std::vector<ControlPoint>& points, bool ownTangents, std::size_t part) {
    if (ownTangents)
        return std::min(part, points.size() - 1);
    std::size_t knot = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].onCurve && knot++ == part)
            return i;
    return 0;
}

} // namespace

std::size_t pointOf(const editing::TrajectoryEdits& edits, const render::Handle& handle) {
    return pointOf(edits.points(), edits.hasOwnTangents(), handle.part);
}

std::size_t pointOf(const scene::Trajectory& trajectory, std::size_t part) {
    return pointOf(editing::controlPointsOf(trajectory.curves), trajectory.points.empty(), part);
}

std::size_t partOf(const scene::Trajectory& trajectory, std::size_t point) {
    if (trajectory.points.empty())
        return point;
    const auto points = editing::controlPointsOf(trajectory.curves);
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(point),
                      [](const ControlPoint& one) { return one.onCurve; }));
}

NewPoint::NewPoint(Ground ground, const Sight& sight, const render::Handle& from)
    : ground_(std::move(ground)), edits_(ground_.text, ground_.scene, from.element), sight_(sight),
      handle_(from), from_(pointOf(edits_, from)), trajectory_(from.element),
      place_(from.valueAt(from.place)) {}

double NewPoint::timeTowards(bool later) const {
    const auto& points = edits_.points();
    const std::size_t there = neighbour(points, from_, later);
    const double now = points[from_].time;
    if (there != from_)
        return (now + points[there].time) / 2;
    // Beyond the end, as far as the last two are apart.
    const std::size_t other = neighbour(points, from_, !later);
    return now + (other == from_ ? (later ? 1 : -1) : now - points[other].time);
}

void NewPoint::update() {
    answer_ = edits_.add(time_, place_);
    if (answer_.possible())
        ground_.preview(text::applied(ground_.text, answer_.edits));
}

void NewPoint::move(const Eigen::Vector2d& pixels) {
    const auto& points = edits_.points();
    const Vector from = handle_.placeOf(points[from_].place);
    if (!later_) {
        const Eigen::Vector2d way = pixels - sight_.pixels(from);
        if (way.norm() < 5)
            return;
        const auto along = [&](bool later) -> double {
            const Eigen::Vector2d toward =
                sight_.pixels(handle_.placeOf(points[neighbour(points, from_, later)].place)) -
                sight_.pixels(from);
            return toward.norm() > 0 ? way.dot(toward) / toward.norm() : 0;
        };
        const bool first = neighbour(points, from_, false) == from_;
        const bool last = neighbour(points, from_, true) == from_;
        // At an end, away from the only neighbour is beyond the end; alone, after.
        later_ = first && last ? true
                 : last        ? along(false) <= 0
                 : first       ? along(true) > 0
                               : along(true) >= along(false);
        time_ = timeTowards(*later_);
    }
    const Vector place = handle_.valueAt(sight_.beside(pixels, from));
    const double step = editing::decimalStep(sight_.pixelLength(from) / handle_.perUnit);
    for (int i = 0; i < 3; ++i)
        place_[i] = editing::roundedTo(place[i], step);
    update();
}

void NewPoint::after() {
    later_ = true;
    const auto& points = edits_.points();
    const std::size_t next = neighbour(points, from_, true);
    const std::size_t before = neighbour(points, from_, false);
    time_ = timeTowards(true);
    place_ = next != from_ ? Vector((points[from_].place + points[next].place) / 2)
                           : Vector(2 * points[from_].place - points[before].place);
    update();
}

void NewPoint::finish() {
    ground_.finish(later_ && answer_.possible() ? text::applied(ground_.text, answer_.edits)
                                                : ground_.text,
                   "New point of " + ground_.scene->trajectories[trajectory_].name);
}

void NewPoint::cancel() { ground_.finish(ground_.text, {}); }

std::string NewPoint::words() const {
    const std::string& name = ground_.scene->trajectories[trajectory_].name;
    if (!answer_.possible())
        return answer_.reason;
    if (!later_)
        return name + ": a new point, before or after by where you drag";
    std::string text = name + ": new point at " + editing::inDigits(time_, 5) + " s:";
    for (const double x : place_)
        text += " " + editing::inDigits(x, 5);
    return text;
}

} // namespace gestures
