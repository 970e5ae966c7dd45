// Bodies that overlap at the start by no more than the numbers of a text leave open are put apart.
//
// An author who writes  -init_pos {0 0.0985 0}  for a box on a slope means a box that touches: the
// digits that are not there push it into the slope, or lift it off. Overlaps of up to 1e-4 of the
// smaller body are taken for that. What overlaps by more is meant, and said (events/sentences.h).
//
// The body moves along the normal of the overlap, and with it, unturned, all that joints hang on
// it; of two that are free each moves by half. What stands, by itself, by a trajectory or by a
// joint to the world, stays.
//
// LIMIT: a body that does not fit between two that stand overlaps still.
#pragma once

#include "geometry/shape.h"
#include "scene/scene.h"

#include <span>

namespace simulation {

// `shapes`: by body.
void putApart(scene::Scene& scene, std::span<const geometry::Shape> shapes);

} // namespace simulation
