// The edits that make one text of another: as one edit, or stretch by stretch.
//
// Stretches are of words, blanks and signs, found as the shortest script of insertions and
// deletions (Myers 1986). Texts that differ in more than `mostDifferences` of these are compared by
// their lines, and then the lines that differ by their words; where more lines differ than that,
// they are one stretch.
#pragma once

#include "text/edit.h"

#include <string_view>
#include <vector>

namespace text {

// The smallest one, at character boundaries of UTF-8; empty when the texts are equal.
[[nodiscard]] Edit difference(std::string_view before, std::string_view after);

constexpr std::size_t mostDifferences = 400;

// A stretch of the text before, and what stands there after; either may be empty.
struct Hunk {
    Range before, after;
    bool operator==(const Hunk&) const = default;
};

// In order and apart from each other.
[[nodiscard]] std::vector<Hunk> differences(std::string_view before, std::string_view after);

// The same as edits of the text before.
[[nodiscard]] Edits editsBetween(std::string_view before, std::string_view after);

// How often this thread has looked for stretches: each goes through two whole texts.
[[nodiscard]] std::size_t differencesSought();

} // namespace text
