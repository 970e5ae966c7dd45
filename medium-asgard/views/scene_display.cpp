#include "views/scene_display.h"

#include "render/framing.h"
#include "render/handles.h"

#include <QKeyEvent>
#include <QMenu>
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
      reason_(std::move(reason)) {
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

void SceneDisplay::redraw(bool moving) {
    moving_ = moving;
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

std::vector<geometry::Vector> SceneDisplay::verticesAndHandles() const {
    const Shown& shown = document_.shown();
    std::vector<geometry::Vector> points;
    for (std::size_t i = 0; i < shown.scene->bodies.size(); ++i) {
        const geometry::Pose pose = render::poseOf(*shown.scene, shown.motion.get(), i, time_);
        for (const render::Ball& ball : render::outlineOf(*shown.scene, shown.scene->bodies[i]))
            points.push_back(pose.toWorld(ball.center));
    }
    const double size = render::extentOf(*shown.scene, shown.motion.get()).size;
    for (const render::Handle& handle : render::handlesOf(drawing(), size))
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
    if (!button || drag_) {
        event->ignore();
        return;
    }
    updateCamera();
    if (event->modifiers() & Qt::ShiftModifier) { // edits
        if (*button == Button::left)
            beginDrag(event->position());
        return;
    }
    control_.press(*button, inPixels(event->position()), pixelSize());
}

void SceneDisplay::mouseMoveEvent(QMouseEvent* event) {
    if (drag_) {
        drag_->move(inPixels(event->position()));
        Q_EMIT handleDragged();
        update();
    } else if (control_.active() && control_.move(inPixels(event->position()), pixelSize()))
        movedByUser();
}

void SceneDisplay::mouseReleaseEvent(QMouseEvent* event) {
    if (drag_ && event->button() == Qt::LeftButton)
        endDrag(event->globalPosition().toPoint());
    control_.release();
}

// --- handles -----------------------------------------------------------------------------------

void SceneDisplay::beginDrag(const QPointF& position) {
    constexpr double reach = 14;
    framesItself_ = false; // the picture stays while what is in it moves
    drag_ = HandleDrag::at(document_, drawing(), pixelSize(), inPixels(position),
                           reach * devicePixelRatioF());
    Q_EMIT handleDragged();
    update();
}

void SceneDisplay::endDrag(const QPoint& global) {
    const std::unique_ptr<HandleDrag> drag = std::move(drag_);
    drag->finish();
    Q_EMIT handleDragged();
    update();
    if (drag->answer().offers.empty())
        return;
    // It cannot be moved as it stands: what could be done instead?
    QMenu menu(this);
    menu.addSection(drag->words());
    for (const editing::Offer& offer : drag->answer().offers) {
        QString preview;
        for (const editing::TextEdit& edit : offer.edits)
            preview +=
                (preview.isEmpty() ? "" : ", ") + QString::fromStdString(edit.text).trimmed();
        QAction* action =
            menu.addAction(tr("%1: %2").arg(QString::fromStdString(offer.label), preview));
        connect(action, &QAction::triggered, this,
                [&] { document_.setText(drag->textWith(offer), drag->label()); });
    }
    menu.exec(global);
}

void SceneDisplay::drawDrag(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const Eigen::Vector2d pixels =
        render::toPixels(control_.camera(), pixelSize(), drag_->place()) / devicePixelRatioF();
    const bool possible = drag_->answer().possible();
    painter.setPen(QPen(possible ? QColor(20, 90, 200) : QColor(190, 40, 30), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(pixels.x(), pixels.y()), 11, 11);
    const QString words = drag_->words();
    const QRect space = rect().adjusted(width() / 3, 10, -12, -10);
    const QRect needed = painter.boundingRect(space, Qt::AlignRight | Qt::TextWordWrap, words);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 225));
    painter.drawRoundedRect(needed.adjusted(-8, -4, 8, 4), 4, 4);
    painter.setPen(possible ? QColor(30, 35, 45) : QColor(170, 30, 20));
    painter.drawText(space, Qt::AlignRight | Qt::TextWordWrap, words);
}

// While a handle is dragged its keys are no shortcuts.
bool SceneDisplay::event(QEvent* event) {
    if (drag_ && event->type() == QEvent::ShortcutOverride) {
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
    constexpr double away = 6; // pixels for a press of a key
    if (drag_) {
        if (event->key() == Qt::Key_Escape) {
            drag_->cancel();
            drag_.reset();
        } else if (event->key() == Qt::Key_Z || event->key() == Qt::Key_X) {
            drag_->push(event->key() == Qt::Key_Z ? away : -away);
        }
        Q_EMIT handleDragged();
        update();
    } else if (event->key() == Qt::Key_C && event->modifiers() == Qt::NoModifier)
        centerAt(mapFromGlobal(QPointF(QCursor::pos())));
    else
        QWidget::keyPressEvent(event);
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
        if (drag_)
            drawDrag(painter);
        return;
    }
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     reason_);
}

} // namespace views
