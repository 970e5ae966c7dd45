// The places of words on the pages.
#pragma once

#include "layout/pages.h"

namespace layout {

struct Found {
    std::size_t page = 0;
    std::vector<QRectF> rects; // in twips on that page, one for each line that has a part of it
};

// In the order of the pages, whatever the case of the letters, headers and footers left out. What
// goes on on the next page is marked on the first.
[[nodiscard]] std::vector<Found> findText(const Pages& pages, const QString& words);

} // namespace layout
