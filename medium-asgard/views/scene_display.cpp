#include "views/scene_display.h"

#include "render/framing.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace views {

namespace {

using Button = render::CameraControl::Button;

std::optional<Button> buttonOf(Qt::MouseButton button) {
    switch (button) {
    case Qt::LeftButton:
        return Button::left;
    case Qt::MiddleButton:
        return Button::middle;
    case Qt::RightButton:
        return Button::right;
    default:
        return std::nullopt;
    }
}

} // namespace

SceneDisplay::SceneDisplay(SceneDocument& document, std::shared_ptr<render::Renderer> renderer,
                           QString reason, QWidget* parent)
    : QWidget(parent), document_(document), renderer_(std::move(renderer)),
      reason_(std::move(reason)), editing_(document, *this), creating_(document, *this) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(false);
    setAccessibleName(tr("Scene"));
    setAccessibleDescription(tr("Picture of the scene. Drag with the left button to turn it, the "
                                "middle one to move it, the right one to scale or roll it."));
    settle_.setSingleShot(true);
    settle_.setInterval(180);
    connect(&settle_, &QTimer::timeout, this, [this] { redraw(false); });
    connect(&document_, &SceneDocument::sceneChanged, this, &SceneDisplay::sceneChanged);
    connect(&document_, &SceneDocument::motionChanged, this, &SceneDisplay::motionChanged);
    connect(&creating_, &Creating::changed, this, [this] { update(); });
    connect(&creating_, &Creating::refused, &editing_, &PictureEditing::say);
    connect(&editing_, &PictureEditing::changed, this, [this] {
        Q_EMIT handleDragged();
        update();
    });
    sceneChanged();
}

render::Size SceneDisplay::pixelSize() const {
    const QSizeF size = QSizeF(this->size()) * devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(size.width()))),
            std::max(1, static_cast<int>(std::lround(size.height())))};
}

Eigen::Vector2d SceneDisplay::inPixels(const QPointF& position) const {
    return Eigen::Vector2d(position.x(), position.y()) * devicePixelRatioF();
}

QPointF SceneDisplay::fromPixels(const Eigen::Vector2d& pixels) const {
    return QPointF(pixels.x(), pixels.y()) / devicePixelRatioF();
}

void SceneDisplay::redraw(bool moving) {
    moving_ = moving;
    if (prepared_)
        prepared_->set.reset();
    imageIsOld_ = true;
    if (moving)
        settle_.start();
    update();
}

void SceneDisplay::setTime(double time, bool moving) {
    if (time == time_)
        return;
    time_ = time;
    cameraIsOld_ = cameraIsOld_ || (view_ && view_->follows());
    redraw(moving);
}

void SceneDisplay::setDisplay(const render::Display& display) {
    display_ = display;
    redraw(false);
}

void SceneDisplay::sceneChanged() {
    const auto& views = document_.shown().scene->views;
    const bool known = std::any_of(views.begin(), views.end(), [&](const auto& v) {
        return QString::fromStdString(v.name) == followed_;
    });
    // A scene with views opens in its first one.
    if (framesItself_ && !known && !views.empty())
        followView(QString::fromStdString(views.front().name));
    else if (!followed_.isEmpty() && !known)
        followView({});
    motionChanged();
}

void SceneDisplay::motionChanged() {
    view_.reset();
    cameraIsOld_ = true;
    redraw(moving_);
}

void SceneDisplay::updateCamera() {
    if (!cameraIsOld_)
        return;
    cameraIsOld_ = false;
    const Shown& shown = document_.shown();
    const bool follows = !followed_.isEmpty();
    if (!follows && !framesItself_)
        return;
    if (follows && !view_)
        view_.emplace(*shown.scene, shown.motion, followed_.toStdString(), pixelSize());
    control_.set(follows ? view_->at(time_)
                         : render::framed(*shown.scene, shown.motion, pixelSize()));
    Q_EMIT cameraChanged();
}

void SceneDisplay::movedByUser() {
    framesItself_ = false;
    if (!followed_.isEmpty())
        followView({});
    Q_EMIT cameraChanged();
    redraw(true);
}

void SceneDisplay::setCamera(const render::Camera& camera) {
    control_.set(camera);
    movedByUser();
}

void SceneDisplay::frameAll() {
    followView({});
    framesItself_ = true;
    cameraIsOld_ = true;
    redraw(false);
}

void SceneDisplay::lookAlong(const geometry::Vector& toward) {
    updateCamera();
    const geometry::Vector up = render::upOf(*document_.shown().scene);
    // Down on the ground, or up at it: what was in front is at the bottom.
    const double along = toward.dot(up);
    geometry::Vector upright = up;
    if (std::abs(along) > 0.99)
        upright =
            std::abs(up.z()) < 0.5 ? geometry::Vector(0, 0, -along) : geometry::Vector(0, along, 0);
    render::Camera camera = control_.camera();
    camera.rotation = render::facing(toward, upright);
    const bool wasFraming = framesItself_;
    setCamera(camera);
    if (wasFraming) {
        const Shown& shown = document_.shown();
        setCamera(render::fitted(render::extentOf(*shown.scene, shown.motion.get()),
                                 camera.rotation, pixelSize()));
    }
    redraw(false);
}

void SceneDisplay::followView(const QString& name) {
    view_.reset();
    cameraIsOld_ = true;
    if (name != followed_) {
        followed_ = name;
        Q_EMIT viewFollowed();
    }
    redraw(false);
}

render::Drawing SceneDisplay::drawing() const {
    return {document_.shown().scene.get(), document_.shown().motion, time_, control_.camera(),
            display_};
}

const render::HandleSet& SceneDisplay::handles() const {
    static const render::HandleSet none;
    if (!render::showsHandles(display_))
        return none;
    Prepared& all = prepared();
    if (!all.set)
        all.set = std::make_shared<const render::HandleSet>(all.handles.at(time_, display_));
    return *all.set;
}

double SceneDisplay::arrowLength(bool couple) const {
    return prepared().handles.arrowLength(couple ? render::HandleKind::torqueHead
                                                 : render::HandleKind::forceHead);
}

SceneDisplay::Prepared& SceneDisplay::prepared() const {
    const Shown& shown = document_.shown();
    if (!prepared_ || prepared_->of.scene != shown.scene || prepared_->of.motion != shown.motion)
        prepared_.reset(new Prepared{shown, render::Handles(*shown.scene, shown.motion), nullptr});
    return *prepared_;
}

void SceneDisplay::keepCamera() { framesItself_ = false; }

std::vector<geometry::Vector> SceneDisplay::verticesAndHandles() const {
    const Shown& shown = document_.shown();
    std::vector<geometry::Vector> points;
    for (std::size_t i = 0; i < shown.scene->bodies.size(); ++i) {
        const geometry::Pose pose = render::poseOf(*shown.scene, shown.motion.get(), i, time_);
        for (const render::Ball& ball : render::outlineOf(*shown.scene, shown.scene->bodies[i]))
            points.push_back(pose.toWorld(ball.center));
    }
    for (const render::Handle& handle : handles().handles)
        points.push_back(handle.place);
    return points;
}

void SceneDisplay::centerAt(const QPointF& position) {
    const render::Camera& camera = control_.camera();
    const Eigen::Vector2d pixels = inPixels(position);
    double nearest = 8 * devicePixelRatioF();
    double front = -std::numeric_limits<double>::infinity(), back = -front;
    std::optional<geometry::Vector> taken;
    for (const geometry::Vector& point : verticesAndHandles()) {
        const double z =
            (camera.rotation * (point - camera.center)).z() * camera.scale + camera.position.z();
        front = std::max(front, z);
        back = std::min(back, z);
        const double distance = (render::toPixels(camera, pixelSize(), point) - pixels).norm();
        if (distance < nearest) {
            nearest = distance;
            taken = point;
        }
    }
    const double middle = front >= back ? (front + back) / 2 : 0;
    setCamera(render::turningAbout(
        camera, taken ? *taken : render::toWorld(camera, pixelSize(), pixels, middle)));
}

void SceneDisplay::mousePressEvent(QMouseEvent* event) {
    const auto button = buttonOf(event->button());
    updateCamera();
    if (!button)
        event->ignore();
    else if (creating_.active() && *button == Button::left) {
        pressed_ = event->position();
        control_.press(*button, inPixels(event->position()), pixelSize());
    } else if (!editing_.press(*event))
        control_.press(*button, inPixels(event->position()), pixelSize());
}

void SceneDisplay::mouseMoveEvent(QMouseEvent* event) {
    constexpr double still = 4; // pixels: not yet a drag
    if (creating_.active() && control_.active() &&
        (event->position() - pressed_).manhattanLength() < still)
        return;
    if (!editing_.move(*event) && control_.active() &&
        control_.move(inPixels(event->position()), pixelSize()))
        movedByUser();
}

void SceneDisplay::mouseReleaseEvent(QMouseEvent* event) {
    constexpr double still = 4;
    if (creating_.active() && event->button() == Qt::LeftButton) {
        if ((event->position() - pressed_).manhattanLength() < still)
            creating_.click(event->position());
    } else {
        editing_.release(*event);
    }
    control_.release();
}

void SceneDisplay::mouseDoubleClickEvent(QMouseEvent* event) {
    if (creating_.active() || !editing_.doubleClick(*event))
        mousePressEvent(event);
}

// While a handle is dragged its keys are no shortcuts.
bool SceneDisplay::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && (editing_.dragging() || creating_.active())) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void SceneDisplay::wheelEvent(QWheelEvent* event) {
    updateCamera();
    control_.wheel(inPixels(event->position()), event->angleDelta().y() / 120.0, pixelSize());
    movedByUser();
    event->accept();
}

void SceneDisplay::keyPressEvent(QKeyEvent* event) {
    updateCamera();
    if (creating_.key(*event) || editing_.keyPress(*event))
        return;
    if (event->key() == Qt::Key_C && event->modifiers() == Qt::NoModifier)
        centerAt(mapFromGlobal(QPointF(QCursor::pos())));
    else
        QWidget::keyPressEvent(event);
}

void SceneDisplay::keyReleaseEvent(QKeyEvent* event) {
    editing_.keyRelease(*event);
    QWidget::keyReleaseEvent(event);
}

void SceneDisplay::focusOutEvent(QFocusEvent* event) {
    editing_.finish();
    update();
    QWidget::focusOutEvent(event);
}

void SceneDisplay::resizeEvent(QResizeEvent*) {
    view_.reset();
    cameraIsOld_ = true;
    imageIsOld_ = true;
}

void SceneDisplay::drawImage() {
    updateCamera();
    imageIsOld_ = false;
    const render::Size size = pixelSize();
    if (image_.size() != QSize(size.width, size.height))
        image_ = QImage(size.width, size.height, QImage::Format_RGB32);
    image_.setDevicePixelRatio(devicePixelRatioF());
    render::Drawing drawing = this->drawing();
    drawing.display.samples = moving_ ? 1 : 4;
    if (render::showsHandles(display_)) {
        const render::HandleSet& shown = handles();
        drawing.handles = {prepared_->set, &shown};
    }
    const render::Image into{{reinterpret_cast<std::byte*>(image_.bits()),
                              static_cast<std::size_t>(image_.sizeInBytes())},
                             static_cast<std::size_t>(image_.bytesPerLine()),
                             size};
    if (!renderer_->draw(drawing, into)) {
        renderer_.reset();
        reason_ = tr("The graphics context was lost. Open another viewer.");
    }
}

void SceneDisplay::paintEvent(QPaintEvent*) {
    if (renderer_ && (imageIsOld_ || image_.isNull()))
        drawImage();
    QPainter painter(this);
    if (renderer_) {
        painter.drawImage(QPointF(0, 0), image_);
        editing_.paint(painter);
        creating_.paint(painter);
        return;
    }
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     reason_);
}

} // namespace views
