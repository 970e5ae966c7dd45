// Balls that go side by side: they touch, and neither part nor approach, or next to nothing.
//
// Pendulums of one length on pivots a diameter apart swing so, and so do the balls of a cradle that
// a blow has gone through. The gap is 0 but for rounding and what the integration errs in it, and
// its sign says nothing. So from then on they hit only where they overlap by a little, a few
// billionths of the smaller radius:
//     nothing pushes them together     they wander by less than that, and never hit
//     a force pushes them together     they hop on each other to that depth, with the restitution
//                                      that they have; elastic ones lose nothing by it
// until they have parted by several times as much. Where they would hit without speed there, too,
// it is that much deeper. A hop that the push itself has made, on a way of that depth, is none of
// the motion's: they take on one speed, with all that touches them, and sink that much deeper. So
// they go on as one that presses, but for what they gain on one such way. There is a most of
// hops: bodies that are pushed together for long come to rest on each other, which is not
// modelled.
//
// Balls on joints are moved onto these at the ends of steps, and may overlap by more than the depth
// at once: then the depth grows to that overlap.
//
// LIMIT: else the depth grows by its first part each time, to 3000 times that at most: 1.2e-5 of
// the smaller radius near the origin, and more where places are coarse.
#pragma once

#include "collision/broad_phase.h"
#include "solution/accumulation_monitor.h"

#include <cstddef>
#include <map>

namespace simulation {

class SideBySide {
public:
    using Pair = collision::Pair;

    // At which they hit; 0: they do not go side by side.
    [[nodiscard]] double depth(const Pair& pair) const;
    struct Now {
        double time = 0, rate = 0; // of the gap
        double push = 0;           // what presses them together, as an acceleration
    };
    // From now on they do, or they reached their depth without speed. False: too often.
    [[nodiscard]] bool sink(const Pair& pair, double deeper, double way, const Now& now);
    // They hit again while they do. False: too often.
    [[nodiscard]] bool hop(const Pair& pair, double time);
    // The speed that their push can have given them on the last part of that depth.
    [[nodiscard]] double speedOfPush(const Pair& pair, const Now& now) const;
    // Their gap now; far apart they do so no longer.
    void look(const Pair& pair, double gap);

private:
    struct State {
        double depth = 0;
        double way = 0, push = 0, since = 0; // when they last reached their depth without speed
        solution::AccumulationMonitor hops, sinks;
    };
    std::map<Pair, State> pairs_;
};

} // namespace simulation
