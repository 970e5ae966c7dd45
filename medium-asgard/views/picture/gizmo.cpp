#include "picture/gizmo.h"

#include "gestures/handle_meaning.h"
#include "picture/scene_display.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace views {

using geometry::Vector;

namespace {

constexpr double tail = 18, length = 74, nearArrow = 7, nearRing = 7, least = 14, atBody = 34,
                 ring = 92, beside = 8, aroundBody = 16, margin = 14, halfSquare = 8; // pixels

// The way from the point to the rectangle's edge; 0: it is outside.
double roomAlong(const QRectF& in, const QPointF& from, const QPointF& way) {
    if (!in.contains(from))
        return 0;
    const auto until = [](double place, double step, double low, double high) {
        return std::abs(step) < 1e-9 ? 1e9 : ((step > 0 ? high : low) - place) / step;
    };
    return std::min(until(from.x(), way.x(), in.left(), in.right()),
                    until(from.y(), way.y(), in.top(), in.bottom()));
}

QRectF roomOf(const QWidget& picture) {
    return QRectF(picture.rect()).adjusted(margin, margin, -margin, -margin);
}

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
    Place all{bodies.front(), pivotOf(bodies.front()), bodies.size() == 1};
    if (all.isOne) {
        addSilhouette(all, all.body);
        return all;
    }
    Vector sum = Vector::Zero();
    for (const std::size_t body : bodies)
        sum += display_.centerOf(body);
    all.middle = sum / static_cast<double>(bodies.size());
    const gestures::Sight sight = display_.sight();
    for (const gestures::Picked& there :
         gestures::bodiesAt(display_.drawn(), sight, sight.pixels(all.middle)))
        if (std::ranges::find(bodies, there.body) != bodies.end())
            addSilhouette(all, there.body);
    return all;
}

void Gizmo::addSilhouette(Place& place, std::size_t body) const {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawn = display_.drawn();
    const scene::Scene& scene = *drawn.scene;
    const geometry::Pose pose = render::poseOf(scene, drawn.motion.get(), body, drawn.time);
    const QPointF middle = display_.fromPixels(sight.pixels(place.middle));
    for (const render::Ball& ball : render::outlineOf(scene, scene.bodies[body])) {
        const Vector at = pose.toWorld(ball.center);
        const double pixel = sight.pixelLength(at) * display_.devicePixelRatioF();
        place.silhouette.emplace_back(display_.fromPixels(sight.pixels(at)) - middle,
                                      ball.radius / pixel);
    }
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
    const render::Drawing drawn = display_.drawn();
    return render::poseOf(*drawn.scene, drawn.motion.get(), body, drawn.time).position;
}

// The way from the middle to what is beside the bodies.
double Gizmo::reachOf(const Place& place, const QPointF& way) {
    double reach = tail;
    for (const auto& [at, radius] : place.silhouette)
        reach = std::max(reach, QPointF::dotProduct(at, way) + radius + beside);
    return reach;
}

std::optional<Gizmo::Arrow> Gizmo::arrowOf(const Place& place, int axis) const {
    const gestures::Sight sight = display_.sight();
    const double unit = sight.pixelLength(place.middle) * display_.devicePixelRatioF();
    const QPointF from = display_.fromPixels(sight.pixels(place.middle));
    const QPointF to =
        display_.fromPixels(sight.pixels(place.middle + length * unit * Vector::Unit(axis)));
    const QLineF whole(from, to);
    if (whole.length() < least + tail)
        return std::nullopt;
    const QPointF way = (to - from) / whole.length();
    const double reach = reachOf(place, way);
    const double drawn = whole.length() - tail;
    const double room = std::max(tail, roomAlong(roomOf(display_), from, way) - drawn);
    const double begins = std::min(reach, room);
    return Arrow{{from + begins * way, from + (begins + drawn) * way}, reach <= room};
}

// Between the tails of the two arrows that lie in its plane.
std::optional<Gizmo::Square> Gizmo::squareOf(const Place& place, int axis) const {
    const auto one = arrowOf(place, (axis + 1) % 3), other = arrowOf(place, (axis + 2) % 3);
    if (!one || !other)
        return std::nullopt;
    const QPointF from = display_.fromPixels(display_.sight().pixels(place.middle));
    const auto side = [](const QLineF& arrow) { // as the axis is shortened
        return halfSquare / (length - tail) * (arrow.p2() - arrow.p1());
    };
    const QPointF a = side(one->line), b = side(other->line);
    if (4 * std::abs(a.x() * b.y() - a.y() * b.x()) < halfSquare * halfSquare)
        return std::nullopt;
    const bool isBeside = one->isBeside && other->isBeside;
    QPointF way = one->line.p1() + other->line.p1() - 2 * from;
    const double away = std::hypot(way.x(), way.y());
    if (away < 1)
        return std::nullopt;
    if (isBeside) // arrows that look apart have the body between them
        way *= std::max(1.0, (reachOf(place, way / away) + halfSquare) / away);
    const QPointF middle = from + way;
    if (!roomOf(display_).contains(middle))
        return std::nullopt;
    return Square{{{middle - a - b, middle + a - b, middle + a + b, middle - a + b}}, isBeside};
}

QPolygonF Gizmo::square(int axis) const {
    const auto of = place();
    const auto found = of ? squareOf(*of, axis) : std::nullopt;
    return found ? found->corners : QPolygonF();
}

std::optional<QLineF> Gizmo::arrow(int axis) const {
    const auto of = place();
    const auto found = of ? arrowOf(*of, axis) : std::nullopt;
    return found ? std::optional(found->line) : std::nullopt;
}

Gizmo::Radius Gizmo::radiusOf(const Place& place) const {
    double reach = ring;
    for (const auto& [at, radius] : place.silhouette)
        reach = std::max(reach, std::hypot(at.x(), at.y()) + radius + aroundBody);
    const QSizeF size = roomOf(display_).size();
    const double room = std::max(ring, std::min(size.width(), size.height()) / 2);
    return {std::min(reach, room), reach <= room};
}

double Gizmo::ringRadius(std::size_t body) const {
    Place place{body, pivotOf(body)};
    addSilhouette(place, body);
    return radiusOf(place).pixels;
}

QPolygonF Gizmo::ringOf(const Vector& place, double pixels, int axis) const {
    const gestures::Sight sight = display_.sight();
    const double radius = pixels * sight.pixelLength(place) * display_.devicePixelRatioF();
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
    if (!of)
        return std::nullopt;
    const bool isOnBody = display_.selecting().selectedBodyAt(position).has_value();
    for (int axis = 0; axis < 3; ++axis) {
        const auto one = arrowOf(*of, axis);
        if (!one || (isOnBody && one->isBeside))
            continue;
        const QPointF way = one->line.p2() - one->line.p1(), to = position - one->line.p1();
        const double along =
            std::clamp(QPointF::dotProduct(to, way) / QPointF::dotProduct(way, way), 0.0, 1.1);
        if (QLineF(one->line.p1() + along * way, position).length() < nearArrow)
            return Part{of->body, axis};
    }
    for (int axis = 0; axis < 3; ++axis)
        if (const auto one = squareOf(*of, axis);
            one && !(isOnBody && one->isBeside) &&
            one->corners.containsPoint(position, Qt::OddEvenFill))
            return Part{of->body, axis, false, true};
    const Radius radius = radiusOf(*of);
    const QPointF middle = display_.fromPixels(display_.sight().pixels(of->middle));
    if (!of->isOne || (isOnBody && radius.isBeside) || QLineF(middle, position).length() < atBody)
        return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        const QPolygonF points = ringOf(of->middle, radius.pixels, axis);
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
        painter.drawPolyline(ringOf(of->middle, radiusOf(*of).pixels, axis));
    }
    for (int axis = 0; of && axis < 3; ++axis)
        if (const auto one = squareOf(*of, axis)) {
            QColor color = QColor::fromRgb(colorOfAxis(axis));
            painter.setPen(QPen(color, 1.4));
            color.setAlphaF(0.45F);
            painter.setBrush(color);
            painter.drawPolygon(one->corners);
        }
    for (int axis = 0; of && axis < 3; ++axis) {
        const auto one = arrowOf(*of, axis);
        if (!one)
            continue;
        const QColor color = QColor::fromRgb(colorOfAxis(axis));
        const QLineF line = one->line;
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
