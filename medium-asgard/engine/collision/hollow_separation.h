// How far is a ball from the wall of a tube or a bowl, inside and outside of it?
//
// A hollow part is not convex: no plane parts it from a ball within. Its gap is that of the ball's
// centre from the nearest piece of its surface (geometry/hollow.h) less the radius. How long the
// gap stays open follows from the motion of the centre along the normal; beside that, of a wall
// that bends towards the ball, a way d across the normal takes at most d^2 / (2 c), where c is the
// least distance from the hollow's axis or centre on the way (time of impact: advancement.h).
//
// LIMIT: to all but balls a hollow is closed by a lid, and nothing else goes in. A ball that is as
// wide as the hollow touches along a circle, which is no contact that lasts.
#pragma once

#include "collision/part_motion.h"
#include "geometry/hollow.h"

#include <optional>

namespace collision {

[[nodiscard]] inline bool isHollowPair(const Part& first, const Part& second) {
    return (first.isHollow() && second.isSphere()) || (second.isHollow() && first.isSphere());
}

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
// A time during which the ball, which is inside, stays clear of the wall; more than the window: all
// of it.
[[nodiscard]] double clearFor(const HollowQuestion& question);

} // namespace collision
