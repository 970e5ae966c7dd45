// A place in the text that stays when pages change.
#pragma once

#include "layout/pages.h"

namespace places {

struct Spot {
    paragraphs::BlockPointer block;
    int letter = 0;   // of the block's text, the first of its line
    double above = 0; // the top of that line to the height that was asked for, in twips
};

struct PlaceOnPage {
    std::size_t page = 0;
    double y = 0;
};

// The first line of text that ends below that height of a page; nothing: there is none behind it.
[[nodiscard]] std::optional<Spot> spotAt(const layout::Pages& pages, PlaceOnPage place);

// Its place now, looked for from that page on to both sides: in the same block, else in one of
// the same words (of a text that was read anew), else in one of the same element, which has
// changed.
[[nodiscard]] std::optional<PlaceOnPage> placeOf(const layout::Pages& pages, const Spot& spot,
                                                 std::size_t from);

} // namespace places
