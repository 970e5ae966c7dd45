#include "views/handle_drag.h"

#include "render/extent.h"

#include <cmath>

namespace views {

using geometry::Vector;

namespace {

double depthOf(const render::Camera& camera, const Vector& world) {
    return (camera.rotation * (world - camera.center)).z() * camera.scale + camera.position.z();
}

// The largest power of ten that is not above: what a gesture of that length writes.
double roundStep(double length) { return std::pow(10, std::floor(std::log10(length))); }

QString listed(const std::vector<double>& values, double resolution) {
    QString text;
    for (const double value : values)
        text += ' ' +
                QString::number(value, 'f',
                                std::clamp(static_cast<int>(-std::log10(resolution) + 0.5), 0, 9));
    return text;
}

} // namespace

std::unique_ptr<HandleDrag> HandleDrag::at(SceneDocument& document, const render::Drawing& drawing,
                                           render::Size size, const Eigen::Vector2d& pixels,
                                           double reach) {
    if (!document.sceneIsCurrent())
        return nullptr;
    const double sceneSize = render::extentOf(*drawing.scene, drawing.motion.get()).size;
    std::optional<render::Handle> nearest;
    Eigen::Vector2d there = Eigen::Vector2d::Zero();
    for (const render::Handle& handle : render::handlesOf(drawing, sceneSize)) {
        const Eigen::Vector2d at = render::toPixels(drawing.camera, size, handle.place);
        // Of two in one place the velocity's: it is drawn smaller, on top.
        if (const double distance = (at - pixels).norm(); distance <= reach) {
            reach = distance;
            nearest = handle;
            there = at;
        }
    }
    if (!nearest)
        return nullptr;
    auto drag =
        std::unique_ptr<HandleDrag>(new HandleDrag(document, drawing, size, *nearest, sceneSize));
    drag->grip_ = there - pixels;
    drag->pointer_ = pixels;
    drag->answer_ = drag->mapper_.answer(drag->wish());
    return drag;
}

HandleDrag::HandleDrag(SceneDocument& document, const render::Drawing& drawing, render::Size size,
                       const render::Handle& handle, double sceneSize)
    : document_(document), text_(document.text()), scene_(document.shown().scene),
      mapper_(text_, scene_), camera_(drawing.camera), size_(size), handle_(handle),
      velocityTime_(render::velocityTime(*drawing.scene, sceneSize)), pixelLength_(1),
      depth_(depthOf(camera_, handle.place)) {
    const Eigen::Vector2d here = render::toPixels(camera_, size_, handle_.place);
    pixelLength_ = (render::toWorld(camera_, size_, here + Eigen::Vector2d(1, 0), depth_) -
                    render::toWorld(camera_, size_, here, depth_))
                       .norm();
}

Vector HandleDrag::place() const {
    return pointer_ ? render::toWorld(camera_, size_, *pointer_ + grip_, depth_) : handle_.place;
}

editing::Wish HandleDrag::wish() const {
    const scene::Body& body = scene_->bodies[handle_.body];
    const bool moves = handle_.kind == render::HandleKind::position;
    const Vector start =
        render::toWorld(camera_, size_, render::toPixels(camera_, size_, handle_.place),
                        depthOf(camera_, handle_.place));
    const Vector delta = place() - start;
    const Vector value = moves ? Vector(body.initialPosition + delta)
                               : Vector(body.initialVelocity + delta / velocityTime_);
    editing::Wish wish;
    wish.element = {editing::Kind::body, handle_.body};
    wish.option = moves ? "-init_pos" : "-init_dpos";
    wish.values = {value.x(), value.y(), value.z()};
    wish.resolution = roundStep(pixelLength_ / (moves ? 1 : velocityTime_));
    wish.absent = {0, 0, 0};
    return wish;
}

void HandleDrag::update() {
    answer_ = mapper_.answer(wish());
    if (answer_.possible())
        document_.preview(editing::applied(text_, answer_.edits));
}

void HandleDrag::move(const Eigen::Vector2d& pixels) {
    pointer_ = pixels;
    update();
}

void HandleDrag::push(double pixels) {
    depth_ -= pixels * pixelLength_ * camera_.scale;
    update();
}

void HandleDrag::finish() {
    document_.finishPreview(answer_.possible() ? editing::applied(text_, answer_.edits) : text_,
                            label());
}

void HandleDrag::cancel() { document_.finishPreview(text_, {}); }

std::string HandleDrag::textWith(const editing::Offer& offer) const {
    return editing::applied(text_, offer.edits);
}

QString HandleDrag::label() const {
    const QString name = QString::fromStdString(scene_->bodies[handle_.body].name);
    return handle_.kind == render::HandleKind::position
               ? QObject::tr("Move %1").arg(name)
               : QObject::tr("Change the velocity of %1").arg(name);
}

QString HandleDrag::words() const {
    if (!answer_.possible())
        return QString::fromStdString(answer_.reason);
    const editing::Wish wanted = wish();
    const QString name = QString::fromStdString(scene_->bodies[handle_.body].name);
    return (handle_.kind == render::HandleKind::position ? QObject::tr("%1: position%2")
                                                         : QObject::tr("%1: velocity%2"))
        .arg(name, listed(wanted.values, wanted.resolution));
}

} // namespace views
