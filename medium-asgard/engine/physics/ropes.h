// Ropes as conditions that only pull, which multipliers keep (expression/equations.h): stops.
//
// Each stretch between wheels or ends has its own: gap >= 0 (rope_paths.h), tension >= 0, one of
// both 0. Becoming taut is an impact of all that hangs together.
//
// LIMIT: a rope keeps to a wheel beside another wheel; where the wrapped angle falls under 0 it
// does not lift off, which a note of the run tells.
//
// Contract: docs/scene-language.md, "Ropes".
#pragma once

#include "physics/joint_multipliers.h"
#include "physics/rope_paths.h"

namespace physics {

class RopeReader {
public:
    // Names of ropes mean something in the scope from here on.
    RopeReader(Graph& g, const scene::Scene& scene, Scope& scope,
               std::span<const BodyMotion> bodies, JointMultipliers& multipliers,
               std::vector<std::string>& faults);

    // Adds the tensions of ropes to bodies.
    void contribute(std::vector<Contribution>& contributions);

    // Of wheels whose angles are unknowns of the set.
    [[nodiscard]] std::vector<RopeWrap> wraps(const expression::EquationSet& set) const;
    // Of all spans at wheels.
    [[nodiscard]] std::vector<RopeLean> leans();
    // About ropes that may not be as they are meant.
    [[nodiscard]] const std::vector<std::string>& notes() const { return paths_.notes(); }

private:
    void contribute(std::size_t rope, std::vector<Contribution>& contributions);
    void nameTensions(std::size_t rope);
    // And what slides past wheels.
    void tieAngles(std::size_t rope, std::span<const double> material);

    Graph& g_;
    const scene::Scene& scene_;
    Scope& scope_;
    std::span<const BodyMotion> bodies_;
    RopePaths paths_;
    JointMultipliers& multipliers_;
    std::vector<RopeNodes> nodes_; // by rope
};

} // namespace physics
