// Words and signs in the source of a formula that somebody wrote as one says them, and what TeX
// writes for them: "pi" is p times i, "\pi" is the letter; "sqrt(x)" is "\sqrt{x}"; "x^10" raises
// the 1 alone. The source is right as it is, so these are proposals, no faults.
//
// LIMIT: a word is taken for a command where it stands alone between what are no letters.
#pragma once

#include "text/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace formulas {

struct PlainWord {
    text::Range range;   // of the source
    text::Edits edits;   // that make TeX of it
    std::string message; // a sentence
};

// In order. All edits together are ordered, too (withTex).
[[nodiscard]] std::vector<PlainWord> plainWords(std::string_view source);
// The source with all that TeX writes instead.
[[nodiscard]] std::string withTex(std::string_view source, const std::vector<PlainWord>& words);

} // namespace formulas
