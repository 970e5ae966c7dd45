#include "physics/surface_gap.h"

#include "physics/surface_nearest.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using surfaces::Place;
using surfaces::Triple;

Triple<double> of(const Vector& v) { return {v.x(), v.y(), v.z()}; }
Vector of(const Triple<double>& v) { return {v.x, v.y, v.z}; }

Place<double> of(const SurfacePose& pose) {
    return {of(pose.centre),
            {of(Vector(pose.rotation.row(0))), of(Vector(pose.rotation.row(1))),
             of(Vector(pose.rotation.row(2)))}};
}

} // namespace

bool haveGap(SurfacePiece::Kind body, SurfacePiece::Kind support) {
    using Kind = SurfacePiece::Kind;
    const Kind first = std::min(body, support), second = std::max(body, support);
    if (second == Kind::plane)
        return first == Kind::point || first == Kind::circle || first == Kind::ellipsoid;
    if (first == Kind::point)
        return second != Kind::ellipsoid;
    return second == Kind::line || second == Kind::circle;
}

NearestSurfaces nearest(const SurfaceGap& gap, const SurfacePose& body,
                        const SurfacePose& support) {
    const surfaces::Nearest<double> found = surfaces::nearestOf(gap, of(body), of(support));
    return {found.gap, of(found.normal), of(found.contact), of(found.place), found.steady};
}

double NearestSurfaces::nearFoot() const { return std::min(0.2, std::sqrt(steady) / 4); }

double reachBelow(const SurfacePiece& piece, const Vector& normal) {
    return surfaces::lowest(piece, of(SurfacePose{}), of(normal)).reach;
}

} // namespace physics
