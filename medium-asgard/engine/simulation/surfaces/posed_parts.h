// Parts of a body somewhere, as collision/ sees them, and what is in their frames.
#pragma once

#include "collision/posed.h"
#include "surfaces/placed.h"

namespace simulation {

[[nodiscard]] Vector intoFrame(const Placed& placed, const Vector& point);
[[nodiscard]] Vector turnedInto(const Placed& placed, const Vector& direction);

// Its places are from the origin, near it.
[[nodiscard]] collision::Posed posed(const Placed& placed, std::size_t part, const Vector& origin);

// The outward normal of the face that lies closest along a direction.
[[nodiscard]] Vector faceNormal(const collision::Posed& owner, const Vector& direction);

} // namespace simulation
