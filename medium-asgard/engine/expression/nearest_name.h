// The name that an author probably meant, for "did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace expression {

// The candidate with the fewest single-letter changes, insertions, deletions and swaps of
// neighbours from the word, if they are few for its length; else "". Capitals count half.
[[nodiscard]] std::string nearestName(std::string_view word,
                                      std::span<const std::string> candidates);

} // namespace expression
