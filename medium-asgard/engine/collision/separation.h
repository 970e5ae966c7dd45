// How far apart are two convex parts, and along which line?
//
// Distance by the algorithm of Gilbert, Johnson and Keerthi on the cores (a sphere is a point with
// a radius), then the best axis among the one it found and the normals of the faces beside it: any
// axis is a proof that the parts are at least so far apart, and a face's own normal has no rounding
// from the far corners of the face. Where the cores all but touch, or overlap, the line between
// closest points is lost in rounding; there all face normals and all pairs of edges that face each
// other are tried (separating axes), which gives a signed gap.
//
// LIMIT: that last search takes the product of the numbers of edges; it runs only within 1e-7 of
// the parts' size.
#pragma once

#include "collision/posed.h"

#include <array>
#include <cstddef>
#include <vector>

namespace collision {

// Pairs of vertices from the last query; the next one starts from them. Speeds up, changes nothing.
struct WarmStart {
    std::array<std::pair<std::size_t, std::size_t>, 4> pairs{};
    std::size_t count = 0;
};

// Capsules and curved parts: curved_separation.h; balls and hollow ones: hollow_separation.h.
[[nodiscard]] Separation separate(const Posed& first, const Posed& second, WarmStart& warm);

// Axes along which the parts are apart, touch, or overlap by no more than `depth`: normals of faces
// and common perpendiculars of edges that face each other, each with its gap. Of two polyhedra.
[[nodiscard]] std::vector<Separation> axesOfTouch(const Posed& first, const Posed& second,
                                                  double depth);

// The signed gap by separating axes alone: exact depth and direction when the parts overlap.
[[nodiscard]] Separation separateByAxes(const Posed& first, const Posed& second);

} // namespace collision
