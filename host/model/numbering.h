// Numbers of sections, figures, items: counters that nest. Patterns spell them
// (schemas/number_pattern.h).
//
// An element with `counter: c` steps c at its level and opens a level below for what is inside it,
// so sections in sections count 1, 1.1, 1.1.1. `restart: c` begins c anew inside an element, at
// level 1.
#pragma once

#include <map>
#include <string>
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

} // namespace model
