// Which brace closes which.
//
// A bare `{` is closed by the first bare `}` after it with balanced bare braces between, whatever
// stands around them; a brace behind an odd number of backslashes is not bare. So one pass with a
// stack answers for a whole file, and reading stays linear however many contents are never closed.
#pragma once

#include "text/edit.h"

#include <string_view>
#include <unordered_map>
#include <vector>

namespace sgml {

// Offset of the `}` that closes the `{` at `open`, or npos.
[[nodiscard]] std::size_t closingBrace(std::string_view text, std::size_t open);

// Offsets of the bare `{` of the text that nothing closes, increasing.
[[nodiscard]] std::vector<std::size_t> unclosedBraces(std::string_view text);

// The pairs of bare braces of a content's spelling, each brace mapped to its partner.
[[nodiscard]] std::unordered_map<std::size_t, std::size_t> bracePairs(std::string_view spelling);

} // namespace sgml
