// The view triad: the world's axes in a corner of the picture, as the view has turned them.
//
// Six ends: those of x, y and z are filled and have their letters, those against them are hollow.
// Whoever shows it asks axisAt() what a click means.
#pragma once

#include "drawing/discs.h"
#include "drawing/frame.h"
#include "drawing/lines.h"
#include "framing/extent.h"

#include <array>
#include <optional>
#include <vector>

namespace render {

// The colours of x, y and z, sRGB, seen on light and on dark.
[[nodiscard]] Eigen::Vector3f axisColor(int axis);

struct TriadEnd {
    int axis = 0;
    bool against = false;  // the axis
    Eigen::Vector2d place; // pixels, origin top left
    double depth = 0;      // -1 to 1, towards the viewer
    [[nodiscard]] Vector direction() const { return (against ? -1.0 : 1.0) * Vector::Unit(axis); }
};

// From back to front, in the lower left corner.
[[nodiscard]] std::array<TriadEnd, 6> triadOf(const Camera& camera, Size size);
// Pixels: where its middle is, and how far its ends and all of it reach.
[[nodiscard]] Eigen::Vector2d triadMiddle(Size size);
[[nodiscard]] double triadReach(Size size);

// The direction of the world whose end is there: the view that looks against it is what the click
// asks for.
[[nodiscard]] std::optional<Vector> triadDirectionAt(const Camera& camera, Size size,
                                                     const Eigen::Vector2d& pixels);

void showTriad(Lines& lines, const Discs& discs, const Frame& frame,
               const scene::Color& background);

// The world's axes at the origin, x red, y green, z blue, with heads.
void addAxes(Lines& lines, const Extent& extent, const Frame& frame);

} // namespace render
