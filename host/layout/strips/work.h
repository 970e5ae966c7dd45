// How much was done to lay something out.
#pragma once

#include <cstddef>

namespace layout {

// Counts of the work, for tests: it grows with the size of the document and no faster.
struct Work {
    std::size_t letters = 0;    // that were given to the text layout for lines
    std::size_t paragraphs = 0; // that these are of
    std::size_t strips = 0;     // that were put on pages, or looked at for it
    std::size_t boxes = 0;      // frames that were looked at for a page
    std::size_t pages = 0;      // that were filled
};

} // namespace layout
