// The characters of UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF).
#pragma once

#include "text/edit.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace text {

inline constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

// Bytes of the character that the text begins with; 0 when its first byte begins none.
[[nodiscard]] std::size_t characterLength(std::string_view text);

// The code point of one well-formed character.
[[nodiscard]] char32_t codePoint(std::string_view character);

// Does the byte look like one behind the first of a character?
[[nodiscard]] inline bool isContinuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

// Does a character go on at this place, which must not be cut there?
[[nodiscard]] inline bool isInsideCharacter(std::string_view text, std::size_t at) {
    return at < text.size() && isContinuation(text[at]);
}

// The start of the character that this place is inside of; the place itself, where it is in none.
[[nodiscard]] std::size_t characterStart(std::string_view text, std::size_t at);

// The first ill-formed bytes at or after `from`: a maximal run of bytes that belong to no
// character. Empty, at the text's end, when there are none.
[[nodiscard]] Range illFormed(std::string_view text, std::size_t from = 0);

[[nodiscard]] inline bool isUtf8(std::string_view text) { return illFormed(text).empty(); }

// With '?' in the place of each byte that belongs to no character.
[[nodiscard]] std::string asUtf8(std::string_view text);

} // namespace text
