// Is a text UTF-8, and where is it not?
#pragma once

#include "sgml/position.h"

#include <string_view>

namespace sgml {

// The first ill-formed bytes at or after `from`: a maximal run of bytes that belong to no
// character. Empty, at the text's end, when there are none. Overlong forms, surrogates and what
// lies beyond U+10FFFF are ill-formed (Unicode 15, table 3-7).
[[nodiscard]] Range illFormed(std::string_view text, std::size_t from = 0);

[[nodiscard]] inline bool isUtf8(std::string_view text) { return illFormed(text).empty(); }

} // namespace sgml
