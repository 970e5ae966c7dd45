// The present of a motion as the start of another: what one sees goes on from here, and may be
// changed here (a body put elsewhere, a velocity given to it: thrown).
//
// The bodies' places, attitudes and velocities of the moment are written as initial values, and the
// moment as the simulator's -start, so that forces and paths in time stay as they are. A body that
// a path leads in part, or for a while, begins with all of these values, too. An element that a
// -release has ended by then gets -release 1: it is gone from the start on.
//
// A joint's coordinate that something asks for (a limit, a drive, a spring, an expression) goes on
// counting: its value of the moment is written as -from.
//
// LIMIT: the length of a spring or a rope that is not written counts from the start: then there is
// no answer but a reason. The angle of a ball joint and B.rx are 0 at the new start, which
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
// "b.rz counts from this moment on: it is 0 at 1.2 s.": of what the text reads. "": there is
// nothing.
[[nodiscard]] std::string countsAnew(const Ground& ground, double time);
// The limits of joints, for a hand that moves bodies from where they are at that moment.
class JointLimits {
public:
    JointLimits(const Ground& ground, double time);
    // All joints are within them with these bodies put elsewhere.
    [[nodiscard]] bool areKept(const std::vector<Put>& puts) const;

private:
    struct Coordinate {
        std::size_t joint, index;
        double value; // at the moment
    };
    Ground ground_;
    double time_;
    std::vector<Coordinate> limited_;
};
// Why it cannot begin at that moment; "": it can, as far as the text allows.
[[nodiscard]] std::string whyNotAt(const scene::Scene& scene,
                                   const simulation::MotionPointer& motion, double time);
// The scene as it would begin there, but for -from.
[[nodiscard]] scene::Scene sceneAt(const Ground& ground, double time);

} // namespace gestures
