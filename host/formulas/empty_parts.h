// The parts of a formula that wait to be written: braces of a fraction, a root or a script, the
// inside of a fence, a cell of a matrix with nothing in it. `{}` that stands alone is none: authors
// mean it.
#pragma once

#include "formulas/formula.h"

#include <optional>

namespace formulas {

struct EmptyPart {
    NodeId node = none;
    std::size_t place = 0; // in the source, where it is written
};
// In the order of the source, as far as it was read.
[[nodiscard]] std::vector<EmptyPart> emptyParts(const Formula& formula);

// The place to go on from a place at which one has written: in the next empty part, else behind
// the outermost part around the place; nothing: there is neither.
[[nodiscard]] std::optional<std::size_t> nextPlace(const Formula& formula, std::size_t place);
// The empty part before the place.
[[nodiscard]] std::optional<std::size_t> placeBefore(const Formula& formula, std::size_t place);

} // namespace formulas
