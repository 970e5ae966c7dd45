// Balls in tubes and bowls: gaps, and the first hit against gaps that are sampled densely.
#include "collision/encounter_trials.h"
#include "collision/hollow_separation.h"
#include "collision/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace collision {
namespace {

using geometry::bowlPart;
using geometry::spherePart;
using geometry::tubePart;

double between(std::mt19937_64& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Vector anyVector(std::mt19937_64& random) {
    return {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
}

Part drawPart(std::mt19937_64& random, double inner) {
    if (random() % 2)
        return geometry::capsulePart(between(random, 0.01, 0.3) * inner,
                                     between(random, 0.2, 3) * inner);
    const Vector edges = 0.7 * inner * anyVector(random).cwiseAbs() + Vector(0.05, 0.05, 0.05);
    return geometry::polyhedronPart(geometry::box(edges));
}

double gapOf(const Meeting& meeting) { // at the start
    WarmStart warm;
    const Part &ball = meeting.first.form.parts[0], &wall = meeting.second.form.parts[0];
    return separate({.part = &ball,
                     .rotation = meeting.first.attitude.toRotationMatrix(),
                     .offset = meeting.first.position},
                    {.part = &wall, .rotation = meeting.second.attitude.toRotationMatrix()}, warm)
        .gap;
}

// A ball near a hollow part, in it or before it, or one with edges, that goes as far as twice its
// size.
Meeting drawHollowMeeting(std::mt19937_64& random, bool hasEdges = false) {
    Meeting meeting;
    const bool isTube = random() % 2;
    const double inner = between(random, 0.5, 0.95);
    meeting.second.form = {
        {isTube ? tubePart(inner, 1, between(random, 0.3, 3)) : bowlPart(inner, 1)}};
    meeting.first.form = {
        {spherePart(between(random, 0.05, 0.9) * inner,
                    random() % 3 ? Vector(Vector::Zero()) : Vector(0.2 * anyVector(random)))}};
    if (hasEdges)
        meeting.first.form = {{drawPart(random, inner)}};
    meeting.first.attitude = geometry::fromRotationVector(3 * anyVector(random));
    meeting.second.attitude = geometry::fromRotationVector(3 * anyVector(random));
    if (random() % 2)
        meeting.first.spin = 5 * anyVector(random);
    if (random() % 3 == 0)
        meeting.second.spin = 3 * anyVector(random);
    const double speed = std::pow(10, between(random, -1, 2));
    meeting.until = 4 / speed;
    meeting.first.velocity = speed * anyVector(random).normalized();
    meeting.second.velocity = 0.3 * speed * anyVector(random);
    meeting.first.acceleration = 0.5 * speed * speed * anyVector(random);
    double gap = 0;
    for (int i = 0; gap < 1e-3 && i < 100; ++i) {
        meeting.first.position = (random() % 3 ? 0.4 : 2.5) * anyVector(random);
        gap = gapOf(meeting);
    }
    return meeting;
}

TEST(HollowSeparation, IsFromThePieceThatIsNearest) {
    const Part ball = spherePart(0.25), bowl = bowlPart(1, 1.5);
    WarmStart warm;
    const auto at = [&](const Vector& place) {
        return separate({.part = &ball, .rotation = Matrix::Identity(), .offset = place},
                        {.part = &bowl}, warm);
    };
    EXPECT_DOUBLE_EQ(at({0, -0.5, 0}).gap, 0.25);
    EXPECT_EQ(at({0, -0.5, 0}).normal, Vector(0, 1, 0));
    EXPECT_TRUE(at({0, -0.5, 0}).isInside);
    EXPECT_DOUBLE_EQ(at({0, -2, 0}).gap, 0.25);
    EXPECT_EQ(at({0, -2, 0}).normal, Vector(0, -1, 0));
    EXPECT_FALSE(at({0, -2, 0}).isInside);
    EXPECT_DOUBLE_EQ(at({1.2, 1, 0}).gap, 0.75);
    // Whose turn it is makes no difference.
    const Separation turned =
        separate({.part = &bowl},
                 {.part = &ball, .rotation = Matrix::Identity(), .offset = {0, -0.5, 0}}, warm);
    EXPECT_DOUBLE_EQ(turned.gap, 0.25);
    EXPECT_EQ(turned.normal, Vector(0, -1, 0));
}

TEST(HollowImpact, ABallThatFallsIntoABowlMeetsItsBottom) {
    FlyingBody ball = flyingSphere(0.1, {0.3, 2, 0});
    ball.acceleration = {0, -10, 0};
    FlyingBody bowl;
    bowl.form = {{bowlPart(1, 1.1)}};
    const Encounter met = timeOfImpact(ball, bowl, {0, 3});
    ASSERT_TRUE(met.hit);
    const double depth = std::sqrt(0.81 - 0.09);
    EXPECT_NEAR(met.hit->time, std::sqrt((2 + depth) / 5), 1e-14);
    EXPECT_NEAR((met.hit->contact.normal - Vector(-0.3, depth, 0) / 0.9).norm(), 0, 1e-13);
    EXPECT_NEAR((met.hit->contact.point - Vector(0.3, -depth, 0) / 0.9).norm(), 0, 1e-13);
    EXPECT_LT(met.evaluations, 40u);
}

// A ball that goes through a tube, and one that is thrown out of a bowl, meet nobody.
TEST(HollowImpact, WhatGoesThroughMeetsNobody) {
    FlyingBody tube;
    tube.form = {{tubePart(1, 1.1, 4)}};
    EXPECT_FALSE(timeOfImpact(flyingSphere(0.9, {0, -9, 0}, {0, 3, 0}), tube, {0, 6}).hit);
    FlyingBody bowl;
    bowl.form = {{bowlPart(1, 1.1)}};
    EXPECT_FALSE(timeOfImpact(flyingSphere(0.1, {0, -0.5, 0}, {0.1, 3, 0}), bowl, {0, 6}).hit);
}

TEST(HollowImpact, IsTheFirstInRandomMeetings) {
    std::mt19937_64 random(20);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const MeetingResult result = checkMeeting(drawHollowMeeting(random));
        EXPECT_EQ(result.fault, "") << "meeting " << i;
        hits += result.hit;
    }
    EXPECT_GT(hits, 1000);
}

TEST(HollowImpact, OfEdgesIsTheFirstInRandomMeetings) {
    std::mt19937_64 random(21);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Meeting meeting = drawHollowMeeting(random, true);
        if (gapOf(meeting) < 1e-3)
            continue; // no place was found
        const MeetingResult result = checkMeeting(meeting);
        EXPECT_EQ(result.fault, "") << "meeting " << i;
        hits += result.hit;
    }
    EXPECT_GT(hits, 300);
}

// With one end over the hollow.
TEST(HollowImpact, ARodThatFallsAcrossARimMeetsItWithItsSide) {
    FlyingBody rod, tube;
    rod.form = {{geometry::capsulePart(0.1, 1)}};
    rod.attitude = geometry::fromRotationVector({0, 0, std::numbers::pi / 2});
    rod.position = {1, 2, 0};
    rod.acceleration = {0, -10, 0};
    tube.form = {{tubePart(1, 1.2, 1)}};
    const Encounter met = timeOfImpact(rod, tube, {0, 3});
    ASSERT_TRUE(met.hit);
    EXPECT_NEAR(met.hit->time, std::sqrt(1.4 / 5), 1e-12);
    EXPECT_NEAR((met.hit->contact.normal - Vector(0, 1, 0)).norm(), 0, 1e-9);
    EXPECT_LT(met.evaluations, 60u);
}

// Of two faces and an edge over a rim: the edge crosses the circle at two places.
TEST(HollowSeparation, OfABoxAcrossARimIsFromItsEdges) {
    const Part box = geometry::polyhedronPart(geometry::box({0.4, 0.4, 0.4})),
               tube = tubePart(0.5, 0.6, 2);
    for (const double height : {1e-3, 1e-9, 0.0, -1e-9}) {
        const Posed over{
            .part = &box, .rotation = Matrix::Identity(), .offset = {0.5, 1.2 + height, 0}};
        const Separation found = separateHollow(over, {.part = &tube});
        EXPECT_NEAR(found.gap, height, 1e-15);
        EXPECT_NEAR((found.normal - Vector(0, 1, 0)).norm(), 0, 1e-9);
        std::size_t edges = 0;
        for (const BallAtWall& place : ballsAtWall(over, {.part = &tube}, 1e-2))
            edges += !place.vertex && std::abs(std::abs(place.separation.touch->z()) - 0.2) < 1e-9;
        EXPECT_EQ(edges, 4u) << height;
    }
    // An edge that goes through the wall.
    const Posed through{.part = &box, .rotation = Matrix::Identity(), .offset = {0.55, 0, 0}};
    EXPECT_LT(separateHollow(through, {.part = &tube}).gap, -0.09);
}

} // namespace
} // namespace collision
