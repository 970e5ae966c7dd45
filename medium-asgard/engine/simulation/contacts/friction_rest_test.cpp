// Contact and friction at once: what `sign` of a speed holds on a slope stands still, at any
// accuracy and of any size, after a bounded number of impacts; and what it cannot hold slides.
#include "simulation/testing.h"

#include <cmath>
#include <tuple>

namespace simulation::testing {
namespace {

constexpr double slopes[] = {0.1, 0.4, 0.9};

struct Along { // what a ball does on a slope of the angle a, in its plane
    double along = 0, up = 0;
};

// A ball of unit size falls from the height h over a slope that leads down along x, with friction
// F sign(dx) along x: event by event.
class FrictionFall {
public:
    FrictionFall(double angle, double friction, double restitution)
        : t_(std::cos(angle), -std::sin(angle)), n_(std::sin(angle), std::cos(angle)),
          friction_(friction), e_(restitution) {}

    // Where it comes to rest, from (0, h) over the slope without speed.
    Along restsAt(double height) {
        at_ = {0, height};
        while (hop()) {
        }
        // Along the slope, until friction has stopped it; then it holds, if it is strong enough.
        const double speed = v_.dot(t_), decline = friction_ * t_.x() + g * t_.y();
        at_ += t_ * (speed * speed / (2 * decline));
        return {.along = at_.x(), .up = at_.y()};
    }

private:
    using Plane = Eigen::Vector2d;
    // A flight, whose speed along x friction lets end at 0, and the impact. False: the last.
    bool hop() {
        const double stops = std::abs(v_.x()) / friction_;
        const double decline = v_.x() > 0 ? -friction_ : friction_;
        const auto placeAt = [&](double time) {
            const double moving = std::min(time, stops);
            return Plane(at_ + Plane(v_.x() * moving + decline * moving * moving / 2,
                                     v_.y() * time - g * time * time / 2));
        };
        double low = 1e-15, high = 1e3;
        for (int i = 0; i < 200; ++i) {
            const double middle = (low + high) / 2;
            (placeAt(middle).dot(n_) > 0 ? low : high) = middle;
        }
        at_ = placeAt(low);
        v_ = {low < stops ? v_.x() + decline * low : 0, v_.y() - g * low};
        v_ -= (1 + e_) * n_ * v_.dot(n_);
        at_ -= n_ * n_.dot(at_);
        return e_ > 0 && v_.dot(n_) > 1e-9;
    }

    Plane t_, n_, at_ = Plane::Zero(), v_ = Plane::Zero();
    double friction_, e_;
};

// A slope through the origin that leads down along x, or along z, and a ball over it; the touching
// point of the ball moves in the plane through the origin. All lengths are times `size`.
class Slope {
public:
    SceneBuilder b;

    Slope(double angle, double restitution, double size, double accuracy, bool isAlongZ = false)
        : b(3, accuracy), size_(size), isAlongZ_(isAlongZ) {
        const Vector axis = isAlongZ ? Vector(Vector::UnitX()) : Vector(-Vector::UnitZ());
        const Quaternion tilt(Eigen::AngleAxisd(angle, axis));
        normal_ = tilt * Vector(Vector::UnitY());
        scene::Body& ramp =
            b.box("ramp", -size / 2 * normal_, Vector(100 * size, size, 100 * size));
        ramp.fixed = true;
        ramp.initialAttitude = tilt;
        ramp.restitution = restitution;
        b.ball("ball", {0, 0, 0}, 0.3 * size);
        b.weight("ball", {0, -g * size, 0});
    }
    void put(double height, double speed = 0) {
        const Vector down =
            isAlongZ_ ? Vector(0, -normal_.z(), normal_.y()) : Vector(normal_.y(), -normal_.x(), 0);
        b.scene.bodies[1].initialPosition = 0.3 * size_ * normal_ + Vector(0, height * size_, 0);
        b.scene.bodies[1].initialVelocity = speed * size_ * down;
    }
    void rub(double friction) {
        const std::string along = isAlongZ_ ? "dz" : "dx";
        const std::string text =
            "-" + std::to_string(friction * size_ * 1e6) + "*1e-6*sign(ball." + along + ")";
        b.force("ball", isAlongZ_ ? "0" : text, "0", isAlongZ_ ? text : "0");
    }
    Result run() { return simulate(b.scene); }
    // Of the touching point, in sizes.
    [[nodiscard]] Along placeIn(const Result& result, double time) const {
        const Vector p = result.motion->at(1, time).position / size_ - 0.3 * normal_;
        return {.along = isAlongZ_ ? p.z() : p.x(), .up = p.y()};
    }

private:
    Vector normal_ = Vector::UnitY();
    double size_;
    bool isAlongZ_;
};

using Case = std::tuple<double, double, double, bool>; // restitution, size, accuracy, along z
class Held : public ::testing::TestWithParam<Case> {};

TEST_P(Held, WhatFallsOnASlopeStandsStillWhereFrictionHoldsIt) {
    const auto [restitution, size, accuracy, isAlongZ] = GetParam();
    for (const double angle : slopes) {
        Slope slope(angle, restitution, size, accuracy, isAlongZ);
        slope.put(0.8);
        slope.rub(20);
        const Result result = slope.run();
        const Along expected = FrictionFall(angle, 20, restitution).restsAt(0.8);
        const Along early = slope.placeIn(result, 2.5), late = slope.placeIn(result, 3);
        EXPECT_NEAR(late.along, expected.along, 2 * accuracy) << angle;
        EXPECT_NEAR(late.up, expected.up, 2 * accuracy) << angle;
        EXPECT_NEAR(late.along, early.along, 1e-13) << angle; // it does not creep
        EXPECT_LT(result.motion->at(1, 3).velocity.norm(), 1e-13 * size) << angle;
        EXPECT_LT(result.statistics.collisions, 25u) << angle;
        EXPECT_LT(result.statistics.steps, 500u) << angle;
        EXPECT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
    }
}

INSTANTIATE_TEST_SUITE_P(Slopes, Held,
                         ::testing::Combine(::testing::Values(0.0, 0.3),
                                            ::testing::Values(1e-3, 1.0),
                                            ::testing::Values(1e-2, 1e-4, 1e-6, 1e-9),
                                            ::testing::Bool()));

// Laid on the slope at rest: it holds up to F = m g tan a, and slides with what is left over that.
TEST(FrictionRest, HoldsUpToTheTangentOfTheSlopeAndNoFurther) {
    for (const double angle : slopes)
        for (const double part : {0.0, 0.5, 1 - 1e-6, 1 + 1e-6, 2.0}) {
            Slope slope(angle, 0, 1, 1e-8);
            slope.put(0);
            const double friction = part * g * std::tan(angle);
            if (part > 0)
                slope.rub(friction);
            const Result result = slope.run();
            const double pull =
                std::max(0.0, g * std::sin(angle) - friction * std::cos(angle)); // down the slope
            EXPECT_NEAR(slope.placeIn(result, 3).along, pull * 4.5 * std::cos(angle), 1e-7)
                << angle << " " << part;
            EXPECT_EQ(result.statistics.collisions, 0u);
        }
}

// Up the slope, to a stop, and it stays there or comes back, as friction wills.
TEST(FrictionRest, WhatSlidesUpStaysWhereItStopsOrComesBack) {
    constexpr double angle = 0.4;
    for (const double friction : {2.0, 5.0}) {
        Slope slope(angle, 0, 1, 1e-8);
        slope.put(0, -2);
        slope.rub(friction);
        const Result result = slope.run();
        const double sine = g * std::sin(angle), rub = friction * std::cos(angle);
        const double stops = 2 / (sine + rub), high = 2 * stops / 2;
        const double back = std::max(0.0, sine - rub) * (3 - stops) * (3 - stops) / 2;
        EXPECT_NEAR(slope.placeIn(result, 3).along, (back - high) * std::cos(angle), 1e-7);
    }
}

// The speed along the slope, as an expression: friction acts along the slope and loads nothing.
TEST(FrictionRest, TheSignOfTheSpeedAlongTheSlopeHoldsToo) {
    constexpr double angle = 0.4;
    for (const double accuracy : {1e-2, 1e-6, 1e-9})
        for (const double friction : {3.0, 6.0}) { // 9.81 sin 0.4 = 3.82
            Slope slope(angle, 0.3, 1, accuracy);
            slope.put(0.8);
            const std::string sign =
                "sign(0.9210609940028851*ball.dx - 0.3894183423086505*ball.dy)";
            const std::string f = "-" + std::to_string(friction);
            slope.b.force("ball", f + "*0.9210609940028851*" + sign,
                          "-(" + f + ")*0.3894183423086505*" + sign, "0");
            const Result result = slope.run();
            const BodyState end = result.motion->at(1, 3);
            EXPECT_LT(result.statistics.collisions, 25u);
            const Along early = slope.placeIn(result, 2.5), late = slope.placeIn(result, 3);
            const double speed = (late.along - early.along) / 0.5 / std::cos(angle);
            if (friction > 4)
                EXPECT_NEAR(speed, 0, 1e-12);
            else
                EXPECT_GT(speed, 0.5);
            EXPECT_NEAR(late.along * std::sin(angle) + late.up * std::cos(angle), 0, 1e-9);
            EXPECT_EQ(friction > 4, end.velocity.norm() < 1e-12);
        }
}

// Friction k in the plane of the slope, as a unit vector; thrown across with the speed v it turns
// downwards, along which the slope pulls by F = g sin a < k. With s and c the speed and the cosine
// of its angle to that way, s^2 (C + 2 (k/F) C c + C c^2), C = F/(4 (F^2 - k^2)), has the rate s c,
// and so it comes to rest v^2 F/(4 (k^2 - F^2)) farther down; 2 k v^2/(4 k^2 - F^2) across
// likewise.
TEST(FrictionRest, WhatIsThrownAcrossASlopeTurnsAndRests) {
    constexpr double angle = 0.4, k = 6, v = 2;
    const double pull = g * std::sin(angle);
    const double down = v * v * pull / (4 * (k * k - pull * pull));
    const double across = 2 * k * v * v / (4 * k * k - pull * pull);
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8})
        for (const double speed : {v, 0.0}) {
            Slope slope(angle, 0, 1, accuracy);
            slope.put(0);
            slope.b.scene.bodies[1].initialVelocity = {0, 0, speed};
            const std::string unit = "/hypot(ball.dx,ball.dy,ball.dz)";
            slope.b.force("ball", "-6*ball.dx" + unit, "-6*ball.dy" + unit, "-6*ball.dz" + unit);
            const Result result = slope.run();
            ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
            const BodyState end = result.motion->at(1, 3);
            const double part = speed * speed / (v * v);
            EXPECT_NEAR(slope.placeIn(result, 3).along, part * down * std::cos(angle),
                        3 * accuracy);
            EXPECT_NEAR(end.position.z(), part * across, 3 * accuracy);
            EXPECT_LT(end.velocity.norm(), 1e-13);
            EXPECT_EQ(slope.placeIn(result, 3).along, slope.placeIn(result, 2).along);
            EXPECT_EQ(result.statistics.collisions, 0u);
            EXPECT_LT(result.statistics.steps, 300u);
        }
}

// A direction may count its parts otherwise: hypot(2 x, z) is the root of 4 x^2 + z^2.
TEST(FrictionRest, ADirectionHasWeights) {
    const auto pulled = [](const std::string& length) {
        SceneBuilder b(3, 1e-8);
        b.ball("ball", {0, 0, 0}, 0.3);
        b.force("ball", "-3*2*ball.dx/" + length + "+2*t", "0", "-3*ball.dz/" + length + "+2*t");
        return simulate(b.scene).motion->at(0, 3);
    };
    const BodyState by = pulled("hypot(2*ball.dx,ball.dz)");
    const BodyState as = pulled("sqrt(4*ball.dx^2+ball.dz^2)");
    EXPECT_GT(by.position.norm(), 0.1);
    EXPECT_LT((by.position - as.position).norm(), 1e-7);
}

// Hops between several contacts end, and so does the rattling of corners: three boxes on each
// other, each offset, with rebound. The floor is smooth, so that all three may drift.
TEST(FrictionRest, BoxesThatAreDroppedOnEachOtherLieFlat) {
    SceneBuilder b(0.8, 1e-5);
    b.floor();
    for (int i = 0; i < 3; ++i) {
        const std::string name = "b" + std::to_string(i);
        scene::Body& box = b.box(name, {0.1 * (i % 2), 0.6 + 1.1 * i, 0}, {1, 1, 1});
        box.restitution = 0.2;
        box.friction = 0.5;
        b.weight(name);
    }
    const Result result = simulate(b.scene);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_FALSE(result.motion->stop(1 + i)) << result.motion->stop(1 + i)->sentence;
        const BodyState then = result.motion->at(1 + i, 0.6), end = result.motion->at(1 + i, 0.8);
        EXPECT_NEAR(end.position.y(), 0.5 + static_cast<double>(i), 1e-8);
        EXPECT_LT(end.velocity.norm(), 1e-11);
        EXPECT_LT(distance(end.position, then.position), 1e-11);
    }
}

} // namespace
} // namespace simulation::testing
