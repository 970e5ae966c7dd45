// Do two balls that reach each other hit, or go side by side (contacts/side_by_side.h)?
#pragma once

#include "events/instant.h"

namespace simulation {

// no: it is a hit; tooOften: it would be one too many of those that go side by side.
enum class Alongside { no, yes, tooOften };

// They are slow where the forces on them give such a speed on a way of the depth at which they hit.
// What loses speed in each hop comes to rest where it is pressed, but for what rounding presses.
[[nodiscard]] Alongside goAlongside(const Instant& instant, const Found& hit, SideBySide& balls);

} // namespace simulation
