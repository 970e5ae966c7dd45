// The states of laws, from nothing, together with the centres of faces and the forces of slips.
//
// An interior point method as that of interior.h, whose path goes through the laws themselves: the
// places where discs act follow the normal forces on the way. Where forces are not unique, as in a
// wall, a search from one centre to the next has other forces each time; here these move with their
// centres. Newton's method takes the products of rooms and pushes as they stand, without a scaling
// that makes one of both: it errs by last places at the end of the path, where most contacts of a
// heap that is hit have neither a force nor a rate. LIMIT: it may stop on the way.
#pragma once

#include "complementarity/interior.h"

namespace complementarity {

// Of laws of any kind.
[[nodiscard]] Approach approachTogether(const Matrix& a, const Vector& b, const Laws& laws);
// Its forces, those of laws at a bound there.
[[nodiscard]] Answer endOf(const Matrix& a, const Vector& b, const Laws& laws, const Approach& of);

} // namespace complementarity
