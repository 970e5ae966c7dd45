#include "collision/contact_points.h"

#include "collision/patch.h"

#include <algorithm>
#include <cmath>

namespace collision {
namespace {

using Kind = Feature::Kind;

// How far the piece falls away from its own furthest extent: of a face that is tilted, and of a
// segment or a cone's line, from one end to the other.
double fallOf(const Feature& f, const Vector& direction) {
    const double along = f.axis.dot(direction);
    const double across = (direction - along * f.axis).norm();
    switch (f.kind) {
    case Kind::face:
        if (f.outline.empty())
            return along > 0 ? 2 * f.radius * across : HUGE_VAL;
        return 0; // all its vertices are near the extent
    case Kind::segment:
        return f.length * std::abs(along);
    case Kind::cone:
        return std::abs(f.length * along - f.radius * across);
    case Kind::point:
    case Kind::circle:
    case Kind::ellipsoid:
        break;
    }
    return 0;
}

double heightOf(const Feature& f, const Vector& direction) {
    const double place = direction.dot(f.place);
    if (f.kind == Kind::point)
        return place + f.radius;
    return f.kind == Kind::circle ? place + f.radius * f.axis.cross(direction).norm() : place;
}

int dimensionOf(const Feature& f) {
    switch (f.kind) {
    case Kind::face:
        return 2;
    case Kind::segment:
    case Kind::cone:
        return 1;
    case Kind::point:
    case Kind::circle:
    case Kind::ellipsoid:
        break;
    }
    return 0;
}

} // namespace

Feature bearingFeature(const Part& part, const Vector& direction, double tolerance) {
    const std::vector<Feature> features = featuresAlong(part, direction, tolerance);
    const Feature* best = nullptr;
    for (const Feature& f : features) {
        if (fallOf(f, direction) > tolerance)
            continue;
        const bool isLarger = !best || dimensionOf(f) > dimensionOf(*best);
        const bool isAsLarge = best && dimensionOf(f) == dimensionOf(*best);
        if (isLarger || (isAsLarge && heightOf(f, direction) > heightOf(*best, direction)))
            best = &f;
    }
    return best ? *best : features.back();
}

ContactPoints contactPoints(const Posed& first, const Posed& second, double tolerance) {
    WarmStart cold;
    const Separation separation = separate(first, second, cold);
    const Vector& n = separation.normal;
    const Patch patch = patchOf(first, second, n, tolerance, tolerance);
    ContactPoints contact{
        .gap = separation.gap,
        .normal = n,
        .first = bearingFeature(*first.part, first.rotation.transpose() * -n, tolerance),
        .second = bearingFeature(*second.part, second.rotation.transpose() * n, tolerance),
        .points = patch.corners,
        .centre = patch.centre};
    const auto isWhole = [&](const Feature& own, const Feature& other, const Posed& posed) {
        if (own.kind != Kind::face || !(own.radius > 0) || other.kind != Kind::face)
            return false;
        const Vector middle = posed.rotation * own.place + posed.offset;
        return std::ranges::all_of(patch.corners, [&](const Vector& corner) {
            const Vector out = corner - middle;
            return std::abs((out - n * n.dot(out)).norm() - own.radius) <= 1e-9 * own.radius;
        });
    };
    contact.isDisc = isWhole(contact.first, contact.second, first) ||
                     isWhole(contact.second, contact.first, second);
    return contact;
}

} // namespace collision
