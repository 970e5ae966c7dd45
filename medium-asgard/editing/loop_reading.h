// The values that a loop or a procedure's calls give their variables, as far as the text shows it:
// their numbers, their order, and other readers of the numbers.
#pragma once

#include "editing/overrides.h"

#include <optional>
#include <string>
#include <vector>

namespace editing {

// A variable that a loop or a call gives a value for each element that is made.
struct LoopVariable {
    std::string name;
    std::vector<scene::Range> each = {};          // foreach, procedure: where the value of each is
    std::optional<scene::Range> start = {};       // for: where it begins
    std::optional<scene::Range> step = {};        // and what it goes on by; none: 1
    std::optional<std::string> listVariable = {}; // the list is the value of that one
    [[nodiscard]] bool counts() const { return start.has_value(); }
};

struct Loop {
    std::vector<LoopVariable> variables;
    std::string place;                   // "the list of the foreach in line 3"
    scene::Range range = {};             // of the command that loops, or defines the procedure
    std::vector<scene::Range> head = {}; // its words that give the variables their values
    scene::Range condition = {};         // of a for
};

// None: it is not understood, or what it makes depends on what is not.
[[nodiscard]] std::optional<Loop> loopOf(const Making& making, const Origins& origins);

// Whether anything but that word of the command reads the variable. Then another value of it would
// change what was not asked for: the name of an element, another option, another element.
[[nodiscard]] bool readElsewhere(const LoopVariable& variable, const Loop& loop, scene::Range word,
                                 const Origins& origins);

} // namespace editing
