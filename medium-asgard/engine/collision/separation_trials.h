// Random and degenerate pairs of parts, and an independent answer to how far apart they are: every
// vertex against every face, every edge against every edge, in extended precision. For tests: the
// unit test runs a few tens of thousands, tests/endurance any number.
#pragma once

#include "collision/separation.h"

#include <random>
#include <string>

namespace collision {

struct PosedPair {
    geometry::Part first, second;
    Posed posedFirst, posedSecond; // `part` is to be set to the members above
};

// Boxes, hulls, needles, plates, spheres: apart, touching, grazing, overlapping, axis-aligned,
// parallel, at one place, tiny and huge.
[[nodiscard]] PosedPair drawPair(std::mt19937_64& random);

// "" when separate() agrees with brute force to 1e-9 of the size; else what is wrong.
[[nodiscard]] std::string separationFault(const PosedPair& pair);

// The distance of two separated parts by brute force; 0 or less when they overlap.
[[nodiscard]] double bruteForceGap(const Posed& first, const Posed& second);

} // namespace collision
