// The grid on the ground: lines at round coordinates of the world.
//
// It stands still in the world. Its step, of the series 1, 2, 5, 10, ..., follows the scale of the
// view; near a change of the step both grids are seen, one fading into the other. Lines fade with
// distance and where they would crowd. On a page of a document it is a discreet patch under the
// scene, in a studio (Display::studio) it reaches to the horizon, with numbers and coloured axes;
// seen from below it is faint, so that it hides nothing.
#pragma once

#include "drawing/frame.h"
#include "drawing/lines.h"
#include "framing/extent.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace render {

// The plane of the grid in the world: points x with up . x = height. `across`: the world's axes
// that lie in it, indices.
struct GroundPlane {
    Vector up = Vector::UnitY();
    double height = 0;
    std::array<int, 2> across{0, 2};
    [[nodiscard]] Vector place(double u, double v) const {
        return height * up + u * Vector::Unit(across[0]) + v * Vector::Unit(across[1]);
    }
};
// `up` is an axis of the world, either way.
[[nodiscard]] GroundPlane groundPlane(const Vector& up, double height);

// A step of the grid, and how much of it is seen, 0 to 1.
struct GridStep {
    double step = 1;
    double weight = 1;
};
// Of a view in which a length of the world is that many pixels times as long: one step, or two
// while one turns into the other. Each is some 90 to 225 pixels of a picture 480 high.
[[nodiscard]] std::vector<GridStep> gridSteps(double pixelsPerLength, double stroke);

// The multiples of a step within a radius of the focus, and at most 400 to either side of what is
// in the middle of the picture: those beyond stand too close to be told apart, however near one
// looks at something far above the ground.
struct GridRows {
    std::int64_t first = 0, last = -1;
};
[[nodiscard]] GridRows gridRows(double step, double focus, double radius, double middle);

// A place of the view on the ground, moved towards the eye as far as needed for nothing of the
// ground to hide what stands there upright; `corners`: where that ends, pixels to the right and up.
[[nodiscard]] Vector beforeGround(const GroundPlane& ground, const Frame& frame,
                                  const Vector& place, std::span<const Eigen::Vector2d> corners);

// The room that numbers have taken in a picture, pixels: no other one is written over them.
using TakenRoom = std::vector<Eigen::AlignedBox2d>;
// It is for this number alone then; false: others have it, or the picture ends in it.
[[nodiscard]] bool takeRoom(TakenRoom& taken, const Eigen::AlignedBox2d& room, Size picture);

struct GridLook {
    std::optional<Eigen::Vector3f> floor; // the colour of the floor that it lies on; none: there
                                          // is none to see
    double strength = 1;
    bool isBesideFloor = false; // the floor ends, and the grid goes on
};
void addGrid(Lines& lines, const GroundPlane& ground, const Extent& extent, const Frame& frame,
             const Display& display, const GridLook& look, TakenRoom& taken);

// The plane of a grid that faces whoever looks along an axis of the world, from the side or from
// the front, where the ground is a line: one builds in it, so it lies as deep as new places do.
struct FacingPlane {
    GroundPlane plane;
    double weight = 1; // it fades as the view is turned away
};
[[nodiscard]] std::optional<FacingPlane> facingPlane(const Drawing& drawing, const Vector& up);

// The coordinate of a place that nobody points at, along an axis of the world: that of all bodies,
// where they have one in common as they start; 0 where there is none; none: they differ.
[[nodiscard]] std::optional<double> commonDepth(const scene::Scene& scene, Eigen::Index axis);

} // namespace render
