// Random fast encounters of two bodies and an oracle that samples their gap densely. For tests: the
// unit test runs some thousands, tests/endurance any number.
#pragma once

#include "collision/flying_body.h"
#include "collision/time_of_impact.h"

#include <random>
#include <string>

namespace collision {

struct Meeting {
    FlyingBody first, second;
    double until = 1;
};

// Balls, bullets, plates, spinning rods, hulls, two-part bodies; aimed at each other, mostly to
// hit, often to graze; up to 1000 lengths a second and 200 radians a second.
[[nodiscard]] Meeting drawMeeting(std::mt19937_64& random);
// The first a capsule, needle, drum, coin, cone or ellipsoid, the second any of these or of those.
[[nodiscard]] Meeting drawCurvedMeeting(std::mt19937_64& random);

struct MeetingResult {
    std::string fault; // "" when time of impact and oracle agree
    bool hit = false;
    std::size_t evaluations = 0;
};

[[nodiscard]] MeetingResult checkMeeting(const Meeting& meeting);

} // namespace collision
