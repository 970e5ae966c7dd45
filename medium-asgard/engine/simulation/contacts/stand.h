// On which points of its rim does a round end stand, as that of a can on a table?
//
// It has four, as a box has four corners. Where it would tip over one of them, or over the line
// between two, it gets three more in each arc beside, and again, until the arcs are so short that
// it tips over its rim (contact_set.h sees it tip). An arc of the angle a is a^2/8 of the radius
// within the rim, 5e-7 at last. LIMIT: nearer than 1e-5 to the angle at which it tips, a can stands
// in unstable balance all but on its rim: it may tip early, the estimate of the error may be too
// small, and the motion may stop.
//
// Across the border of a face it has the points where its rim crosses the border, and few of the
// others; once it tips, all sixteen of a round patch (touching.h). LIMIT: over these it may tip up
// to 2 % too early.
#pragma once

#include "contacts/touching.h"
#include "physics/contact_rows.h"
#include "surfaces/placed.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace simulation {

struct Stand {
    std::size_t bodyPart = 0, supportPart = 0;
    bool stands = false;
    bool isBodys = true;                          // the end; else the support's
    bool isAcrossBorder = false, isOnFew = false; // then on few of its points
    // Of the points, in the order of the contact's: in the frame of the end's body, and round the
    // rim, in rad from anywhere. None across a border.
    std::vector<Vector> places = {};
    std::vector<double> angles = {};
    std::vector<char> carries = {}; // by point, where it tips; else none

    struct Arc { // of the rim, in rad
        double from = 0, width = 0;
    };
    // Without points: between those that carry and are next to each other, else beside them.
    [[nodiscard]] std::vector<Arc> arcsBeside() const;
    // Those that carry are one, two, or next to each other on a short part of the rim, and beside
    // them there are others of the rim that might.
    [[nodiscard]] bool tipsEarly() const;
};

// Of a round end that touches with all of its patch, at `points`, by the touch's corners: leaves
// those on which it stands. `was`: how it stood before, or null. onRim: the point at this place
// (world) of the rim of the end of the body, or of the support.
[[nodiscard]] Stand
chooseStand(const Touch& touch, const Placed& body, const Placed& support, const Stand* was,
            const std::function<physics::ContactPoint(const Vector& at, bool isBodys)>& onRim,
            std::vector<physics::ContactPoint>& points);

} // namespace simulation
