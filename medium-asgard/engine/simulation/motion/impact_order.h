// Impacts in an order that does not show how they were found: by time, and what happens at one
// instant to different bodies by the least of these.
#pragma once

#include "motion/impacts.h"

#include <functional>

namespace simulation {

// Impacts of bodies that one of the same instant connects keep their order: it is that of the
// impulses.
void putInOrder(Impacts& impacts, const std::function<bool(std::size_t)>& isFixed);

} // namespace simulation
