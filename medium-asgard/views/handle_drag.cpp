#include "views/handle_drag.h"

#include "views/handle_meaning.h"
#include "views/new_point.h"

#include <cmath>

namespace views {

using geometry::Vector;

HandleDrag::HandleDrag(SceneDocument& document, const Sight& sight, const render::Handle& handle,
                       const std::optional<Eigen::Vector2d>& pixels)
    : document_(document), text_(document.text()), scene_(document.shown().scene),
      motion_(document.shown().motion),
      mapper_(text_, scene_,
              [this](const std::string& name) {
                  return render::constantValue(*scene_, motion_.get(), name);
              }),
      sight_(sight), handle_(handle), pixelLength_(sight.pixelLength(handle.place)),
      place_(handle.place), plane_(handle.place), held_(sight.pixels(handle.place)),
      grip_(Eigen::Vector2d::Zero()) {
    if (pixels) {
        grip_ = held_ - *pixels;
        held_ = *pixels;
    }
    if (handle_.kind == render::HandleKind::orientation) {
        auto wish = wishes().front();
        wish.path.clear();
        quaternion_ = mapper_.count(wish) == 4;
    }
    if (handle_.kind == render::HandleKind::linkEnd) {
        const scene::Link& link = scene_->links[handle_.element];
        const auto* second = std::get_if<scene::BodyEnd>(&link.second);
        const std::string body = handle_.part == 0 ? link.first.body : second ? second->body : "";
        surface_ = shapeOf(*scene_, body);
        // One that does not lie on the surface is not drawn to it.
        follows_ = isOnSurface(handle_.place);
    }
    if (handle_.kind == render::HandleKind::trajectoryPoint)
        path_.emplace(text_, scene_, handle_.element);
    // Why it cannot be moved is told before it is.
    auto asked = wishes();
    for (editing::Wish& wish : asked)
        wish.now.clear();
    answer_ = mapper_.answer(asked);
    answer_.edits.clear();
}

bool HandleDrag::isOnSurface(const Vector& place) const {
    if (!surface_)
        return false;
    const double near = 2 * pixelLength_;
    const Line sight = lineOfSight(sight_, sight_.pixels(place));
    const auto hit =
        geometry::castRay(*surface_, handle_.frame.toLocal(place - near * sight.direction),
                          handle_.frame.attitude.conjugate() * sight.direction);
    return hit && hit->distance <= 2 * near;
}

// Of the two places of the body's sphere under the pointer the one on the handle's side; beside
// the sphere, its rim.
Vector HandleDrag::onSphere() const {
    const Line sight = lineOfSight(sight_, held_ + grip_);
    const Vector middle = handle_.base;
    const double radius = (handle_.place - middle).norm();
    const double along = (middle - sight.from).dot(sight.direction);
    const Vector nearest = sight.from + along * sight.direction;
    const double away = (nearest - middle).norm();
    if (away >= radius)
        return middle + radius / away * (nearest - middle);
    const double half = std::sqrt(radius * radius - away * away);
    const bool behind = (handle_.place - middle).dot(sight.direction) > 1e-9 * radius;
    return nearest + (behind ? half : -half) * sight.direction;
}

std::optional<Vector> HandleDrag::onSurface() const {
    const Line sight = lineOfSight(sight_, held_ + grip_);
    const auto hit = geometry::castRay(*surface_, handle_.frame.toLocal(sight.from),
                                       handle_.frame.attitude.conjugate() * sight.direction);
    return hit ? std::optional(handle_.frame.toWorld(hit->point)) : std::nullopt;
}

Vector HandleDrag::wanted() const {
    if (handle_.kind == render::HandleKind::orientation)
        return onSphere();
    if (follows_ && !free_) // beside the body it waits where it was
        return onSurface().value_or(place_);
    return sight_.beside(held_ + grip_, plane_);
}

std::vector<editing::Wish> HandleDrag::wishes() const {
    return wishesFor(*scene_, handle_, place_, pixelLength_, quaternion_);
}

// What it asks of the text. A point that ends one curve and begins the next moves in both.
editing::Answer HandleDrag::asked() const {
    if (!path_)
        return mapper_.answer(wishes());
    const editing::Wish wish = wishes().front();
    const std::size_t point = pointOf(*path_, handle_);
    Vector place;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = wish.values[wish.values.size() - 3 + i];
        place[static_cast<Eigen::Index>(i)] =
            wish.resolution > 0 // in the digits of the gesture
                ? QString::number(std::round(value / wish.resolution) * wish.resolution, 'g', 12)
                      .toDouble()
                : value;
    }
    return path_->move(point, path_->points()[point].time, place, 0);
}

void HandleDrag::update() {
    moved_ = true;
    const bool followed = follows_ && !free_;
    place_ = wanted();
    if (followed)
        plane_ = place_; // freed, it goes on from here
    else if (surface_ && !free_)
        follows_ = isOnSurface(place_);
    answer_ = asked();
    if (answer_.possible())
        document_.preview(editing::applied(text_, answer_.edits));
}

void HandleDrag::move(const Eigen::Vector2d& pixels) {
    if (pixels == held_)
        return;
    held_ = pixels;
    update();
}

void HandleDrag::nudge(const Eigen::Vector2d& byPixels) {
    held_ += byPixels;
    update();
}

void HandleDrag::push(double pixels) {
    plane_ += pixels * pixelLength_ * lineOfSight(sight_, held_ + grip_).direction;
    // The handle stays under the pointer.
    if (follows_)
        follows_ = false;
    update();
}

void HandleDrag::setFree(bool free) {
    free_ = free;
    if (!free && surface_)
        follows_ = isOnSurface(place_);
}

void HandleDrag::finish() {
    document_.finishPreview(
        answer_.possible() && moved_ ? editing::applied(text_, answer_.edits) : text_, label());
}

void HandleDrag::cancel() { document_.finishPreview(text_, {}); }

QString HandleDrag::label() const { return labelOf(*scene_, handle_); }

QString HandleDrag::words() const {
    if (!answer_.possible())
        return QString::fromStdString(answer_.reason);
    return QObject::tr("%1: %2 %3")
        .arg(subjectOf(*scene_, handle_), quantityOf(*scene_, handle_), valuesOf(wishes()));
}

} // namespace views
