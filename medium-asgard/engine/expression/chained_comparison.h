// An expression whose meaning differs from that of mathematics.
#pragma once

#include "expression/parse.h"

#include <optional>
#include <string_view>

namespace expression {

// The first of a < b < c: (a < b) < c compares 0 or 1 with c. Its bytes are from the first of its
// comparisons to the second. Parentheses around one of them say that it is meant.
[[nodiscard]] std::optional<SyntaxError> chainedComparison(std::string_view text);

} // namespace expression
