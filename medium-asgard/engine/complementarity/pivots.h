// Intervals on an A that need not be symmetric: contacts that slide put their friction into the
// columns of their normal forces.
//
// Rows change sides, all that are wrong at once while their number shrinks, else the last of them
// alone (Kostreva, Linear Algebra and its Applications 21, 1978; Judice and Pires, Computers and
// Operations Research 19, 1992). With a little on the diagonal redundant rows have one answer, and
// of feet whose rates cannot all be 0 some leave. Where A has positive principal minors then, which
// friction that is not strong leaves it, the answer is the only one and is always found.
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

// From these states. `laws` has intervals only. Nothing: no answer was found.
[[nodiscard]] std::optional<Answer> solveByPivots(const Matrix& a, const Vector& b,
                                                  const Laws& laws, States states);

} // namespace complementarity
