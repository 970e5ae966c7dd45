#include "picture/gizmo.h"

#include "gestures/handle_meaning.h"
#include "picture/scene_display.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace views {

using geometry::Vector;

namespace {

constexpr double tail = 18, length = 74, nearArrow = 7, nearRing = 7, least = 14,
                 atBody = 34; // pixels

} // namespace

unsigned colorOfAxis(int axis) {
    constexpr std::array<unsigned, 3> colors{0xFFDC4446, 0xFF4E9A2E, 0xFF3468D6};
    return colors[static_cast<std::size_t>(axis)];
}

std::optional<Gizmo::Place> Gizmo::place() const {
    const Shown& shown = document_.shown();
    const double start = shown.motion ? shown.motion->start() : display_.time();
    if (display_.creating().active() || display_.time() > start) // there it is thrown
        return std::nullopt;
    std::vector<std::size_t> bodies;
    for (const editing::Element& one : document_.selected()) {
        if (one.kind != editing::Kind::body)
            continue;
        if (one.index >= shown.scene->bodies.size() ||
            render::isHidden(display_.display(), shown.scene->bodies[one.index]))
            return std::nullopt;
        bodies.push_back(one.index);
    }
    if (bodies.empty())
        return std::nullopt;
    if (bodies.size() == 1)
        return Place{bodies.front(), pivotOf(bodies.front())};
    Vector sum = Vector::Zero();
    for (const std::size_t body : bodies)
        sum += display_.centerOf(body);
    return Place{bodies.front(), sum / static_cast<double>(bodies.size()), false};
}

// A drag goes on with what it began with, and so does a scene that is awaited.
bool Gizmo::isPlacedAlone(std::size_t body) const {
    const auto& scene = document_.shown().scene;
    const bool isKnown = alone_.scene == scene && alone_.body == body;
    if (!isKnown && !display_.editing().dragging() && document_.sceneIsCurrent())
        alone_ = {scene, body,
                  gestures::isPlacedAlone(editing::Mapper(document_.text(), scene), body)};
    return alone_.body != body || alone_.is;
}

// A body in joints turns as these let it.
Vector Gizmo::pivotOf(std::size_t body) const {
    const Shown& shown = document_.shown();
    const std::string& name = shown.scene->bodies[body].name;
    const bool isHeld = std::ranges::any_of(shown.scene->joints, [&](const scene::Joint& joint) {
        return joint.body1 == name || joint.body2 == name;
    });
    if (isHeld || isPlacedAlone(body))
        return display_.centerOf(body);
    return render::poseOf(*shown.scene, shown.motion.get(), body, display_.time()).position;
}

std::optional<std::pair<QPointF, QPointF>> Gizmo::arrow(const Vector& place, int axis) const {
    const gestures::Sight sight = display_.sight();
    const double unit = sight.pixelLength(place) * display_.devicePixelRatioF();
    const QPointF from = display_.fromPixels(sight.pixels(place));
    const QPointF to =
        display_.fromPixels(sight.pixels(place + length * unit * Vector::Unit(axis)));
    const QLineF whole(from, to);
    if (whole.length() < least + tail)
        return std::nullopt;
    return std::pair(whole.pointAt(tail / whole.length()), to);
}

QPolygonF Gizmo::ringOf(const Vector& place, int axis) const {
    const gestures::Sight sight = display_.sight();
    const double radius = ring * sight.pixelLength(place) * display_.devicePixelRatioF();
    const Vector toViewer = sight.camera.rotation.conjugate() * Vector::UnitZ();
    const Vector normal = Vector::Unit(axis);
    Vector side = normal.cross(toViewer);
    constexpr double faces = 0.15, slants = 0.12;
    const bool isWhole = side.norm() < faces; // it faces the viewer
    if (std::abs(normal.dot(toViewer)) < slants)
        return {}; // a line across the body
    side = isWhole ? Vector(Vector::Unit((axis + 1) % 3)) : Vector(side.normalized());
    const Vector front = side.cross(normal);
    QPolygonF points;
    constexpr int count = 40;
    for (int i = 0; i <= count; ++i) {
        const double angle = (isWhole ? 2 * M_PI : M_PI) * i / count;
        const Vector at = place + radius * (std::cos(angle) * side + std::sin(angle) * front);
        points << display_.fromPixels(sight.pixels(at));
    }
    return points;
}

std::optional<Gizmo::Part> Gizmo::at(const QPointF& position) const {
    const auto of = place();
    for (int axis = 0; of && axis < 3; ++axis) {
        const auto ends = arrow(of->middle, axis);
        if (!ends)
            continue;
        const QPointF way = ends->second - ends->first, to = position - ends->first;
        const double along =
            std::clamp(QPointF::dotProduct(to, way) / QPointF::dotProduct(way, way), 0.0, 1.1);
        if (QLineF(ends->first + along * way, position).length() < nearArrow)
            return Part{of->body, axis};
    }
    for (int axis = 0; of && of->isOne && axis < 3; ++axis) {
        const QPolygonF points = ringOf(of->middle, axis);
        const QPointF middle = display_.fromPixels(display_.sight().pixels(of->middle));
        if (QLineF(middle, position).length() < atBody)
            break;
        for (qsizetype i = 0; i + 1 < points.size(); ++i) {
            const QPointF way = points[i + 1] - points[i], to = position - points[i];
            const double length = std::max(QPointF::dotProduct(way, way), 1e-9);
            const double along = std::clamp(QPointF::dotProduct(to, way) / length, 0.0, 1.0);
            if (QLineF(points[i] + along * way, position).length() < nearRing)
                return Part{of->body, axis, true};
        }
    }
    return std::nullopt;
}

void Gizmo::paint(QPainter& painter) const {
    const auto of = place();
    for (int axis = 0; of && of->isOne && axis < 3; ++axis) {
        QColor faint = QColor::fromRgb(colorOfAxis(axis));
        faint.setAlphaF(0.75F);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(faint, 1.6));
        painter.drawPolyline(ringOf(of->middle, axis));
    }
    for (int axis = 0; of && axis < 3; ++axis) {
        const auto ends = arrow(of->middle, axis);
        if (!ends)
            continue;
        const QColor color = QColor::fromRgb(colorOfAxis(axis));
        const QLineF line(ends->first, ends->second);
        painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line);
        const QPointF back = (line.p1() - line.p2()) / line.length();
        const QPointF side(-back.y(), back.x());
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawPolygon(QPolygonF({line.p2() - 4 * back, line.p2() + 7 * back + 4.5 * side,
                                       line.p2() + 7 * back - 4.5 * side}));
    }
}

} // namespace views
