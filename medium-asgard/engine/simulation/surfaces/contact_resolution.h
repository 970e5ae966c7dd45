// How finely contact is resolved: the thresholds that decide it, and how they depend on each other.
//
// All follow from three scales. From the finest to the coarsest:
//
//     rounding    what places, times and speeds are known to, whatever is asked
//     tolerance   what a run errs in a step: decides when a body hops no more, so that runs at two
//                 tolerances differ in it
//     accuracy    what is asked for: how far apart bodies are that touch for long
//
// A threshold of one scale is never finer than what the scale before it blurs: a contact at rest is
// seen at `gap`, which no impact leaves open (touchingGap of collision/contact.h, 1e-10); a hop is
// left out at `hopHeight`, which the search for impacts finds (leastHop).
// contact_resolution_test.cpp has these relations.
#pragma once

#include <limits>

namespace simulation {

namespace resolution {

// --- rounding -----------------------------------------------------------------------------------

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double ofPlaces = 8 * epsilon; // of coordinates, and of times at a speed
inline constexpr double deep = 400 * epsilon;   // of the radius: a ball that has just been hit
inline constexpr double ofMotion = 1e-13;       // of coordinates: what a solved motion has lost
inline constexpr double leastHop = 2e-9;        // of the smaller radius: lower hops may be missed
inline constexpr double atRest = 1e-9;          // of the speeds that enter: relative rest
inline constexpr double rattled = 3e-8; // of the speeds that enter a blow: what it leaves of less
                                        // is rest
inline constexpr double noRate = 1e-12; // of the size, in the unit of time: of gaps, none

// --- directions that count as the same ----------------------------------------------------------

inline constexpr double sameNormal = 1e-4; // difference of unit normals

// --- loads, of the accelerations that enter ------------------------------------------------------

// Between bodies that both give way a push is rounding's, and so none, if it gives less than that
// part of the accelerations that enter, or than so many radii per second squared, where the forces
// themselves are next to 0.
inline constexpr double weakPush = 1e-6, leastPush = 1e-12;

// --- accuracy ------------------------------------------------------------------------------------

inline constexpr double gapPart = 1e-2, hopPart = 1e-3; // of the accuracy
inline constexpr double leastGap = 1e-8, mostGap = 1e-6;
inline constexpr double searchedGap = 4 * mostGap; // boxes hold what comes so near

// --- tolerance -----------------------------------------------------------------------------------

inline constexpr double finest = 1e-4;          // of a hop's height, at the tightest tolerances
inline constexpr double besideDepth = 4e-9;     // of the smaller radius, at the first tolerance
inline constexpr double fineBesideDepth = 1e-3; // of the tolerance: from here on its fourth root
inline constexpr double nudgedPart = 0.1;       // of both, in a run that shows what rounding does

} // namespace resolution

struct ContactResolution {   // of a body
    double gap = 1e-7;       // of the parts' size: touching
    double beyond = 0;       // of the same: a point at a border may go so far beyond it
    double hopHeight = 1e-9; // of the body's radius: parting slower than for that is not parting
    double depth = 4e-9;     // of the smaller radius: at which balls side by side hit
};

struct ContactScales {
    double accuracy = 0;       // that is asked for
    double firstTolerance = 0; // of one step, in the first run of the search
    double tolerance = 0;      // of the body in this run
    bool isNudged = false;     // the run shows what rounding does
};

// A hop that is lower than a thousandth of the accuracy is the last, at the first tolerance. The
// height follows the square of the tolerance: where runs left out nearly the same hops, both could
// be hit elsewhere during one of them, and go the same wrong way. The nudged run follows lower ones
// yet, to show what they do. The depth of balls side by side follows the tolerance itself; far
// down, where rounding is near, its fourth root.
[[nodiscard]] ContactResolution resolutionFor(const ContactScales& scales);

} // namespace simulation
