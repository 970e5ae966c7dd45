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
// reason. Expressions that read a coordinate (J.q, B.rx) count from the new start, which
// countsAnew() tells.
#pragma once

#include "editing/value_edit.h"
#include "geometry/pose.h"
#include "gestures/ground.h"

#include <optional>
#include <vector>

namespace gestures {

// The moment to begin at: rounded to some thousandth of the motion, and not before its start.
[[nodiscard]] double roundMoment(const simulation::Motion& motion, double time);

// A body that a hand has put elsewhere at that moment; as it was there where nothing is given.
struct Put {
    std::size_t body = 0;
    geometry::Vector place; // of its shape's origin
    std::optional<geometry::Vector> velocity;
    double resolution = 0; // what the hand tells apart
    std::optional<geometry::Quaternion> attitude = std::nullopt;
    std::optional<geometry::Vector> spin = std::nullopt; // angular velocity
};
[[nodiscard]] editing::Answer startingAt(const Ground& ground, double time,
                                         const std::vector<Put>& puts = {});
// "pin.q counts from this moment on: it is 0 at 1.2 s.": coordinates that the text reads. "": there
// are none.
[[nodiscard]] std::string countsAnew(const Ground& ground, double time);
// Why it cannot begin at that moment; "": it can, as far as the text allows.
[[nodiscard]] std::string whyNotAt(const scene::Scene& scene,
                                   const simulation::MotionPointer& motion, double time);
// The scene as it would begin there.
[[nodiscard]] scene::Scene sceneAt(const Ground& ground, double time);

} // namespace gestures
