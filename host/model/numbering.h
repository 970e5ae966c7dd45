// Numbers of sections, figures, items: counters that nest, and the patterns that spell them.
//
// An element with `counter: c` steps c at its level and opens a level below for what is inside it,
// so sections in sections count 1, 1.1, 1.1.1. `restart: c` begins c anew inside an element, at
// level 1.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace model {

// LIMIT: of deeper ones the innermost are counted out: 1.1.1...
inline constexpr std::size_t deepestLevel = 16;

class Counters {
public:
    // The element's path, outermost level first: {2, 1} for the first subsection of section 2.
    std::vector<int> step(const std::string& counter);
    void leaveStep(const std::string& counter);
    void restart(const std::string& counter);
    void leaveRestart(const std::string& counter);
    bool operator==(const Counters&) const = default;

private:
    using Levels = std::vector<int>;
    std::map<std::string, std::vector<Levels>> counters_; // the innermost restart last
};

// Puts numbers into a pattern. Each `1 a A i I` that stands alone between other characters is a
// level, the last one the innermost: "1.1" of {2, 3} is "2.3", of {4} "4"; "Figure 1:" of {7} is
// "Figure 7:"; "(a)" of {2} "(b)".
[[nodiscard]] std::string numbered(std::string_view pattern, const std::vector<int>& path);

// Without the punctuation and blanks at its end: how a number is referred to.
[[nodiscard]] std::string withoutPunctuation(std::string_view number);

} // namespace model
