// Balls that touch and go side by side: Newton's cradle.
#include "resimulation/resimulation_testing.h"
#include "simulation/testing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace simulation {
namespace {

using testing::distance;
using ::testing::HasSubstr;
using testing::SceneBuilder;

constexpr double radius = 0.1, stiffness = 10, aside = 0.5;

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}

double hookAt(std::size_t ball) { return 0.3 + 2 * radius * static_cast<double>(ball); }

// On springs whose ends are a diameter apart; the first few are drawn aside.
SceneBuilder cradle(std::size_t drawn, double finish, double accuracy, double restitution = 1) {
    SceneBuilder b(finish, accuracy);
    for (std::size_t i = 0; i < 5; ++i) {
        const std::string name = "b" + std::to_string(i);
        b.ball(name, {hookAt(i) - (i < drawn ? aside : 0), 0, 0}, radius).restitution = restitution;
        scene::Link link;
        link.first.body = name;
        link.second = scene::PointEnd{{number(hookAt(i)), "0", "0"}};
        link.tightness = stiffness;
        link.damping = 0;
        b.scene.links.push_back(link);
    }
    return b;
}

// As many leave at the other end as came, one swing after the other.
TEST(Cradle, AsManyBallsLeaveAsCame) {
    const double w = std::sqrt(stiffness);
    for (const std::size_t drawn : {1u, 2u, 3u})
        for (const double accuracy : {1e-3, 1e-4, 1e-6}) {
            const SceneBuilder b = cradle(drawn, 8, accuracy);
            const Result result = simulate(b.scene);
            for (std::size_t i = 0; i < 5; ++i) {
                ASSERT_FALSE(result.motion->stop(i)) << result.motion->stop(i)->sentence;
                double worst = 0;
                for (double t = 0; t <= 8; t += 0.01) {
                    const double swing = -aside * std::cos(w * t);
                    const double left = i < drawn ? std::min(swing, 0.0) : 0;
                    const double right = i >= 5 - drawn ? std::max(swing, 0.0) : 0;
                    const double x = result.motion->at(i, t).position.x() - hookAt(i);
                    worst = std::max(worst, std::abs(x - left - right));
                }
                EXPECT_LT(worst, accuracy) << drawn << " " << i << " " << accuracy;
            }
        }
}

// They swing as one, whatever they lose in a blow: nothing is hit.
TEST(Cradle, BallsThatSwingInStepDoNotMeet) {
    for (const double restitution : {1.0, 0.5})
        for (const double accuracy : {1e-3, 1e-6}) {
            const Result result = simulate(cradle(5, 8, accuracy, restitution).scene);
            EXPECT_FALSE(result.motion->stop(2));
            EXPECT_EQ(result.motion->impacts().size(), 0u);
        }
}

constexpr double length = 1, tilt = 0.5;

// Rigid pendulums: each ball is held at a point above it by a stiff link.
SceneBuilder pendulums(double finish, double accuracy, double stiff = 1e8) {
    SceneBuilder b(finish, accuracy);
    for (std::size_t i = 0; i < 5; ++i) {
        const std::string name = "b" + std::to_string(i);
        const double x = 2 * radius * static_cast<double>(i), angle = i == 0 ? -tilt : 0;
        b.ball(name,
               {x + length * std::sin(angle),
                length - length * std::cos(angle) - (i == 0 ? 0 : testing::g / stiff), 0},
               radius)
            .initialAttitude = geometry::Quaternion(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
        b.weight(name);
        scene::Link link;
        link.first = {.body = name, .offset = Vector(0, length, 0)};
        link.second = scene::PointEnd{{number(x), number(length), "0"}};
        link.tightness = stiff;
        b.scene.links.push_back(link);
    }
    return b;
}

// The blow goes through the centre of the first ball and does not stop its turning; its pivot does,
// within a microsecond, and pushes it onto the row, which goes on as one: a force that lasts. In
// the limit of a rigid link u is their speed, V that of the blow, with q = I/(m L^2):
//     4 (1 + q) u = q V,   (1 + q) V^2 = 2 g L (1 - cos tilt)
TEST(Cradle, WhatAForcePushesOntoTheRowMovesItAsOne) {
    const double q = 0.4 * radius * radius / (length * length);
    const double fall = length * (1 - std::cos(tilt));
    const double blow = std::sqrt(2 * testing::g * fall / (1 + q));
    const double speed = blow * q / (4 * (1 + q)), w = std::sqrt(testing::g / length / (1 + q));
    for (const double accuracy : {1e-3, 1e-4, 1e-6}) {
        const Result result = simulate(pendulums(1, accuracy).scene);
        ASSERT_FALSE(result.motion->impacts().empty());
        const double met = result.motion->impacts()[0].time;
        for (std::size_t i = 0; i < 4; ++i) {
            ASSERT_FALSE(result.motion->stop(i)) << result.motion->stop(i)->sentence;
            const double x =
                result.motion->at(i, 1).position.x() - 2 * radius * static_cast<double>(i);
            EXPECT_NEAR(x, speed / w * std::sin(w * (1 - met)), 1.5 * accuracy + 4e-6) << i;
        }
    }
}

// The truth is an independent integration of bodies in contact, in steps of 1e-8 while they press.
TEST(Cradle, ARowOnStiffLinksIsWithinTheAccuracyOrToldNotToBe) {
    struct Truth {
        double stiff, first, others; // moved by at t = 1, in 1e-6
    };
    for (const Truth truth : {Truth{1e4, 484.79, 493.44}, Truth{1e8, 490.97, 492.91}})
        for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
            const Result result = simulate(pendulums(1, accuracy, truth.stiff).scene);
            constexpr double size = 1.96, known = 2e-8;
            double worst = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                ASSERT_FALSE(result.motion->stop(i)) << result.motion->stop(i)->sentence;
                const double x =
                    result.motion->at(i, 1).position.x() - 2 * radius * static_cast<double>(i);
                worst = std::max(worst, std::abs(x - 1e-6 * (i == 0 ? truth.first : truth.others)));
            }
            const double estimate = result.motion->errorEstimate().value();
            EXPECT_LT(worst / size, accuracy + known) << truth.stiff << " " << accuracy;
            EXPECT_LT(worst / size, 30 * estimate + known) << truth.stiff << " " << accuracy;
        }
}

// On rods with hinges, which keep their places but for the errors of steps. The balls in the middle
// of the row stay there.
TEST(Cradle, PendulumsOnHingesGoOnForManySwings) {
    for (const std::size_t drawn : {1u, 2u, 3u})
        for (const double accuracy : {1e-2, 1e-3, 6.30957e-4, 2.51189e-4, 1e-4, 7.94328e-5, 1e-6}) {
            SceneBuilder b(10, accuracy);
            for (std::size_t i = 0; i < 5; ++i) {
                const std::string name = "b" + std::to_string(i);
                const double x = 2 * radius * static_cast<double>(i), angle = i < drawn ? -0.4 : 0;
                b.ball(name, {x + length * std::sin(angle), -length * std::cos(angle), 0}, radius)
                    .initialAttitude =
                    geometry::Quaternion(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
                b.weight(name);
                scene::Joint hinge;
                hinge.name = "h" + std::to_string(i);
                hinge.type = scene::JointType::hinge;
                hinge.body1 = name;
                hinge.offset1 = Vector(0, length, 0);
                hinge.axis = Vector::UnitZ();
                b.scene.joints.push_back(hinge);
            }
            const Result result = simulate(b.scene);
            double worst = 0;
            for (std::size_t i = 0; i < 5; ++i) {
                ASSERT_FALSE(result.motion->stop(i)) << result.motion->stop(i)->sentence;
                const bool isInside = i >= drawn && i + drawn < 5;
                for (double t = 0; t < 10 && isInside; t += 0.1)
                    worst = std::max(worst, std::abs(result.motion->at(i, t).position.x() -
                                                     2 * radius * static_cast<double>(i)));
            }
            EXPECT_LT(worst, accuracy) << drawn;
        }
}

TEST(Cradle, PendulumsGoOnForManySwings) {
    const Result result = simulate(pendulums(10, 1e-3).scene);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_FALSE(result.motion->stop(i));
    EXPECT_GT(result.motion->impacts().size(), 10u);
    EXPECT_LT(result.motion->impacts().size(), 3000u);
}

TEST(Cradle, ARowThatLiesOnAFloorPassesABlowOn) {
    for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6}) {
        SceneBuilder b(3, accuracy);
        b.floor();
        for (std::size_t i = 0; i < 5; ++i) {
            const double x = 0.37 + 2 * radius * static_cast<double>(i) - (i == 0 ? 1 : 0);
            b.ball("b" + std::to_string(i), {x, radius, 0}, radius);
            b.weight("b" + std::to_string(i));
        }
        b.scene.bodies[1].initialVelocity = {1, 0, 0};
        const Result result = simulate(b.scene);
        EXPECT_EQ(result.motion->impacts().size(), 4u);
        EXPECT_LT(distance(result.motion->at(5, 3).position, {0.37 + 8 * radius + 2, radius, 0}),
                  0.1 * accuracy);
        for (std::size_t i = 1; i < 5; ++i)
            EXPECT_LT(result.motion->at(i, 3).velocity.norm(), 1e-9);
    }
}

TEST(Cradle, AnEditedOneHasTheBytesOfARunFromTheStart) {
    Resimulation edited;
    scene::Scene scene = cradle(1, 4, 1e-4).scene;
    testing::updated(edited, scene);
    scene.simulator.finish = 7;
    testing::updated(edited, scene);
    scene.bodies[1].initialPosition.x() -= 0.3;
    EXPECT_FALSE(testing::updated(edited, scene).motion->stop(2));
}

// Whatever hits a pair that a force presses together goes through it: a box as a ball does.
TEST(Cradle, ABlowOntoBallsThatArePressedIsNoPush) {
    for (const bool isBox : {false, true})
        for (const double accuracy : {1e-3, 1e-4, 1e-6}) {
            SceneBuilder b(0.5, accuracy);
            b.ball("first", {0, 0, 0}, 0.5);
            b.ball("second", {1, 0, 0}, 0.5);
            b.force("first", "1", "0", "0");
            b.force("second", "-1", "0", "0");
            scene::Body& hammer = isBox ? b.box("hammer", {-1.05, 0, 0}, {1, 1, 1})
                                        : b.ball("hammer", {-1.05, 0, 0}, 0.5);
            hammer.initialVelocity = {1, 0, 0};
            for (scene::Body& body : b.scene.bodies)
                body.mass = 1;
            const Result result = simulate(b.scene);
            // Hit at 0.05; then each is pushed for 0.04.
            const std::array<double, 3> speeds{0.04, 0.96, 0};
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(result.motion->at(i, 0.09).velocity.x(), speeds[i], 1e-4)
                    << i << " at " << accuracy;
        }
}

// A force that does not end: they would lie on each other.
TEST(Cradle, BallsThatArePushedTogetherForLongStopWithASentence) {
    SceneBuilder b(5);
    for (const double side : {-1.0, 1.0}) {
        const std::string name = side < 0 ? "left" : "right";
        b.ball(name, {side * radius, 0, 0}, radius);
        b.force(name, number(-side), "0", "0");
    }
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_THAT(result.motion->stop(0)->sentence, HasSubstr("come to rest on each other"));
    EXPECT_LT(result.motion->impacts().size(), 5000u);
}

} // namespace
} // namespace simulation
