// The first hit of two shapes or parts in an interval of time, as
// time_of_impact.h and advancement.h find it.
#pragma once

#include "collision/contact.h"

#include <cstddef>
#include <optional>

namespace collision {

struct Interval {
    double from = 0, to = 0;
};

struct Hit {
    double time = 0;
    Contact contact; // of the parts that hit first; contactsAt() gives all
    // They touch without approaching and are pushed together: no impulse parts
    // them, only a force.
    bool pressing = false;
    // They stay so close while they turn that the search ended here without an
    // answer.
    bool isLost = false;
};

struct Encounter {
    std::optional<Hit> hit;
    double overlap = 0;          // depth at the start when more than round-off, else 0
    std::size_t evaluations = 0; // gaps computed
};

} // namespace collision
