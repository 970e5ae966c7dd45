// The pages of a document as a text: a line for each piece, so that a difference of two texts says
// what moved.
#pragma once

#include "layout/pages.h"

#include <string>

namespace golden {

// Lengths are twips. A piece stands at its distance from the left edge of the paper and, after a
// sign, below the piece before it: what moves as a whole is one line of a difference.
[[nodiscard]] std::string textOf(const layout::Pages& pages);

// "": both are the same. Else the first lines that differ, of both.
[[nodiscard]] std::string differenceOf(const std::string& was, const std::string& now);

} // namespace golden
