// The phases of a body's thirteen unknowns: free, or held by trajectories.
//
// What is held is given and its rate is the derivative of what is given; what is not held goes on
// by its own equation. When a trajectory lets go, the unknown starts from the last value that was
// given. Where forces read trajectories, each segment has the one piece that is in force, so that
// its equations are smooth and no choice by time is left in them. A held position is the reference
// point's, so that the centre of mass also turns about it.
#pragma once

#include "physics/equations_of_motion.h"

#include <span>

namespace physics {

// Phases of the body's unknowns in the order of BodyUnknown; `trajectories` are those that its
// forces read. What was over before `start` leaves no
// trace; the phase in force then is said to hold from the start of time.
[[nodiscard]] std::array<std::vector<expression::Phase>, bodyUnknowns>
phasesOf(Graph& g, const Scope& scope, const BodyMotion& body,
         std::span<const HoldSegment> segments, std::span<const std::size_t> trajectories,
         double start);

} // namespace physics
