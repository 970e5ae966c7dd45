// Which force or link is to blame that a motion ended?
//
// The one that is not finite at the end itself; else, where a motion runs into a pole, the one that
// is by far larger there than it was: near t = 2 no double makes 1/(2-t) infinite, and yet it ends
// the motion.
#pragma once

#include "physics/equations_of_motion.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace physics {

struct Blame {
    std::size_t contribution = 0; // of the equations'
    std::size_t axis = 0;
    bool isWritten = false; // the value is that of the scene's own expression
    double value = 0;
    std::string said = {}; // the sentence, where it is another than of most
};

// The value of any unknown at a time, as asked.
struct Instant {
    std::function<double(std::size_t unknown)> value;
    double time = 0;
};

// Looks at the forces and links on some bodies, and reads no other unknowns than these do. The
// scene and its equations must outlive it.
class Suspects {
public:
    Suspects(const scene::Scene& scene, const EquationsOfMotion& equations);

    // Those with a value that is not finite.
    [[nodiscard]] std::vector<Blame> notFinite(const Instant& now,
                                               std::span<const std::size_t> onBodies) const;
    // The one that is largest now, if it is a thousand times what it was before or over 1e100.
    [[nodiscard]] std::optional<Blame> growing(const Instant& before, const Instant& now,
                                               std::span<const std::size_t> onBodies) const;

private:
    // How a rope cannot leave a wheel, whatever its forces are; "": it can.
    [[nodiscard]] std::string atWheel(const Contribution& of, const Instant& now) const;
    [[nodiscard]] std::array<double, 3> valueOf(const NodeVector& nodes, const Instant& now) const;
    [[nodiscard]] std::vector<std::size_t> on(std::span<const std::size_t> bodies) const;

    const scene::Scene& scene_;
    const EquationsOfMotion& equations_;
    std::unordered_map<std::uint32_t, std::size_t> unknownOf_;                  // by symbol
    std::unordered_map<std::size_t, std::vector<std::size_t>> contributionsOn_; // by body
};

// the force on body "b1" is not finite: its y, "sqrt(-t)", is not a number
// the force on body "b1" grows without bound: its x, "1/(2-t)^2", is 3.2e+17
// the joint "p" on body "b1", -motor "log(1-t)", is not finite: its z is infinite
[[nodiscard]] std::string inWords(const scene::Scene& scene, const EquationsOfMotion& equations,
                                  const Blame& blame);

// The author can change an expression so that this ends.
[[nodiscard]] bool hasExpression(const EquationsOfMotion& equations, const Blame& blame);

// The option whose expression is to blame; "": none is, the whole element.
[[nodiscard]] std::string optionOf(const Blame& blame);

} // namespace physics
