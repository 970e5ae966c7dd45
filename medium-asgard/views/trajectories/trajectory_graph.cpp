#include "trajectories/trajectory_graph.h"

#include "frame/readable.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

constexpr double pointReach = 9;   // pixels within which a point is taken
constexpr double timeDragFrom = 6; // pixels after which a drag changes the time
constexpr double leftSpace = 56, topSpace = 10, rightSpace = 14;

// Red, green, blue for x, y, z, as the axes are drawn.
QColor curveColour(int component, const QPalette& palette) {
    static const QColor colours[] = {QColor(0xB8, 0x30, 0x2A), QColor(0x2E, 0x86, 0x3B),
                                     QColor(0x2A, 0x55, 0xB8)};
    return readable(colours[component], palette.color(QPalette::Base));
}

} // namespace

TrajectoryGraph::TrajectoryGraph(int component, const QString& name)
    : component_(component), name_(name) {
    setFocusPolicy(Qt::ClickFocus);
    setMouseTracking(true);
    setAccessibleName(tr("%1 against time").arg(name));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TrajectoryGraph::setCurves(std::vector<scene::BezierCurve> curves,
                                std::vector<editing::ControlPoint> points) {
    curves_ = std::move(curves);
    points_ = std::move(points);
    if (!holdsValues_)
        fitValues();
    update();
}

void TrajectoryGraph::fitValues() {
    if (points_.empty())
        return;
    low_ = high_ = points_.front().place[component_];
    for (const editing::ControlPoint& point : points_) {
        low_ = std::min(low_, point.place[component_]);
        high_ = std::max(high_, point.place[component_]);
    }
    // What does not change is a line in the middle, at the scale of its size.
    const double least = std::max(1.0, 0.2 * std::max(std::abs(low_), std::abs(high_)));
    const double room = 0.12 * (high_ - low_) + std::max(0.0, least - (high_ - low_)) / 2;
    low_ -= room;
    high_ += room;
}

void TrajectoryGraph::setChosen(std::optional<std::size_t> point) {
    chosen_ = point;
    update();
}

void TrajectoryGraph::setTimes(double from, double to) {
    from_ = from;
    to_ = to;
    update();
}

void TrajectoryGraph::setNow(std::optional<double> time) {
    now_ = time;
    update();
}

// --- where things are --------------------------------------------------------------------------

QRectF TrajectoryGraph::area() const {
    return {leftSpace, topSpace, std::max(1.0, width() - leftSpace - rightSpace),
            std::max(1.0, height() - topSpace - fontMetrics().height() - 8.0)};
}

ChartAxes TrajectoryGraph::axes() const { return {area(), from_, to_, low_, high_}; }

QPointF TrajectoryGraph::place(double time, double value) const {
    return axes().place(time, value);
}

double TrajectoryGraph::timeAt(double x) const {
    return from_ + (x - area().left()) / area().width() * (to_ - from_);
}

double TrajectoryGraph::valueAt(double y) const {
    return low_ + (area().bottom() - y) / area().height() * (high_ - low_);
}

bool TrajectoryGraph::isShown(std::size_t point) const {
    if (points_[point].onCurve || !chosen_)
        return points_[point].onCurve;
    const auto knotBefore = [&](std::size_t i) {
        while (i > 0 && !points_[i].onCurve)
            --i;
        return i;
    };
    const std::size_t before = knotBefore(point);
    std::size_t after = point;
    while (after + 1 < points_.size() && !points_[after].onCurve)
        ++after;
    return (*chosen_ >= before && *chosen_ <= after);
}

// The chosen point first, then points, then tangents: what lies on top of another is taken.
std::optional<std::size_t> TrajectoryGraph::pointAt(const QPointF& position) const {
    std::optional<std::size_t> nearest;
    double best = pointReach;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!isShown(i))
            continue;
        const QPointF there = place(points_[i].time, points_[i].place[component_]);
        const double distance = std::hypot(there.x() - position.x(), there.y() - position.y()) -
                                (points_[i].onCurve ? 1 : 0) - (chosen_ == i ? 1 : 0);
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    return nearest;
}

// --- what is drawn -----------------------------------------------------------------------------

void TrajectoryGraph::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area(), palette().color(QPalette::Base));
    paintAxes(painter);
    painter.save();
    painter.setClipRect(area().adjusted(-6, -6, 6, 6));
    if (now_) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawLine(place(*now_, low_), place(*now_, high_));
    }
    paintCurve(painter);
    paintPoints(painter);
    painter.restore();
    QColor frame = palette().color(QPalette::WindowText);
    frame.setAlpha(hasFocus() ? 160 : 70);
    painter.setPen(QPen(frame, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area());
}

void TrajectoryGraph::paintAxes(QPainter& painter) const {
    const QRectF a = area();
    views::paintAxes(painter, axes(), palette());
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(readable(curveColour(component_, palette()), palette().color(QPalette::Window)));
    painter.drawText(QPointF(4, a.top() + fontMetrics().ascent()), name_);
    painter.setFont(font());
}

void TrajectoryGraph::paintCurve(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(curveColour(component_, palette()), 2));
    for (const scene::BezierCurve& curve : curves_) {
        const auto n = static_cast<double>(curve.control.size() - 1);
        const auto control = [&](std::size_t i) {
            const double share = n > 0 ? static_cast<double>(i) / n : 0;
            return place(curve.from + share * (curve.to - curve.from),
                         curve.control[i][component_]);
        };
        QPainterPath path(control(0));
        if (curve.control.size() == 4) {
            path.cubicTo(control(1), control(2), control(3));
        } else {
            constexpr int pieces = 64;
            for (int k = 1; k <= pieces; ++k) {
                std::vector<QPointF> p;
                for (std::size_t i = 0; i < curve.control.size(); ++i)
                    p.push_back(control(i));
                for (std::size_t m = p.size() - 1; m > 0; --m)
                    for (std::size_t i = 0; i < m; ++i)
                        p[i] += (p[i + 1] - p[i]) * (static_cast<double>(k) / pieces);
                path.lineTo(p.front());
            }
            if (curve.control.size() == 1) // it holds until its end
                path.lineTo(place(curve.to, curve.control.front()[component_]));
        }
        painter.drawPath(path);
    }
}

void TrajectoryGraph::paintPoints(QPainter& painter) const {
    const QColor colour = curveColour(component_, palette());
    QColor faint = palette().color(QPalette::WindowText);
    faint.setAlpha(120);
    const auto at = [&](std::size_t i) {
        return place(points_[i].time, points_[i].place[component_]);
    };
    for (std::size_t i = 0; i < points_.size(); ++i) { // to the tangents of the chosen point
        if (points_[i].onCurve || !isShown(i))
            continue;
        painter.setPen(QPen(faint, 1));
        if (i > 0 && points_[i - 1].onCurve)
            painter.drawLine(at(i - 1), at(i));
        if (i + 1 < points_.size() && points_[i + 1].onCurve)
            painter.drawLine(at(i), at(i + 1));
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!isShown(i))
            continue;
        const bool isChosen = chosen_ == i;
        const double radius = points_[i].onCurve ? (isChosen ? 6 : 5) : (isChosen ? 5 : 4);
        painter.setPen(QPen(isChosen ? palette().color(QPalette::Highlight) : colour.darker(120),
                            isChosen ? 2.5 : 1.2));
        painter.setBrush(points_[i].onCurve ? QBrush(colour)
                                            : QBrush(palette().color(QPalette::Base)));
        painter.drawEllipse(at(i), radius, radius);
    }
}

// --- what is done ------------------------------------------------------------------------------

void TrajectoryGraph::mousePressEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (event->button() == Qt::MiddleButton) {
        Q_EMIT addWanted(timeAt(at.x()), valueAt(at.y()));
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto point = pointAt(at)) {
        const editing::ControlPoint& taken = points_[*point];
        drag_ = PointDrag{at, place(taken.time, taken.place[component_]) - at, taken.time};
        Q_EMIT chosen(*point);
    } else {
        drag_ = PlaneDrag{at, from_, to_};
        setCursor(Qt::ClosedHandCursor);
    }
}

void TrajectoryGraph::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || pointAt(event->position()))
        return;
    drag_ = {};
    Q_EMIT addWanted(timeAt(event->position().x()), valueAt(event->position().y()));
}

void TrajectoryGraph::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (auto* drag = std::get_if<PointDrag>(&drag_)) {
        drag->keepsTime = drag->keepsTime && std::abs(at.x() - drag->from.x()) < timeDragFrom;
        const QPointF there = at + drag->offset;
        Q_EMIT dragged(drag->keepsTime ? drag->time : timeAt(there.x()), valueAt(there.y()),
                       event->modifiers());
    } else if (const auto* plane = std::get_if<PlaneDrag>(&drag_)) {
        const double shift =
            (plane->from.x() - at.x()) / area().width() * (plane->last - plane->first);
        Q_EMIT timesWanted(plane->first + shift, plane->last + shift);
    } else {
        setCursor(pointAt(at) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
}

void TrajectoryGraph::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    const auto before = std::exchange(drag_, {});
    setCursor(Qt::ArrowCursor);
    if (std::holds_alternative<PointDrag>(before))
        Q_EMIT released();
}

void TrajectoryGraph::letGo() {
    drag_ = {};
    holdsValues_ = false;
    setCursor(Qt::ArrowCursor);
}

void TrajectoryGraph::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(0.999, event->angleDelta().y());
    const double middle = timeAt(event->position().x());
    Q_EMIT timesWanted(middle + factor * (from_ - middle), middle + factor * (to_ - middle));
    event->accept();
}

void TrajectoryGraph::contextMenuEvent(QContextMenuEvent* event) {
    const QPointF at = event->pos();
    Q_EMIT menuWanted(event->globalPos(), pointAt(at), timeAt(at.x()), valueAt(at.y()));
}

} // namespace views
