// The values of expressions at the start of a motion, where trajectories hold already.
//
// They may read the time, and places and attitudes of bodies.
#pragma once

#include "physics/scope.h"

#include <unordered_map>

namespace physics {

class StartValues {
public:
    // Keeps all three.
    StartValues(const Graph& g, const scene::Scene& scene, const Scope& scope);

    // Not a number where the expression is none, or reads more than it may.
    [[nodiscard]] double of(Node node);
    [[nodiscard]] const geometry::Pose& poseOf(std::size_t body); // of its centre of mass

private:
    struct Entry {
        std::size_t body, index; // 0 to 2: a coordinate, 3 to 6: of the quaternion
    };
    [[nodiscard]] Vector of(const NodeVector& nodes);

    const Graph& g_;
    const scene::Scene& scene_;
    const Scope& scope_;
    std::unordered_map<std::uint32_t, Entry> entries_;      // by symbol
    std::unordered_map<std::size_t, geometry::Pose> poses_; // of centres of mass, by body
};

} // namespace physics
