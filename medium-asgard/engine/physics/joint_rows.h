// The conditions of joints on velocities at an instant, as numbers: a blow keeps them.
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/impact.h"

#include <functional>
#include <span>
#include <vector>

namespace physics {

class JointRows {
public:
    explicit JointRows(const EquationsOfMotion& equations);

    // Moving bodies on the same joints and gears as this one; itself not.
    [[nodiscard]] std::span<const std::size_t> neighbours(std::size_t body) const {
        return neighbours_[body];
    }
    [[nodiscard]] bool isJoined(std::size_t body) const { return !rows_[body].empty(); }
    // Conditions between these bodies; their parts count places among them.
    [[nodiscard]] std::vector<ImpactRow>
    rowsAt(std::span<const std::size_t> bodies, double time,
           const std::function<BodyValues(std::size_t body)>& stateOf,
           const std::function<bool(std::size_t multiplier)>& isReleased) const;

private:
    const EquationsOfMotion& equations_;
    std::vector<std::vector<std::size_t>> neighbours_; // by body
    std::vector<std::vector<std::size_t>> rows_;       // by body: indices into the equations' rows
};

} // namespace physics
