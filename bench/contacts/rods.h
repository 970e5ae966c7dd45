// The exact motion of thin rods that fall about an end: on the floor, along a wall, onto a stop.
// Integrated as answers.h says.
#pragma once

#include "cases.h"

namespace bench::contacts {

// A thin uniform rod of length 2 whose foot stands on the floor, `angle` from the vertical, let go.
// The foot slips back, away from where the rod falls, where the floor would have to push forward
// with more than `back` times the normal force; it slips forward where that is less than -`forward`
// times it. A smooth ladder on a smooth wall moves as if its foot could not slip back, and does so
// without friction from when it leaves the wall: before, its centre moves on the same circle.
struct FallingRod {
    double angle = 0.05;
    double back = 0, forward = 0;

    static constexpr double half = 1, inertia = 1.0 / 3; // per mass
    struct Slip {
        double time = 0, angle = 0, rate = 0;
    };
    [[nodiscard]] Slip firstSlip() const;
    // How far the centre is from where the foot began, along the fall, and the angle.
    struct Pose {
        double along = 0, angle = 0;
    };
    [[nodiscard]] std::vector<Pose> poses(const std::vector<double>& times) const;

private:
    using State = std::vector<long double>; // the foot, the angle, their rates
    struct Forces;
    // `slips`: which way the foot goes, 0 if it does not; `tip` is the rate of the angle's rate.
    [[nodiscard]] Forces forces(const State& state, int slips) const;
    // How far the foot is from slipping.
    [[nodiscard]] long double margin(const State& state) const;
    [[nodiscard]] int direction(const State& state) const;
    long double advance(State& state, int& slips, long double span) const;
};

// A thin uniform rod of length 1 on a hinge at its end, let go level; a stop where it hangs down
// turns its rate round, `rebound` times as much. Its angle is 0 at the start, then negative.
struct StoppedRod {
    double rebound = 0.5;

    [[nodiscard]] std::vector<double> angles(const std::vector<double>& times) const;
    [[nodiscard]] std::vector<double> hits(std::size_t count) const;

private:
    long double advance(std::vector<long double>& state, long double span, bool& hit) const;
};

} // namespace bench::contacts
