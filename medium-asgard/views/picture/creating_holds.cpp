// The other body of a joint or a rope, and the place on it.
#include "picture/creating.h"

#include "gestures/snapping.h"
#include "gestures/standing.h"
#include "picture/scene_display.h"

#include <cmath>

namespace views {

// A point of the world on a body; one that is meant to be deep lies on the body's axes if near.
Indicated Creating::onBody(std::size_t body, const Vector& point) const {
    const render::Drawing drawing = display_.drawing();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
    Indicated found = centerOf(body);
    found.atCenter = false;
    found.resolution = display_.sight().pixelLength(point);
    found.onBody = pose.toLocal(point);
    if (step().deep)
        found.onBody = onAxes(body, found.onBody, found.resolution);
    found.point = pose.toWorld(found.onBody);
    return found;
}

// A hand's unsteadiness beside an axis of the body through its centre is none.
Vector Creating::onAxes(std::size_t body, const Vector& onBody, double near) const {
    const Vector center = display_.centroidOf(body);
    Vector from = onBody - center;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(from[i]) < 0.6 * clickReach * display_.devicePixelRatioF() * near)
            from[i] = 0;
    return from + center;
}

// The place that holds the first body lies in the plane of the screen through what was shown of it,
// or, where another body is shown that is further behind or before, as deep as that body's centre.
Indicated Creating::held(const Eigen::Vector2d& pixels) {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    const Indicated& first = shown_.front();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), *first.body, drawing.time);
    Indicated found;
    found.given = true;
    found.point = sight.across(pixels, first.point);
    found.resolution = sight.pixelLength(found.point);
    const auto other = gestures::bodyAt(drawing, sight, pixels, first.body);
    if (other) {
        const Indicated center = centerOf(other->body);
        found.body = other->body;
        found.atCenter = (sight.pixels(center.point) - pixels).norm() <=
                         0.7 * clickReach * display_.devicePixelRatioF();
        if (gestures::isGrasped(*drawing.scene, other->body) &&
            !gestures::isIn(drawing, other->body, found.point))
            found.point = sight.beside(pixels, center.point);
        const geometry::Pose its =
            render::poseOf(*drawing.scene, drawing.motion.get(), other->body, drawing.time);
        found.onBody = found.atCenter
                           ? center.onBody
                           : onAxes(other->body, its.toLocal(found.point), found.resolution);
        found.point = its.toWorld(found.onBody);
    }
    found.onFirst = onAxes(*first.body, pose.toLocal(found.point), found.resolution);
    if (!other && first.atCenter)
        found.point = pose.toWorld(found.onFirst);
    if (!other && !holdsOff_)
        drawn(found, pose);
    return found;
}

// On the ground it is drawn to things and round numbers, but for what lies on the body's axes.
void Creating::drawn(Indicated& found, const geometry::Pose& first) {
    const gestures::Snapped meant = snapping().at(found.point);
    found.at = meant.to;
    const Vector center = first.toWorld(display_.centroidOf(*shown_.front().body));
    Vector place = meant.place;
    constexpr double finer = 4; // than for bodies: a joint may be anywhere on them
    const double step = gestures::roundStep(snapping().step(found.point) / finer);
    if (meant.isExact)
        found.resolution *= 0.01; // so that it meets the thing
    for (Eigen::Index i = 0; i < 3 && !meant.isExact; ++i) {
        const bool isOnAxis =
            std::abs(found.point[i] - center[i]) < 1e-9 * (1 + std::abs(center[i]));
        const bool isDepth = i == display_.sight().facing(); // nobody points at it
        place[i] = isOnAxis  ? center[i]
                   : isDepth ? found.point[i]
                             : step * std::round(found.point[i] / step);
    }
    found.point = place;
    found.onFirst = first.toLocal(place);
}

// A typed place holds the first body to the body that is there.
void Creating::holdFirst(Indicated& found) const {
    const render::Drawing drawing = display_.drawing();
    const auto poseOf = [&](std::size_t body) {
        return render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
    };
    const std::size_t first = *shown_.front().body;
    found.onFirst = poseOf(first).toLocal(found.point);
    found.body = gestures::bodyAround(drawing, found.point, first);
    if (found.body)
        found.onBody = poseOf(*found.body).toLocal(found.point);
}

} // namespace views
