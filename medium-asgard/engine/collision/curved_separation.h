// How far apart are two convex parts with curved surfaces, and along which line?
//
// With support functions h, the gap along a unit vector n from the second part B to the first A is
//     g(n) = -H(n),   H(n) = h_A(-n) + h_B(n),
// and the distance is the largest of all g: any n is a proof that the parts are at least so far
// apart. Parts that overlap by little have a largest negative g there, the depth.
//
//     1. Gilbert, Johnson and Keerthi's algorithm on support points finds n roughly. Where the
//        parts all but touch, the line between closest points is lost in rounding: there it runs
//        on parts that are shrunk towards their centres.
//     2. Pieces of the surfaces (feature.h) that are near along n are paired. On a pair H is
//     smooth,
//        and n is bound by linear conditions: n.u = 0 across a segment u, n.u = sine on a cone, all
//        of it on a face. The stationary n is a closed form, or found by Newton's method on the
//        sphere, where it needs no digits of the distance: curvature alone.
//     3. Of these n that with the largest g, by the whole parts' support, is the answer.
// So the gap and the normal are right to rounding at any distance, and through contact. Only where
// two sharp points meet, or one meets a sharp edge, no normal is known at a distance of 0: then
// `isBlurred` says so.
//
// LIMIT: of parts that overlap by more than some hundredths of their size, the depth is that of a
// direction in which they part, and not always of the nearest.
#pragma once

#include "collision/posed.h"

namespace collision {

// One of the two is a capsule or curved; or both are anything bounded.
[[nodiscard]] Separation separateCurved(const Posed& first, const Posed& second);

// Whether separate() leaves them to separateCurved().
[[nodiscard]] inline bool isCurvedPair(const Part& first, const Part& second) {
    const auto isPlain = [](const Part& part) { return part.isSphere() || part.isPolyhedron(); };
    return !isPlain(first) || !isPlain(second);
}

} // namespace collision
