// Convex parts whose union is a solid, as nearly as is asked for.
//
// The surplus of a part is the volume of its hull over what the solid has there. The part with the
// largest is cut by the plane that leaves the least, among: the faces beside concave edges, the
// planes that halve the angle there, and planes across the axes; until the surplus of all is as
// small as wanted. Then parts whose common hull adds the least are joined. Greedy, as V-HACD
// (Mamou 2016) and CoACD (Wei and others 2022) are, but on the surface itself: solids with flat
// faces come out exactly, corner by corner.
// LIMIT: no plane is tried in view of the one after it, so that rings take more parts than they
// need.
#pragma once

#include "meshes/solids.h"

namespace meshes {

struct Wanted {
    double surplus = 0.02;   // volume of all parts over the solids', as a share of it
    std::size_t parts = 32;  // at most, whatever the surplus
    std::size_t points = 64; // of one part; its hull is filled from the inside then
};

struct ConvexParts {
    std::vector<std::vector<Vector>> parts; // points of which each part is the hull
    double volume = 0;                      // of the solids; of open pieces, that of their hulls
    double partsVolume = 0;                 // where parts overlap, counted twice
    std::size_t flat = 0;                   // pieces that lie in a plane, and are left out
    bool cancelled = false;
};

[[nodiscard]] ConvexParts convexParts(const Solids& solids, const Wanted& wanted,
                                      const GoOn& goOn = {});

// So many of a hull's points that it is filled best from the inside, found one by one: each is the
// furthest from the hull of those before.
[[nodiscard]] std::vector<Vector> fewerPoints(const std::vector<Vector>& points, std::size_t most);

// 0 for points in a plane.
[[nodiscard]] double hullVolume(const std::vector<Vector>& points);

} // namespace meshes
