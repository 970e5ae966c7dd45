// Sequences of times, and what they come to.
#include "solution/accumulation_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace solution {
namespace {

using Verdict = AccumulationMonitor::Verdict;

constexpr AccumulationLaw meetings{.many = 1000, .within = 1e-5, .close = 200};

// Each hop of a ball takes e times as long as the one before: all of them end at a finite time.
TEST(AccumulationMonitor, HopsThatShrinkConverge) {
    AccumulationMonitor monitor;
    double time = 1, hop = 1;
    Verdict verdict = Verdict::goesOn;
    while (verdict == Verdict::goesOn && monitor.count() < 10'000) {
        verdict = monitor.add(time, meetings);
        time += hop *= 0.99;
    }
    EXPECT_EQ(verdict, Verdict::converges);
    EXPECT_EQ(monitor.count(), 3000u); // the third thousand takes 1e-9 of the time
}

TEST(AccumulationMonitor, EvenOnesGoOn) {
    AccumulationMonitor monitor;
    for (int i = 1; i <= 100'000; ++i)
        ASSERT_EQ(monitor.add(1e-3 * i, meetings), Verdict::goesOn) << i;
}

// Laws know no unit of time.
TEST(AccumulationMonitor, TheScaleOfTimeDoesNotMatter) {
    for (const double scale : {1e-9, 1.0, 1e9}) {
        AccumulationMonitor monitor;
        std::size_t count = 0;
        for (double part = 1; monitor.add(scale * (2 - part), meetings) == Verdict::goesOn;
             part *= 0.98)
            ++count;
        EXPECT_EQ(count, 1999u) << scale;
    }
}

TEST(AccumulationMonitor, ManyAtOneInstantAreNoProgress) {
    AccumulationMonitor monitor;
    EXPECT_EQ(monitor.add(1, meetings), Verdict::goesOn);
    for (int i = 0; i < 199; ++i)
        EXPECT_EQ(monitor.add(1, meetings), Verdict::goesOn);
    EXPECT_EQ(monitor.closeAt(1), 200u);
    EXPECT_EQ(monitor.closeAt(1.5), 0u);
    EXPECT_EQ(monitor.add(1, meetings), Verdict::noProgress);
    EXPECT_EQ(monitor.add(2, meetings), Verdict::goesOn);
}

// A pause before the next begins the count anew.
TEST(AccumulationMonitor, CloseOnesAreCountedFromTheLastPause) {
    constexpr AccumulationLaw changes{.close = 30, .pause = 1e-9};
    AccumulationMonitor monitor;
    double time = 1;
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(monitor.add(time *= 1 + 1e-10, changes), Verdict::goesOn) << i;
    EXPECT_EQ(monitor.add(time *= 1.1, changes), Verdict::goesOn);
    for (int i = 0; i < 29; ++i)
        EXPECT_EQ(monitor.add(time *= 1 + 1e-10, changes), Verdict::goesOn) << i;
    EXPECT_EQ(monitor.add(time *= 1 + 1e-10, changes), Verdict::noProgress);
}

TEST(AccumulationMonitor, SoManyAndNoMore) {
    constexpr AccumulationLaw hops{.most = 3};
    AccumulationMonitor monitor;
    EXPECT_EQ(monitor.add(1, hops), Verdict::goesOn);
    EXPECT_EQ(monitor.add(2, hops), Verdict::goesOn);
    EXPECT_EQ(monitor.add(3, hops), Verdict::tooLong);
}

} // namespace
} // namespace solution
