// What can be offered where a loop or a procedure makes an element.
#pragma once

#include "editing/origin.h"
#include "editing/value_edit.h"

namespace editing {

struct Making {
    const script::Command& command; // that made the element, more than once
    const scene::Source& source;
    std::string name;     // of the element, "" when it has none
    std::size_t together; // elements that the command made
};

[[nodiscard]] std::vector<Offer> offersFor(const Making& making, const Wish& wish,
                                           const Origins& origins);

} // namespace editing
