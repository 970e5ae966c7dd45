// The conditions of joints on velocities at an instant, as numbers: a blow keeps them. Those of
// stops and ropes are kept where they are closed.
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/impact.h"

#include <functional>
#include <span>
#include <vector>

namespace physics {

class JointRows {
public:
    enum class State { open, held, gone }; // of a multiplier; what sleeps is open
    // Who knows the motion at the instant.
    struct Motion {
        std::function<BodyValues(std::size_t body)> stateOf;
        std::function<double(std::size_t unknown)> valueOf; // of angles
        std::function<State(std::size_t multiplier)> multiplierOf;
    };
    explicit JointRows(const EquationsOfMotion& equations);

    // Moving bodies on the same joints and gears as this one; itself not.
    [[nodiscard]] std::span<const std::size_t> neighbours(std::size_t body) const {
        return neighbours_[body];
    }
    // Multipliers move it.
    [[nodiscard]] bool isJoined(std::size_t body) const { return isMoved_[body] != 0; }
    // Conditions between these bodies; their parts count places among them.
    [[nodiscard]] std::vector<ImpactRow> rowsAt(std::span<const std::size_t> bodies, double time,
                                                const Motion& motion) const;

private:
    void findMoved();
    [[nodiscard]] std::vector<std::size_t> rowsOf(std::span<const std::size_t> bodies,
                                                  const Motion& motion) const;
    [[nodiscard]] std::vector<double> evaluated(std::span<const Node> outputs,
                                                std::span<const std::size_t> bodies, double time,
                                                const Motion& motion) const;
    const EquationsOfMotion& equations_;
    std::vector<std::vector<std::size_t>> neighbours_; // by body
    std::vector<char> isMoved_;                        // by body
    std::vector<std::vector<std::size_t>> rows_;       // by body: indices into the equations' rows
};

} // namespace physics
