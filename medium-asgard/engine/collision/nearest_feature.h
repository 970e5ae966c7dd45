// Which face, edge or vertex of a convex polyhedron lies nearest to a point outside it?
//
// Space outside is divided into one cell for each feature (Voronoi): over a face lies the space in
// the face's own prism, beside an edge or a vertex the space in none of the prisms. A sphere
// touches that in whose cell its centre lies, and as it goes from cell to cell its contact passes
// from feature to feature: over the edge of a table just when its centre does, whatever counts as
// touching there.
//
// A point on the border of two cells, to within `border`, is the larger feature's.
#pragma once

#include "collision/posed.h"

namespace collision {

struct NearestFeature {
    std::vector<Vector> corners;     // 1: a vertex, 2: an edge, more: a face
    Vector normal = Vector::UnitX(); // unit, from the feature to the point
    double distance = 0;             // negative: inside
};

// Of a polyhedron, or a half space: a face with three corners about the point's foot. World
// coordinates.
[[nodiscard]] NearestFeature nearestFeature(const Posed& posed, const Vector& point, double border);

} // namespace collision
