// How far is a part from the wall of a tube or a bowl, inside and outside of it?
//
// A hollow part is not convex: no plane parts it from what is within. What reaches furthest there
// are balls: a sphere, the ends of a capsule, the vertices of a polyhedron, of radius 0. The gap of
// a ball is that of its centre from the nearest piece of the wall's surface (geometry/hollow.h)
// less its radius. How long it stays open follows from the motion of the centre along the normal;
// beside that, of a wall that bends towards the ball, a way d across the normal takes at most
// d^2 / (2 c), where c is the least distance from the hollow's axis or centre on the way (time of
// impact: advancement.h). From outside all but spheres meet the hull, as other curved parts do.
//
// Between its ends an edge, or the side of a capsule, can touch the circles of a mouth alone, the
// rim of the hollow and the outer one: the hollow bends away from it, and a convex part that is in
// the hollow and goes through its mouth crosses the plane of the mouth within the rim. Faces touch
// there with their edges for the same reason. How long an edge stays clear follows from the speed
// of its ends.
//
// LIMIT: to cylinders, cones and ellipsoids a hollow is closed by a lid. A ball that is as wide as
// the hollow touches its rim along a circle (contacts/hollow_faults.h).
#pragma once

#include "collision/part_motion.h"
#include "geometry/hollow.h"

#include <optional>
#include <vector>

namespace collision {

// One of the two is hollow, and the other may go into it.
[[nodiscard]] inline bool isHollowPair(const Part& first, const Part& second) {
    return (first.isHollow() && !second.curved) || (second.isHollow() && !first.curved);
}

// Of the other's core its vertices and its edges, around each of which it has its radius: those
// that come within `tolerance` of the hollow's wall, where the part is inside, or at its rim. None:
// it is outside.
struct BallAtWall {
    std::optional<std::size_t> vertex; // none: a place on an edge
    Separation separation;             // there
};
[[nodiscard]] std::vector<BallAtWall> ballsAtWall(const Posed& first, const Posed& second,
                                                  double tolerance);

[[nodiscard]] Separation separateHollow(const Posed& first, const Posed& second);

// How far the ball's centre can go from the hollow's axis or centre.
[[nodiscard]] double roomInHollow(const PartPair& pair);

struct HollowQuestion {
    const PartPair& pair;
    double t = 0, gap = 0;
    double window = 0;
    // The gap is 0 now, and opens: when does it close again? Its root now is divided out.
    bool isLeaving = false;
};
// A time during which the part, which is inside, stays clear of the wall; more than the window: all
// of it.
[[nodiscard]] double clearFor(const HollowQuestion& question);

} // namespace collision
