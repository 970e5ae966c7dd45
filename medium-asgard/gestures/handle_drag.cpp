#include "gestures/handle_drag.h"

#include "editing/number_text.h"
#include "gestures/handle_meaning.h"
#include "gestures/new_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gestures {

using geometry::Vector;

namespace {

constexpr double unturned = 1e-6; // radians

std::string distanceText(double distance, double resolution) {
    return editing::numberText(distance, editing::decimalStep(resolution));
}

} // namespace

HandleDrag::HandleDrag(Ground ground, const Sight& sight, const render::Handle& handle,
                       const std::optional<Eigen::Vector2d>& pixels)
    : ground_(std::move(ground)),
      mapper_(ground_.text, ground_.scene,
              [this](const std::string& name) {
                  return render::constantValue(*ground_.scene, ground_.motion.get(), name);
              }),
      sight_(sight), handle_(handle), pixelLength_(sight.pixelLength(handle.place)),
      place_(handle.place), plane_(handle.place), held_(sight.pixels(handle.place)),
      grip_(Eigen::Vector2d::Zero()), isByKeys_(!pixels) {
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
        const scene::Link& link = ground_.scene->links[handle_.element];
        const auto* second = std::get_if<scene::BodyEnd>(&link.second);
        const std::string body = handle_.part == 0 ? link.first.body : second ? second->body : "";
        hold_.surface = shapeOf(*ground_.scene, body);
        // One that does not lie on the surface is not drawn to it.
        hold_.follows = isOnSurface(handle_.place);
    }
    if (handle_.kind == render::HandleKind::trajectoryPoint)
        path_.emplace(ground_.text, ground_.scene, handle_.element);
    // Why it cannot be moved is told before it is.
    auto asked = withFollowing(*ground_.scene, wishes());
    if (path_)
        asked = {path_->wishOf(pointOf(*path_, handle_))};
    for (editing::Wish& wish : asked) {
        wish.now.clear();
        wish.offers = false;
    }
    answer_ = mapper_.answer(asked);
    answer_.edits.clear();
}

bool HandleDrag::isOnSurface(const Vector& place) const {
    if (!hold_.surface)
        return false;
    const double near = 2 * pixelLength_;
    const Line sight = lineOfSight(sight_, sight_.pixels(place));
    const auto hit =
        geometry::castRay(*hold_.surface, handle_.frame.toLocal(place - near * sight.direction),
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
    const auto hit = geometry::castRay(*hold_.surface, handle_.frame.toLocal(sight.from),
                                       handle_.frame.attitude.conjugate() * sight.direction);
    return hit ? std::optional(handle_.frame.toWorld(hit->point)) : std::nullopt;
}

// As the view rolls (framing/camera.h), about the axis that points out of the screen.
Vector HandleDrag::rolled() const {
    double angle = -1.5 * (held_.x() - *rollsFrom_) / render::pixelsPerUnit(sight_.size);
    if (std::abs(std::remainder(angle, 2 * M_PI)) > M_PI - 1e-3)
        angle += 2e-3; // half a turn has no axis of its own
    const geometry::Quaternion back = sight_.camera.rotation.conjugate();
    const double reach = (handle_.place - handle_.base).norm();
    return handle_.base + reach * (back * Vector(std::cos(angle), std::sin(angle), 0));
}

// About the axis, from the next axis on. An axis across the line of sight has its ring seen from
// the side: there the hand goes along it.
double HandleDrag::angleOfHand() const {
    constexpr double slanting = 0.2; // cosine
    const Line line = lineOfSight(sight_, held_);
    const int axis = turning_->axis;
    const double cosine = line.direction[axis];
    if (std::abs(cosine) > slanting) {
        const Vector hit = line.from + line.direction * ((handle_.base - line.from)[axis] / cosine);
        const Vector way = hit - handle_.base;
        return std::atan2(way[(axis + 2) % 3], way[(axis + 1) % 3]);
    }
    const Vector front = Vector::Unit(axis).cross(-line.direction).normalized();
    const Eigen::Vector2d along =
        sight_.pixels(handle_.base + handle_.perUnit * front) - sight_.pixels(handle_.base);
    return held_.dot(along) / along.squaredNorm();
}

void HandleDrag::setTurns(int axis) {
    const bool wasTurned = turning_ && moved_;
    turning_ = Turning{axis, 0};
    turning_->last = angleOfHand();
    if (wasTurned) // another axis: from the attitude that it had
        update();
}

double HandleDrag::turned() const {
    if (!turning_)
        return 0;
    return joined_ ? turning_->reached : rounded(turning_->angle * 180 / M_PI);
}

double HandleDrag::rounded(double degrees) const {
    constexpr double round = 15, near = 2.5;
    if (snaps_.areHeldOff)
        return editing::roundedTo(degrees, 0.1);
    const double nearest = round * std::round(degrees / round);
    return std::abs(degrees - nearest) < near ? nearest : std::round(degrees);
}

void HandleDrag::setRolls() { rollsFrom_ = held_.x(); }

bool HandleDrag::isPlace() const {
    using render::HandleKind;
    return handle_.kind == HandleKind::position || handle_.kind == HandleKind::linkEnd ||
           handle_.kind == HandleKind::jointPoint || handle_.kind == HandleKind::lightPlace ||
           (handle_.kind == HandleKind::trajectoryPoint && !handle_.isValue());
}

void HandleDrag::setSnaps(double scale) {
    if (!isPlace())
        return;
    render::Drawing drawing;
    drawing.scene = ground_.scene.get();
    drawing.motion = ground_.motion;
    drawing.time = ground_.motion ? ground_.motion->start() : ground_.scene->simulator.start;
    snaps_.by.emplace(drawing, sight_, scale, &handle_,
                      company_ ? company_->bodies() : std::vector<std::size_t>());
}

void HandleDrag::setCompany(const std::vector<std::size_t>& others) {
    if (others.empty() || handle_.kind != render::HandleKind::position)
        return;
    std::vector<std::size_t> all{handle_.element};
    all.insert(all.end(), others.begin(), others.end());
    company_.emplace(*ground_.scene, all);
}

// A place that a thing draws is written so finely that it meets the thing.
double HandleDrag::resolution() const {
    return snaps_.last.isExact ? 0.01 * pixelLength_ : pixelLength_;
}

Vector HandleDrag::wanted() {
    snaps_.last.isExact = false;
    snaps_.last.to.clear();
    if (turning_)
        return handle_.place;
    if (rollsFrom_)
        return rolled();
    if (handle_.kind == render::HandleKind::orientation)
        return onSphere();
    if (hold_.follows && !hold_.isFree) // beside the body it waits where it was
        return onSurface().value_or(place_);
    const Vector place = unsnapped();
    return swings() && joined_->turns() ? place : snapped(place);
}

Vector HandleDrag::snapped(const Vector& place) {
    if (!snaps_.by || snaps_.areHeldOff)
        return place;
    snaps_.last = snaps_.by->at(place, handle_.place);
    Vector on = kept(snaps_.last.place);
    snaps_.last.isExact = snaps_.last.isExact && on == snaps_.last.place;
    return on;
}

// Where the line of sight comes nearest to the axis, or meets the plane.
Vector HandleDrag::unsnapped() const {
    if (!along_)
        return under(held_ + grip_);
    constexpr double least = 0.03; // an axis or a plane that one looks along
    const Line line = lineOfSight(sight_, held_ + grip_);
    const Vector axis = Vector::Unit(along_->axis), way = handle_.place - line.from;
    const double cosine = line.direction[along_->axis];
    if (along_->isPlane)
        return std::abs(cosine) < least
                   ? place_
                   : kept(line.from + line.direction * (way[along_->axis] / cosine));
    if (1 - cosine * cosine < least * least)
        return place_;
    const double there = (cosine * line.direction.dot(way) - axis.dot(way)) / (1 - cosine * cosine);
    return handle_.place + there * axis;
}

Vector HandleDrag::kept(const Vector& place) const {
    if (!along_)
        return place;
    Vector on = along_->isPlane ? place : handle_.place;
    on[along_->axis] = along_->isPlane ? handle_.place[along_->axis] : place[along_->axis];
    return on;
}

void HandleDrag::setAlong(const std::optional<Along>& along) {
    if (!isPlace() || along == along_)
        return;
    along_ = along;
    if (moved_)
        update();
}

std::vector<editing::Wish> HandleDrag::wishes() const {
    constexpr double exact = 1e-9;
    if (turning_)
        return turnWishes(exact);
    return wishesFor(*ground_.scene, handle_, place_, resolution(), quaternion_);
}

// The middle of the rings stays.
std::vector<editing::Wish> HandleDrag::turnWishes(double exact) const {
    const geometry::Quaternion turn(
        Eigen::AngleAxisd(turned() * M_PI / 180, Vector::Unit(turning_->axis)));
    std::vector<editing::Wish> wishes{turnWish(*ground_.scene, handle_, turn, exact, quaternion_)};
    render::Handle place = handle_;
    place.kind = render::HandleKind::position;
    place.base = place.place = handle_.frame.position;
    const Vector arm = handle_.frame.position - handle_.base;
    if (arm.norm() > exact * (1 + handle_.base.norm()))
        wishes.push_back(
            wishesFor(*ground_.scene, place, handle_.base + turn * arm, 0.01 * pixelLength_, false)
                .front());
    return wishes;
}

// What it asks of the text. A point that ends one curve and begins the next moves in both.
editing::Answer HandleDrag::asked(bool offers) const {
    if (joined_ && !whyNotJoined().empty())
        return {.edits = {}, .reason = whyNotJoined(), .cause = {}, .offers = {}, .kept = {}};
    if (joined_ || company_) {
        auto wishes = company_ ? company_->wishes(mapper_) : joined_->wishes(mapper_);
        for (editing::Wish& wish : wishes)
            wish.offers = offers;
        return mapper_.answer(wishes);
    }
    if (!path_) {
        auto wishes = withFollowing(*ground_.scene, this->wishes());
        for (editing::Wish& wish : wishes)
            wish.offers = offers;
        return mapper_.answer(wishes);
    }
    const editing::Wish wish = wishes().front();
    const std::size_t point = pointOf(*path_, handle_);
    const editing::ControlPoint& now = path_->points()[point];
    // A coordinate that was not moved keeps its digits.
    Vector place = now.place;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = wish.values[wish.values.size() - 3 + i];
        double& coordinate = place[static_cast<Eigen::Index>(i)];
        if (std::abs(value - coordinate) >= 0.5 * wish.resolution)
            coordinate = editing::roundedTo(value, wish.resolution);
    }
    return path_->move(point, now.time, place, 0);
}

Vector HandleDrag::under(const Eigen::Vector2d& pixels) const {
    return isUpright_ ? sight_.across(pixels, plane_) : sight_.beside(pixels, plane_);
}

// By the point under the pointer, in the plane that it moves in.
void HandleDrag::findJoined() {
    if (company_)
        return;
    if (handle_.kind == render::HandleKind::position)
        joined_ = Joined::of(*ground_.scene, handle_.element,
                             under(sight_.pixels(handle_.place) - grip_));
    else if (turning_)
        joined_ = Joined::of(*ground_.scene, handle_.element, handle_.base);
}

void HandleDrag::turnJoined() {
    const double degrees = rounded(turning_->angle * 180 / M_PI);
    if (!joined_->areTooMany() &&
        joined_->turnAbout(Vector::Unit(turning_->axis), degrees * M_PI / 180))
        turning_->reached = degrees;
}

// Along an axis any number of them moves.
std::string HandleDrag::whyNotJoined() const {
    if (turning_)
        return turned() == 0 && rounded(turning_->angle * 180 / M_PI) != 0
                   ? joined_->whyNotTurned("xyz"[turning_->axis])
                   : std::string();
    return along_ ? std::string() : joined_->whyNotPulled();
}

// A key that is pressed once turns it, if by less than a degree.
double HandleDrag::joinedDegrees() const {
    const double degrees = joined_->turned() * 180 / M_PI;
    return isByKeys_ ? editing::roundedTo(degrees, 0.1) : rounded(degrees);
}

// One way for all bodies, rounded so that this body comes to a round place.
void HandleDrag::roundPlace() {
    for (const editing::Wish& wish : wishes())
        for (std::size_t i = 0; i < 3; ++i)
            place_[static_cast<Eigen::Index>(i)] =
                std::abs(wish.values[i] - wish.now[i]) < 0.5 * wish.resolution
                    ? wish.now[i]
                    : editing::roundedTo(wish.values[i], wish.resolution);
}

void HandleDrag::moveJoined() {
    if (turning_)
        return turnJoined();
    if (!whyNotJoined().empty())
        return;
    if (!swings()) {
        roundPlace();
        return joined_->moveAll(place_ - handle_.place);
    }
    if (joined_->turns())
        joined_->pull(under(held_) - joined_->grabbed());
    if (joined_->turned() > unturned)
        joined_->turnTo(joinedDegrees() * M_PI / 180);
    else
        joined_->pull((joined_->turns() ? snapped(place_) : place_) - handle_.place);
    place_ = joined_->poseOf(handle_.element).position;
}

void HandleDrag::update() {
    if (!std::exchange(moved_, true))
        findJoined();
    if (turning_) {
        const double now = angleOfHand();
        turning_->angle += std::remainder(now - std::exchange(turning_->last, now), 2 * M_PI);
    }
    const bool followed = hold_.follows && !hold_.isFree;
    place_ = wanted();
    if (joined_)
        moveJoined();
    if (company_) {
        roundPlace();
        company_->moveAll(place_ - handle_.place);
    }
    if (followed)
        plane_ = place_; // freed, it goes on from here
    else if (hold_.surface && !hold_.isFree)
        hold_.follows = isOnSurface(place_);
    answer_ = asked(false); // which nobody sees before it ends
    if (answer_.possible())
        ground_.preview(text::applied(ground_.text, answer_.edits));
}

void HandleDrag::move(const Eigen::Vector2d& pixels) {
    if (pixels == held_)
        return;
    held_ = pixels;
    update();
}

bool HandleDrag::goOn() {
    constexpr double still = 0.1; // pixels
    if (!moved_ || isByKeys_ || turning_ || !swings())
        return false;
    const Vector before = place_;
    update();
    return (place_ - before).norm() > still * pixelLength_;
}

void HandleDrag::nudge(const Eigen::Vector2d& byPixels) {
    held_ += byPixels;
    update();
}

void HandleDrag::push(double pixels) {
    plane_ += pixels * pixelLength_ * lineOfSight(sight_, held_ + grip_).direction;
    // The handle stays under the pointer.
    if (hold_.follows)
        hold_.follows = false;
    update();
}

void HandleDrag::setFree(bool free) {
    hold_.isFree = free;
    if (!free && hold_.surface)
        hold_.follows = isOnSurface(place_);
}

void HandleDrag::finish() {
    if (moved_ && !answer_.possible())
        answer_ = asked(true);
    ground_.finish(answer_.possible() && moved_ ? text::applied(ground_.text, answer_.edits)
                                                : ground_.text,
                   label());
}

void HandleDrag::cancel() { ground_.finish(ground_.text, {}); }

std::string HandleDrag::label() const {
    return company_ ? "Move " + std::to_string(company_->bodies().size()) + " bodies"
                    : labelOf(*ground_.scene, handle_);
}

std::string HandleDrag::joinedWords() const {
    if (company_)
        return ", with " + std::to_string(company_->bodies().size() - 1) + " more";
    if (!joined_)
        return {};
    if (!swings())
        return joined_->bodies().size() > 1 ? ", with all that is joined to it" : "";
    return joined_->turned() > unturned
               ? ", turned by " + editing::numberText(joined_->turned() * 180 / M_PI, 0.1) +
                     " degrees, as its joints allow"
               : ", as its joints allow";
}

std::string HandleDrag::words() const {
    if (!answer_.possible())
        return answer_.reason;
    if (turning_)
        return subjectOf(*ground_.scene, handle_) + ": turned by " +
               editing::numberText(turned(), 0.1) + " degrees about " + "xyz"[turning_->axis] +
               (joined_ ? ", as its joints allow" : "");
    return subjectOf(*ground_.scene, handle_) + ": " + quantityOf(*ground_.scene, handle_) + " " +
           valuesOf(wishes()) +
           (hold_.follows && !hold_.isFree ? ", on the surface; a takes it off" : "") +
           (snaps_.last.to.empty() ? "" : ", at " + snaps_.last.to + "; Ctrl takes it off") +
           (along_ ? std::string(along_->isPlane ? "; across " : "; along ") + "xyz"[along_->axis]
                   : "") +
           joinedWords() +
           (isPlace() && moved_
                ? "; moved " + distanceText((place_ - handle_.place).norm(), pixelLength_)
                : "");
}

} // namespace gestures
