// With which forces do bodies press on each other at a time of a motion?
//
// Of all contacts that last then, named or not. Impacts have impulses (Motion::impacts()).
#pragma once

#include "motion/motion.h"

namespace simulation {

struct ContactForce {
    std::size_t on = 0;              // body of the scene: the one that moves, or the first
    Vector point = Vector::Zero();   // centre of pressure, world
    Vector force = Vector::Zero();   // on that body, world
    Vector normal = Vector::UnitX(); // towards that body
    double friction = 0;             // coefficient while it sticks
};

// At a time, clamped into start()..computed(). A body that has stopped has none.
[[nodiscard]] std::vector<ContactForce> contactForcesAt(const Motion& motion, double time);

} // namespace simulation
