// Two people change one text: what each did, and both at once.
//
// Differences are stretches of words, blanks and signs, found as the shortest script of insertions
// and deletions (Myers 1986). Texts that differ in more than `mostDifferences` of these are told
// apart as one stretch.
#pragma once

#include "editing/text_edit.h"

#include "scene/scene.h"

#include <string_view>

namespace editing {

constexpr std::size_t mostDifferences = 400;

// A stretch of the text before, and what stands there after; either may be empty.
struct Hunk {
    scene::Range before, after;
    bool operator==(const Hunk&) const = default;
};

// In order and apart from each other.
[[nodiscard]] std::vector<Hunk> differences(std::string_view before, std::string_view after);
// How many this thread has looked for: each goes through two whole texts.
[[nodiscard]] std::size_t differencesSought();

struct Merge {
    std::vector<TextEdit> edits;         // of mine: what they did where I did nothing
    std::vector<scene::Range> conflicts; // in the merged text: mine, where they did something else
};

[[nodiscard]] Merge merged(std::string_view base, std::string_view mine, std::string_view theirs);

} // namespace editing
