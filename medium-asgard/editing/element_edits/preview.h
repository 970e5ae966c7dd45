// A change of the text, line by line, before it is made.
#pragma once

#include "text/edit.h"

namespace editing {

struct LineChange {
    int line = 0; // from 1, of the old text
    std::string before, after;
    // The bytes [from, beforeTo) of the one become [from, afterTo) of the other.
    std::size_t from = 0, beforeTo = 0, afterTo = 0;
};

// The lines that differ, without the blanks at their starts, each cut down to the surroundings of
// what changes. A line that is new has an empty `before`.
[[nodiscard]] std::vector<LineChange> changedLines(const std::string& text,
                                                   const text::Edits& edits);

} // namespace editing
