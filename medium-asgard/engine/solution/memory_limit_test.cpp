// The component that needs most of the memory ends where the limit is.
#include "solution/memory_limit.h"
#include "solution/network_testing.h"

#include <gtest/gtest.h>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr std::size_t limitBytes = 2500;

Options ofLittleMemory() {
    Options options;
    options.mostBytes = limitBytes;
    return options;
}

struct MemoryLimitTest : NetworkTest {
    MemoryLimitTest() : NetworkTest(ofLittleMemory()) {}
    EventIslands islands;
    Flights flights{network, islands};
    MemoryLimit limit{network, flights, islands, nullptr};

    void keepTo(double time) {
        stepTo(time);
        for (std::size_t c = 0; c < network.components.size(); ++c) {
            network.schedule.changed(c);
            network.noteKept(c);
        }
    }
};

} // namespace

TEST_F(MemoryLimitTest, NothingEndsBelowIt) {
    keepTo(1e-3);
    EXPECT_FALSE(limit.isFull());
    limit.endWhereFull(0, 0);
    EXPECT_EQ(network.kept.fullAt(), infinity);
    EXPECT_TRUE(network.histories.stops().empty());
}

TEST_F(MemoryLimitTest, WhatReadsEachOtherEndsTogether) {
    keepTo(1000);
    ASSERT_TRUE(limit.isFull());
    limit.endWhereFull(0, 0);
    ASSERT_NE(network.histories.stop(v), nullptr);
    EXPECT_EQ(network.histories.stop(v)->reason, Stop::Reason::tooMuchKept);
    EXPECT_EQ(network.histories.stop(v)->time, network.histories.stop(w)->time);
    EXPECT_LE(network.keptBefore(network.histories.stop(v)->time), limitBytes);
}
