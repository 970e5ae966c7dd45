// Where handles and labels stand in a picture, so that each of them can be seen and reached.
#pragma once

#include "handles/handles.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace render {

// Pixels: where a handle is drawn and taken; `Handle::place` but for what stands aside.
[[nodiscard]] Eigen::Vector2d standOf(const Handle& handle, const Camera& camera, Size size);

// Arrows whose foot is in the picture and whose head is not are shortened until it is.
void keepInside(HandleSet& set, const Camera& camera, Size size);

// Handles that would cover each other: the largest stays, six stand around it, and what else lies
// beneath them is folded: a number beside the largest tells how many there are. Points of paths
// stay where they are.
void spread(HandleSet& set, const Camera& camera, Size size);

// Labels beside their points: for each the rectangle of its size, at one of eight places about its
// point, where it covers the least of the labels before it, of all points, and of what lies
// outside the picture. Pixels, origin top left.
struct LabelWish {
    Eigen::Vector2d point, size;
};
[[nodiscard]] std::vector<Eigen::AlignedBox2d>
placedLabels(std::span<const LabelWish> wishes, const Eigen::AlignedBox2d& picture, double gap);

} // namespace render
