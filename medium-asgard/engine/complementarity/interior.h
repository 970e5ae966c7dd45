// The states of the laws, from nothing: an interior point method.
//
// Each force goes to its law's bounds only in the limit: with a small t > 0
//     interval   w = l - h,   l (f - low) = t,   h (high - f) = t
//     disc       r s + f.w = t,   r w + s f = 0     with an s > |w|, the slip
// Newton's method follows the solutions as t goes to 0. Some twenty steps lead there, whatever the
// masses and however many contacts share a load (Wright, Primal-dual interior-point methods, 1997;
// for discs, as second-order cones: Alizadeh and Goldfarb, 2003; where they follow a normal force:
// Acary, Armand, Nguyen and Shpakovych, 2023). Mehrotra's correction follows the curvature of the
// path along the discs. Contacts that share a load may do so in many ways: a pull towards the
// forces of the step before leaves one.
#pragma once

#include "complementarity/laws.h"

namespace complementarity {

struct Approach {
    Vector forces; // strictly inside the laws
    States states; // to which they lead
    int steps = 0;
};

[[nodiscard]] Approach approach(const Matrix& a, const Vector& b, const Laws& laws);
// Of the convex problem beside it, on a symmetric A: the least  f'Af/2 + b'f  of all forces that
// the laws allow. There a disc that slips by v pushes its normal rates, too, by coefficient * |v|;
// `slips`, one number for each law, are taken off again in the same proportion.
[[nodiscard]] Approach approachConvex(const Matrix& a, const Vector& b, const Laws& laws,
                                      const Vector& slips);

} // namespace complementarity
