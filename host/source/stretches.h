// The parts of a text that are shown by other letters after a change than before.
#pragma once

#include "text/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace source {

// The changed bytes, with so much around them that a letter outside is the same before and after:
// none of them is joined of bytes inside and outside.
struct Stretch {
    text::Range now;    // in the text after
    std::string before; // the bytes that stood there
};

// In order and apart from each other. `back`: the edits that undo the change, in offsets of the
// text after. Reads the bytes around the edits alone.
[[nodiscard]] std::vector<Stretch> stretchesOf(std::string_view after, const text::Edits& back);

} // namespace source
