#include "surfaces/flat_faces.h"

#include "surfaces/contact_resolution.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using geometry::Curved;
using geometry::Part;

double depthIn(const FlatFace& face, const Vector& point) {
    if (face.isEndless())
        return HUGE_VAL;
    const Vector off = point - face.plane.place;
    if (face.outline.empty())
        return face.radius - (off - face.plane.axis * face.plane.axis.dot(off)).norm();
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const Vector& from = face.outline[i];
        const Vector edge = face.outline[(i + 1) % face.outline.size()] - from;
        least = std::min(least, face.plane.axis.cross(edge).normalized().dot(point - from));
    }
    return least;
}

namespace {

FlatFace faceOf(const geometry::Face& face, const Part& part, const Vector& centroid) {
    FlatFace found;
    found.plane.kind = physics::SurfacePiece::Kind::plane;
    found.plane.axis = face.normal;
    for (const std::size_t vertex : face.vertices)
        found.outline.emplace_back(part.core.vertices[vertex] - centroid);
    found.plane.place = found.outline[0];
    return found;
}

} // namespace

std::optional<FlatFace> faceMostTowards(const Placed& owner, std::size_t part,
                                        const Vector& direction) {
    const Part& of = owner.shape->parts[part];
    if (!of.isPolyhedron())
        return std::nullopt;
    const Vector local = owner.state.attitude.conjugate() * direction;
    const auto most = std::ranges::max_element(
        of.core.faces, {}, [&](const geometry::Face& face) { return face.normal.dot(local); });
    return faceOf(*most, of, owner.record->centroid);
}

std::optional<FlatFace> faceTowards(const Placed& owner, std::size_t part,
                                    const Vector& direction) {
    const Part& of = owner.shape->parts[part];
    const Vector& centroid = owner.record->centroid;
    const Vector local = owner.state.attitude.conjugate() * direction;
    const auto isAlong = [&](const Vector& normal) {
        return (normal - local).norm() <= resolution::sameNormal;
    };
    FlatFace face;
    face.plane.kind = physics::SurfacePiece::Kind::plane;
    if (of.isPolyhedron()) {
        for (const geometry::Face& each : of.core.faces)
            if (isAlong(each.normal))
                return faceOf(each, of, centroid);
        return std::nullopt;
    }
    if (!of.curved || of.curved->kind == Curved::Kind::ellipsoid)
        return std::nullopt;
    const double sign = of.isPlane() ? 1 : of.curved->axis().dot(local) > 0 ? 1 : -1;
    face.plane.axis = sign * of.curved->axis();
    const bool isTip = (of.curved->kind == Curved::Kind::cone && sign > 0) ||
                       (of.curved->kind == Curved::Kind::bowl && sign < 0);
    if (isTip || !isAlong(face.plane.axis))
        return std::nullopt;
    face.radius = of.isPlane() ? 0 : of.curved->radius();
    face.plane.place = of.curved->center - centroid;
    if (!of.isPlane())
        face.plane.place += of.curved->half() * face.plane.axis;
    return face;
}

} // namespace simulation
