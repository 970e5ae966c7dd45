// Where handles and labels stand in a picture, so that each of them can be seen and reached.
#pragma once

#include "handles/handles.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <vector>

namespace render {

// Pixels: where a handle is drawn and taken; `Handle::place` but for what stands aside.
[[nodiscard]] Eigen::Vector2d standOf(const Handle& handle, const Camera& camera, Size size);

// Arrows whose foot is in the picture and whose head is not are shortened until it is.
void keepInside(HandleSet& set, const Camera& camera, Size size);

// Handles that would cover each other: the largest stays, six stand around it, and what else lies
// beneath them is folded: a number beside the largest tells how many there are. Of the crowd that
// is opened these stand around the six, ring by ring, where they cover no others. Points of paths
// stay where they are. Handles stand in the picture while there is room.
void spread(HandleSet& set, const Camera& camera, Size size,
            const std::optional<HandleName>& opened = std::nullopt);

// The handles that have a label to be shown; none of a spin of 0, whose handle lies on its body.
[[nodiscard]] std::vector<const Handle*> labelled(const HandleSet& set);

// Labels beside their points: for each the rectangle of its size, at one of eight places about its
// point or, where these are full, one or two labels farther away, where it covers the least of the
// labels before it, of what is taken, of all points, and of what lies outside the picture. One
// whose point is outside stands at the first place. Pixels, origin top left.
struct LabelWish {
    Eigen::Vector2d point, size;
    double gap = 7;       // between it and its point
    double reach = 0;     // of what lies about the point and is to be seen, too
    bool isBelow = false; // its first place is to the lower right, not to the upper right
    std::optional<Eigen::AlignedBox2d> put = {}; // somebody put it there: the others avoid it
};
[[nodiscard]] std::vector<Eigen::AlignedBox2d>
placedLabels(std::span<const LabelWish> wishes, const Eigen::AlignedBox2d& picture,
             std::vector<Eigen::AlignedBox2d> taken = {});

} // namespace render
