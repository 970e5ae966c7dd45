#include "picture/indicating.h"

#include "editing/number_text.h"
#include "framing/extent.h"
#include "gestures/standing.h"
#include "picture/scene_display.h"
#include "script/numbers.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

// Along an axis.
bool isUpright(const Vector& direction) { return direction.cwiseAbs().maxCoeff() > 1 - 1e-9; }

// Along the axes of the world that lie in a face, all of a level one: above the middle of the body
// below where that is near, else at round numbers.
Vector besideMiddle(Vector place, const Vector& up, const Vector& middle, double reach,
                    double step) {
    const double near = std::min(reach, step / 2);
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(up[i]) < 1e-9)
            place[i] = std::abs(place[i] - middle[i]) < near ? middle[i]
                                                             : step * std::round(place[i] / step);
    return place;
}

// The way from its lowest point to its origin, upwards, where it is turned so.
double heightOf(const geometry::Shape& shape, const Vector& up,
                const geometry::Quaternion& attitude) {
    const geometry::Quaternion level = geometry::Quaternion::FromTwoVectors(up, Vector::UnitY());
    return -geometry::bounds(shape, {Vector::Zero(), level * attitude}).min().y();
}

bool isBall(const std::vector<scene::Part>& parts) {
    return parts.size() == 1 && std::holds_alternative<scene::SphereShape>(parts.front().shape);
}

// The place on that oblique plane through it whose numbers are short: multiples of `step`, but for
// one that keeps it on the plane, or `depth` off it along the normal. `kept`: a coordinate that
// does not change; -1: none.
Vector shortestOn(Vector place, const Vector& up, double step, double depth, Eigen::Index kept) {
    Eigen::Index told = 0;
    Vector across = up.cwiseAbs();
    if (kept >= 0)
        across[kept] = 0;
    across.maxCoeff(&told);
    double off = 0; // the plane, along its normal
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (i == told || i == kept || std::abs(up[i]) < 1e-9)
            continue;
        const double rounded = step * std::round(place[i] / step);
        off += up[i] * (rounded - place[i]);
        place[i] = rounded;
    }
    const double digit = editing::decimalStep(depth), sign = up[told] < 0 ? -1 : 1;
    constexpr double rounding = 1e-3; // of the digit
    place[told] =
        sign * digit * std::floor(sign * (place[told] - off / up[told]) / digit + rounding);
    return place;
}

bool hasFlatFaces(const scene::ShapeSet* set) {
    return set && std::ranges::all_of(set->parts, [](const scene::Part& part) {
               return std::holds_alternative<scene::BoxShape>(part.shape) ||
                      std::holds_alternative<scene::HullShape>(part.shape);
           });
}

} // namespace

std::variant<Indicated, QString> Indicating::at(BegunRecipe& begun, const QPointF& position,
                                                bool holdsOff) {
    const gestures::Sight sight = display_.sight();
    const Eigen::Vector2d pixels = display_.inPixels(position);
    const render::Drawing drawing = display_.drawing();
    switch (begun.step().wanted) {
    case Wanted::trajectory: {
        Indicated found;
        found.given = true;
        found.trajectory = gestures::trajectoryAt(*drawing.scene, sight, pixels,
                                                  clickReach * display_.devicePixelRatioF());
        if (!found.trajectory)
            return QObject::tr("There is no trajectory.");
        return found;
    }
    case Wanted::hold:
        return held(begun, pixels, holdsOff);
    case Wanted::point:
        return pointAt(begun, pixels, holdsOff);
    case Wanted::body:
        break;
    }
    const auto picked = gestures::bodyAt(drawing, sight, pixels);
    if (!picked)
        return QObject::tr("There is no body.");
    return onSurface(begun.step(), picked->body, picked->point);
}

Indicated Indicating::onSurface(const Step& step, std::size_t body, const Vector& surface) const {
    const gestures::Sight sight = display_.sight();
    const Eigen::Vector2d pixels = sight.pixels(surface);
    Indicated center = centerOf(body);
    if (step.whole || isNear(center.point, pixels))
        return center;
    return onBody(step, body, step.deep ? sight.beside(pixels, center.point) : surface);
}

Indicated Indicating::centerOf(std::size_t body) const {
    const geometry::Pose pose = poseOf(body);
    Indicated center;
    center.given = center.atCenter = true;
    center.body = body;
    center.attitude = pose.attitude;
    center.sight = towardsViewer();
    center.onBody = display_.centroidOf(body);
    center.point = pose.toWorld(center.onBody);
    center.resolution = display_.sight().pixelLength(center.point);
    return center;
}

std::optional<Indicated> Indicating::typed(BegunRecipe& begun, const QString& numbers) const {
    const QStringList words =
        numbers.split(QRegularExpression(QStringLiteral("[\\s,;]+")), Qt::SkipEmptyParts);
    if (words.isEmpty() || words.size() > 3)
        return std::nullopt;
    Indicated found;
    found.given = found.isTyped = true;
    found.sight = towardsViewer();
    for (qsizetype i = 0; i < words.size(); ++i) {
        const auto number = script::decimalNumber(words[i].toStdString());
        if (!number)
            return std::nullopt;
        found.point[i] = *number;
    }
    begun.fit(display_.sight(), found.point);
    if (const auto& headOf = begun.step().headOf) {
        const Vector value = found.point;
        constexpr double exact = 1e-9; // of a value of 1
        const auto head = [&](const Vector& one) { return headOf(begun.shown(), one); };
        found.point = head(value);
        found.resolution = exact * (head(Vector::UnitX()) - head(Vector::Zero())).norm();
    }
    if (begun.step().wanted == Wanted::hold)
        holdFirst(found, begun.shown().front());
    return found;
}

Indicated Indicating::pointAt(BegunRecipe& begun, const Eigen::Vector2d& pixels, bool holdsOff) {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    const Step& step = begun.step();
    const Vector deep = depth(begun.shown());
    Indicated found;
    found.given = true;
    found.point = step.snaps ? sight.across(pixels, deep) : sight.beside(pixels, deep);
    found.resolution = sight.pixelLength(found.point);
    found.sight = towardsViewer();
    const bool rests = step.rests && begun.ghost() && !holdsOff;
    const auto surface =
        step.surface || rests ? gestures::bodyAt(drawing, sight, pixels) : std::nullopt;
    if (surface && rests)
        return restingOn(begun, *surface, std::move(found));
    if (rests)
        if (const auto on = onGrid(begun, pixels, found))
            return *on;
    const bool snaps = step.snaps && !holdsOff; // fit() may make other steps
    begun.fit(sight, surface ? surface->point : found.point);
    if (surface)
        found.point = surface->point;
    if (!snaps)
        return found;
    const gestures::Snapped meant = snapping().at(found.point);
    if (surface && !meant.isExact)
        return found;
    found.point = meant.place;
    found.at = meant.to;
    if (meant.isExact)
        found.resolution *= 0.01; // so that it meets the thing
    return found;
}

// As deep as the place before, or as all bodies are that stand in one plane, or in the middle of
// the picture.
Vector Indicating::depth(const std::vector<Indicated>& shown) const {
    if (!shown.empty() && shown.back().given)
        return shown.back().point;
    const gestures::Sight sight = display_.sight();
    const Eigen::Index axis = sight.facing();
    Vector depth = sight.camera.center;
    depth[axis] = render::commonDepth(*display_.drawing().scene, axis).value_or(depth[axis]);
    return depth;
}

// It stands on the grid that is seen there, at round numbers, or where a thing on it draws it.
std::optional<Indicated> Indicating::onGrid(BegunRecipe& begun, const Eigen::Vector2d& pixels,
                                            Indicated found) {
    const auto ground = display_.ground();
    const gestures::Sight sight = display_.sight();
    const auto place =
        ground ? gestures::onGround(sight, pixels, ground->up, ground->height) : std::nullopt;
    if (!place)
        return std::nullopt;
    begun.fit(sight, *place);
    found.resolution = sight.pixelLength(*place);
    const gestures::Snapped meant = snapping().at(*place);
    found.point = meant.isExact ? meant.place : *place;
    if (!meant.isExact) {
        const double step = snapping().step(*place);
        for (const int axis : ground->across)
            found.point[axis] = step * std::round(found.point[axis] / step);
    }
    found.at = meant.isExact ? meant.to : QObject::tr("on the grid").toStdString();
    return standingOn(begun, *ground, std::move(found));
}

// The place at which it stands above or below that one, or beside it where others stand there.
Indicated Indicating::standingOn(const BegunRecipe& begun, const render::GroundPlane& ground,
                                 Indicated found) {
    const double height = ground.height + heightOf(*begun.ghost(), ground.up, found.attitude);
    found.point += (height - found.point.dot(ground.up)) * ground.up;
    const auto free =
        gestures::standingFree(display_.drawing(), *begun.ghost(), {found.point, found.attitude},
                               ground, snapping().step(found.point));
    if (free && *free != found.point)
        found.at = QObject::tr("on the grid, where there is room").toStdString();
    found.point = free.value_or(found.point);
    found.resolution *= 1e-3; // so that it touches
    return found;
}

Indicated Indicating::atOrigin(BegunRecipe& begun) {
    const gestures::Sight sight = display_.sight();
    begun.fit(sight, Vector::Zero());
    const auto ground = display_.ground();
    if (!begun.step().rests || !begun.ghost() || !ground ||
        ground->height + heightOf(*begun.ghost(), ground->up, geometry::Quaternion::Identity()) <=
            0)
        return {};
    Indicated found;
    found.given = true;
    found.sight = towardsViewer();
    found.resolution = sight.pixelLength(found.point);
    return standingOn(begun, *ground, std::move(found));
}

// Beside a body that stands on the ground a new one stands there, too: it goes up a face, or level
// to where it touches what is round. Answers with the coordinate of its height where the others are
// no round numbers then, else with -1; `up` is what it leans on.
Eigen::Index Indicating::raise(const BegunRecipe& begun, const gestures::Picked& picked, Vector& up,
                               Indicated& found) const {
    const auto ground = display_.ground();
    if (!ground || !(picked.point.dot(ground->up) > ground->height))
        return -1;
    const geometry::Shape& ghost = *begun.ghost();
    const double least = ground->height + heightOf(ghost, ground->up, found.attitude);
    const double missing = least - found.point.dot(ground->up), rise = up.dot(ground->up);
    const Vector along = ground->up - rise * up, level = up - rise * ground->up;
    constexpr double steep = 0.5, round = 0.01; // sin^2 of the slope
    if (!(missing > 0) || level.squaredNorm() < round)
        return -1;
    const scene::Scene& scene = *display_.drawing().scene;
    const Vector out = level.normalized(), raised = found.point + missing * ground->up;
    const auto beside = hasFlatFaces(scene::findShapeSet(scene, scene.bodies[picked.body].shape))
                            ? std::nullopt
                            : gestures::touchingBeside(display_.drawing(), ghost,
                                                       {raised, found.attitude}, picked.body, out);
    if (beside) {
        found.point = *beside;
        up = out;
    } else if (level.squaredNorm() > steep) {
        found.point += missing / along.squaredNorm() * along;
    }
    if (!beside && (level.squaredNorm() <= steep || isUpright(up)))
        return -1; // its numbers are round
    Eigen::Index kept = 0;
    ground->up.cwiseAbs().maxCoeff(&kept);
    return kept;
}

// It touches the surface there, and lies on a slope: turned as the body below it is, or, on an
// oblique face of that, by the shortest way.
Indicated Indicating::restingOn(BegunRecipe& begun, const gestures::Picked& picked,
                                Indicated found) {
    const geometry::Pose pose = poseOf(picked.body);
    begun.fit(display_.sight(), picked.point);
    Vector up = picked.normal;
    const bool isLevel = isUpright(up);
    const scene::Scene& scene = *display_.drawing().scene;
    const Vector upwards = render::upOf(scene);
    const bool lies = !isLevel && !isBall(begun.recipe().ghost); // which has no side to lie on
    if (lies && isUpright(pose.attitude.conjugate() * up))
        found.attitude = pose.attitude;
    else if (lies && up.dot(upwards) > 0 &&
             hasFlatFaces(scene::findShapeSet(scene, scene.bodies[picked.body].shape)))
        found.attitude = geometry::Quaternion::FromTwoVectors(upwards, up);
    Vector place = picked.point;
    double step = snapping().step(place);
    const gestures::Snapped meant = snapping().at(place);
    // The middle of another face, as of the lower one of a thin board, is none of this surface.
    const double off = std::abs((meant.place - place).dot(up));
    if (meant.isExact && meant.to.starts_with("the middle of a face") &&
        off < 0.1 * found.resolution) {
        place = meant.place;
        found.at = meant.to;
        step = editing::decimalStep(found.resolution);
    } else {
        place = besideMiddle(place, up, pose.position, 1.5 * clickReach * found.resolution, step);
    }
    found.point = place + heightOf(*begun.ghost(), up, found.attitude) * up;
    const Eigen::Index kept = raise(begun, picked, up, found);
    found.resolution *= 1e-3;          // so that it touches
    if (!isUpright(up) || kept >= 0) { // and a little more: a gap would be a fall
        constexpr double touch = 1e-8; // of its size: an overlap that is none (docs/numerics.md)
        found.resolution =
            editing::decimalStep(touch * geometry::radiusAbout(*begun.ghost(), Vector::Zero()));
        found.point = shortestOn(found.point, up, step, found.resolution, kept);
    }
    if (found.at.empty())
        found.at = QObject::tr("on %1")
                       .arg(QString::fromStdString(scene.bodies[picked.body].name))
                       .toStdString();
    return found;
}

// A point of the world on a body; one that is meant to be deep lies on the body's axes if near.
Indicated Indicating::onBody(const Step& step, std::size_t body, const Vector& point) const {
    const geometry::Pose pose = poseOf(body);
    Indicated found = centerOf(body);
    found.atCenter = false;
    found.resolution = display_.sight().pixelLength(point);
    found.onBody = pose.toLocal(point);
    if (step.deep)
        found.onBody = onAxes(body, found.onBody, found.resolution);
    found.point = pose.toWorld(found.onBody);
    return found;
}

// A hand's unsteadiness beside an axis of the body through its centre is none.
Vector Indicating::onAxes(std::size_t body, const Vector& onBody, double near) const {
    const Vector center = display_.centroidOf(body);
    Vector from = onBody - center;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(from[i]) < 0.6 * clickReach * display_.devicePixelRatioF() * near)
            from[i] = 0;
    return from + center;
}

// The place under a body that is shown there, further behind or before: as deep as its centre. The
// edge of a body reaches a little further than it is seen, or a hand that trembles at the seam of
// two bodies would join one of them to the ground.
Indicated Indicating::held(const BegunRecipe& begun, Eigen::Vector2d pixels, bool holdsOff) {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    const std::size_t first = *begun.shown().front().body;
    Indicated found;
    found.given = true;
    const auto other = holdsOff
                           ? gestures::bodyAt(drawing, sight, pixels, first)
                           : gestures::bodyBeside(drawing, sight, pixels,
                                                  edgeReach * display_.devicePixelRatioF(), first);
    if (other)
        pixels = sight.pixels(other->point);
    found.point = sight.across(pixels, begun.shown().front().point);
    found.resolution = sight.pixelLength(found.point);
    std::size_t alongside = first; // its axes draw the place to them
    if (other) {
        const Indicated center = centerOf(other->body);
        found.body = other->body;
        found.atCenter = isNear(center.point, pixels);
        if (gestures::isGrasped(*drawing.scene, other->body)) {
            alongside = other->body;
            if (!gestures::isIn(drawing, other->body, found.point))
                found.point = sight.beside(pixels, center.point);
        }
        if (found.atCenter)
            found.point = center.point;
    }
    if (!found.atCenter && (other || begun.shown().front().atCenter)) {
        const geometry::Pose pose = poseOf(alongside);
        found.point = pose.toWorld(onAxes(alongside, pose.toLocal(found.point), found.resolution));
    }
    if (!found.atCenter && !holdsOff)
        drawn(found, alongside);
    found.onFirst = poseOf(first).toLocal(found.point);
    if (other) {
        const geometry::Pose pose = poseOf(other->body);
        found.onBody = pose.toLocal(found.point);
        found.attitude = pose.attitude;
    }
    return found;
}

// It is drawn to things and round numbers, but for what lies on the axes of that body. Where one
// looks along an axis nobody points at a depth: an edge in front draws the place sideways only.
void Indicating::drawn(Indicated& found, std::size_t alongside) {
    const gestures::Snapped meant = snapping().at(found.point);
    const gestures::Sight sight = display_.sight();
    const Eigen::Index facing = sight.facing();
    found.at = meant.to;
    if (meant.isExact) {
        const double depth = found.point[facing], away = meant.place[facing] - depth;
        found.point = meant.place;
        if (sight.isPlan() && std::abs(away) <= clickReach * found.resolution)
            found.point[facing] = depth;
        found.resolution *= 0.01; // so that it meets the thing
        return;
    }
    const geometry::Pose pose = poseOf(alongside);
    const Vector center = pose.toWorld(display_.centroidOf(alongside));
    const bool isTurned = (pose.attitude * Vector::UnitX()).cwiseAbs().maxCoeff() < 1 - 1e-9 ||
                          (pose.attitude * Vector::UnitY()).cwiseAbs().maxCoeff() < 1 - 1e-9;
    if (found.body && isTurned) // along its axes no number of the world is round
        return;
    constexpr double finer = 4; // than for bodies: a joint may be anywhere on them
    const double step = gestures::roundStep(snapping().step(found.point) / finer);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const bool isOnAxis =
            std::abs(found.point[i] - center[i]) < 1e-9 * (1 + std::abs(center[i]));
        if (!isOnAxis && i != facing)
            found.point[i] = step * std::round(found.point[i] / step);
    }
}

// A typed place holds the first body to the body that is there.
void Indicating::holdFirst(Indicated& found, const Indicated& first) const {
    found.onFirst = poseOf(*first.body).toLocal(found.point);
    found.body = gestures::bodyAround(display_.drawing(), found.point, *first.body);
    if (!found.body)
        return;
    const geometry::Pose pose = poseOf(*found.body);
    found.onBody = pose.toLocal(found.point);
    found.attitude = pose.attitude;
}

bool Indicating::isNear(const Vector& point, const Eigen::Vector2d& pixels) const {
    return (display_.sight().pixels(point) - pixels).norm() <=
           0.7 * clickReach * display_.devicePixelRatioF();
}

geometry::Pose Indicating::poseOf(std::size_t body) const {
    const render::Drawing drawing = display_.drawing();
    return render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
}

Vector Indicating::towardsViewer() const {
    return display_.sight().camera.rotation.conjugate() * Vector::UnitZ();
}

const gestures::Snapping& Indicating::snapping() {
    const Shown& shown = document_.shown();
    const gestures::Sight sight = display_.sight();
    if (!near_ || near_->of.scene != shown.scene || near_->of.motion != shown.motion ||
        near_->time != display_.time() || near_->sight.size != sight.size ||
        near_->sight.camera != sight.camera)
        near_.emplace(
            Near{shown, display_.time(), sight,
                 gestures::Snapping(display_.drawing(), sight, display_.devicePixelRatioF())});
    return near_->snapping;
}

} // namespace views
