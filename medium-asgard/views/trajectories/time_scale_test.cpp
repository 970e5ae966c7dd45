// The part of a motion's time that a scale shows.
#include "trajectories/time_scale.h"

#include <gtest/gtest.h>

namespace views {
namespace {

TEST(TimeScaleTest, ItFollowsTheMotionUntilSomebodyZooms) {
    TimeScale scale;
    scale.setRange(2, 6);
    EXPECT_EQ(scale.from(), 2);
    EXPECT_EQ(scale.to(), 6);
    EXPECT_TRUE(scale.zoom(0.5, 2));
    EXPECT_EQ(scale.from(), 2);
    EXPECT_EQ(scale.to(), 4);
    scale.setRange(2, 8);
    EXPECT_EQ(scale.to(), 4);
    EXPECT_TRUE(scale.pan(1));
    EXPECT_EQ(scale.from(), 3);
    EXPECT_FALSE(scale.shows(2.9));
    EXPECT_TRUE(scale.showAll(3, 5)); // within the motion
    scale.setRange(0, 9);
    EXPECT_EQ(scale.from(), 0); // it follows again
    EXPECT_EQ(scale.to(), 9);
}

TEST(TimeScaleTest, WhatReachesBeyondTheMotionHasRoom) {
    TimeScale scale;
    scale.setRange(0, 10);
    EXPECT_TRUE(scale.showAll(-10, 10));
    EXPECT_LT(scale.from(), -10);
    EXPECT_GT(scale.to(), 10);
    const double from = scale.from();
    scale.setRange(0, 11);
    EXPECT_EQ(scale.from(), from); // it does not follow
}

TEST(TimeScaleTest, NothingIsShownThatNumbersCannotTellApart) {
    TimeScale scale;
    scale.setRange(0, 10);
    EXPECT_FALSE(scale.zoom(1e-6, 5));
    EXPECT_FALSE(scale.zoom(1e6, 5));
    EXPECT_EQ(scale.from(), 0);
    EXPECT_EQ(scale.to(), 10);
    EXPECT_EQ(scale.timeAt(scale.along(7)), 7);
}

} // namespace
} // namespace views
