#include "collision/time_of_impact.h"

#include "collision/encounter_trials.h"
#include "collision/flying_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision {
namespace {

constexpr double g = 10;

FlyingBody falling(FlyingBody body) {
    body.acceleration = {0, -g, 0};
    return body;
}

// Scenes of the reference set are named by their numbers.

TEST(TimeOfImpact, OfTwoSpheresIsExact) { // d12b
    const auto a = flyingSphere(0.5, {-2, 0, 0}, {1, 0, 0}), b = flyingSphere(0.5, {0, 0, 0});
    const Encounter e = timeOfImpact(a, b, {0, 3});
    ASSERT_TRUE(e.hit);
    EXPECT_EQ(e.hit->time, 1);
    EXPECT_EQ(e.hit->contact.normal, Vector(-1, 0, 0));
    EXPECT_EQ(e.hit->contact.point, Vector(-0.5, 0, 0));
    EXPECT_EQ(e.hit->contact.closingSpeed, 1);
    EXPECT_FALSE(e.hit->pressing);
}

TEST(TimeOfImpact, OfASphereOnAWideFloorHasNoRoundingFromItsCorners) { // d05
    const auto floor = flyingBox({4000, 1, 4000}, {0, -0.5, 0});
    auto ball = falling(flyingSphere(0.5, {0, 5.5, 0}));
    for (int bounce = 0; bounce < 200; ++bounce) {
        const Encounter e = timeOfImpact(ball, floor, {ball.since, ball.since + 10});
        ASSERT_TRUE(e.hit);
        ASSERT_NEAR(e.hit->time, 1 + 2 * bounce, 1e-12);
        ASSERT_EQ(e.hit->contact.normal, Vector(0, 1, 0));
        ball.moveTo(e.hit->time);
        ball.velocity = -ball.velocity;
    }
}

TEST(TimeOfImpact, FindsAGrazingHitAndNotTheMissBesideIt) { // d10, d10b
    const auto target = flyingSphere(0.5, {0, 0, 0});
    const auto hit =
        timeOfImpact(flyingSphere(0.5, {-3, 0.999999999, 0}, {2, 0, 0}), target, {0, 4});
    ASSERT_TRUE(hit.hit);
    EXPECT_NEAR(hit.hit->time, 1.4999776393202306, 1e-11);
    EXPECT_NEAR(hit.hit->contact.closingSpeed, 2 * 4.4721359538815455e-5, 1e-11);
    EXPECT_FALSE(
        timeOfImpact(flyingSphere(0.5, {-3, 1.000000001, 0}, {2, 0, 0}), target, {0, 4}).hit);
}

TEST(TimeOfImpact, OfASphereOnACornerOfABox) { // d07
    const auto sphere = flyingSphere(0.3, {4.05, 2.47, -1.73}, {-3, -2, 1});
    auto box = flyingBox({2, 1, 1.5}, {0, 0, 0});
    box.attitude = Quaternion(0.8, 0, 0.6, 0);
    const Encounter e = timeOfImpact(sphere, box, {0, 3});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 0.926373395996375, 1e-14);
    EXPECT_LT((e.hit->contact.normal -
               Vector(0.9029327067029166, 0.39084402669083324, -0.17875534667874995))
                  .norm(),
              1e-13);
    EXPECT_LT((e.hit->contact.point - Vector(1, 0.5, -0.75)).norm(), 1e-13);
    EXPECT_LT(e.evaluations, 20u);
}

TEST(TimeOfImpact, OfACubeFallingOnItsCornerHasTheFloorsNormal) { // d08
    const auto slab = flyingBox({100, 2, 100}, {0, -1, 0});
    auto cube = falling(flyingBox({1, 1, 1}, {0, 1.5, 0}));
    cube.attitude = Quaternion(0.8, 0.36, 0.48, 0);
    const Encounter e = timeOfImpact(cube, slab, {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 0.3657321424211987, 1e-14);
    EXPECT_EQ(e.hit->contact.normal, Vector(0, 1, 0));
    EXPECT_LT((e.hit->contact.point - Vector(-0.0584, 0, 0.236)).norm(), 1e-14);
}

TEST(TimeOfImpact, OfABoxLandingFlatIsOneContactAtTheCentreOfItsPatch) { // d08b
    const auto slab = flyingBox({100, 2, 100}, {0, -1, 0});
    const auto box = falling(flyingBox({2, 1, 1.5}, {0, 1.75, 0}));
    const Encounter e = timeOfImpact(box, slab, {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 0.5, 1e-15);
    EXPECT_EQ(e.hit->contact.patch.size(), 4u);
    EXPECT_LT(e.hit->contact.point.norm(), 1e-14);
    EXPECT_EQ(contactsAt(box, slab, e.hit->time, 1e-9).size(), 1u);
}

TEST(TimeOfImpact, OfABoxOverhangingAnEdgeIsAtTheCentreOfWhatTouches) {
    const auto table = flyingBox({2, 1, 2}, {0, -0.5, 0});
    const auto box = falling(flyingBox({1, 1, 1}, {1.25, 1.5, 0}));
    const Encounter e = timeOfImpact(box, table, {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_EQ(e.hit->contact.normal, Vector(0, 1, 0));
    EXPECT_LT((e.hit->contact.point - Vector(0.875, 0, 0)).norm(), 1e-14);
}

TEST(TimeOfImpact, OfASpinningRodAndASphere) { // d11
    auto rod = flyingBox({2, 0.1, 0.1}, {0, 0, 0});
    rod.spin = {0, 0, 3};
    const auto sphere = flyingSphere(0.2, {0.5, 0.5, 0});
    const Encounter e = timeOfImpact(rod, sphere, {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 0.14134367983024684, 1e-13);
    EXPECT_LT((e.hit->contact.normal - Vector(0.4114378277661476, -0.9114378277661477, 0)).norm(),
              1e-12);
    EXPECT_LT((e.hit->contact.point - Vector(0.5822875655532296, 0.3177124344467705, 0)).norm(),
              1e-12);
    EXPECT_LT(e.evaluations, 40u);
}

TEST(TimeOfImpact, OfAThousandMetresPerSecondAgainstAMillimetre) { // d09, for boxes too
    const auto plate = flyingBox({0.001, 10, 10}, {0, 0, 0});
    const auto ball = flyingSphere(0.01, {-500, 0, 0}, {1000, 0, 0});
    const auto cube = flyingBox({0.02, 0.02, 0.02}, {-500, 0, 0}, {1000, 0, 0});
    for (const FlyingBody* body : {&ball, &cube}) {
        const Encounter e = timeOfImpact(*body, plate, {0, 1});
        ASSERT_TRUE(e.hit);
        EXPECT_NEAR(e.hit->time, (500 - 0.0105) / 1000, 1e-15);
        EXPECT_LT(e.evaluations, 10u);
    }
}

TEST(TimeOfImpact, OfCrossingEdgesHasTheirCommonPerpendicular) {
    auto lower = flyingBox({2, 1, 1}, {0, 0, 0});
    lower.attitude = geometry::fromRotationVector({M_PI / 4, 0, 0}); // an edge up, along x
    auto upper = flyingBox({1, 1, 2}, {0.1, 3, 0.2}, {0, -1, 0});
    upper.attitude = geometry::fromRotationVector({0, 0, M_PI / 4}); // an edge down, along z
    const Encounter e = timeOfImpact(upper, lower, {0, 3});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 3 - std::sqrt(2.0), 1e-14);
    EXPECT_LT((e.hit->contact.normal - Vector(0, 1, 0)).norm(), 1e-14);
    EXPECT_LT((e.hit->contact.point - Vector(0.1, std::sqrt(0.5), 0.0)).norm(), 1e-14);
}

TEST(TimeOfImpact, OfParallelEdgesIsAtTheMiddleOfTheirCommonStretch) {
    auto lower = flyingBox({2, 1, 1}, {0, 0, 0});
    lower.attitude = geometry::fromRotationVector({M_PI / 4, 0, 0});
    auto upper = flyingBox({2, 1, 1}, {1, 3, 0}, {0, -1, 0});
    upper.attitude = geometry::fromRotationVector({M_PI / 4, 0, 0});
    const Encounter e = timeOfImpact(upper, lower, {0, 3});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 3 - std::sqrt(2.0), 1e-14);
    EXPECT_LT((e.hit->contact.normal - Vector(0, 1, 0)).norm(), 1e-8);
    EXPECT_LT((e.hit->contact.point - Vector(0.5, std::sqrt(0.5), 0)).norm(), 1e-8);
}

TEST(TimeOfImpact, OfVerticesIsAlongTheLineBetweenThemJustBefore) {
    const auto still = flyingBox({1, 1, 1}, {0, 0, 0});
    const auto moving = flyingBox({1, 1, 1}, {3, 3, 3}, {-1, -1, -1});
    const Encounter e = timeOfImpact(moving, still, {0, 3});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 2, 1e-14);
    EXPECT_LT((e.hit->contact.normal - Vector(1, 1, 1).normalized()).norm(), 1e-8);
    EXPECT_LT((e.hit->contact.point - Vector(0.5, 0.5, 0.5)).norm(), 1e-9);
}

TEST(TimeOfImpact, TouchingAndPartingIsNoHitAndTouchingAndApproachingIsOneAtOnce) {
    for (double roundOff : {0.0, 1e-16, -1e-16, 1e-13, -1e-13}) {
        const auto floor = flyingBox({100, 1, 100}, {0, -0.5, 0});
        auto box = falling(flyingBox({1, 1, 1}, {0, 0.5 + roundOff, 0}, {0, 5, 0}));
        const Encounter up = timeOfImpact(box, floor, {0, 3});
        ASSERT_TRUE(up.hit);
        EXPECT_NEAR(up.hit->time, 1, 1e-12); // it comes back
        EXPECT_FALSE(timeOfImpact(box, floor, {0, 0.9}).hit);
        EXPECT_EQ(up.overlap, 0);
        box.velocity = {0, -5, 0};
        const Encounter down = timeOfImpact(box, floor, {0, 3});
        ASSERT_TRUE(down.hit);
        EXPECT_NEAR(down.hit->time, 0, 1e-12);

        auto ball = flyingSphere(0.5, {1 + roundOff, 0, 0}, {1, 0, 0});
        const auto other = flyingSphere(0.5, {0, 0, 0});
        EXPECT_FALSE(timeOfImpact(ball, other, {0, 100}).hit);
        ball.velocity = {-1, 0, 0};
        EXPECT_NEAR(timeOfImpact(ball, other, {0, 100}).hit->time, 0, 1e-12);
    }
}

// The speeds of a piece that lasts for a few doubles are rounding.
TEST(TimeOfImpact, AnApproachOfLessThanRoundingIsNone) {
    const auto standing = flyingBox({1, 1, 1}, {0, 0, 0});
    const auto other = flyingBox({1, 1, 1}, {1, 0, 0}, {-0.003, 0, 0});
    EXPECT_FALSE(timeOfImpact(other, standing, {0, 4e-15}).hit);
    const Encounter e = timeOfImpact(other, standing, {0, 1e-9});
    ASSERT_TRUE(e.hit);
    EXPECT_EQ(e.hit->time, 0);
}

TEST(TimeOfImpact, PressingIsToldFromHitting) {
    const auto floor = flyingBox({100, 1, 100}, {0, -0.5, 0});
    for (const FlyingBody& body : {falling(flyingBox({1, 1, 1}, {0, 0.5, 0}, {1, 0, 0})),
                                   falling(flyingSphere(0.5, {0, 0.5, 0}))}) {
        const Encounter e = timeOfImpact(body, floor, {0, 1});
        ASSERT_TRUE(e.hit);
        EXPECT_TRUE(e.hit->pressing);
        EXPECT_EQ(e.hit->time, 0);
    }
    auto sphere = flyingSphere(0.5, {1, 0, 0});
    sphere.acceleration = {-1, 0, 0};
    const Encounter e = timeOfImpact(sphere, flyingSphere(0.5, {0, 0, 0}), {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_TRUE(e.hit->pressing);
}

TEST(TimeOfImpact, SlidingAlongAFaceIsNoHit) {
    const auto floor = flyingBox({100, 1, 100}, {0, -0.5, 0});
    const auto box = flyingBox({1, 1, 1}, {-20, 0.5, 0}, {1, 0, 0});
    const Encounter e = timeOfImpact(box, floor, {0, 30});
    EXPECT_FALSE(e.hit);
    EXPECT_LT(e.evaluations, 10u);
}

TEST(TimeOfImpact, ShapesThatOverlapAtFirstHitOnlyAfterTheySeparated) {
    const auto wall = flyingBox({1, 10, 10}, {0, 0, 0});
    auto box = flyingBox({1, 1, 1}, {0.75, 0, 0}, {2, 0, 0});
    box.acceleration = {-2, 0, 0};
    const Encounter e = timeOfImpact(box, wall, {0, 5});
    EXPECT_NEAR(e.overlap, 0.25, 1e-15);
    ASSERT_TRUE(e.hit); // x = 0.75 + 2t - t^2 comes back to 1
    EXPECT_NEAR(e.hit->time, 1 + std::sqrt(0.75), 1e-12);

    auto ball = flyingSphere(0.5, {0.75, 0, 0}, {2, 0, 0});
    ball.acceleration = {-2, 0, 0};
    const Encounter s = timeOfImpact(ball, flyingSphere(0.5, {0, 0, 0}), {0, 5});
    EXPECT_NEAR(s.overlap, 0.25, 1e-15);
    ASSERT_TRUE(s.hit);
    EXPECT_NEAR(s.hit->time, 1 + std::sqrt(0.75), 1e-12);
}

TEST(TimeOfImpact, AHitExactlyAtTheEndOfTheIntervalIsNotLost) {
    const auto floor = flyingBox({100, 1, 100}, {0, -0.5, 0});
    for (const FlyingBody& body :
         {falling(flyingBox({1, 1, 1}, {0, 5.5, 0})), falling(flyingSphere(0.5, {0, 5.5, 0}))}) {
        int hits = 0;
        double t = 0;
        for (double end : {0.5, 1.0, 1.5})
            if (const Encounter e = timeOfImpact(body, floor, {t, end}); e.hit && hits == 0) {
                ++hits;
                EXPECT_NEAR(e.hit->time, 1, 1e-15);
            } else {
                t = end;
            }
        EXPECT_EQ(hits, 1);
    }
}

TEST(TimeOfImpact, OfATwoFootedBodyLandingFlatGivesBothContacts) {
    FlyingBody table;
    table.form.parts.push_back(geometry::polyhedronPart(geometry::box({0.2, 1, 0.2}),
                                                        {{-1, 0, 0}, Quaternion::Identity()}));
    table.form.parts.push_back(geometry::polyhedronPart(geometry::box({0.2, 1, 0.2}),
                                                        {{1, 0, 0}, Quaternion::Identity()}));
    table.position = {0, 2.5, 0};
    table.velocity = {0, -1, 0};
    const auto floor = flyingBox({100, 1, 100}, {0, -0.5, 0});
    const Encounter e = timeOfImpact(table, floor, {0, 10});
    ASSERT_TRUE(e.hit);
    EXPECT_EQ(e.hit->time, 2);
    const auto contacts = contactsAt(table, floor, e.hit->time, 1e-9);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_LT((contacts[0].point - Vector(-1, 0, 0)).norm(), 1e-15);
    EXPECT_LT((contacts[1].point - Vector(1, 0, 0)).norm(), 1e-15);
}

TEST(TimeOfImpact, FarFromTheOriginIsAsGoodAsCoordinatesAreThere) {
    const Vector away(1e6, -1e6, 1e6);
    auto rod = flyingBox({2, 0.1, 0.1}, away);
    rod.spin = {0, 0, 3};
    const auto sphere = flyingSphere(0.2, away + Vector(0.5, 0.5, 0));
    const Encounter e = timeOfImpact(rod, sphere, {0, 1});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 0.14134367983024684, 1e-9);
}

TEST(TimeOfImpact, GrazingPassesOfSpinningBodiesStayCheap) {
    // The tip of the rod sweeps past the plane of the wall, 1e-9 short of it and 1e-9 beyond.
    for (double beyond : {-1e-9, 1e-9}) {
        auto rod = flyingBox({2, 0.1, 0.1}, {0, 0, 0});
        rod.spin = {0, 0, 3};
        const double reach = std::hypot(1, 0.05);
        const auto wall = flyingBox({10, 1, 10}, {0, reach + 0.5 - beyond, 0});
        const Encounter e = timeOfImpact(rod, wall, {0, 1});
        EXPECT_EQ(e.hit.has_value(), beyond > 0);
        EXPECT_LT(e.evaluations, 200u);
    }
}

TEST(TimeOfImpact, MissesAndInventsNothingInFastEncounters) {
    std::mt19937_64 random(20261120);
    std::size_t hits = 0, most = 0;
    for (int i = 0; i < 3'000; ++i) {
        const MeetingResult result = checkMeeting(drawMeeting(random));
        EXPECT_EQ(result.fault, "") << "meeting " << i;
        hits += result.hit;
        most = std::max(most, result.evaluations);
    }
    EXPECT_GT(hits, 500u);
    EXPECT_LT(most, 3000u); // of gaps; the fastest spin turns many times during a meeting
}

} // namespace
} // namespace collision
