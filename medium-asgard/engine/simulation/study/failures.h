// Signs that a method has failed on a motion although it arrived at the end; see study.h.
#pragma once

#include "motion/computed_motion.h"
#include "simulation/simulation.h"

namespace simulation {

// LIMIT: seen among the first 200,000 steps of a body; what rings does so from the start of
// something, and a method that takes more steps than that is too slow before it rings. `visible`:
// what of the largest velocity an increment is at least.
[[nodiscard]] bool rings(const ComputedMotion& motion, const Motion& reference,
                         const std::vector<BodyRecord>& bodies, double visible);

// Energy over a motion, in units of its largest kinetic energy. That is a measure alone: the part
// of spin is that of a ball as large as the bounding sphere, more than the body's own.
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
