// Two people change one text: both changes at once, and where they touch.
#pragma once

#include "text/edit.h"

#include <string_view>
#include <vector>

namespace text {

struct Merge {
    Edits edits;                  // of mine: what they did where I did nothing
    std::vector<Range> conflicts; // in the merged text: mine, where they did something else
};

[[nodiscard]] Merge merged(std::string_view base, std::string_view mine, std::string_view theirs);

} // namespace text
