// The forces of contacts (motion/contact_forces.h) as arrows and friction cones.
#pragma once

#include "drawing/drawing.h"
#include "drawing/frame.h"
#include "drawing/lines.h"
#include "motion/contact_forces.h"

namespace render {

// View units for a force of 1: round; the weight of a few of the bodies is a good arrow.
[[nodiscard]] double contactForceScale(const simulation::Motion& motion);

// An arrow for each force, and a cone about its normal that the force cannot leave while the
// contact sticks.
void addContactForces(Lines& lines, const std::vector<simulation::ContactForce>& forces,
                      double scale, const Frame& frame, const Display& display);

} // namespace render
