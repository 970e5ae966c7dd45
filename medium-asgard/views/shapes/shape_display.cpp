#include "shapes/shape_display.h"

#include "framing/studio.h"
#include "geometry/hull.h"
#include "point_edits/shape_points.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

using geometry::Vector;
using Button = render::CameraControl::Button;

constexpr double reach = 10; // pixels within which a point is taken
constexpr double ballRadius = 5;
const QColor grey(0xA8, 0xAC, 0xB2), chosenRing(0xF0, 0x96, 0x14);

std::optional<Button> buttonOf(Qt::MouseButton button) {
    if (button == Qt::LeftButton)
        return Button::left;
    if (button == Qt::MiddleButton)
        return Button::middle;
    return button == Qt::RightButton ? std::optional(Button::right) : std::nullopt;
}

Eigen::Vector2d vector(const QPointF& p) { return {p.x(), p.y()}; }

// Of x, y and z; seen on light and on dark.
const QColor axisColours[] = {QColor(0xC0, 0x35, 0x36), QColor(0x3B, 0x7D, 0x22),
                              QColor(0x34, 0x68, 0xD6)};

// A disc with its letter, whatever shape is behind it.
void paintAxisName(QPainter& painter, int axis, const QPointF& at) {
    constexpr double radius = 9;
    painter.setPen(Qt::NoPen);
    painter.setBrush(axisColours[axis]);
    painter.drawEllipse(at, radius, radius);
    painter.setPen(Qt::white);
    painter.drawText(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius),
                     Qt::AlignCenter, QString(QChar('x' + axis)));
}

} // namespace

ShapeDisplay::ShapeDisplay(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Shape"));
    setAccessibleDescription(
        tr("The parts of the shape. The left button drags a point, elsewhere it turns the view; "
           "with Shift the middle one adds a point, the right one deletes one."));
    setMouseTracking(true);
    render::Camera camera;
    camera.rotation = render::facing({0.45, 0.35, 1}, Vector::UnitY());
    control_.set(camera);
}

// --- what there is -----------------------------------------------------------------------------

ShapeDisplay::Drawn ShapeDisplay::drawn(const scene::Part& part) {
    Drawn result;
    result.points = editing::pointsOf(part);
    result.inner = editing::innerPoints(part);
    if (const auto* sphere = std::get_if<scene::SphereShape>(&part.shape)) {
        result.radius = sphere->radius;
        return result;
    }
    const scene::Part solid = editing::asPolyhedron(part);
    auto hull = geometry::convexHull(std::get<scene::HullShape>(solid.shape).points);
    if (auto* made = std::get_if<geometry::Hull>(&hull))
        result.solid = geometry::transformed(
            made->polyhedron, {part.position, geometry::fromRotationVector(part.rotation)});
    return result;
}

void ShapeDisplay::setParts(std::vector<scene::Part> parts, bool another) {
    if (another || parts.size() != parts_.size())
        surface_.assign(parts.size(), Vector::UnitX());
    std::vector<Drawn> now; // hulls are made of what changed only
    for (std::size_t i = 0; i < parts.size(); ++i)
        now.push_back(i < parts_.size() && parts[i] == parts_[i] ? std::move(drawn_[i])
                                                                 : drawn(parts[i]));
    parts_ = std::move(parts);
    drawn_ = std::move(now);
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        if (drawn_[i].radius)
            drawn_[i].points[1] = drawn_[i].points[0] + *drawn_[i].radius * surface_[i];
    if (another || (part_ && *part_ >= parts_.size()))
        part_.reset();
    if (!part_ || (point_ && *point_ >= drawn_[*part_].points.size()))
        point_.reset();
    if (another)
        frame();
    update();
}

void ShapeDisplay::setForLooking() {
    forLooking_ = true;
    setAccessibleDescription(tr("The parts, each in a colour of its own."));
    update();
}

std::optional<Vector> ShapeDisplay::chosenPlace() const {
    if (!part_ || !point_)
        return std::nullopt;
    return drawn_[*part_].points[*point_];
}

void ShapeDisplay::choose(std::optional<std::size_t> part, std::optional<std::size_t> point) {
    part_ = part && *part < parts_.size() ? part : std::nullopt;
    point_ = part_ && point && *point < drawn_[*part_].points.size() ? point : std::nullopt;
    update();
}

void ShapeDisplay::setGrid(double step) {
    grid_ = step;
    update();
}

void ShapeDisplay::frame() {
    Eigen::AlignedBox3d box;
    for (const Drawn& one : drawn_)
        for (const Vector& p : one.points) {
            const double r = one.radius.value_or(0);
            box.extend(Vector(p.array() - r));
            box.extend(Vector(p.array() + r));
        }
    render::Camera camera = control_.camera();
    camera.center = box.isEmpty() ? Vector::Zero() : Vector(box.center());
    const double size = box.isEmpty() ? 1 : box.diagonal().norm() / 2;
    camera.scale = 0.9 / std::max(size, 1e-9);
    camera.position = Vector::Zero();
    control_.set(camera);
    update();
}

Vector ShapeDisplay::screenAxis(int which) const {
    const Eigen::Matrix3d seen = control_.camera().rotation.toRotationMatrix(); // columns: the axes
    int right = 0, up = 0;
    seen.row(0).cwiseAbs().maxCoeff(&right);
    Eigen::RowVector3d upwards = seen.row(1).cwiseAbs();
    upwards[right] = -1;
    upwards.maxCoeff(&up);
    const int axis = which == 0 ? right : which == 1 ? up : 3 - right - up;
    return (seen(which, axis) < 0 ? -1 : 1) * Vector::Unit(axis);
}

void ShapeDisplay::lookAlong(const Vector& toward) {
    render::Camera camera = control_.camera();
    camera.rotation = render::facing(toward, std::abs(toward.y()) > 0.99 ? Vector(0, 0, -toward.y())
                                                                         : Vector(0, 1, 0));
    control_.set(camera);
    update();
}

// --- where things are --------------------------------------------------------------------------

QPointF ShapeDisplay::position(const Vector& place) const {
    const Eigen::Vector2d p = render::toPixels(control_.camera(), pixels(), place);
    return {p.x(), p.y()};
}

double ShapeDisplay::depth(const Vector& place) const {
    const render::Camera& camera = control_.camera();
    return (camera.rotation * (place - camera.center)).z() * camera.scale + camera.position.z();
}

double ShapeDisplay::pixelLength() const {
    const Eigen::Vector2d middle(width() / 2.0, height() / 2.0);
    return (render::toWorld(control_.camera(), pixels(), middle + Eigen::Vector2d(1, 0)) -
            render::toWorld(control_.camera(), pixels(), middle))
        .norm();
}

Vector ShapeDisplay::placeAt(const QPointF& at, const Vector& like) const {
    Vector place = render::toWorld(control_.camera(), pixels(), vector(at), depth(like));
    if (grid_ <= 0)
        return place;
    for (int k = 0; k < 3; ++k) // a coordinate that one looks along stays as it was
        if (std::abs((control_.camera().rotation * Vector::Unit(k)).z()) > 0.999)
            place[k] = like[k];
        else
            place[k] = std::round(place[k] / grid_) * grid_;
    return place;
}

std::optional<ShapeDisplay::Hit> ShapeDisplay::pointAt(const QPointF& at) const {
    std::optional<Hit> nearest;
    double best = reach;
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        for (std::size_t k = 0; k < drawn_[i].points.size(); ++k) {
            const QPointF d = position(drawn_[i].points[k]) - at;
            // Of two as near the chosen part's, then the one in front.
            const double distance = std::hypot(d.x(), d.y()) - (part_ == i ? 2 : 0) -
                                    0.5 * std::clamp(depth(drawn_[i].points[k]), -1.0, 1.0);
            if (distance < best) {
                best = distance;
                nearest = {i, k};
            }
        }
    return nearest;
}

// --- what is drawn -----------------------------------------------------------------------------

QColor ShapeDisplay::colourOf(std::size_t part) const {
    if (!isColoured(part))
        return grey;
    const auto& color = parts_[part].appearance.color;
    if (forLooking_ && !color) // hues that follow each other are far apart
        return QColor::fromHsvF(static_cast<float>(std::fmod(0.58 + 0.381966 * double(part), 1.0)),
                                0.55F, 0.85F);
    if (!color)
        return QColor(0x2F, 0x6F, 0xB5);
    return QColor::fromRgbF(static_cast<float>(color->red), static_cast<float>(color->green),
                            static_cast<float>(color->blue));
}

void ShapeDisplay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBackdrop(painter);
    paintGrid(painter);
    paintFaces(painter);
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        if (part_ != i && !forLooking_) // there faces have their own, and hide those behind
            paintEdges(painter, i);
    if (part_)
        paintEdges(painter, *part_);
    if (!forLooking_)
        paintPoints(painter);
    for (int k = 0; k < 3; ++k)
        paintAxisName(painter, k, position(1.05 * 0.9 / control_.camera().scale * Vector::Unit(k)));
    QColor frame = palette().color(QPalette::WindowText);
    frame.setAlpha(hasFocus() ? 150 : 60);
    painter.setPen(QPen(frame, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

// Sky above and ground below, as behind a scene.
void ShapeDisplay::paintBackdrop(QPainter& painter) const {
    const bool isNight = palette().color(QPalette::Base).lightness() < 128;
    const render::StudioColors& colors = render::studioColors(isNight);
    QLinearGradient shade(0, 0, 0, height());
    const std::pair<double, const Eigen::Vector3f*> stops[] = {
        {0, &colors.low}, {0.55, &colors.haze}, {0.75, &colors.far}, {1, &colors.near}};
    for (const auto& [at, color] : stops)
        shade.setColorAt(at, QColor::fromRgbF(color->x(), color->y(), color->z()));
    painter.fillRect(rect(), shade);
}

// The axes, and with a grid its lines in the plane that is seen best.
void ShapeDisplay::paintGrid(QPainter& painter) const {
    if (grid_ > 0)
        paintLines(painter);
    const double half = 0.9 / control_.camera().scale;
    for (int k = 0; k < 3; ++k) {
        const QPointF end = position(half * Vector::Unit(k));
        painter.setPen(QPen(axisColours[k], 1.2));
        painter.drawLine(position(Vector::Zero()), end);
    }
}

void ShapeDisplay::paintLines(QPainter& painter) const {
    const int count = static_cast<int>(0.9 / control_.camera().scale / grid_);
    if (count > 60)
        return; // finer than one could see
    const Vector normal = screenAxis(2);
    int k = 0;
    normal.cwiseAbs().maxCoeff(&k);
    const Vector u = grid_ * Vector::Unit((k + 1) % 3), v = grid_ * Vector::Unit((k + 2) % 3);
    QColor ink = palette().color(QPalette::WindowText);
    ink.setAlpha(26);
    painter.setPen(QPen(ink, 1));
    for (int i = -count; i <= count; ++i) {
        painter.drawLine(position(i * u - count * v), position(i * u + count * v));
        painter.drawLine(position(i * v - count * u), position(i * v + count * u));
    }
}

// Faint, from back to front over all parts.
void ShapeDisplay::paintFaces(QPainter& painter) const {
    struct Face {
        QPolygonF outline;
        double z;
        QColor colour;
    };
    std::vector<Face> faces;
    const Vector light = Vector(0.3, 0.6, 0.75).normalized();
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
        for (const geometry::Face& face : drawn_[i].solid.faces) {
            const Vector normal = control_.camera().rotation * face.normal;
            if (normal.z() < 0)
                continue;
            Face one{{}, 0, colourOf(i)};
            for (const std::size_t v : face.vertices) {
                one.outline << position(drawn_[i].solid.vertices[v]);
                one.z +=
                    depth(drawn_[i].solid.vertices[v]) / static_cast<double>(face.vertices.size());
            }
            const double shade = 0.55 + 0.45 * std::max(0.0, normal.dot(light));
            one.colour = QColor::fromRgbF(static_cast<float>(one.colour.redF() * shade),
                                          static_cast<float>(one.colour.greenF() * shade),
                                          static_cast<float>(one.colour.blueF() * shade),
                                          forLooking_  ? 0.9F
                                          : part_ == i ? 0.45F
                                                       : 0.25F);
            faces.push_back(one);
        }
    }
    std::ranges::sort(faces, {}, &Face::z);
    for (const Face& face : faces) {
        painter.setPen(forLooking_ ? QPen(face.colour.darker(130), 1) : QPen(Qt::NoPen));
        painter.setBrush(face.colour);
        painter.drawPolygon(face.outline);
    }
}

void ShapeDisplay::paintEdges(QPainter& painter, std::size_t part) const {
    const Drawn& one = drawn_[part];
    const bool isChosen = isColoured(part);
    const QColor colour = isChosen ? colourOf(part).darker(125) : grey;
    painter.setPen(QPen(colour, part_ == part ? 1.8 : 1));
    if (one.radius)
        return paintSphere(painter, part);
    for (const geometry::Edge& edge : one.solid.edges)
        painter.drawLine(position(one.solid.vertices[edge.from]),
                         position(one.solid.vertices[edge.to]));
}

void ShapeDisplay::paintSphere(QPainter& painter, std::size_t part) const {
    const Drawn& one = drawn_[part];
    const QPointF middle = position(one.points[0]);
    const Vector across = control_.camera().rotation.conjugate() * Vector(*one.radius, 0, 0);
    const QPointF edge = position(one.points[0] + across) - middle;
    const double radius = std::hypot(edge.x(), edge.y());
    QRadialGradient shade(middle - QPointF(radius, radius) * 0.3, 1.5 * radius);
    QColor inner = colourOf(part).lighter(150), outer = colourOf(part);
    for (QColor* colour : {&inner, &outer})
        colour->setAlphaF(isColoured(part) ? 0.5F : 0.3F);
    shade.setColorAt(0, inner);
    shade.setColorAt(1, outer);
    painter.setBrush(shade);
    painter.drawEllipse(middle, radius, radius);
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(middle, position(one.points[1]));
}

void ShapeDisplay::paintPoints(QPainter& painter) const {
    struct Ball {
        std::size_t part, point;
        double z;
    };
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        for (std::size_t k = 0; k < drawn_[i].points.size(); ++k)
            balls.push_back({i, k, depth(drawn_[i].points[k]) + (part_ == i ? 100 : 0)});
    std::ranges::sort(balls, {}, &Ball::z);
    for (const Ball& ball : balls) {
        const Drawn& one = drawn_[ball.part];
        const bool isChosen = part_ == ball.part && point_ == ball.point;
        const QColor colour = one.inner[ball.point] ? QColor(Qt::white) : colourOf(ball.part);
        painter.setPen(
            QPen(isChosen ? chosenRing : colourOf(ball.part).darker(150), isChosen ? 2.5 : 1));
        painter.setBrush(colour);
        const double radius =
            (part_ == ball.part ? ballRadius : ballRadius - 1.5) + (isChosen ? 1.5 : 0);
        painter.drawEllipse(position(one.points[ball.point]), radius, radius);
    }
}

// --- what is done ------------------------------------------------------------------------------

void ShapeDisplay::mousePressEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    const auto hit = forLooking_ ? std::nullopt : pointAt(at);
    const bool isShifted = event->modifiers() & Qt::ShiftModifier;
    if (forLooking_ || (!isShifted && !(hit && event->button() == Qt::LeftButton))) {
        if (const auto button = buttonOf(event->button()); button && !grip_)
            control_.press(*button, vector(at), pixels());
        return;
    }
    if (event->button() == Qt::LeftButton && hit) {
        grip_ = drawn_[hit->part].points[hit->point];
        offset_ = position(*grip_) - at;
        pointer_ = at;
        Q_EMIT chosen(hit->part, hit->point);
    } else if (event->button() == Qt::MiddleButton && part_) {
        // As deep as the chosen point, else as the middle of the part.
        Vector like = Vector::Zero();
        for (const Vector& p : drawn_[*part_].points)
            like += p / static_cast<double>(drawn_[*part_].points.size());
        if (point_)
            like = drawn_[*part_].points[*point_];
        Q_EMIT addWanted(placeAt(at, like));
    } else if (event->button() == Qt::RightButton && hit) {
        Q_EMIT removeWanted(hit->part, hit->point);
    }
}

void ShapeDisplay::dragTo(const QPointF& position) {
    pointer_ = position;
    const Vector place = placeAt(position + offset_, *grip_);
    const bool onSphere = part_ && point_ == 1 && drawn_[*part_].radius;
    if (const Vector out = onSphere ? Vector(place - drawn_[*part_].points[0]) : Vector::Zero();
        out.norm() > 0)
        surface_[*part_] = out.normalized();
    Q_EMIT dragged(place);
}

void ShapeDisplay::mouseMoveEvent(QMouseEvent* event) {
    if (grip_) {
        dragTo(event->position());
    } else if (control_.active() && control_.move(vector(event->position()), pixels())) {
        update();
    } else if (!forLooking_ && !control_.active()) {
        setCursor(pointAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
}

void ShapeDisplay::mouseReleaseEvent(QMouseEvent* event) {
    control_.release();
    if (event->button() == Qt::LeftButton && grip_) {
        grip_.reset();
        Q_EMIT released();
    }
}

void ShapeDisplay::wheelEvent(QWheelEvent* event) {
    control_.wheel(vector(event->position()), event->angleDelta().y() / 120.0, pixels());
    update();
    event->accept();
}

void ShapeDisplay::keyPressEvent(QKeyEvent* event) {
    if (grip_ && event->key() == Qt::Key_Escape) {
        grip_.reset();
        Q_EMIT cancelled();
    } else if (grip_ && (event->key() == Qt::Key_Z || event->key() == Qt::Key_X)) {
        const double step = (event->key() == Qt::Key_Z ? -10 : 10) * pixelLength();
        *grip_ += control_.camera().rotation.conjugate() * Vector(0, 0, step);
        dragTo(pointer_);
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace views
