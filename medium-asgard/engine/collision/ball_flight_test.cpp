// The closed forms against the general search, which knows nothing of flights.
#include "collision/ball_flight.h"

#include "collision/flying_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace collision {
namespace {

FlyingBody bodyOf(const BallFlight& flight) {
    FlyingBody body = flyingSphere(flight.radius, flight.place, flight.velocity);
    body.acceleration = 2 * flight.half;
    body.since = flight.from;
    return body;
}

struct Tally {
    int hits = 0, misses = 0, unclear = 0;

    void compare(const FlightMeeting& met, const Encounter& encounter) {
        if (met.kind == FlightMeeting::Kind::unclear) {
            ++unclear;
            return;
        }
        const bool isHit = met.kind == FlightMeeting::Kind::hit;
        ASSERT_EQ(isHit, encounter.hit.has_value());
        ++(isHit ? hits : misses);
        if (isHit) {
            ASSERT_NEAR(met.time, encounter.hit->time, 1e-11);
        }
    }
};

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vector vector(double most) {
        return {number(-most, most), number(-most, most), number(-most, most)};
    }
    BallFlight flight(const Vector& half) {
        return {number(-0.1, 0), vector(1.5), vector(3), half, number(0.1, 0.5)};
    }

private:
    std::mt19937_64 random_;
};

TEST(BallFlight, BallsMeetWhenTheGeneralSearchSaysSo) {
    Draw draw(11);
    Tally tally;
    for (int i = 0; i < 20'000; ++i) {
        const Vector half = i % 2 ? Vector::Zero() : draw.vector(5);
        const BallFlight a = draw.flight(half), b = draw.flight(half);
        if ((a.centreAt(0) - b.centreAt(0)).norm() < a.radius + b.radius)
            continue;
        const Interval during{0, draw.number(0.1, 2)};
        tally.compare(meetingOf(a, b, during), timeOfImpact(bodyOf(a), bodyOf(b), during));
        if (HasFatalFailure())
            FAIL() << "case " << i;
    }
    EXPECT_GT(tally.hits, 500) << tally.misses << " misses, " << tally.unclear << " unclear";
    EXPECT_GT(tally.misses, 1000);
    EXPECT_LT(tally.unclear, tally.hits / 2);
}

TEST(BallFlight, BallsMeetFacesWhenTheGeneralSearchSaysSo) {
    Draw draw(12);
    Tally tally;
    for (int i = 0; i < 10'000; ++i) {
        const BallFlight ball = draw.flight(i % 2 ? Vector::Zero() : draw.vector(5));
        FlyingBody box =
            flyingBox(draw.vector(1.2).cwiseAbs() + Vector::Constant(0.1), draw.vector(1.5));
        box.attitude = geometry::fromRotationVector(draw.vector(3));
        const StandingPart part = standingPart(box.form.parts[0], {box.position, box.attitude});
        const Interval during{0, draw.number(0.1, 2)};
        const Encounter encounter = timeOfImpact(bodyOf(ball), box, during);
        if (encounter.overlap > 0)
            continue;
        tally.compare(meetingOf(ball, part, during), encounter);
        if (HasFatalFailure())
            FAIL() << "case " << i;
    }
    EXPECT_GT(tally.hits, 100) << tally.misses << " misses, " << tally.unclear << " unclear";
    EXPECT_GT(tally.misses, 1000);
    EXPECT_LT(tally.unclear, 1000);
}

// After a bounce the ball touches and leaves; under gravity it comes back, without it never.
TEST(BallFlight, WhatBouncedComesBackOnlyWhenItIsPushed) {
    const FlyingBody floor = flyingBox({10, 1, 10}, {0, -0.5, 0});
    const StandingPart part = standingPart(floor.form.parts[0], {floor.position, floor.attitude});
    BallFlight ball{1.5, {0, 0.25, 0}, {0.1, 3, 0}, Vector::Zero(), 0.25};
    EXPECT_EQ(meetingOf(ball, part, {1.5, 9}).kind, FlightMeeting::Kind::none);
    ball.half = {0, -5, 0};
    const FlightMeeting back = meetingOf(ball, part, {1.5, 9});
    ASSERT_EQ(back.kind, FlightMeeting::Kind::hit);
    EXPECT_NEAR(back.time, 1.5 + 0.6, 1e-15);
    ball.velocity.y() = 1e-9; // too low a hop for a formula
    EXPECT_EQ(meetingOf(ball, part, {1.5, 9}).kind, FlightMeeting::Kind::unclear);
}

TEST(BallFlight, ContactsAreThoseOfTheShapes) {
    const BallFlight a{0, {1, 0, 0}, Vector::Zero(), Vector::Zero(), 0.5};
    const BallFlight b{0, {0, 0, 0}, Vector::Zero(), Vector::Zero(), 0.5};
    const FlightContact met = contactOf(a.placedAt(3), b.placedAt(3), 1e-10);
    ASSERT_EQ(met.kind, FlightContact::Kind::contact);
    EXPECT_EQ(met.point, Vector(0.5, 0, 0));
    EXPECT_EQ(met.normal, Vector(1, 0, 0));
    const FlyingBody box = flyingBox({2, 2, 2}, {0, -1.5, 0});
    const StandingPart part = standingPart(box.form.parts[0], {box.position, box.attitude});
    const FlightContact stood = contactOf(b.placedAt(3), part, 1e-10);
    ASSERT_EQ(stood.kind, FlightContact::Kind::contact);
    EXPECT_EQ(stood.point, Vector(0, -0.5, 0));
    EXPECT_EQ(stood.normal, Vector(0, 1, 0));
    EXPECT_EQ(contactOf(a.placedAt(3), part, 1e-10).kind,
              FlightContact::Kind::unclear); // on the edge
}

} // namespace
} // namespace collision
