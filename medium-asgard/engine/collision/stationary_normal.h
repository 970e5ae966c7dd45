// At which normals is the sum of the support functions of two smooth pieces stationary?
//
// The pieces are given as those of the Minkowski sum (-A) + B, so that both have the same outward
// normal n. With G the gradient of H (the place of the sum's point with normal n) and T a basis of
// the directions in which n may turn, Newton's method solves T'G = 0:
//     free on the sphere       T' (H'' - (G.n) 1) T d = -T'G
//     on the circle n.u = s    (t'H''t - G.e / c) d = -t.G,   n = s u + c e,  t = u x e
#pragma once

#include "collision/feature.h"

#include <optional>
#include <vector>

namespace collision {

struct StationaryNormal {
    Vector normal = Vector::UnitX();
    bool isBlurred = false; // the points are so near that their difference is mostly rounding
};

// A feature of the first part as one of the part reflected in the origin.
[[nodiscard]] Feature reflected(Feature feature);

// None of them is a face. `near` is where Newton's method starts; `size` is that of both parts.
[[nodiscard]] std::vector<StationaryNormal>
stationaryNormals(const Feature& first, const Feature& second, const Vector& near, double size);

} // namespace collision
