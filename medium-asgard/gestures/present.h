// The present of a motion as the start of another: what one sees goes on from here, and may be
// changed here (a body put elsewhere, a velocity given to it: thrown).
//
// The bodies' places, attitudes and velocities of the moment are written as initial values, and the
// moment as the simulator's -start, so that forces and paths in time stay as they are. A body that
// a path leads in part, or for a while, begins with all of these values, too. An element that a
// -release has ended by then gets -release 1: it is gone from the start on.
//
// LIMIT: a value that counts from the start (a joint's coordinate with a limit, a spring's or
// rope's length that is not written) would mean something else: then there is no answer but a
// reason. Expressions that read a coordinate (J.q, B.rx) count from the new start.
#pragma once

#include "editing/value_edit.h"
#include "gestures/ground.h"

namespace gestures {

[[nodiscard]] editing::Answer startingAt(const Ground& ground, double time);

} // namespace gestures
