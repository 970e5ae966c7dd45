// How long do two parts stay apart, along an axis that turns with them?
//
// A face that rolls off an edge, or lifts off it, stays beside it along its own normal and along no
// fixed line; two edges that part where they cross do so along their common perpendicular. With
// attitudes that are polynomials of time, as they are solved, so are the distances of vertices from
// planes that are fixed in a part or go along an edge of each, times squares of quaternions. Their
// coefficients in Bernstein's form bound them over a window, and tightly: where speed and
// acceleration of the gap vanish together with it, no bound of its second derivative gets away from
// there.
#pragma once

#include "collision/part_motion.h"

namespace collision {

struct ApartQuestion {
    const PartPair& pair;
    Vector normal;          // at t, from the second part towards the first
    double t = 0;           // now
    double gap = 0;         // along the normal
    double unnoticed = 0;   // so deep an overlap counts as none, if it is over at the window's end
    double left = 0;        // until the end of what is known
    double firstWindow = 0; // to begin with; shorter ones follow
};

// A time during which they stay apart from t on; 0: none was found.
[[nodiscard]] double apartFor(const ApartQuestion& question);

} // namespace collision
