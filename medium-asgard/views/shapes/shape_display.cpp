#include "shapes/shape_display.h"

#include "framing/framing.h"
#include "geometry/hull.h"
#include "gestures/wireframe.h"
#include "painting/pointer.h"
#include "point_edits/shape_points.h"
#include "surroundings/triad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

using geometry::Vector;

constexpr double reach = 10; // pixels within which a point is taken
constexpr double ballRadius = 5;
const QColor grey(0xA8, 0xAC, 0xB2), chosenRing(0xF0, 0x96, 0x14);

// Of a polyhedron, a box, or the outlines of what is round; a floor has none.
std::vector<std::vector<Vector>> edgesOf(const scene::Part& part) {
    if (std::holds_alternative<scene::PlaneShape>(part.shape))
        return {};
    const auto* points = std::get_if<scene::HullShape>(&part.shape);
    if (!points)
        return gestures::wireframeOf({part});
    const auto made = geometry::convexHull(points->points);
    const auto* hull = std::get_if<geometry::Hull>(&made);
    if (!hull)
        return {};
    const geometry::Polyhedron solid = geometry::transformed(
        hull->polyhedron, {part.position, geometry::fromRotationVector(part.rotation)});
    std::vector<std::vector<Vector>> edges;
    for (const geometry::Edge& edge : solid.edges)
        edges.push_back({solid.vertices[edge.from], solid.vertices[edge.to]});
    return edges;
}

} // namespace

ShapeDisplay::ShapeDisplay(std::shared_ptr<PictureThread> pictures, QWidget* parent)
    : QWidget(parent), picture_(*this, std::move(pictures), [this] { return wish(); }) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Shape"));
    setAccessibleDescription(
        tr("The parts of the shape. A click chooses a part. The left button drags a point, "
           "elsewhere it turns the view; with Shift the middle one adds a point, the right one "
           "deletes one."));
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
    result.edges = edgesOf(part);
    if (const auto* sphere = std::get_if<scene::SphereShape>(&part.shape))
        result.radius = sphere->radius;
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
    redraw(true);
    if (another)
        frame();
}

void ShapeDisplay::redraw(bool changed) {
    if (changed)
        scene_.reset();
    picture_.redraw(grip_.has_value() || control_.active());
}

void ShapeDisplay::setForLooking() {
    forLooking_ = true;
    setAccessibleDescription(tr("The parts, each in a colour of its own."));
    redraw(true);
}

std::optional<Vector> ShapeDisplay::chosenPlace() const {
    if (!part_ || !point_)
        return std::nullopt;
    return drawn_[*part_].points[*point_];
}

void ShapeDisplay::choose(std::optional<std::size_t> part, std::optional<std::size_t> point) {
    part_ = part && *part < parts_.size() ? part : std::nullopt;
    point_ = part_ && point && *point < drawn_[*part_].points.size() ? point : std::nullopt;
    redraw(true);
}

void ShapeDisplay::setGrid(double step) {
    grid_ = step;
    update();
}

void ShapeDisplay::frame() {
    makeScene();
    const render::Camera& camera = control_.camera();
    control_.set(render::fitted(render::extentOf(*scene_, nullptr), camera.rotation,
                                picture_.pixelSize(), camera.orthographic));
    redraw(false);
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
    redraw(false);
}

// --- where things are --------------------------------------------------------------------------

QPointF ShapeDisplay::position(const Vector& place) const {
    return picture_.fromPixels(sight().pixels(place));
}

double ShapeDisplay::pixelLength() const {
    return sight().pixelLength(control_.camera().center) * devicePixelRatioF();
}

Vector ShapeDisplay::placeAt(const QPointF& at, const Vector& like) const {
    Vector place = sight().beside(picture_.inPixels(at), like);
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
    const gestures::Sight sight = this->sight();
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        for (std::size_t k = 0; k < drawn_[i].points.size(); ++k) {
            const QPointF d = position(drawn_[i].points[k]) - at;
            // Of two as near the chosen part's, then the one in front.
            const double distance = std::hypot(d.x(), d.y()) - (part_ == i ? 2 : 0) -
                                    0.5 * std::clamp(sight.depth(drawn_[i].points[k]), -1.0, 1.0);
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

void ShapeDisplay::makeScene() {
    if (scene_)
        return;
    auto made = std::make_shared<scene::Scene>();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        scene::ShapeSet set;
        set.name = std::to_string(i);
        set.parts = {parts_[i]};
        const QColor colour = colourOf(i);
        set.parts[0].appearance.color = {colour.redF(), colour.greenF(), colour.blueF()};
        scene::Body body;
        body.name = body.shape = set.name;
        made->shapeSets.push_back(std::move(set));
        made->bodies.push_back(std::move(body));
    }
    scene_ = std::move(made);
}

render::Drawing ShapeDisplay::drawing() {
    makeScene();
    render::Drawing drawing;
    drawing.scene = scene_.get();
    drawing.camera = control_.camera();
    drawing.display.studio = drawing.display.axes = true;
    drawing.display.triad = !forLooking_;
    drawing.display.rotationCenter = control_.active() && !press_.isClick;
    return drawing;
}

PictureWish ShapeDisplay::wish() {
    const render::Drawing drawing = this->drawing();
    PictureWish wish;
    wish.shown.scene = scene_;
    wish.display = drawing.display;
    wish.from = SeenFrom::camera;
    wish.camera = drawing.camera;
    return wish;
}

void ShapeDisplay::paintEvent(QPaintEvent*) {
    picture_.bringUpToDate();
    QPainter painter(this);
    if (!picture_.paint(painter))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintLines(painter);
    if (!forLooking_) {
        paintEdges(painter);
        paintPoints(painter);
    }
    QColor frame = palette().color(QPalette::WindowText);
    frame.setAlpha(hasFocus() ? 150 : 60);
    painter.setPen(QPen(frame, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

// Of the grid that places keep to, in the plane that is seen best.
void ShapeDisplay::paintLines(QPainter& painter) const {
    const int count = grid_ > 0 ? static_cast<int>(0.9 / control_.camera().scale / grid_) : 0;
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

// Of the chosen part, also where others hide it.
void ShapeDisplay::paintEdges(QPainter& painter) const {
    if (!part_)
        return;
    const Drawn& one = drawn_[*part_];
    QColor ink = chosenRing;
    ink.setAlpha(170);
    painter.setPen(QPen(ink, 1.2));
    painter.setBrush(Qt::NoBrush);
    for (const std::vector<Vector>& edge : one.edges) {
        QPolygonF line;
        for (const Vector& place : edge)
            line << position(place);
        painter.drawPolyline(line);
    }
    if (one.radius)
        painter.drawLine(position(one.points[0]), position(one.points[1]));
}

void ShapeDisplay::paintPoints(QPainter& painter) const {
    struct Ball {
        std::size_t part, point;
        double z;
    };
    std::vector<Ball> balls;
    const gestures::Sight sight = this->sight();
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        for (std::size_t k = 0; k < drawn_[i].points.size(); ++k)
            balls.push_back({i, k, sight.depth(drawn_[i].points[k]) + (part_ == i ? 100 : 0)});
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

bool ShapeDisplay::clickTriad(const QMouseEvent& event) {
    if (forLooking_ || event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier)
        return false;
    const auto end = render::triadDirectionAt(control_.camera(), picture_.pixelSize(),
                                              picture_.inPixels(event.position()));
    if (end)
        lookAlong(*end);
    return end.has_value();
}

void ShapeDisplay::mousePressEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (control_.active() || grip_ || clickTriad(*event))
        return;
    press_ = {at, event->button() == Qt::LeftButton && !forLooking_};
    const auto hit = forLooking_ ? std::nullopt : pointAt(at);
    const bool isShifted = event->modifiers() & Qt::ShiftModifier;
    if (!forLooking_ && (isShifted || (hit && event->button() == Qt::LeftButton)))
        return pressPoint(*event, hit);
    if (const auto button = viewButton(event->button()))
        control_.press(*button, picture_.inPixels(at), picture_.pixelSize());
}

void ShapeDisplay::pressPoint(const QMouseEvent& event, const std::optional<Hit>& hit) {
    const QPointF at = event.position();
    if (event.button() == Qt::LeftButton && hit) {
        grip_ = drawn_[hit->part].points[hit->point];
        offset_ = position(*grip_) - at;
        pointer_ = at;
        Q_EMIT chosen(hit->part, hit->point);
    } else if (event.button() == Qt::MiddleButton && part_) {
        // As deep as the chosen point, else as the middle of the part.
        Vector like = Vector::Zero();
        for (const Vector& p : drawn_[*part_].points)
            like += p / static_cast<double>(drawn_[*part_].points.size());
        if (point_)
            like = drawn_[*part_].points[*point_];
        Q_EMIT addWanted(placeAt(at, like));
    } else if (event.button() == Qt::RightButton && hit) {
        Q_EMIT removeWanted(hit->part, hit->point);
    }
}

// Of all parts there the front-most, or that behind the chosen one where it was clicked before.
void ShapeDisplay::click(const QPointF& at) {
    const bool isAgain = clicked_ && isNear(*clicked_, at);
    clicked_ = at;
    const auto there = gestures::bodiesAt(drawing(), sight(), picture_.inPixels(at));
    if (there.empty())
        return Q_EMIT clicked(std::nullopt);
    auto taken =
        isAgain && part_ ? std::ranges::find(there, *part_, &gestures::Picked::body) : there.end();
    if (taken == there.end() || ++taken == there.end())
        taken = there.begin();
    Q_EMIT clicked(taken->body);
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
    const QPointF at = event->position();
    press_.isClick = press_.isClick && isNear(at, press_.at);
    if (grip_) {
        dragTo(at);
    } else if (control_.active()) {
        if (!press_.isClick && control_.move(picture_.inPixels(at), picture_.pixelSize(),
                                             event->modifiers() & Qt::AltModifier))
            redraw(false);
    } else if (!forLooking_) {
        setCursor(pointAt(at) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
}

void ShapeDisplay::mouseReleaseEvent(QMouseEvent* event) {
    const bool wasView = control_.active();
    control_.release();
    if (event->button() == Qt::LeftButton && grip_) {
        grip_.reset();
        Q_EMIT released();
    } else if (wasView && std::exchange(press_.isClick, false)) {
        click(event->position());
    }
    redraw(false);
}

void ShapeDisplay::wheelEvent(QWheelEvent* event) {
    control_.wheel(picture_.inPixels(event->position()), event->angleDelta().y() / 120.0,
                   picture_.pixelSize());
    picture_.redraw(true);
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
