// The gaps between blocks that text does not go on beside: two tables, a table and a figure. A
// caret may stand in one, where no line of text is; what is typed there is a paragraph of its own.
//
// LIMIT: a figure or table that is all that a paragraph holds is a part of that line.
#pragma once

#include "manuscript/manuscript.h"

#include <optional>

namespace manuscript {

// Text in such an element does not go on beside it: a table, a figure, preformatted text.
[[nodiscard]] bool isClosed(const Element& element);

// Is the place directly between two closed blocks?
[[nodiscard]] bool isGap(const Manuscript& manuscript, std::size_t place);
// The gap beside the innermost closed block around a place, or around that block; nothing: there is
// a line of text on that side, or nothing at all.
[[nodiscard]] std::optional<std::size_t> gapBeside(const Manuscript& manuscript, std::size_t place,
                                                   Direction direction);
// The blocks on both sides of a gap.
struct Sides {
    sgml::NodeId before = sgml::noNode, behind = sgml::noNode;
};
[[nodiscard]] Sides sidesOf(const Manuscript& manuscript, std::size_t gap);

} // namespace manuscript
