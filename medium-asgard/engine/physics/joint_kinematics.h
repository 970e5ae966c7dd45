// The conditions and coordinates of joints as expressions, with their rates along the equations.
//
// joints.h has the list of conditions.
#pragma once

#include "physics/jets.h"
#include "physics/joint_frames.h"

#include <unordered_map>

namespace physics {

class JointKinematics {
public:
    JointKinematics(Graph& g, const scene::Scene& scene, const JointFrames& frames,
                    std::span<const BodyMotion> bodies)
        : g_(g), scene_(scene), frames_(frames), points_(g, bodies) {}

    // All that are 0, as lengths.
    [[nodiscard]] std::vector<Jet> conditions(std::size_t joint, const Along& along);
    // In the world, as its first body carries it (0), or the second or the ground (1).
    [[nodiscard]] NodeVector pointOf(std::size_t joint, std::size_t end);
    // As expressions read it: with -from.
    [[nodiscard]] Jet coordinate(std::size_t joint, std::size_t k, const Along& along);
    // How far it has gone since the start; of a distance and a ball, which have no -from, the same.
    [[nodiscard]] Jet gone(std::size_t joint, std::size_t k, const Along& along);
    // 0 where the unknown of an angle agrees with the attitudes: of first order, with the
    // multiplier that is added to the angle's rate.
    [[nodiscard]] Jet tie(std::size_t joint, std::size_t k, const Along& along);
    // That multiplier, by the angle's symbol.
    void setTie(Node angle, Node multiplier) { ties_.emplace(angle.index, multiplier); }

private:
    [[nodiscard]] JetVector carried(const JointEnd& end, const Vector& v, const Along& along) {
        return points_.carried(end, v, along);
    }
    [[nodiscard]] JetVector apart(const JointFrame& frame, const Along& along); // d
    [[nodiscard]] JetVector turning(const JointFrame& frame, const Along& along);
    [[nodiscard]] Jet angleOf(const JointFrame& frame, std::size_t k, const JetVector& axis,
                              const Along& along);
    [[nodiscard]] Jet ballAngle(const JointFrame& frame, const Along& along);

    Graph& g_;
    const scene::Scene& scene_;
    const JointFrames& frames_;
    CarriedPoints points_;
    std::unordered_map<std::uint32_t, Node> ties_; // by the angle's symbol
};

} // namespace physics
