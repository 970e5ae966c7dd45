// The points in which two parts touch, and the pieces of their surfaces that do.
//
// The pieces are for one who keeps a contact: a gap keeps its place while a sphere, a rim or a side
// rolls only for one who knows the surface, which a point and a normal do not tell. The pieces are
// given in the frames of their parts, so that they stay what they are while the parts move;
// feature.h has the numbers of each:
//
//     on a floor       the cylinder's piece        points
//     standing         face with a radius          its rim, as corners of the patch; isDisc
//     lying            segment with a radius       both ends of the line of contact
//     leaning          circle                      one
//     a cone lying     cone                        apex and rim
//     a capsule lying  segment with a radius       both ends
//     a sphere, a capsule's end: point with a radius; a box: face, segment, point; an ellipsoid.
#pragma once

#include "collision/feature.h"

#include <vector>

namespace collision {

struct ContactPoints {
    double gap = 0;
    Vector normal = Vector::UnitX(); // from the second part to the first, in the common frame
    Feature first, second;           // in the part's own frame
    // In the common frame, halfway between the surfaces; of a patch its corners.
    std::vector<Vector> points;
    Vector centre = Vector::Zero(); // of the patch
    bool isDisc = false;            // the patch is the whole of a round face
};

// The pieces that bear along the normal of their separation: of the furthest extent all that lies
// within `tolerance`. Parts that do not touch get the pieces that are nearest. Not of two half
// spaces.
[[nodiscard]] ContactPoints contactPoints(const Posed& first, const Posed& second,
                                          double tolerance);

// The largest piece of the part that lies within `tolerance` of its furthest extent along a
// direction; both in the part's frame.
[[nodiscard]] Feature bearingFeature(const Part& part, const Vector& direction, double tolerance);

} // namespace collision
