// Two spheres: the time of impact as the root of a polynomial.
#pragma once

#include "collision/part_motion.h"
#include "collision/polynomial.h"

#include <array>
#include <optional>

namespace collision {

// Place of the first pivot relative to the second's, x y z in powers of s = t - `from`.
using RelativePath = std::array<Polynomial, 3>;
[[nodiscard]] RelativePath relativePath(const MotionPiece& first, const MotionPiece& second,
                                        double from);

// |path|^2 - radius^2, the constant term without cancellation.
[[nodiscard]] Polynomial squaredDistance(const RelativePath& path, double radius);

struct SphereHit {
    double after = 0; // seconds after the start
    bool pressing = false;
};

struct SphereEncounter {
    std::optional<SphereHit> hit;
    double overlap = 0;
};

// Centres at the pivots, during s in [0, length]. `roundOff`: gaps below it are contact;
// `speedOff`: approaching slower than this is not approaching.
[[nodiscard]] SphereEncounter spheresMeet(const RelativePath& path, double radius, double length,
                                          double roundOff, double speedOff);

} // namespace collision
