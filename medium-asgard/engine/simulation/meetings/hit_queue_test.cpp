// Hits come in order of time, and those from before a cut do not come.
#include "meetings/hit_queue.h"

#include <gtest/gtest.h>

namespace simulation {
namespace {

using Pair = collision::Pair;

std::vector<double> timesOf(HitQueue queue) {
    std::vector<double> times;
    while (queue.first())
        times.push_back(queue.take().time);
    return times;
}
using Times = std::vector<double>;

TEST(HitQueue, InOrderOfTimeThenOfPairs) {
    HitQueue queue(4);
    queue.push({.time = 2, .pair = {0, 1}});
    queue.push({.time = 1, .pair = {2, 3}});
    queue.push({.time = 1, .pair = {1, 2}, .pressing = true});
    ASSERT_TRUE(queue.first());
    EXPECT_EQ(queue.first()->pair, Pair(1, 2));
    EXPECT_TRUE(queue.take().pressing);
    EXPECT_EQ(queue.take().pair, Pair(2, 3));
    EXPECT_EQ(queue.take().time, 2);
    EXPECT_FALSE(queue.first());
}

TEST(HitQueue, ACutForgetsTheHitsOfItsBodyAlone) {
    HitQueue queue(4);
    queue.push({.time = 1, .pair = {0, 1}});
    queue.push({.time = 2, .pair = {1, 2}});
    queue.push({.time = 3, .pair = {2, 3}});
    queue.cut(1);
    EXPECT_EQ(timesOf(queue), Times{3});
    queue.push({.time = 2.5, .pair = {1, 2}}); // found after the cut
    EXPECT_EQ(timesOf(queue), (Times{2.5, 3}));
}

// A body that is cut again and again leaves no heap of outdated hits.
TEST(HitQueue, OutdatedHitsTakeNoRoom) {
    HitQueue queue(2);
    for (int i = 0; i < 10'000; ++i) {
        queue.push({.time = 1e6 - i, .pair = {0, 1}});
        queue.cut(0);
    }
    EXPECT_LT(queue.size(), 100u);
    EXPECT_FALSE(queue.first());
}

} // namespace
} // namespace simulation
