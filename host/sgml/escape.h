// How a text is spelled between braces, and where each of its bytes stands in the file.
//
// `\{`, `\}` and `\\` stand for `{`, `}` and `\`; a backslash before anything else is itself; a
// balanced pair of bare braces is itself. New text is always escaped.
#pragma once

#include "text/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace sgml {

[[nodiscard]] std::string escaped(std::string_view text);

// The text that a spelling stands for, and the map between the offsets of both.
class Unescaped {
public:
    Unescaped() = default;
    // `start` is the offset in the file of the spelling's first byte.
    explicit Unescaped(std::string_view spelling, std::size_t start = 0);

    [[nodiscard]] const std::string& text() const { return text_; }
    // Of an escaped character: the offset of its backslash. Of the text's end: of the brace.
    [[nodiscard]] std::size_t fileOffset(std::size_t offset) const;
    // Of either byte of an escaped character: the offset of that character.
    [[nodiscard]] std::size_t textOffset(std::size_t fileOffset) const;
    // Offsets, in the text, of the characters that are spelled with a backslash before them.
    [[nodiscard]] const std::vector<std::size_t>& escapes() const { return escapes_; }
    [[nodiscard]] bool isEscaped(std::size_t offset) const;

private:
    std::string text_;
    std::vector<std::size_t> escapes_;
    std::size_t start_ = 0;
};

} // namespace sgml
