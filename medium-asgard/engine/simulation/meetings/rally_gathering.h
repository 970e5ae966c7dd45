// How balls leave the search for a rally, and come back.
#pragma once

#include "meetings/encounter_search.h"

namespace simulation {

// The balls of a hit that turned them, and those they may meet, leave for a rally
// (flights/rally.h), in which they meet by its numbers; false: there is none to be had.
[[nodiscard]] bool gather(EncounterSearch& search, const Pair& pair, Rally& rally);
// They come back as they are then: the search knows all as if it had done each hit itself.
void dissolve(const Rally& rally, EncounterSearch& search);

} // namespace simulation
