// Time of impact: the first instant at which two moving shapes touch and approach.
//
//   sphere, sphere   |p(t)|^2 - R^2 is a polynomial; its first descent through zero is isolated in
//                    Bernstein form and refined to the last bits
//   otherwise        from the separating axis n at t, the gap stays at least
//                        gap + n.(p(t+s) - p(t)) - (what turning can take away along n within s),
//                    a polynomial in s whose first root is the next t: conservative advancement
//                    (Mirtich 1996) with the motion along n exact and turning to second order. It
//                    converges as Newton's method does, but never from beyond the root.
//
// Contact is a matter of speeds, not of times: shapes that touch (or overlap by round-off) and part
// are not reported, however close the last impact was; shapes that touch and approach along all
// axes of their touch (contact.h) are a hit at once. Where they do not, the search goes on along
// the axis that keeps them apart.
//
// No encounter deeper than 1e-10 of the smaller part's size is missed, at any speed. Shapes that
// overlap by more than 1e-7 of their size at the start are said to overlap, and can hit only after
// they separated. LIMIT: contacts shallower than that which begin and end within one step may be
// passed over.
#pragma once

#include "collision/encounter.h"
#include "collision/moving_shape.h"

#include <cstddef>
#include <functional>

namespace collision {

// Pairs of parts for which `leaveOut` is true are not looked at. Balls hit where they overlap by
// `depth`, everything else where it touches.
using PartFilter = std::function<bool(std::size_t firstPart, std::size_t secondPart)>;
[[nodiscard]] Encounter timeOfImpact(const MovingShape& first, const MovingShape& second,
                                     Interval during, const PartFilter& leaveOut = nullptr,
                                     Slack slack = 0, double depth = 0);

} // namespace collision
