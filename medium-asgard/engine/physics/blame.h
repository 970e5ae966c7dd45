// Which force or link is to blame that a motion ended?
//
// What is not finite at the end itself; else, where a motion runs into a pole, what is by far
// larger there than it was: near t = 2 no double makes 1/(2-t) infinite, and yet it ends the
// motion.
#pragma once

#include "physics/equations_of_motion.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physics {

struct Blame {
    std::size_t contribution = 0; // of the equations'
    std::size_t axis = 0;
    bool isWritten = false; // the value is that of the scene's own expression
    double value = 0;
};

// All unknowns, and the time.
struct Instant {
    std::span<const double> state;
    double time = 0;
};

// Of the forces and links on some bodies (none named: on all), those with a value that is not
// finite.
[[nodiscard]] std::vector<Blame> whatIsNotFinite(const EquationsOfMotion& equations,
                                                 const Instant& now,
                                                 std::span<const std::size_t> onBodies = {});

// The one that is largest now, if it is a thousand times what it was before.
[[nodiscard]] std::optional<Blame> whatGrows(const EquationsOfMotion& equations,
                                             const Instant& before, const Instant& now,
                                             std::span<const std::size_t> onBodies = {});

// the force on body "b1" is not finite: its y, "sqrt(-t)", is not a number
// the force on body "b1" grows without bound: its x, "1/(2-t)^2", is 3.2e+17
[[nodiscard]] std::string inWords(const scene::Scene& scene, const EquationsOfMotion& equations,
                                  const Blame& blame);

// The option whose expression is to blame; "": none is, the whole element.
[[nodiscard]] std::string optionOf(const Blame& blame);

} // namespace physics
