// Which switches accumulate, by their times alone.
#include "modes/switch_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace solution;

namespace {

// Switches about two surfaces in turn, at these times.
SwitchLog logOf(const std::vector<double>& times, double start = 0) {
    SwitchLog log(start);
    for (std::size_t k = 0; k < times.size(); ++k)
        log.add(times[k], {k % 2});
    return log;
}

// A ball that bounces: each interval is `factor` times the one before.
std::vector<double> shrinking(double from, double interval, double factor, int count) {
    std::vector<double> times;
    for (int k = 0; k < count; ++k, interval *= factor)
        times.push_back(from += interval);
    return times;
}

std::vector<double> even(double from, double interval, int count) {
    return shrinking(from, interval, 1, count);
}

} // namespace

TEST(SwitchLog, IntervalsThatShrinkByOneFactorAccumulate) {
    const std::vector<double> times = shrinking(1, 1e-3, 0.7, 80);
    const SwitchLog log = logOf(times);
    EXPECT_TRUE(log.hasSwitched(times.back()));
    EXPECT_TRUE(log.swingsShrink(times.back(), 0));
}

TEST(SwitchLog, EvenIntervalsDoNotShrink) {
    const std::vector<double> times = even(1, 1e-13, 80);
    EXPECT_TRUE(logOf(times).hasSwitched(times.back()));
    EXPECT_FALSE(logOf(times).swingsShrink(times.back(), 0));
}

TEST(SwitchLog, ShrinkingThatIsNotYetNearItsEndDoesNotCount) {
    const std::vector<double> times = shrinking(1, 1, 0.7, 30);
    EXPECT_FALSE(logOf(times).hasSwitched(times.back()));
    EXPECT_FALSE(logOf(times).swingsShrink(times.back(), 0));
}

TEST(SwitchLog, SwitchesBeforeNewEquationsOrARestDoNotCount) {
    const std::vector<double> times = shrinking(1, 1e-3, 0.7, 80);
    SwitchLog log = logOf(times);
    EXPECT_FALSE(log.swingsShrink(times.back(), times[60]));
    log.rest(times[60]);
    EXPECT_FALSE(log.swingsShrink(times.back(), 0));
}

// The last nine intervals take more than nine tenths of the ten before them.
TEST(SwitchLog, GoingToAndFroTakesAsLongEachTime) {
    const std::vector<double> times = shrinking(1, 1e-7, 1.01, 20);
    EXPECT_TRUE(logOf(times).goesToAndFro(times.back(), 0));
    EXPECT_FALSE(logOf(times).goesToAndFro(times.back(), times[5]));
    const std::vector<double> slow = shrinking(1, 1e-3, 1.01, 20);
    EXPECT_FALSE(logOf(slow).goesToAndFro(slow.back(), 0));
    std::vector<double> ever = shrinking(1, 1e-5, 0.7, 20);
    EXPECT_FALSE(logOf(ever).goesToAndFro(ever.back(), 0));
}

// 100 switches within a 1e-10th of the time have no end; a fast swing that has run for long has.
TEST(SwitchLog, ManySwitchesInNextToNoTimeAreEndless) {
    const std::vector<double> dense = even(1, 1e-13, 100);
    EXPECT_TRUE(logOf(dense).isEndless(dense.back()));
    const std::vector<double> few = even(1, 1e-13, 50);
    EXPECT_FALSE(logOf(few).isEndless(few.back()));
    const std::vector<double> fast = even(1, 1e-6, 3'000);
    EXPECT_FALSE(logOf(fast).isEndless(fast.back()));
    EXPECT_TRUE(logOf(even(1e3, 1e-8, 1'000)).isEndless(1e3 + 1e-5));
}

// The part is of the time since the start, not of the time's own value.
TEST(SwitchLog, ALateStartIsNoLongTime) {
    const std::vector<double> times = even(1e6, 1e-6, 100);
    EXPECT_TRUE(logOf(times).isEndless(times.back()));
    EXPECT_FALSE(logOf(times, 1e6 - 1e-5).isEndless(times.back()));
}

TEST(SwitchLog, SwitchesAtOneTimeAreCountedUntilTimeGoesOn) {
    SwitchLog log(0);
    EXPECT_EQ(log.addAtOnce(), 1u);
    EXPECT_EQ(log.addAtOnce(), 2u);
    log.add(1, {0});
    EXPECT_EQ(log.atOnce(), 0u);
    EXPECT_EQ(log.addAtOnce(), 1u);
    log.goOn();
    EXPECT_EQ(log.atOnce(), 0u);
}

TEST(SwitchLog, AnEventTakesBackWhatCameAfterIt) {
    const std::vector<double> times = even(1, 1e-13, 100);
    SwitchLog log = logOf(times);
    log.stay(1);
    log.stay(2);
    EXPECT_TRUE(log.staysAt(2));
    log.backTo(times[40]);
    EXPECT_FALSE(log.isEndless(times.back()));
    EXPECT_TRUE(log.staysAt(1));
    EXPECT_FALSE(log.staysAt(2));
}

TEST(SwitchLog, NamesTheSurfacesOfTheLastSwitchesOnceEach) {
    SwitchLog log = logOf(even(1, 1e-3, 20));
    log.add(1.5, {7, 3});
    EXPECT_EQ(log.surfacesOfLast(), (std::vector<std::size_t>{0, 1, 3, 7}));
    EXPECT_NEAR(log.timeOfLast(), 1.012, 1e-12);
}

TEST(SwitchLog, AStayCountsForAShortWhile) {
    SwitchLog log(0);
    EXPECT_FALSE(log.hasStayedNear(1));
    log.stay(1);
    EXPECT_TRUE(log.hasStayedNear(1 + 5e-6));
    EXPECT_FALSE(log.hasStayedNear(1 + 2e-5));
}
