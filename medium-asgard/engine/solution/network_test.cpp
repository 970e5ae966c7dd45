// The components in force: who reads whom, what an event touches, and where motion is read.
#include "solution/awakening.h"
#include "solution/network_testing.h"

#include <gtest/gtest.h>

using namespace solution;
using namespace solution::testing;

TEST_F(NetworkTest, AnEventTouchesThoseThatReadWhatItTouches) {
    EXPECT_EQ(network.touchedBy(at(0, w), {}), componentsOf({w, v, x}));
    EXPECT_EQ(network.touchedBy(at(0, x), {}), componentsOf({x}));
    EXPECT_EQ(network.touchedBy(at(0, alone), {}), componentsOf({alone}));
    Changes changes;
    changes.jumps.push_back({v, 5});
    EXPECT_EQ(network.touchedBy(at(0, alone), changes).size(), 3u);
}

TEST_F(NetworkTest, WhatIsToStepFirstIsAnInput) {
    Component& last = *network.components[network.componentOf[x]];
    EXPECT_EQ(&network.readyFor(last), network.components[network.componentOf[w]].get());
}

TEST_F(NetworkTest, GoesOnFromAJump) {
    stepTo(1);
    Changes changes;
    changes.jumps.push_back({alone, 100});
    const auto touched = network.touchedBy(at(0.5, alone), changes);
    network.goBack(touched, 0.5);
    EXPECT_EQ(network.components[touched[0]]->time(), 0.5);
    network.restart(touched, changes);
    stepTo(1);
    EXPECT_NEAR(network.histories.pieceBefore(alone, 0.5).value(0.5), 4.5, 1e-12);
    EXPECT_NEAR(network.histories.value(alone, 1), 100.5, 1e-12);
}

TEST_F(NetworkTest, TellsReadersOfStops) {
    EXPECT_EQ(network.histories.stop(alone), nullptr);
    Changes changes;
    changes.ends.push_back({.unknowns = {alone, flat}, .sentence = "over"});
    network.endThose(changes);
    EXPECT_EQ(network.histories.stop(alone), nullptr);
    network.noteStops();
    ASSERT_NE(network.histories.stop(alone), nullptr);
    EXPECT_EQ(network.histories.stop(alone)->sentence, "over");
    EXPECT_EQ(network.histories.stop(flat), nullptr); // it has no component
    EXPECT_EQ(network.histories.stop(x), nullptr);
}

TEST_F(NetworkTest, AnUnknownMoreIsZeroUntilItHasAnEquation) {
    Changes::Addition added{.unknown = network.set->unknowns[alone], .like = alone};
    added.unknown.name = "more";
    network.addUnknown(added);
    const std::size_t more = network.set->unknowns.size() - 1;
    EXPECT_TRUE(network.isAdded(more));
    EXPECT_FALSE(network.isAdded(spin));
    EXPECT_EQ(network.componentOf[more], noComponent);
    EXPECT_EQ(network.histories.value(more, 7), 0);
}

TEST_F(NetworkTest, CountsWhatIsKept) {
    const std::size_t before = network.keptBefore(infinity);
    stepTo(5);
    EXPECT_GT(network.keptBefore(infinity), before);
    EXPECT_LT(network.keptBefore(1), network.keptBefore(infinity));
    EXPECT_GT(network.keptOf(v, infinity), network.keptOf(v, 1));
}

// A jump beside a much larger one is rounding; and what stays 0 is not roused by a 0.
TEST_F(NetworkTest, RoundingWakesNothing) {
    using Jumps = std::vector<Changes::Jump>;
    EXPECT_EQ(roused(network, 0, Jumps{{spin, 1e-3}, {v, 1}}), std::vector<std::size_t>{spin});
    EXPECT_TRUE(roused(network, 0, Jumps{{spin, 1e-16}, {v, 1}}).empty());
    EXPECT_TRUE(roused(network, 0, Jumps{{spin, 0}, {v, 1}}).empty());
    Changes changes;
    changes.jumps.push_back({spin, 1});
    EXPECT_EQ(wake(network, at(0, spin), changes), (std::vector<std::size_t>{flat, spin}));
}
