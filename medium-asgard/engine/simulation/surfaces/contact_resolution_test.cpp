// The thresholds of contact in their order, from rounding to accuracy.
#include "surfaces/contact_resolution.h"

#include "collision/contact.h"

#include <gtest/gtest.h>

namespace simulation {
namespace {

using namespace resolution;

// What an impact leaves, and what hops that the search may miss, open no contact at rest.
static_assert(collision::touchingGap < leastGap);
static_assert(leastHop < leastGap);
static_assert(ofPlaces < deep && deep < ofMotion && ofMotion < collision::approachThreshold);
// Boxes hold all that counts as in contact.
static_assert(searchedGap >= 2 * mostGap);

ContactResolution at(double accuracy, double part, bool isNudged = false) {
    return resolutionFor({.accuracy = accuracy,
                          .firstTolerance = accuracy / 2,
                          .tolerance = part * accuracy / 2,
                          .isNudged = isNudged});
}

TEST(ContactResolution, FollowsTheAccuracyWithinItsBounds) {
    EXPECT_DOUBLE_EQ(at(1e-5, 1).gap, 1e-7);
    EXPECT_DOUBLE_EQ(at(1e-2, 1).gap, mostGap);
    EXPECT_DOUBLE_EQ(at(1e-9, 1).gap, leastGap);
    EXPECT_DOUBLE_EQ(at(1e-4, 1).hopHeight, 1e-7);
    EXPECT_DOUBLE_EQ(at(1e-2, 1).beyond, mostGap);
    EXPECT_DOUBLE_EQ(at(1e-9, 1).beyond, 1e-11);
    for (const double accuracy : {1e-2, 1e-5, 1e-8})
        EXPECT_LE(at(accuracy, 1.0 / 8).beyond, at(accuracy, 1.0 / 8).gap);
}

// Runs that are compared leave out hops of different heights.
TEST(ContactResolution, FollowsTheSquareOfTheTolerance) {
    EXPECT_DOUBLE_EQ(at(1e-4, 1.0 / 8).hopHeight, 1e-7 / 64);
    EXPECT_DOUBLE_EQ(at(1e-4, 1e-5).hopHeight, 1e-7 * finest);
    EXPECT_DOUBLE_EQ(at(1e-4, 1.0 / 8, true).hopHeight, 1e-7 / 64 * nudgedPart);
    EXPECT_DOUBLE_EQ(at(1e-4, 1).hopHeight, at(1e-4, 2).hopHeight);
    EXPECT_GE(at(1e-4, 1e-5, true).gap, leastGap);
}

// The depth of balls side by side has no jump where the fourth root begins.
TEST(ContactResolution, OfBallsSideBySideFollowsTheToleranceThenItsFourthRoot) {
    EXPECT_DOUBLE_EQ(at(1e-4, 1).depth, besideDepth);
    EXPECT_DOUBLE_EQ(at(1e-4, 0.1).depth, besideDepth / 10);
    EXPECT_NEAR(at(1e-4, fineBesideDepth).depth, at(1e-4, 0.999999 * fineBesideDepth).depth,
                1e-6 * besideDepth * fineBesideDepth);
    EXPECT_DOUBLE_EQ(at(1e-4, fineBesideDepth / 16).depth, besideDepth * fineBesideDepth / 2);
}

} // namespace
} // namespace simulation
