// How near and how slow two bodies must be for a touch that lasts.
#pragma once

#include "contacts/in_plane.h"
#include "contacts/stand.h"

#include <optional>
#include <vector>

namespace simulation {

struct TouchLimits {
    double gap = 1e-7;              // of the parts' size
    double beyond = 0;              // of the same: ContactResolution
    double slow = 0;                // corners that part faster take no part
    bool wereInContact = false;     // then corners that part take part until they have parted
    bool isStart = false;           // of the motion: gaps stay what they are
    bool isOfBlow = false;          // a round end touches with all points that may carry
    std::vector<Stand> stands = {}; // of round ends, so far
    std::optional<MotionPlane> plane;
};

} // namespace simulation
