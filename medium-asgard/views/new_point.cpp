#include "views/new_point.h"

#include <QObject>

#include <cmath>

namespace views {

using editing::ControlPoint;
using geometry::Vector;

namespace {

double rounded(double value, double length) {
    const double step = length > 0 ? std::pow(10, std::floor(std::log10(length))) : 0;
    // Through its decimals, so that it is written in few digits.
    return step > 0 ? QString::number(std::round(value / step) * step, 'g', 12).toDouble() : value;
}

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

std::size_t pointOf(const editing::TrajectoryEdits& edits, const render::Handle& handle) {
    if (edits.hasOwnTangents())
        return std::min(handle.part, edits.points().size() - 1);
    std::size_t part = 0;
    for (std::size_t i = 0; i < edits.points().size(); ++i)
        if (edits.points()[i].onCurve && part++ == handle.part)
            return i;
    return 0;
}

NewPoint::NewPoint(SceneDocument& document, const Sight& sight, const render::Handle& from)
    : document_(document), text_(document.text()), scene_(document.shown().scene),
      edits_(text_, scene_, from.element), sight_(sight), from_(pointOf(edits_, from)),
      trajectory_(from.element), place_(from.place) {}

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
        document_.preview(editing::applied(text_, answer_.edits));
}

void NewPoint::move(const Eigen::Vector2d& pixels) {
    const auto& points = edits_.points();
    const Vector from = points[from_].place;
    if (!later_) {
        const Eigen::Vector2d way = pixels - sight_.pixels(from);
        if (way.norm() < 5)
            return;
        const auto along = [&](bool later) -> double {
            const Eigen::Vector2d toward =
                sight_.pixels(points[neighbour(points, from_, later)].place) - sight_.pixels(from);
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
    const Vector place = sight_.beside(pixels, from);
    const double length = sight_.pixelLength(from);
    for (int i = 0; i < 3; ++i)
        place_[i] = rounded(place[i], length);
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
    document_.finishPreview(
        later_ && answer_.possible() ? editing::applied(text_, answer_.edits) : text_,
        QObject::tr("New point of %1")
            .arg(QString::fromStdString(scene_->trajectories[trajectory_].name)));
}

void NewPoint::cancel() { document_.finishPreview(text_, {}); }

QString NewPoint::words() const {
    const QString name = QString::fromStdString(scene_->trajectories[trajectory_].name);
    if (!answer_.possible())
        return QString::fromStdString(answer_.reason);
    if (!later_)
        return QObject::tr("%1: a new point, before or after by where you drag").arg(name);
    return QObject::tr("%1: new point at %2 s: %3 %4 %5")
        .arg(name)
        .arg(time_, 0, 'g', 5)
        .arg(place_.x(), 0, 'g', 5)
        .arg(place_.y(), 0, 'g', 5)
        .arg(place_.z(), 0, 'g', 5);
}

} // namespace views
