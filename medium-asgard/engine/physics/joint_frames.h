// The points and axes of joints, and what each body has of them, as bodies stand at the start.
#pragma once

#include "physics/carried_points.h"
#include "physics/start_values.h"

namespace physics {

// Of length 1: the world's axis that is the farthest from n, without its part along n. It is the
// -axis2 of a universal joint that has none.
[[nodiscard]] Vector acrossOf(const Vector& n);

struct JointEnd : CarriedPoint {
    // Along the body's axes; across and third are perpendicular to the joint's axis.
    Vector axis = Vector::UnitZ(), across = Vector::UnitX(), third = Vector::UnitY();
};

struct JointFrame {
    std::array<JointEnd, 2> ends;
    double size = 1;           // of the joint: an angle times it is a length
    std::vector<double> start; // what its coordinates that are lengths were
    std::vector<Node> angles;  // symbols, by coordinate
};

class JointFrames {
public:
    // Of the scene's joints, in their order. Names that nobody has, and distances without a
    // direction, go to faults.
    JointFrames(Graph& g, const scene::Scene& scene, const Scope& scope,
                std::span<const BodyMotion> bodies, std::vector<std::string>& faults);

    [[nodiscard]] const JointFrame& operator[](std::size_t joint) const { return frames_[joint]; }
    [[nodiscard]] std::size_t size() const { return frames_.size(); }
    [[nodiscard]] std::vector<std::size_t> moving(std::size_t joint) const; // of its bodies

private:
    [[nodiscard]] std::optional<std::size_t> bodyNamed(const std::string& name) const;
    [[nodiscard]] JointFrame frameOf(const scene::Joint& joint);
    void findAxes(const scene::Joint& joint, JointFrame& frame);
    [[nodiscard]] double sizeOf(const JointFrame& frame);
    [[nodiscard]] geometry::Pose poseOf(const JointEnd& end);
    void findStart(Graph& g, std::size_t joint, const scene::Joint& said);

    const Scope& scope_;
    std::span<const BodyMotion> bodies_;
    std::vector<std::string>& faults_;
    StartValues start_; // where trajectories hold bodies, these stand elsewhere than they say
    std::vector<JointFrame> frames_;
};

} // namespace physics
