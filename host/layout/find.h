// The places of words on the pages.
#pragma once

#include "layout/pages.h"

namespace layout {

struct Found {
    // In one line.
    struct Part {
        std::shared_ptr<const Paragraph> paragraph;
        int line = 0, from = 0, to = 0;      // letters of the paragraph
        QPointF at;                          // the top left of the line
        [[nodiscard]] double bottom() const; // cheap, where the place in the line is not
        [[nodiscard]] QRectF rect() const;
    };
    std::size_t page = 0;
    std::vector<Part> parts; // in twips on that page
};

// In the order of the pages, whatever the case of the letters, headers and footers left out. What
// goes on on the next page is marked on the first.
[[nodiscard]] std::vector<Found> findText(const Pages& pages, const QString& words);

} // namespace layout
