// The joints of a scene, drawn as engineers draw them, in one colour over the bodies.
//
// A hinge is a pin in a ring, a slider a block on a rail, a ball joint a ball in its cup, a fixed
// joint a small block, a cylindrical joint and a screw a sleeve on a rod, a universal joint a
// cross, a planar joint a square of its plane, a distance a thin rod between its points. A hinge
// and a slider with -limits show them: an arc with a hand, a rail with stops. What belongs to body
// 1 moves with body 1. A thin line leads to a body that a hinge, a ball joint or a universal joint
// lies outside of. Signs have the size of handles on the screen and are smaller where there are
// many, or where the scene is small in the picture.
#pragma once

#include "drawing/frame.h"
#include "drawing/lines.h"
#include "drawing/solids.h"
#include "framing/extent.h"

#include <vector>

namespace render {

// sRGB; of the handles of joints, too. Seen on white, grey and black.
inline constexpr scene::Color jointColor{0.72, 0.36, 0.12};

struct JointSigns {
    struct Stroke {
        Vector from, to; // view
        float alphaFrom = 1, alphaTo = 1;
        float width = 1; // pixels of the picture
    };
    std::vector<Solid> solids;
    std::vector<Stroke> strokes;
};

[[nodiscard]] JointSigns jointSignsOf(const Drawing& drawing, const Extent& extent,
                                      const Frame& frame);

} // namespace render
