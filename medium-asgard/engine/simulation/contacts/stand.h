// On which points of its rim does a round end stand, as that of a can on a table?
//
// It has four, as a box has four corners. Where it would tip over one of them, or over the line
// between two, it gets three more in each arc beside, and again, until the arcs are so short that
// it tips over its rim (contact_places.h chooses the points, contact_set.h sees it tip). An arc of
// the angle a is a^2/8 of the radius within the rim. LIMIT: a third point next to those that carry
// may hold by rounding, and ends that early: it may tip up to 3e-6 too early, and within 1e-6 of
// the angle at which it tips its speed may be wrong by more than the estimate of the error says.
//
// Where its rim crosses the border of the face, the crossings are points, and few of the others;
// once it tips, all sixteen of a round patch (touching.h). LIMIT: over these it may tip up to 2 %
// too early.
#pragma once

#include "geometry/pose.h"

#include <cstddef>
#include <vector>

namespace simulation {

struct Stand {
    std::size_t bodyPart = 0, supportPart = 0;
    bool stands = false, isAcrossBorder = false;
    bool isOnFew = false; // across a border
    // Of the points, in the order of the contact's: in the frame of the end's body, and round the
    // rim, in rad from anywhere. None across a border.
    std::vector<geometry::Vector> places = {};
    std::vector<double> angles = {};
    std::vector<char> carries = {}; // by point, where it tips; else none

    struct Arc { // of the rim, in rad
        double from = 0, width = 0;
    };
    // Without points: between those that carry and are next to each other, else beside them.
    [[nodiscard]] std::vector<Arc> arcsBeside() const;
    // One or two points carry, and beside them there are others of the rim that might.
    [[nodiscard]] bool tipsEarly() const;
};

} // namespace simulation
