// The characters of UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF).
#pragma once

#include <cstddef>
#include <string_view>

namespace utf8 {

// Bytes of the character that the text begins with; 0 when its first byte begins none.
[[nodiscard]] std::size_t characterLength(std::string_view text);

// The code point of one well-formed character.
[[nodiscard]] char32_t codePoint(std::string_view character);

} // namespace utf8
