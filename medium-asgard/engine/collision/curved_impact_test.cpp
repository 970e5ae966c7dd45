#include "collision/encounter_trials.h"
#include "collision/flying_body.h"
#include "collision/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace collision {
namespace {

using namespace geometry;

FlyingBody flying(const Part& part, const Vector& position, const Vector& velocity = Vector::Zero(),
                  const Vector& rotation = Vector::Zero()) {
    FlyingBody body;
    body.form.parts.push_back(part);
    body.position = position;
    body.velocity = velocity;
    body.attitude = fromRotationVector(rotation);
    return body;
}

Hit hitOf(const FlyingBody& one, const FlyingBody& other, double until = 10) {
    const Encounter met = timeOfImpact(one, other, {0, until});
    EXPECT_TRUE(met.hit);
    EXPECT_EQ(met.overlap, 0);
    return met.hit.value_or(Hit{});
}

void expectHit(const Hit& hit, double time, const Vector& point, const Vector& normal,
               double rounding = 1e-13) {
    EXPECT_NEAR(hit.time, time, 1e-14);
    EXPECT_FALSE(hit.isLost);
    EXPECT_LT((hit.contact.point - point).norm(), 1e-7) << hit.contact.point.transpose();
    EXPECT_LT((hit.contact.normal - normal.normalized()).norm(), rounding);
}

const FlyingBody& floor_() {
    static const FlyingBody body = flying(planePart(), Vector::Zero());
    return body;
}

TEST(CurvedImpact, OnAHalfSpaceIsWhenTheLowestPointArrives) {
    const Vector down(0.5, -2, 0);
    const double t = 1.5; // of all: the lowest point is 3 above the floor
    expectHit(hitOf(flying(spherePart(0.5), {0, 3.5, 0}, down), floor_()), t, {0.75, 0, 0},
              {0, 1, 0});
    expectHit(hitOf(flying(capsulePart(0.5, 2), {0, 3.5 + std::cos(0.3), 0}, down, {0, 0, 0.3}),
                    floor_()),
              t, {0.75 + std::sin(0.3), 0, 0}, {0, 1, 0});
    // Lying: a line; its middle is the point.
    expectHit(hitOf(flying(capsulePart(0.5, 2), {0, 3.5, 0}, down, {std::numbers::pi / 2, 0, 0}),
                    floor_()),
              t, {0.75, 0, 0}, {0, 1, 0});
    expectHit(hitOf(flying(cylinderPart(0.5, 2), {0, 3.5, 0}, down, {std::numbers::pi / 2, 0, 0}),
                    floor_()),
              t, {0.75, 0, 0}, {0, 1, 0});
    const double rim = std::cos(0.3) + 0.5 * std::sin(0.3);
    expectHit(hitOf(flying(cylinderPart(0.5, 2), {0, 3 + rim, 0}, down, {0, 0, 0.3}), floor_()), t,
              {0.75 + std::sin(0.3) - 0.5 * std::cos(0.3), 0, 0}, {0, 1, 0});
    // Upright: the whole end.
    expectHit(hitOf(flying(cylinderPart(0.5, 2), {0, 4, 0}, down), floor_()), t, {0.75, 0, 0},
              {0, 1, 0});
    expectHit(hitOf(flying(conePart(0.5, 2), {0, 4, 0}, down, {std::numbers::pi, 0, 0}), floor_()),
              t, {0.75, 0, 0}, {0, 1, 0});
    const double low = std::hypot(0.5 * std::sin(0.3), 2 * std::cos(0.3));
    expectHit(
        hitOf(flying(ellipsoidPart({0.5, 2, 1}), {0, 3 + low, 0}, down, {0, 0, 0.3}), floor_()), t,
        {0.75 + (4 - 0.25) * std::sin(0.3) * std::cos(0.3) / low, 0, 0}, {0, 1, 0});
}

TEST(CurvedImpact, UnderGravityIsTheRootOfTheParabola) {
    FlyingBody drum = flying(cylinderPart(0.5, 2), {0, 4, 0}, {1, 2, 0}, {0, 0, 0.3});
    drum.acceleration = {0, -9.81, 0};
    const double rim = std::cos(0.3) + 0.5 * std::sin(0.3);
    const double t = (2 + std::sqrt(4 + 2 * 9.81 * (4 - rim))) / 9.81;
    EXPECT_NEAR(hitOf(drum, floor_()).time, t, 1e-15);
}

// The lowest point of a capsule that turns in the air: h/2 |cos(a + w t)| + r.
TEST(CurvedImpact, OfACapsuleThatTurnsIsRightToRounding) {
    FlyingBody rod = flying(capsulePart(0.25, 2), {0, 3, 0}, {0, -1, 0});
    rod.spin = {0, 0, 1.7};
    double t = 1.5;
    for (int k = 0; k < 100; ++k) {
        const double gap = 3 - t - 0.25 - std::abs(std::cos(1.7 * t));
        const double sign = std::cos(1.7 * t) > 0 ? 1 : -1;
        t -= gap / (-1 + sign * 1.7 * std::sin(1.7 * t));
    }
    ASSERT_NEAR(3 - t - 0.25 - std::abs(std::cos(1.7 * t)), 0, 1e-15);
    const Hit hit = hitOf(rod, floor_());
    // It may hit before: the first root is what counts.
    double first = t;
    for (double s = 0; s < t; s += 1e-4)
        if (3 - s - 0.25 - std::abs(std::cos(1.7 * s)) < 0) {
            first = s;
            break;
        }
    EXPECT_NEAR(hit.time, first, first == t ? 1e-13 : 1e-4);
    EXPECT_NEAR(hit.contact.gap, 0, 1e-14);
}

// h/2 |cos a| + r |sin a| of a cylinder, along x and y of the disc's turning.
TEST(CurvedImpact, OfACoinThatTumblesTouchesWithItsRim) {
    FlyingBody coin = flying(cylinderPart(1, 0.2), {0, 5, 0}, {0.3, -1, 0}, {0, 0, 0.2});
    coin.spin = {0, 0, 0.9};
    const Hit hit = hitOf(coin, floor_());
    const double a = 0.2 + 0.9 * hit.time;
    const double low = 0.1 * std::abs(std::cos(a)) + std::abs(std::sin(a));
    EXPECT_NEAR(5 - hit.time - low, 0, 1e-14);
    EXPECT_GT(hit.contact.closingSpeed, 0);
    const Encounter before = timeOfImpact(coin, floor_(), {0, hit.time - 1e-9});
    EXPECT_FALSE(before.hit);
    EXPECT_LT(before.evaluations, 200u);
}

TEST(CurvedImpact, BetweenCurvedParts) {
    const Vector left(-1, 0, 0);
    expectHit(hitOf(flying(spherePart(0.5), {4.5, 0.3, 0}, left),
                    flying(cylinderPart(1, 2), Vector::Zero())),
              3, {1, 0.3, 0}, {1, 0, 0});
    expectHit(hitOf(flying(cylinderPart(1, 2), {5, 0, 0}, left),
                    flying(cylinderPart(1, 2), Vector::Zero(), Vector::Zero(),
                           {std::numbers::pi / 2, 0, 0})),
              3, {1, 0, 0}, {1, 0, 0});
    expectHit(hitOf(flying(ellipsoidPart({1, 2, 3}), {6, 0, 0}, left),
                    flying(ellipsoidPart({2, 1, 1}), Vector::Zero())),
              3, {2, 0, 0}, {1, 0, 0});
    const Vector n = Vector(0.3, 0.5, 0.4).normalized();
    const auto point = [&](const Vector& a) {
        return Vector(a.cwiseProduct(a).cwiseProduct(n) / a.cwiseProduct(n).norm());
    };
    const Vector there = point({2, 1, 1}), apart = there + point({1, 2, 3});
    expectHit(hitOf(flying(ellipsoidPart({1, 2, 3}), apart + 2 * n, -n),
                    flying(ellipsoidPart({2, 1, 1}), Vector::Zero())),
              2, there, n);
    // A rim across the edge of a box: the coin leans by 0.4 along the edge.
    const Part cube = polyhedronPart(
        box({2, 2, 2}), {Vector::Zero(), fromRotationVector({0, 0, std::numbers::pi / 4})});
    const double low = std::cos(0.4) + 0.05 * std::sin(0.4);
    const double side = std::sin(0.4) - 0.05 * std::cos(0.4); // of the lowest point along the edge
    expectHit(hitOf(flying(cylinderPart(1, 0.1), {0, std::sqrt(2) + 2 + low, 0}, {0, -1, 0},
                           {std::numbers::pi / 2 - 0.4, 0, 0}),
                    flying(cube, Vector::Zero())),
              2, {0, std::sqrt(2), side}, {0, 1, 0});
    // The tip of a cone on the tip of another: the line between them before.
    expectHit(hitOf(flying(conePart(1, 2), {0, 5, 0}, {0, -1, 0}, {std::numbers::pi, 0, 0}),
                    flying(conePart(1, 2), Vector::Zero())),
              3, {0, 1, 0}, {0, 1, 0}, 1e-9);
    EXPECT_FALSE(timeOfImpact(flying(conePart(1, 2), {1.2, 4, 0}, {0, -1, 0}),
                              flying(cylinderPart(0.15, 2), Vector::Zero()), {0, 10})
                     .hit);
}

TEST(CurvedImpact, AHalfSpaceThatTiltsHitsWhatIsFarFromItsPivot) {
    FlyingBody table = flying(planePart(), Vector::Zero());
    table.spin = {0, 0, 0.1};
    const FlyingBody ball = flying(spherePart(0.5), {10, 2, 0});
    const Hit hit = hitOf(ball, table);
    // -10 sin(0.1 t) + 2 cos(0.1 t) = 0.5
    const double t = 10 * (std::atan2(2, 10) - std::asin(0.5 / std::sqrt(104)));
    EXPECT_NEAR(hit.time, t, 1e-12);
    EXPECT_NEAR(hit.contact.closingSpeed, 0.1 * std::sqrt(104 - 0.25), 1e-9);
}

TEST(CurvedImpact, AgreesWithDenseSamplingOnRandomEncounters) {
    std::mt19937_64 random(20261123);
    std::size_t hits = 0, most = 0;
    for (int i = 0; i < 1500; ++i) {
        const Meeting meeting = drawCurvedMeeting(random);
        const MeetingResult result = checkMeeting(meeting);
        EXPECT_EQ(result.fault, "") << i;
        hits += result.hit;
        most = std::max(most, result.evaluations);
    }
    EXPECT_GT(hits, 300u);
    EXPECT_LT(most, 2000u);
}

TEST(CurvedImpact, WhatTouchesAndPartsDoesNotHit) {
    EXPECT_FALSE(timeOfImpact(flying(capsulePart(0.5, 2), {0, 0.5, 0}, {0, 1, 0},
                                     {std::numbers::pi / 2, 0, 0}),
                              floor_(), {0, 10})
                     .hit);
    EXPECT_FALSE(
        timeOfImpact(flying(ellipsoidPart({1, 2, 3}), {0, 2, 0}, {1, 0, 0}), floor_(), {0, 10})
            .hit);
    const Hit now = hitOf(flying(ellipsoidPart({1, 2, 3}), {0, 2, 0}, {1, -1, 0}), floor_());
    EXPECT_EQ(now.time, 0);
}

// Two rods lie across each other, part slowly while both turn out of the plane of their axes, and
// fall back onto each other. The gap is the distance of two lines.
TEST(CurvedImpact, OfSidesAndEdgesThatCrossAndTurnIsFoundInFewSteps) {
    const double r = 0.1, diagonal = r * std::sqrt(2.0);
    const Vector turned(0, std::numbers::pi / 4, 0); // about the length: an edge above and below
    const Part bar =
        polyhedronPart(box({2 * r, 2, 2 * r}), {Vector::Zero(), fromRotationVector(turned)});
    struct Rod {
        Part part;
        double round, sharp; // distances of the surface, and of the touching edge, from the axis
    };
    for (const Rod& rod :
         {Rod{capsulePart(r, 2), r, 0}, Rod{cylinderPart(r, 2), r, 0}, Rod{bar, 0, diagonal}}) {
        const double out = rod.round + rod.sharp;
        FlyingBody upper =
            flying(rod.part, {0, out, 0}, {0, 0.01, 0}, {0, 0, std::numbers::pi / 2});
        FlyingBody lower =
            flying(rod.part, {0, -out, 0}, Vector::Zero(), {std::numbers::pi / 2, 0, 0});
        upper.acceleration = {0, -0.05, 0};
        upper.spin = {0.1, 0.3, 0.6};
        lower.spin = {-0.4, 0.2, 0.1};
        // In the body's frame the edge that touches lies beside the axis; the rods are along y.
        const Vector ofUpper =
            fromRotationVector({0, 0, std::numbers::pi / 2}).conjugate() * Vector(0, -rod.sharp, 0);
        const Vector ofLower =
            fromRotationVector({std::numbers::pi / 2, 0, 0}).conjugate() * Vector(0, rod.sharp, 0);
        const auto gapAt = [&](double t) {
            const Pose a = poseAt(upper, t), b = poseAt(lower, t);
            Vector n = Vector(a.attitude * Vector::UnitY()).cross(b.attitude * Vector::UnitY());
            n.normalize();
            const double way = n.dot(a.toWorld(ofUpper) - b.toWorld(ofLower));
            return (n.y() > 0 ? way : -way) - 2 * rod.round;
        };
        const Encounter met = timeOfImpact(upper, lower, {0, 2});
        ASSERT_TRUE(met.hit);
        EXPECT_FALSE(met.hit->isLost);
        EXPECT_LT(met.evaluations, 100u);
        EXPECT_GT(met.hit->time, 0.1);
        EXPECT_NEAR(gapAt(met.hit->time), 0, 1e-14);
        for (int i = 1; i < 1000; ++i)
            EXPECT_GT(gapAt(met.hit->time * i / 1000), 0) << i;
    }
}

} // namespace
} // namespace collision
