#include "surfaces/hollow_walls.h"

#include "geometry/hollow.h"

namespace simulation {

using geometry::Curved;
using geometry::Part;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;

namespace {

// The piece of a hollow part that a ball touches, by its centre in the part's frame.
SurfacePiece wallOf(const Curved& curved, const Vector& centre, const Vector& centroid) {
    using Piece = geometry::HollowNearest::Piece;
    const geometry::HollowNearest nearest = geometry::nearestOf(curved, centre);
    const Vector middle = curved.center - centroid;
    const Vector end = middle + nearest.end * curved.half() * curved.axis();
    const auto round = [&](double radius) {
        const bool isTube = curved.kind == Curved::Kind::tube;
        return SurfacePiece{.kind = isTube ? Kind::line : Kind::point,
                            .place = middle,
                            .axis = curved.axis(),
                            .radius = radius};
    };
    const auto circle = [&](double radius) {
        return SurfacePiece{
            .kind = Kind::circle, .place = end, .axis = curved.axis(), .radius = radius};
    };
    switch (nearest.piece) {
    case Piece::hollow:
        return round(-curved.inner);
    case Piece::rim:
        return circle(curved.inner);
    case Piece::end:
        return {.kind = Kind::plane, .place = end, .axis = nearest.end * curved.axis()};
    case Piece::edge:
        return circle(curved.radius());
    case Piece::outside:
        break;
    }
    return round(curved.radius());
}

// A vertex of the one, with its radius, and the piece of the hollow part that is nearest to it.
PiecePoint pointAtWall(const Placed& body, std::size_t bodyPart, const Placed& support,
                       std::size_t supportPart, std::size_t vertex) {
    const bool isBodys = !body.shape->parts[bodyPart].isHollow(); // the vertex
    const Placed &owner = isBodys ? body : support, &other = isBodys ? support : body;
    const Part& ball = owner.shape->parts[isBodys ? bodyPart : supportPart];
    const Part& wall = other.shape->parts[isBodys ? supportPart : bodyPart];
    const SurfacePiece round{.kind = Kind::point,
                             .place = ball.core.vertices[vertex] - owner.record->centroid,
                             .radius = ball.radius};
    const Vector centre =
        other.state.attitude.conjugate() *
        Vector(owner.state.position - other.state.position + owner.state.attitude * round.place);
    const SurfacePiece piece =
        wallOf(*wall.curved, centre + other.record->centroid, other.record->centroid);
    const SurfaceGap gap =
        isBodys ? SurfaceGap{round, piece, false} : SurfaceGap{piece, round, false};
    const physics::SurfacePose at{Vector::Zero(), body.state.attitude.toRotationMatrix()};
    const physics::SurfacePose under{support.state.position - body.state.position,
                                     support.state.attitude.toRotationMatrix()};
    return {gap, physics::nearest(gap, at, under)};
}

} // namespace

PieceTouch vertexAtWall(const Placed& body, std::size_t bodyPart, const Placed& support,
                        std::size_t supportPart, std::size_t vertex) {
    const PiecePoint point = pointAtWall(body, bodyPart, support, supportPart, vertex);
    return {.normal = point.at.normal, .points = {point}, .isModelled = true};
}

} // namespace simulation
