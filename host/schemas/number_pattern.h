// Patterns of presentations for numbers: "1.1", "Figure 1:", "(a)".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace schemas {

// Puts numbers into a pattern. Each `1 a A i I` that stands alone between other characters is a
// level, the last one the innermost: "1.1" of {2, 3} is "2.3", of {4} "4"; "Figure 1:" of {7} is
// "Figure 7:"; "(a)" of {2} "(b)".
[[nodiscard]] std::string numbered(std::string_view pattern, const std::vector<int>& path);

// The words of a pattern before its first level, without blanks: "Figure" of "Figure 1:".
[[nodiscard]] std::string_view wordsBefore(std::string_view pattern);
// The pattern without them: "1:".
[[nodiscard]] std::string_view withoutWords(std::string_view pattern);

// Without the punctuation and blanks at its end: how a number is referred to.
[[nodiscard]] std::string withoutPunctuation(std::string_view number);

} // namespace schemas
