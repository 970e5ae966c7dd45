// The hints in the empty places of a document that is written: "Title", "Author", faintly.
#pragma once

#include <QPainter>

namespace view {

class DocumentView;

// Over a page, in twips.
void paintHints(QPainter& painter, const DocumentView& view, std::size_t page);

} // namespace view
