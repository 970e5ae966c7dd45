// Which unknowns met in events, and how many events they had at one instant.
#include "solution/event_islands.h"

#include <gtest/gtest.h>

using namespace solution;

namespace {

const std::vector<std::size_t> ball = {0, 1, 2}, other = {7, 8}, between = {2, 7}, nobody;

} // namespace

TEST(EventIslands, GrowWhereUnknownsMeet) {
    EventIslands islands;
    islands.note(1, ball);
    islands.join(other);
    EXPECT_EQ(islands.islandNumber(1), islands.islandNumber(2));
    EXPECT_EQ(islands.islandNumber(7), islands.islandNumber(8));
    EXPECT_NE(islands.islandNumber(1), islands.islandNumber(8));
    EXPECT_EQ(islands.islandNumber(100), 100u);
    islands.note(2, between);
    EXPECT_EQ(islands.islandNumber(1), islands.islandNumber(8));
    EXPECT_NE(islands.islandNumber(1), islands.islandNumber(3));
}

TEST(EventIslands, CountEventsOfOneInstant) {
    EventIslands islands;
    for (const std::vector<std::size_t>* unknowns : {&ball, &ball, &other, &nobody})
        islands.note(1, *unknowns);
    EXPECT_EQ(islands.atOnce(1, ball), 2u);
    EXPECT_EQ(islands.atOnce(1, between), 2u);
    EXPECT_EQ(islands.atOnce(1, nobody), 1u);
    islands.note(1, between);
    EXPECT_EQ(islands.atOnce(1, other), 4u);
    islands.note(2, other);
    EXPECT_EQ(islands.atOnce(2, ball), 1u);
    EXPECT_EQ(islands.atOnce(3, ball), 0u);
}
