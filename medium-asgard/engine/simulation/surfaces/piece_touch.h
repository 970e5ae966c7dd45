// The points at which two parts touch, each by a piece of both surfaces.
#pragma once

#include "physics/surface_gap.h"
#include "surfaces/placed.h"

#include <vector>

namespace simulation {

struct PiecePoint {
    physics::SurfaceGap gap;
    physics::NearestSurfaces at; // from the body's centre of mass, along the world's axes
};
struct PieceTouch {
    Vector normal = Vector::UnitX(); // from the support to the body
    std::vector<PiecePoint> points;
    bool isModelled = true; // each of the points
};

} // namespace simulation
