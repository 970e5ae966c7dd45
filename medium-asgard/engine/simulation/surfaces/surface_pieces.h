// Through which pieces of their surfaces do two parts touch of which one is curved, and how long?
//
//     on a flat face   what of the other is furthest: both rims of a cylinder that lies, both ends
//                      of a capsule, apex and rim of a cone, one rim, a tip, a sphere, an ellipsoid
//     a flat round end an edge or a side up to where it crosses the rim, each vertex within
//     else             the pieces that bear along the normal: sphere on a side, a rim or a cone,
//                      side, rim or edge across each other, and the rim of a side that would
//                      cross beyond its end; side by side, both ends of the common stretch
//
// A piece of a polyhedron is touched as long as the other's place is in its cell, so is one of a
// curved part. Hollow parts: hollow_walls.h. What lies on a face has none: there other pieces land.
//
// LIMIT: pairs without a formula have no contact that lasts: a cone's side on what is no face, an
// ellipsoid on what is no face, a rim along an edge or a rim.
#pragma once

#include "surfaces/flat_faces.h"
#include "surfaces/piece_touch.h"

#include <vector>

namespace simulation {

// Along the normal of their separation; `tolerance` along it.
[[nodiscard]] PieceTouch pieceTouch(const Placed& body, std::size_t bodyPart, const Placed& support,
                                    std::size_t supportPart, const Vector& normal,
                                    double tolerance);

// Of two flat faces that lie on each other, at least one of them a round end: where their borders
// cross. LIMIT: borders that cross at less than 0.8 degrees count as not crossing.
[[nodiscard]] std::vector<PiecePoint> crossingsOfBorders(const Placed& body, std::size_t bodyPart,
                                                         const Placed& support,
                                                         std::size_t supportPart,
                                                         const Vector& normal, double tolerance);

// Of a part the pieces of which one lies lowest on each plane; none of a polyhedron.
[[nodiscard]] std::vector<physics::SurfacePiece> extremesOf(const Placed& owner, std::size_t part);

// Is this one of them? Pieces of one part.
[[nodiscard]] bool isOnePiece(const physics::SurfacePiece& a, const physics::SurfacePiece& b,
                              double size);

} // namespace simulation
