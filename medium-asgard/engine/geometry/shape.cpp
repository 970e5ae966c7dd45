#include "geometry/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geometry {

Part spherePart(double radius, const Vector& center) { return {point(center), radius}; }

Part polyhedronPart(const Polyhedron& polyhedron, const Pose& pose) {
    const bool moved = pose.position != Vector::Zero() ||
                       pose.attitude.coeffs() != Quaternion::Identity().coeffs();
    return {moved ? transformed(polyhedron, pose) : polyhedron, 0};
}

// A capsule without height is a sphere, to the last bit.
Part capsulePart(double radius, double height, const Pose& pose) {
    if (height == 0)
        return spherePart(radius, pose.position);
    const Vector half = pose.attitude * Vector(0, height / 2, 0);
    Polyhedron segment;
    segment.vertices = {pose.position - half, pose.position + half};
    segment.neighbours = {{1}, {0}};
    return {segment, radius};
}

namespace {

Part curvedPart(Curved::Kind kind, const Vector& sizes, const Pose& pose) {
    return {point(pose.position), 0,
            Curved{kind, sizes, pose.position, pose.attitude.toRotationMatrix()}};
}

} // namespace

Part cylinderPart(double radius, double height, const Pose& pose) {
    return curvedPart(Curved::Kind::cylinder, {radius, height / 2, radius}, pose);
}

Part conePart(double radius, double height, const Pose& pose) {
    return curvedPart(Curved::Kind::cone, {radius, height / 2, radius}, pose);
}

Part ellipsoidPart(const Vector& halfAxes, const Pose& pose) {
    return curvedPart(Curved::Kind::ellipsoid, halfAxes, pose);
}

Part tubePart(double inner, double outer, double height, const Pose& pose) {
    Part part = curvedPart(Curved::Kind::tube, {outer, height / 2, outer}, pose);
    part.curved->inner = inner;
    return part;
}

Part bowlPart(double inner, double outer, const Pose& pose) {
    Part part = curvedPart(Curved::Kind::bowl, {outer, 0, outer}, pose);
    part.curved->inner = inner;
    return part;
}

Part planePart(const Pose& pose) { return curvedPart(Curved::Kind::plane, Vector::Zero(), pose); }

Vector supportPoint(const Part& part, const Vector& direction) {
    return part.curved ? supportPoint(*part.curved, direction)
                       : part.core.vertices[support(part.core, direction)];
}

double radiusAbout(const Part& part, const Vector& center) {
    if (part.curved)
        return radiusAbout(*part.curved, center);
    double furthest = 0;
    for (const Vector& v : part.core.vertices)
        furthest = std::max(furthest, (v - center).norm());
    return furthest + part.radius;
}

double radiusAbout(const Shape& shape, const Vector& center) {
    double furthest = 0;
    for (const Part& part : shape.parts)
        furthest = std::max(furthest, radiusAbout(part, center));
    return furthest;
}

Box bounds(const Shape& shape, const Pose& pose) {
    Box box;
    for (const Part& part : shape.parts)
        if (part.curved) {
            for (int axis = 0; axis < 3; ++axis)
                for (const double sign : {-1.0, 1.0}) {
                    const Vector direction = sign * Vector::Unit(axis);
                    box.extend(
                        pose.toWorld(supportPoint(part, pose.attitude.conjugate() * direction)));
                }
        } else
            for (const Vector& v : part.core.vertices) {
                const Vector world = pose.toWorld(v);
                box.extend(world - Vector::Constant(part.radius));
                box.extend(world + Vector::Constant(part.radius));
            }
    return box;
}

namespace {

std::optional<RayHit> hitSphere(const Part& part, const Vector& origin, const Vector& direction) {
    const Vector from = origin - part.center();
    const double a = direction.squaredNorm(), b = from.dot(direction);
    // The discriminant from the distance of the centre to the line: no cancellation far away.
    const double miss = (from - b / a * direction).squaredNorm();
    const double within = part.radius * part.radius - miss;
    if (within < 0)
        return std::nullopt;
    const double half = std::sqrt(within / a);
    const double distance = -b / a - half >= 0 ? -b / a - half : -b / a + half;
    if (distance < 0)
        return std::nullopt;
    const Vector point = origin + distance * direction;
    return RayHit{distance, point, (point - part.center()).normalized(), 0, std::nullopt};
}

// The first crossing at a distance >= 0 of a stretch that is inside.
std::optional<double> crossing(const std::optional<std::pair<double, double>>& inside) {
    if (!inside)
        return std::nullopt;
    const double distance = inside->first >= 0 ? inside->first : inside->second;
    return distance >= 0 && std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

// The hollow of one as a body of its own: longer than the tube, and of the bowl the whole ball.
Part hollowOf(const Curved& curved) {
    Part hollow = curved.kind == Curved::Kind::tube ? cylinderPart(curved.inner, 4 * curved.half())
                                                    : ellipsoidPart(Vector::Constant(curved.inner));
    hollow.curved->center = curved.center;
    hollow.curved->frame = curved.frame;
    return hollow;
}

// The wall before the hollow and the wall behind it.
std::optional<double> crossingWall(const Curved& curved, const Vector& origin,
                                   const Vector& direction) {
    const auto hull = insideAlong(curved, origin, direction);
    const auto hollow = insideAlong(*hollowOf(curved).curved, origin, direction);
    if (!hull || !hollow || hollow->second <= hull->first || hollow->first >= hull->second)
        return crossing(hull);
    std::optional<double> first;
    if (hollow->first > hull->first)
        first = crossing(std::pair(hull->first, hollow->first));
    if (!first && hollow->second < hull->second)
        first = crossing(std::pair(hollow->second, hull->second));
    return first;
}

std::optional<RayHit> hitCurved(const Part& part, const Vector& origin, const Vector& direction) {
    const auto distance = part.isHollow() ? crossingWall(*part.curved, origin, direction)
                                          : crossing(insideAlong(*part.curved, origin, direction));
    if (!distance)
        return std::nullopt;
    const Vector point = origin + *distance * direction;
    const Vector normal =
        part.isHollow() ? nearestOf(*part.curved, point).normal : normalAt(*part.curved, point);
    return RayHit{*distance, point, normal, 0, std::nullopt};
}

// Inside the tube or one of the balls: convex, and so one stretch.
std::optional<RayHit> hitCapsule(const Part& part, const Vector& origin, const Vector& direction) {
    const Vector &a = part.core.vertices[0], &b = part.core.vertices[1];
    const Vector middle = (a + b) / 2, along = (b - a).normalized();
    const Quaternion turn = Quaternion::FromTwoVectors(Vector::UnitY(), along);
    const Part tube = cylinderPart(part.radius, (b - a).norm(), {middle, turn});
    std::optional<std::pair<double, double>> inside = insideAlong(*tube.curved, origin, direction);
    for (const Vector& end : {a, b}) {
        const Part ball =
            ellipsoidPart(Vector::Constant(part.radius), {end, Quaternion::Identity()});
        const auto own = insideAlong(*ball.curved, origin, direction);
        if (own && inside)
            inside = {std::min(inside->first, own->first), std::max(inside->second, own->second)};
        else if (own)
            inside = own;
    }
    const auto distance = crossing(inside);
    if (!distance)
        return std::nullopt;
    const Vector hit = origin + *distance * direction;
    const double s = std::clamp((hit - a).dot(along), 0.0, (b - a).norm());
    return RayHit{*distance, hit, (hit - a - s * along).normalized(), 0, std::nullopt};
}

// Clips the ray by the face planes: it is inside from the last entry to the first exit.
std::optional<RayHit> hitPolyhedron(const Part& part, const Vector& origin,
                                    const Vector& direction) {
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    std::size_t enterFace = 0, leaveFace = 0;
    for (std::size_t f = 0; f < part.core.faces.size(); ++f) {
        const Face& face = part.core.faces[f];
        const double along = face.normal.dot(direction);
        const double outside = face.normal.dot(origin) - face.offset;
        if (along == 0 && outside > 0)
            return std::nullopt;
        if (along < 0 && -outside / along > enter) {
            enter = -outside / along;
            enterFace = f;
        }
        if (along > 0 && -outside / along < leave) {
            leave = -outside / along;
            leaveFace = f;
        }
    }
    if (enter > leave || leave < 0)
        return std::nullopt;
    const bool startsInside = enter < 0;
    const double distance = startsInside ? leave : enter;
    const std::size_t face = startsInside ? leaveFace : enterFace;
    return RayHit{distance, origin + distance * direction, part.core.faces[face].normal, 0, face};
}

} // namespace

std::optional<RayHit> castRay(const Shape& shape, const Vector& origin, const Vector& direction) {
    std::optional<RayHit> nearest;
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        const Part& part = shape.parts[i];
        auto hit = part.curved        ? hitCurved(part, origin, direction)
                   : part.isCapsule() ? hitCapsule(part, origin, direction)
                   : part.isSphere()  ? hitSphere(part, origin, direction)
                                      : hitPolyhedron(part, origin, direction);
        if (hit && (!nearest || hit->distance < nearest->distance)) {
            hit->part = i;
            nearest = hit;
        }
    }
    return nearest;
}

} // namespace geometry
