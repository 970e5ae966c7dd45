// The caret of a writing view between two tables or figures, where no line of text is: a line
// across (manuscript/gaps.h). Arrows and a click lead there; what is typed there is a new
// paragraph.
#pragma once

#include "document/selection.h"
#include "view/document_view.h"

namespace view {

// On a page, in twips: from what stands above the gap to what stands below it.
struct GapPlace {
    std::size_t page = 0;
    double top = 0, bottom = 0;
    double left = 0;                    // of the text
    [[nodiscard]] QRectF caret() const; // a line across
};
// Of the caret; nothing: it is in a line.
[[nodiscard]] std::optional<GapPlace> gapOfCaret(const DocumentView& view);

// False: no gap is there, and nothing happened.
bool pressGap(const DocumentView& view, QPointF point); // of the viewport
bool leaveGap(const DocumentView& view, int key);       // by an arrow, Backspace or Delete
// After an arrow has moved the caret over one: it stops there.
bool enterGap(const DocumentView& view, int key, std::size_t before, std::size_t after);

} // namespace view
