// When trajectories hold a body, and at which values (`constrain`).
#pragma once

#include "physics/scope.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physics {

// A time from which on one set of trajectories holds a body, each on one smooth piece.
struct HoldSegment {
    double from = 0; // to the next segment; the first from the start of time
    struct Linear {
        bool isVelocity = false; // of the centre of mass; else the reference point's position
        Node value;
    };
    struct Angular {
        bool isRate = false; // angular velocity along the world's axes; else a rotation vector
        NodeVector value;
    };
    std::array<std::optional<Linear>, 3> linear;
    std::optional<Angular> angular;

    [[nodiscard]] bool isFree() const { return !linear[0] && !linear[1] && !linear[2] && !angular; }
};

// Times at which `constraint` holds: [from, to) each.
struct HoldInterval {
    double from = 0, to = 0;
};
[[nodiscard]] std::vector<HoldInterval> intervalsOf(const scene::Constraint& constraint,
                                                    const scene::Trajectory& trajectory);

// A segment from the start of time at least, and one from each of `cuts`, where forces change. Two
// constraints that hold one thing at one time are told in `faults`; the earlier one of the text
// holds.
[[nodiscard]] std::vector<HoldSegment> segmentsOf(const scene::Scene& scene, const Scope& scope,
                                                  std::size_t body, std::span<const double> cuts,
                                                  std::vector<std::string>& faults);

} // namespace physics
