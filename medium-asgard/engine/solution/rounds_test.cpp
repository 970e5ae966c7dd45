// Rounds: all that are behind step, none far ahead of the others while there are events.
#include "solution/network_testing.h"
#include "solution/rounds.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

struct RoundsTest : NetworkTest {
    using NetworkTest::NetworkTest;
    Interruption interruption{network.options};

    void SetUp() override { interruption.begin(); }
};

} // namespace

TEST_F(RoundsTest, WithoutEventsOneRoundReachesTheFinish) {
    Rounds rounds(network, interruption, false);
    rounds.doOne(10);
    EXPECT_GE(network.known(), 10);
    EXPECT_EQ(rounds.done(), 1u);
}

TEST_F(RoundsTest, WithEventsNoneGoesFarAhead) {
    Rounds rounds(network, interruption, true);
    while (network.known() < 10)
        rounds.doOne(10);
    EXPECT_GT(rounds.done(), 1u);
    EXPECT_NEAR(network.histories.value(w, 5), 3 * std::exp(-5.0), 1e-5);
}

TEST_F(RoundsTest, NothingStepsAfterSomebodyCancelled) {
    network.options.cancelled = [] { return true; };
    Rounds rounds(network, interruption, false);
    interruption.poll(0);
    rounds.doOne(10);
    EXPECT_EQ(network.known(), 0);
}
