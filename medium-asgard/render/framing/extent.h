// The room that a scene's motion takes: framing, the ground and the trails follow it.
//
// Bodies are taken as their spheres and corners, at a limited number of times over the motion.
#pragma once

#include "framing/body_places.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace render {

struct Extent {
    Eigen::AlignedBox3d box; // what moves, over the whole motion, and what is fixed near it
    std::vector<Ball> balls; // the same, as spheres and (of radius 0) corners
    std::vector<bool> moves; // of each body: its place or attitude changes
    std::vector<bool> turns; // of each body: its attitude changes
    std::vector<bool> spins; // of each body: it is round about an axis, and turns about that
    std::vector<bool> fixed; // of each body
    Vector up = Vector::UnitY();
    Vector ground = Vector::UnitY();   // normal of what things stand on: up, or that of a table
    double lowest = 0;                 // along the ground's normal
    bool lowestStands = false;         // what reaches there is fixed
    double size = 1;                   // longest edge of the box
    std::optional<Vector> planeNormal; // the axis that the motion is flat along
};

// Against gravity, as far as the scene's forces tell: the world axis that most bodies fall along;
// y when nothing falls.
[[nodiscard]] Vector upOf(const scene::Scene& scene);
// None: nothing falls.
[[nodiscard]] std::optional<Vector> againstGravity(const scene::Scene& scene);

// Bodies that drop out of sight, as nothing catches them, count only while they are seen beside the
// place where they start; the ground is that of the start.
[[nodiscard]] Extent extentOf(const scene::Scene& scene, const simulation::Motion* motion);

// The extent of a picture at that time: of those bodies, or of all when none are given, fixed
// ones included. Half spaces have no size: their place near the others counts. Empty scenes have
// the extent of a ball of radius 1.
[[nodiscard]] Extent extentAt(const scene::Scene& scene, const simulation::Motion* motion,
                              double time, const std::vector<std::size_t>& bodies = {});

// The whole motion, falls out of sight, too, and all of the fixed bodies, but of those that are
// much larger than it what lies near it.
[[nodiscard]] Extent extentOfAll(const scene::Scene& scene, const simulation::Motion* motion);

} // namespace render
