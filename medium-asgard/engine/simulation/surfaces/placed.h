// A body somewhere, as contacts see it.
#pragma once

#include "geometry/shape.h"
#include "motion/body_motion.h"

#include <cstddef>

namespace simulation {

struct Placed {
    std::size_t index = 0; // in the scene
    const BodyRecord* record = nullptr;
    const geometry::Shape* shape = nullptr;
    BodyState state;
};

} // namespace simulation
