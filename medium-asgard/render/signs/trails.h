// The paths of the bodies' centres of mass up to now, older parts fainter.
//
// Paths are sampled from a motion once and again when it has got further; each picture only
// projects them. Where a body jumps its trail is broken.
#pragma once

#include "drawing/frame.h"
#include "drawing/lines.h"
#include "drawing/solids.h"

#include <vector>

namespace render {

class Trails {
public:
    // Samples what is new since the last call.
    void follow(const Drawing& drawing, const Extent& extent);
    void add(Lines& lines, const Drawing& drawing, const Frame& frame) const;

private:
    struct Point {
        double time;
        Vector place;
        bool breaks; // nothing leads here from the point before
    };
    struct Trail {
        std::size_t body;
        std::vector<Point> points;
    };

    struct Place {
        double time;
        Vector place;
    };
    // Adds what leads from one place to the other, as finely as it bends.
    static void refine(Trail& trail, const simulation::Motion& motion,
                       const std::vector<double>& jumps, const Place& from, const Place& to,
                       double bend, int depth);

    std::weak_ptr<const simulation::Motion> of_;
    std::vector<Trail> trails_;
};

} // namespace render
