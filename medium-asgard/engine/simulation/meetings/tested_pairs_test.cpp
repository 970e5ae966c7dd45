// Each pair that was searched is listed once, however often it was.
#include "meetings/tested_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace simulation {
namespace {

using ::testing::ElementsAre;
using Pair = collision::Pair;

TEST(TestedPairs, AreListedOnceAndInOrder) {
    TestedPairs tested;
    for (const Pair& pair : {Pair(3, 7), Pair(0, 2), Pair(3, 7), Pair(0, 1), Pair(0, 2)})
        tested.test(pair);
    EXPECT_EQ(tested.tests(), 5u);
    EXPECT_THAT(tested.all(), ElementsAre(Pair(0, 1), Pair(0, 2), Pair(3, 7)));
}

// Also of more than are remembered at a time.
TEST(TestedPairs, ManyOfThemAreAllDifferent) {
    TestedPairs tested;
    for (int again = 0; again < 3; ++again)
        for (std::size_t a = 0; a < 200; ++a)
            for (std::size_t b = a + 1; b < 200; ++b)
                tested.test({a, b});
    EXPECT_EQ(tested.all().size(), 200u * 199 / 2);
    EXPECT_EQ(tested.tests(), 3u * 200 * 199 / 2);
}

} // namespace
} // namespace simulation
