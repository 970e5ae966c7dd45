// The motion of a scene put together from units that were solved at different times.
#pragma once

#include "resimulation/kept_motion.h"

#include <unordered_map>

namespace simulation {

// All of it. `work`: what was done for it; the rest of the statistics is filled in.
[[nodiscard]] Result compose(const KnownMotion& known, Statistics work);

// Kept units beside a draft of what is being solved; `bodies`: those of the draft in the scene,
// as in PlacedPart.
[[nodiscard]] MotionPointer composeDraft(const KnownMotion& kept, const ComputedMotion& draft,
                                         const std::vector<std::size_t>& bodies);

} // namespace simulation
