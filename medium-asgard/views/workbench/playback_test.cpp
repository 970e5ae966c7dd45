#include "views/test_workshop.h"
#include "workbench/playback.h"

#include <gtest/gtest.h>

namespace views {
namespace {

class PlaybackTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    PlaybackTest() {
        playback.setClock([this] { return now; });
        playback.setRange(0, 10, 10);
    }
    void pass(double seconds) {
        now += seconds;
        playback.advance();
    }

    double now = 100;
    Playback playback;
};

TEST_F(PlaybackTest, FollowsTheClockHoweverSeldomItIsAsked) {
    playback.play();
    pass(0.1);
    EXPECT_NEAR(playback.time(), 0.1, 1e-12);
    pass(3);
    EXPECT_NEAR(playback.time(), 3.1, 1e-12);
    playback.setRate(0.5);
    pass(1);
    EXPECT_NEAR(playback.time(), 3.6, 1e-12);
    playback.pause();
    pass(1);
    EXPECT_NEAR(playback.time(), 3.6, 1e-12);
}

TEST_F(PlaybackTest, EndsAtTheEndOrBeginsAgain) {
    playback.play();
    pass(11);
    EXPECT_EQ(playback.time(), 10);
    EXPECT_FALSE(playback.isPlaying());
    playback.play(); // from the start
    EXPECT_EQ(playback.time(), 0);
    playback.setLoops(true);
    pass(12);
    EXPECT_NEAR(playback.time(), 2, 1e-12);
    EXPECT_TRUE(playback.isPlaying());
    playback.stop();
    EXPECT_EQ(playback.time(), 0);
    EXPECT_FALSE(playback.isPlaying());
}

TEST_F(PlaybackTest, WaitsForMotionThatIsNotComputedYet) {
    playback.setRange(0, 10, 2);
    playback.play();
    pass(5);
    EXPECT_EQ(playback.time(), 2);
    EXPECT_TRUE(playback.isPlaying());
    pass(1);
    playback.setRange(0, 10, 10);
    pass(0.5);
    EXPECT_NEAR(playback.time(), 2.5, 1e-12);
}

TEST_F(PlaybackTest, WhatIsHeldGoesOnUnlessItWasStoppedMeanwhile) {
    int starts = 0;
    QObject::connect(&playback, &Playback::started, [&] { ++starts; });
    playback.play();
    playback.hold();
    pass(1);
    EXPECT_EQ(playback.time(), 0);
    playback.goOn();
    pass(1);
    EXPECT_NEAR(playback.time(), 1, 1e-12);
    EXPECT_EQ(starts, 2);
    playback.hold();
    playback.stop();
    playback.goOn();
    EXPECT_FALSE(playback.isPlaying());
    playback.hold(); // it did not play
    playback.goOn();
    EXPECT_FALSE(playback.isPlaying());
    EXPECT_EQ(starts, 2);
}

TEST_F(PlaybackTest, AnEditKeepsTheMomentThatIsShown) {
    playback.seek(4);
    playback.setRange(0, 10, 0.1); // computed anew
    EXPECT_EQ(playback.time(), 4);
    playback.setRange(0, 3, 3);
    EXPECT_EQ(playback.time(), 3);
}

TEST_F(PlaybackTest, StepsLandOnWholeMultiples) {
    EXPECT_NEAR(playback.stepLength(), 0.04, 1e-12);
    playback.seek(0.1);
    playback.step(1);
    EXPECT_NEAR(playback.time(), 0.12, 1e-12);
    playback.step(-1);
    EXPECT_NEAR(playback.time(), 0.08, 1e-12);
    playback.step(-10);
    EXPECT_EQ(playback.time(), 0);
    playback.setRange(0, 1e-3, 1e-3);
    EXPECT_LT(playback.stepLength(), 1e-4);
    playback.setRange(0, 1e5, 1e5);
    EXPECT_GE(playback.stepLength(), 100);
}

TEST_F(PlaybackTest, AMotionOfNoLengthDoesNothingBad) {
    playback.setRange(1, 1, 1);
    playback.setLoops(true);
    playback.play();
    pass(1);
    EXPECT_EQ(playback.time(), 1);
    playback.step(1);
    EXPECT_EQ(playback.time(), 1);
}

} // namespace
} // namespace views
