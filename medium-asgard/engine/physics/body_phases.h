// The phases of a body's thirteen unknowns: free, or held by trajectories.
//
// A held unknown has a given value and its derivative as rate; the others follow their own
// equations. When a trajectory lets go, the unknown starts from the last given value. Where forces
// read trajectories, each segment has the one piece in force, so that its equations are smooth,
// without a choice by time. A held position is the reference point's, so that the centre of mass
// also turns about it.
#pragma once

#include "physics/equations_of_motion.h"

#include <span>

namespace physics {

// Phases of the body's unknowns in the order of BodyUnknown; `trajectories` are those that its
// forces read. Phases that end before `start` leave no trace; the phase in force then holds from
// the start of time.
[[nodiscard]] std::array<std::vector<expression::Phase>, bodyUnknowns>
phasesOf(Graph& g, const Scope& scope, const BodyMotion& body,
         std::span<const HoldSegment> segments, std::span<const std::size_t> trajectories,
         double start);

} // namespace physics
