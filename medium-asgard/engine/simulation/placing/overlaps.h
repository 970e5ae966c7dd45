// Which bodies that may meet overlap at the start, how deep, and along which direction?
//
// Each pair of parts has the gap and the normal of collision/separation.h, which of parts that
// overlap is the least way that parts them. Parts that overlap by less than 1e-8 of the smaller
// one touch. All bounds are those of the pair: bodies elsewhere change nothing.
//
// LIMIT: a body of several parts parts from each of its neighbour's parts by itself, so that one
// that has gone deep into a notch may go out through its bottom.
#pragma once

#include "collision/broad_phase.h"
#include "collision/separation.h"
#include "meetings/may_meet.h"
#include "physics/assembly.h"
#include "physics/equations_of_motion.h"

#include <functional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace simulation {

// By body: it may be moved, and hangs on nothing.
[[nodiscard]] std::vector<char> looseBodies(const scene::Scene& scene,
                                            const physics::EquationsOfMotion& equations);

class Overlaps {
public:
    // All outlive it. `shapes`: by body.
    Overlaps(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
             const std::vector<geometry::Shape>& shapes);

    enum class Depth { any, little };
    // Of bodies whose centres of mass are at these poses. Pairs that were found before are among
    // them whether they overlap or not. `little`: by at most 1e-3 of the smaller part. A patch has
    // several places.
    [[nodiscard]] std::vector<physics::PartGap> at(const std::vector<geometry::Pose>& poses,
                                                   Depth depth);
    // Of bodies that are asked for, at one place of each pair of parts: where they are apart by at
    // most 1e-3 of the smaller part, or also touch, or overlap by as little.
    enum class Near { apart, apartOrTouching };
    using Asked = std::function<bool(std::size_t first, std::size_t second)>;
    [[nodiscard]] std::vector<physics::PartGap> nearGaps(const std::vector<geometry::Pose>& poses,
                                                         Near near, const Asked& isAsked) const;
    // Their poses at the start, those of bodies that trajectories hold included.
    [[nodiscard]] std::vector<geometry::Pose> startPoses() const;

private:
    using Parts = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>;
    // Both parts as they stand, about the second body's centre of mass.
    [[nodiscard]] std::pair<collision::Posed, collision::Posed>
    posed(const Parts& parts, const std::vector<geometry::Pose>& poses) const;
    void look(const Parts& parts, const std::vector<geometry::Pose>& poses, Depth depth,
              std::vector<physics::PartGap>& found);

    const scene::Scene& scene_;
    const physics::EquationsOfMotion& equations_;
    const std::vector<geometry::Shape>& shapes_;
    MayMeet mayMeet_;
    std::set<Parts> told_; // first body, its part, second body, its part
};

} // namespace simulation
