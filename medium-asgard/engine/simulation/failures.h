// Signs that a method has failed on a motion although it arrived at the end; see study.h.
#pragma once

#include "simulation/computed_motion.h"
#include "simulation/simulation.h"

namespace simulation {

// `visible`: what of the largest velocity an increment is at least.
[[nodiscard]] bool rings(const ComputedMotion& motion, const Motion& reference,
                         const std::vector<BodyRecord>& bodies, double visible);

// Energy over a motion, in units of its largest kinetic energy.
struct EnergyCourse {
    double range = 0; // largest less smallest
    double drift = 0; // mean of the last quarter less mean of the first
};
// None where nothing has kinetic energy.
[[nodiscard]] std::optional<EnergyCourse> energyCourse(const scene::Scene& scene,
                                                       const Options& options,
                                                       const MotionPointer& motion,
                                                       const std::vector<BodyRecord>& bodies);

} // namespace simulation
