#include "physics/contact_press.h"

#include <array>
#include <cmath>
#include <utility>

namespace physics {
namespace {

using Kind = SurfacePiece::Kind;

// The directions of friction (contact_rows.cpp, frameOf()).
std::array<Vector, 2> directionsOf(const ContactSurfaces& surfaces, const Vector& normal,
                                   const SurfacePose& body, const SurfacePose& support) {
    const SurfaceGap& gap = surfaces.gaps[0];
    const std::array owners{std::pair(&gap.body, &body), std::pair(&gap.support, &support)};
    for (const auto& [piece, owner] : owners)
        if (piece->kind == Kind::plane) {
            const Vector n = piece->axis, across = acrossAxis(n);
            const Vector second = (across - n * n.dot(across)).normalized();
            return {owner->rotation * n.cross(second), owner->rotation * second};
        }
    Vector fixed = acrossAxis(surfaces.normal);
    for (const auto& [piece, owner] : owners)
        if (piece->kind == Kind::line && piece->radius < 0) // round a tube
            fixed = owner->rotation * piece->axis;
    const Vector second = (fixed - normal * normal.dot(fixed)).normalized();
    return {normal.cross(second), second};
}

} // namespace

Vector acrossAxis(const Vector& normal) {
    int best = 2;
    for (const int axis : {1, 0})
        if (std::abs(normal[axis]) < std::abs(normal[best]) - 1e-9)
            best = axis;
    return Vector::Unit(best);
}

ContactPress pressOf(const ContactSurfaces& surfaces, const SurfacePose& body,
                     const SurfacePose& support, std::span<const double> normals,
                     std::span<const double> friction) {
    ContactPress found;
    Vector push = Vector::Zero(), first = Vector::UnitX();
    double pressure = 0;
    for (std::size_t k = 0; k < normals.size(); ++k) {
        if (k > 0 && !(normals[k] > 0))
            continue;
        const NearestSurfaces at = nearest(surfaces.gaps[k], body, support);
        if (k == 0)
            first = at.normal;
        if (!(normals[k] > 0))
            continue;
        pressure += normals[k];
        push += normals[k] * at.normal;
        found.point += normals[k] * at.contact;
    }
    if (!(pressure > 0))
        return found;
    found.point /= pressure;
    found.normal = push.normalized();
    found.force = push;
    if (friction.size() >= 2) {
        const auto along = directionsOf(surfaces, first, body, support);
        found.force += friction[0] * along[0] + friction[1] * along[1];
    }
    return found;
}

double slipSpeedOf(const ContactSurfaces& surfaces, std::size_t point, const SurfaceMotion& body,
                   const SurfaceMotion& support) {
    const NearestSurfaces at = nearest(surfaces.gaps[point], body.pose, support.pose);
    const auto velocityOf = [&](const SurfaceMotion& of, const Vector& surface) -> Vector {
        return of.velocity + of.spin.cross(at.contact - of.pose.centre) +
               of.pose.rotation * surface;
    };
    const Vector v =
        velocityOf(body, surfaces.bodySurface) - velocityOf(support, surfaces.supportSurface);
    return (v - at.normal * at.normal.dot(v)).norm();
}

} // namespace physics
