#include "playing/playback.h"

#include <gtest/gtest.h>

namespace playing {
namespace {

using std::chrono::milliseconds;

const Instant zero{};

Playback playbackOf(Span span) {
    Playback playback;
    playback.setSpan(span, zero);
    return playback;
}

TEST(Playback, FollowsTheClockAtItsRateAndStopsAtTheFinish) {
    Playback playback = playbackOf({1, 5, 5});
    EXPECT_EQ(playback.time(zero), 1);
    playback.play(zero);
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(1500)), 2.5);
    playback.setRate(2, false, zero + milliseconds(1500));
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(2000)), 3.5);
    EXPECT_FALSE(playback.advance(zero + milliseconds(2000)));
    EXPECT_TRUE(playback.advance(zero + milliseconds(9000)));
    EXPECT_FALSE(playback.playing());
    EXPECT_EQ(playback.time(zero + milliseconds(9500)), 5);
}

TEST(Playback, PlaysFromTheStartAgainAtTheFinish) {
    Playback playback = playbackOf({0, 2, 2});
    playback.seek(7, zero);
    EXPECT_EQ(playback.time(zero), 2);
    playback.play(zero);
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(500)), 0.5);
}

TEST(Playback, LoopsWithoutLosingTime) {
    Playback playback = playbackOf({0, 2, 2});
    playback.setRate(1, true, zero);
    playback.play(zero);
    EXPECT_FALSE(playback.advance(zero + milliseconds(4500)));
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(4500)), 0.5);
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(5000)), 1.0);
}

TEST(Playback, WaitsForTheMotionAndGoesOnFromThere) {
    Playback playback = playbackOf({0, 10, 1});
    playback.play(zero);
    EXPECT_EQ(playback.time(zero + milliseconds(3000)), 1);
    playback.advance(zero + milliseconds(3000));
    playback.setSpan({0, 10, 10}, zero + milliseconds(3000));
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(3500)), 1.5); // not 3.5
    EXPECT_TRUE(playback.playing());
}

TEST(Playback, ASeekBeforeAnythingIsKnownIsCarriedOutWhenItIs) {
    Playback playback;
    playback.seek(4, zero);
    playback.play(zero);
    playback.setSpan({0, 10, 0}, zero + milliseconds(200)); // the scene, nothing of its motion
    EXPECT_EQ(playback.time(zero + milliseconds(200)), 0);
    playback.advance(zero + milliseconds(200));
    playback.setSpan({0, 10, 3}, zero + milliseconds(200));
    playback.advance(zero + milliseconds(200));
    EXPECT_EQ(playback.time(zero + milliseconds(200)), 3);
    playback.setSpan({0, 10, 10}, zero + milliseconds(200));
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(700)), 4.5);
    EXPECT_TRUE(playback.playing());
    Playback beyond;
    beyond.seek(99, zero);
    beyond.setSpan({0, 10, 10}, zero);
    EXPECT_EQ(beyond.time(zero), 10);
}

TEST(Playback, ASoughtTimeIsKeptWhileItIsNotComputedYet) {
    Playback playback = playbackOf({0, 10, 1});
    playback.seek(4, zero);
    EXPECT_EQ(playback.time(zero), 1);
    playback.setSpan({0, 10, 6}, zero);
    EXPECT_EQ(playback.time(zero), 4);
}

TEST(Playback, PlaysAMotionThatComesLaterFromItsStart) {
    Playback playback;
    playback.play(zero);
    EXPECT_FALSE(playback.advance(zero + milliseconds(100)));
    EXPECT_TRUE(playback.playing());
    playback.setSpan({3, 9, 9}, zero + milliseconds(700));
    EXPECT_DOUBLE_EQ(playback.time(zero + milliseconds(1700)), 4);
}

TEST(Playback, AnEditThatShortensTheMotionMovesTimeIntoIt) {
    Playback playback = playbackOf({0, 10, 10});
    playback.seek(8, zero);
    playback.setSpan({0, 3, 3}, zero);
    EXPECT_EQ(playback.time(zero), 3);
    Playback empty = playbackOf({2, 2, 2});
    empty.play(zero);
    EXPECT_FALSE(empty.playing());
}

TEST(Playback, StepsLandOnWholeMultiples) {
    Playback playback = playbackOf({0, 10, 10});
    EXPECT_NEAR(playback.stepLength(), 0.04, 1e-12);
    playback.play(zero);
    playback.step(1, zero + milliseconds(100));
    EXPECT_FALSE(playback.playing());
    EXPECT_NEAR(playback.time(zero), 0.12, 1e-12);
    playback.step(-1, zero);
    EXPECT_NEAR(playback.time(zero), 0.08, 1e-12);
    playback.step(-10, zero);
    EXPECT_EQ(playback.time(zero), 0);
    playback.setSpan({0, 10, 0.1}, zero);
    playback.step(10, zero);
    EXPECT_EQ(playback.time(zero), 0.1);
    EXPECT_LT(playbackOf({0, 1e-3, 1e-3}).stepLength(), 1e-4);
    EXPECT_GE(playbackOf({0, 1e5, 1e5}).stepLength(), 100);
}

TEST(Playback, StopsAtTheStart) {
    Playback playback = playbackOf({1, 5, 5});
    playback.play(zero);
    playback.stop(zero + milliseconds(1500));
    EXPECT_FALSE(playback.playing());
    EXPECT_EQ(playback.time(zero + milliseconds(2500)), 1);
}

} // namespace
} // namespace playing
