// The forces that keep laws of which many share a disc, as the normal forces round the rim of a
// can.
//
// Of more than eight in most blows a few have a force. The search begins with four of each such
// disc and takes in those that would sink in, until none does: the others have no force. Of
// problems of a tenth of the rows the solver finds answers that it misses of all of them.
//
// A blow has an answer wherever bodies can part: where none is found with friction at the centres
// of the normal forces, friction acts at places of the faces near these (centres.h).
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

// As solve() of solve.h. Normal forces that stand in their order round the patch are taken in best;
// those that have a force in the guess are in from the start.
[[nodiscard]] std::optional<Answer> solveByFew(const Matrix& a, const Vector& b, const Laws& laws,
                                               const Answer& guess = {});

} // namespace complementarity
