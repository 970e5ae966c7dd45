// What happened up to a time, and each pair's note once.
#include "events/collision_record.h"

#include "events/meeting_counts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace simulation {
namespace {

using ::testing::ElementsAre;
using Pair = collision::Pair;

TEST(CollisionRecord, ToldUpToATime) {
    CollisionRecord record;
    record.addNote({0, 1}, 1, "first");
    record.addNote({0, 1}, 2, "again");
    record.addNote({1, 1}, 3, "alone");
    record.addBlocked({0, 2}, 2);
    record.addEvent(1);
    record.addEvent(1);
    record.addEvent(2.5);
    EXPECT_THAT(record.notes(2.9), ElementsAre("first"));
    EXPECT_THAT(record.notes(3), ElementsAre("first", "alone"));
    EXPECT_TRUE(record.blocked(1.9).empty());
    EXPECT_THAT(record.blocked(2), ElementsAre(Pair(0, 2)));
    EXPECT_TRUE(record.hasEventAt(2.5));
    EXPECT_FALSE(record.hasEventAt(2));
}

// The engine leaves out hops that shrink: the highest tells.
TEST(CollisionRecord, OfLostHopsThoseThatAreHigher) {
    CollisionRecord record;
    record.addLostHop({.time = 1, .height = 0.2, .body = 4});
    record.addLostHop({.time = 2, .height = 0.1, .body = 4});
    record.addLostHop({.time = 3, .height = 0.1, .body = 5});
    record.addLostHop({.time = 4, .height = 0, .body = 6});
    record.addLostHop({.time = 5, .height = 0.3, .body = 4});
    const auto hops = record.lostHops(4);
    ASSERT_EQ(hops.size(), 2u);
    EXPECT_EQ(hops[0].height, 0.2);
    EXPECT_EQ(hops[1].body, 5u);
    EXPECT_EQ(record.lostHops(5).size(), 3u);
}

// A ball between walls that close in meets them in ever shorter time.
TEST(MeetingCounts, BetweenWallsThatCloseInHaveNoEnd) {
    MeetingCounts counts(3, 0);
    double time = 1, pause = 0.1;
    std::size_t meetings = 1;
    while (!counts.meets(0, 1 + meetings % 2, false, time) && meetings < 10'000) {
        time += pause *= 0.99;
        ++meetings;
    }
    EXPECT_EQ(meetings, 3000u); // the third thousand took less than 1e-5 of the time
    EXPECT_TRUE(counts.isWithSeveral(0));
    EXPECT_FALSE(counts.isWithSeveral(1));
}

// With a body that gives way it turns back, however late.
TEST(MeetingCounts, WithABodyThatGivesWayTheyGoOnForLonger) {
    const auto meetingsUntilTheEnd = [](bool turnsBack) {
        MeetingCounts counts(2, 0);
        double time = 1, pause = 1e-4;
        std::size_t meetings = 1;
        while (!counts.meets(0, 1, turnsBack, time) && meetings < 100'000) {
            time += pause *= 0.9995;
            ++meetings;
        }
        return meetings;
    };
    EXPECT_LT(meetingsUntilTheEnd(false) + 5000, meetingsUntilTheEnd(true));
}

// From a start far from 0, too, and as often in an hour as in a millisecond.
TEST(MeetingCounts, WhatOpensAndClosesAtOnceIsRestless) {
    for (const double start : {0.0, -7.0, 5.0}) {
        MeetingCounts counts(1, start);
        double after = 1;
        int changes = 1;
        while (!counts.isRestless(0, start + after) && changes < 10'000) {
            after *= 1 + 1e-12;
            ++changes;
        }
        EXPECT_EQ(changes, 32) << start;
    }
}

} // namespace
} // namespace simulation
