// The offers for an element that a loop or a procedure makes.
#pragma once

#include "editing/origin.h"
#include "editing/value_edit.h"

namespace editing {

struct Making {
    const script::Command& command; // that made the element, more than once
    const scene::Source& source;
    std::string name;     // of the element, "" when it has none
    std::size_t together; // elements that the command made
    std::size_t which;    // of these, from 0
};

// The word of an option, or with "" of the name; null: it does not stand there.
[[nodiscard]] const script::Word* wordOf(const script::Command& command,
                                         const scene::Source& source, const std::string& option);

[[nodiscard]] std::vector<Offer> offersFor(const Making& making, const Wish& wish,
                                           const Origins& origins);

} // namespace editing
