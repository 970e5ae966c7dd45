// The places where a caret may stand: in the character data of a content, in an element that is
// empty, and beside an element that is one unit.
#pragma once

#include "manuscript/manuscript.h"

#include <optional>

namespace manuscript {

// The nearest place at or beyond the offset; nothing when there is none on that side.
[[nodiscard]] std::optional<std::size_t> place(const Manuscript& manuscript, std::size_t offset,
                                               Direction direction);
// The place that an arrow key leads to in the order of the text, which is not the visual order of
// text from right to left; nothing at the ends of a document, of a footnote and of a nested
// document. `from` is a place.
[[nodiscard]] std::optional<std::size_t> placeBeside(const Manuscript& manuscript, std::size_t from,
                                                     Direction direction, Unit unit);
// The line of text around a place: first and last place of the paragraph, heading or item.
[[nodiscard]] Selection lineAround(const Manuscript& manuscript, std::size_t place);
// All of the flow around a place: of the document, of a footnote, of a nested document.
[[nodiscard]] Selection everything(const Manuscript& manuscript, std::size_t place);

// A selection that does not end inside of a unit: where one end is in a footnote or in a nested
// document and the other is not, all of the unit is selected. Commands take it so.
[[nodiscard]] Selection widened(const Manuscript& manuscript, Selection selection);

} // namespace manuscript
