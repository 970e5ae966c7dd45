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

double radiusAbout(const Part& part, const Vector& center) {
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
        auto hit = part.isSphere() ? hitSphere(part, origin, direction)
                                   : hitPolyhedron(part, origin, direction);
        if (hit && (!nearest || hit->distance < nearest->distance)) {
            hit->part = i;
            nearest = hit;
        }
    }
    return nearest;
}

} // namespace geometry
