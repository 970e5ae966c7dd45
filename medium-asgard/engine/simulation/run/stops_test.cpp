// What an author reads when a motion ends.
#include "reports/report.h"
#include "resimulation/resimulation_testing.h"
#include "run/budget.h"

#include <cmath>

namespace simulation {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::SceneBuilder;

scene::Scene pushed(const std::string& force, double finish = 10) {
    SceneBuilder b(finish, 1e-4);
    b.ball("b", {1, 0, 0});
    b.force("b", "0", "1", "0").source.line = 3;
    b.force("b", force, "0", "0");
    scene::Source& source = b.scene.forces.back().source;
    source.line = 4;
    source.column = 1;
    source.arguments.push_back({.option = "-x", .word = {30, 40}, .literal = true});
    return b.scene;
}

// 1/(2-t) is infinite at no double near 2 but at 2 itself: its integral is what has no value.
TEST(Stops, APoleIsBlamedOnTheForceThatHasIt) {
    const scene::Scene scene = pushed("1/(2-t)^2");
    const Result result = simulate(scene);
    const auto stop = result.motion->stop(0);
    ASSERT_TRUE(stop);
    EXPECT_NEAR(stop->time, 2, 1e-3);
    EXPECT_THAT(stop->sentence, HasSubstr("the force on body \"b\" grows without bound: its x, "
                                          "\"1/(2-t)^2\", is "));
    EXPECT_THAT(stop->sentence, HasSubstr("let the motion finish before"));
    EXPECT_EQ(stop->culprit, (Stop::Culprit{"b", false, 1, "-x"}));
    const auto report = reportOf(scene, *result.motion);
    ASSERT_EQ(report.size(), 1u) << "a stop, and no horizon beside it";
    EXPECT_EQ(report[0].line, 4);
    EXPECT_EQ(report[0].range, (scene::Range{30, 40}));
}

TEST(Stops, AMotionThatBlowsUpSaysSoOnce) {
    const scene::Scene scene = pushed("10*b.x^2");
    const Result result = simulate(scene);
    const auto report = reportOf(scene, *result.motion);
    ASSERT_EQ(report.size(), 1u);
    EXPECT_EQ(report[0].severity, scene::Severity::error);
    EXPECT_THAT(report[0].message, HasSubstr("its x, \"10*b.x^2\", is "));
    EXPECT_FALSE(result.motion->predictableUntil());
}

// With no step made there is nothing that it has grown from.
TEST(Stops, AForceThatIsEnormousFromTheStartIsNamed) {
    const auto stop = simulate(pushed("1e300*exp(30*t)")).motion->stop(0);
    ASSERT_TRUE(stop);
    EXPECT_THAT(stop->sentence, HasSubstr("since the force on body \"b\" grows without bound: its "
                                          "x, \"1e300*exp(30*t)\", is 1e+300"));
}

TEST(Stops, WhatIsNotANumberIsNamedWithItsExpression) {
    const auto stop = simulate(pushed("sqrt(1-t)")).motion->stop(0);
    ASSERT_TRUE(stop);
    EXPECT_THAT(stop->sentence,
                HasSubstr("Stopped at t = 1: the force on body \"b\" is not finite: "
                          "its x, \"sqrt(1-t)\", is not a number"));
}

// Up to its finish the motion needs no value beyond it. 10 t is 3 at the double 0.3.
TEST(Stops, WhatHasNoValueBeyondTheFinishIsKnownUpToIt) {
    struct Case {
        std::string force;
        double finish, speed; // then
    };
    for (const auto& [force, finish, speed] :
         {Case{"sqrt(10-t)", 10, 2 * std::pow(10, 1.5) / 3}, Case{"sqrt(3-10*t)", 0.3, 0.346410162},
          Case{"pow(10-t,1.5)", 10, 0.4 * std::pow(10, 2.5)},
          Case{"(10-t)^0.3", 10, std::pow(10, 1.3) / 1.3}, Case{"t<2?1:sqrt(3-2*t)", 2, 2}}) {
        for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
            scene::Scene scene = pushed(force, finish);
            scene.simulator.accuracy = accuracy;
            const Result result = simulate(scene);
            EXPECT_FALSE(result.motion->stop(0)) << force << " at " << accuracy;
            EXPECT_EQ(result.motion->computed(), finish) << force;
            EXPECT_NEAR(result.motion->at(0, finish).velocity.x(), speed, 100 * accuracy) << force;
        }
    }
}

// It stops there all the same where it is to go on, and reads so after an edit of the finish.
TEST(Stops, BeyondTheFinishAreNone) {
    Resimulation edited;
    EXPECT_FALSE(testing::updated(edited, pushed("sqrt(10-t)", 10)).motion->stop(0));
    const auto stop = testing::updated(edited, pushed("sqrt(10-t)", 12)).motion->stop(0);
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->time, 10);
    EXPECT_FALSE(testing::updated(edited, pushed("sqrt(10-t)", 10)).motion->stop(0));
}

// At its finish itself such a force is infinite.
TEST(Stops, AnInfiniteForceAtTheFinishIsSaid) {
    for (const std::string force : {"1/sqrt(10-t)", "log(10-t)", "1/(10-t)^2"}) {
        const auto stop = simulate(pushed(force, 10)).motion->stop(0);
        ASSERT_TRUE(stop) << force;
        EXPECT_NEAR(stop->time, 10, 1e-6) << force;
    }
}

// What reads a motion that ended says whose fault it was, however long the chain.
TEST(Stops, WhatReadsAMotionThatEndedNamesTheCause) {
    SceneBuilder b(4, 1e-4);
    b.ball("a", {0, 0, 0});
    b.force("a", "sqrt(1-t)", "0", "0");
    b.ball("b", {5, 0, 0});
    b.force("b", "a.x-b.x", "0", "0");
    b.ball("c", {9, 0, 0});
    b.force("c", "b.x-c.x", "0", "0");
    const Result result = simulate(b.scene);
    for (const std::size_t body : {1u, 2u}) {
        const auto stop = result.motion->stop(body);
        ASSERT_TRUE(stop);
        EXPECT_THAT(stop->sentence,
                    HasSubstr(", whose motion ended: the force on body \"a\" is not "
                              "finite: its x, \"sqrt(1-t)\", is not a number"));
        EXPECT_EQ(stop->culprit, (Stop::Culprit{"a", false, 0, "-x"}));
    }
    EXPECT_THAT(result.motion->stop(0)->sentence,
                HasSubstr("Stopped at t = 1: the force on body \"a\" is"));
}

// x = 1 + v t.
TEST(Stops, MotionInClosedFormEndsWhereItGoesOver1e100) {
    SceneBuilder b(1e60, 1e-4);
    b.ball("far", {1, 0, 0}).initialVelocity = {1e50, 0, 0};
    b.ball("near", {0, 0, 9}).initialVelocity = {0, 0, 1};
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_NEAR(result.motion->stop(0)->time / 1e50, 1, 1e-9);
    EXPECT_THAT(result.motion->stop(0)->sentence, EndsWith("far.x grows over 1e100."));
    EXPECT_FALSE(result.motion->stop(1));
}

// Up to 0.9e100 and down again: nothing ends. A little higher, and it does.
TEST(Stops, WhatTurnsBackBefore1e100GoesOn) {
    for (const double height : {0.9e100, 1.1e100}) {
        SceneBuilder b(2 * std::sqrt(2 * height / testing::g), 1e-4);
        b.ball("b", {0, 0, 0}).initialVelocity = {0, std::sqrt(2 * height * testing::g), 0};
        b.weight("b");
        EXPECT_EQ(simulate(b.scene).motion->stop(0).has_value(), height > 1e100) << height;
    }
}

scene::Scene orbit(double finish) {
    SceneBuilder b(finish, 1e-4);
    b.ball("b", {1, 0, 0}).initialVelocity = {0, 1, 0};
    b.force("b", "-b.x/hypot(b.x,b.y)^3", "-b.y/hypot(b.x,b.y)^3", "0");
    return b.scene;
}

// A twentieth of the usual memory.
struct LittleMemory {
    LittleMemory() { setMostBytes(usualBytes / 20); }
    ~LittleMemory() { setMostBytes(usualBytes); }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;
};

TEST(Stops, AFinishThatIsNeverReachedEndsWhereMemoryDoes) {
    const LittleMemory little;
    const Result result = simulate(orbit(1e99));
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_THAT(result.motion->stop(0)->sentence, HasSubstr("takes 4 MB, which is the limit"));
    EXPECT_GT(result.motion->stop(0)->time, 1000);
}

TEST(Stops, EventsThatNeverEndDoSoWhereMemoryDoes) {
    const LittleMemory little;
    SceneBuilder b(1e99, 1e-4);
    b.floor();
    b.ball("b", {0, 1, 0});
    b.weight("b");
    b.ball("lone", {1000, 1, 0}).initialVelocity = {0, 1, 0}; // has no part in it
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(1));
    EXPECT_THAT(result.motion->stop(1)->sentence, HasSubstr("which is the limit"));
    EXPECT_FALSE(result.motion->stop(2));
}

// Steps that grow for ever reach any finish.
TEST(Stops, WhatSlowsDownGetsThere) {
    SceneBuilder b(1e60, 1e-4);
    b.ball("b", {0, 0, 0}).initialVelocity = {1, 0, 0};
    b.force("b", "-b.dx*abs(b.dx)", "0", "0");
    EXPECT_FALSE(simulate(b.scene).motion->stop(0));
}

// A run that memory ended is not read for another finish.
TEST(Stops, AnEarlierFinishIsReachedAfterOneThatIsNot) {
    const LittleMemory little;
    Resimulation edited;
    EXPECT_TRUE(testing::updated(edited, orbit(1e99)).motion->stop(0));
    EXPECT_FALSE(testing::updated(edited, orbit(1000)).motion->stop(0));
}

TEST(Stops, ALaterFinishEndsWhereARunFromTheStartDoes) {
    const LittleMemory little;
    Resimulation edited;
    EXPECT_FALSE(testing::updated(edited, orbit(1000)).motion->stop(0));
    const auto stop = testing::updated(edited, orbit(1e99)).motion->stop(0);
    const auto scratch = simulate(orbit(1e99)).motion->stop(0);
    ASSERT_TRUE(stop && scratch);
    EXPECT_EQ(stop->time, scratch->time);
}

// "stone" stops at t = 1, where its force has no value any more; "comer" comes by at t = 3.
SceneBuilder stoneInTheWay(double speed, const std::string& drag = "0") {
    SceneBuilder b(8, 1e-6);
    b.ball("stone", {0, 0, 0}, 0.5);
    b.force("stone", "0", "0", "1e-3*sqrt(1-t)");
    b.ball("comer", {4, 0, 0}, 0.5).initialVelocity = {-speed, 0, 0};
    b.force("comer", drag, "0", "0");
    b.ball("late", {20, 0, 0}, 0.5).initialVelocity = {-speed, 0, 0};
    b.ball("far", {0, 50, 0}, 0.5).initialVelocity = {-speed, 0, 0};
    return b;
}

// Thirty boxes on each other, and one that falls onto them: one fault.
TEST(Stops, FourStacksOfThreeStandWhileABallFalls) {
    SceneBuilder b(3, 1e-4);
    b.floor(40);
    for (int i = 0; i < 12; ++i) {
        const std::string name = "b" + std::to_string(i);
        b.box(name, {i % 4 * 2.0, 0.5 + i / 4, 0}, {1, 1, 1});
        b.weight(name);
    }
    b.ball("late", {2, 8, 0}, 0.3).initialVelocity = {0, -3, 0};
    const Result result = simulate(b.scene);
    std::size_t stopped = 0;
    for (std::size_t body = 0; body < b.scene.bodies.size(); ++body)
        stopped += result.motion->stop(body) ? 1 : 0;
    EXPECT_EQ(stopped, 0u);
    EXPECT_LE(reportOf(b.scene, *result.motion).size(), 1u);
}

// What then happens to it is as little known.
TEST(Stops, WhatMeetsABodyThatStoppedStopsThereToo) {
    for (const std::string drag : {"0", "-1e-9*comer.dx^3"}) {
        const SceneBuilder b = stoneInTheWay(1.5, drag);
        const Result result = simulate(b.scene);
        const auto stop = result.motion->stop(1), late = result.motion->stop(2);
        ASSERT_TRUE(stop && !late) << drag;
        EXPECT_NEAR(stop->time, 2, 1e-6);
        EXPECT_EQ(stop->sentence, "Stopped at t = 2: body \"comer\" meets \"stone\", whose motion "
                                  "stopped at t = 1; what happens then is not known.");
        EXPECT_NEAR(result.motion->at(1, 8).position.x(), 1, 1e-6);
        EXPECT_FALSE(result.motion->stop(3));
        const auto report = reportOf(b.scene, *result.motion);
        ASSERT_EQ(report.size(), 1u) << "of one cause";
        EXPECT_THAT(report[0].message, HasSubstr("A meeting with a stopped body stops 1 more body: "
                                                 "\"comer\", at t = 2."));
    }
}

// And so does what meets that one, and what falls onto it.
TEST(Stops, WhoMeetsOneThatMetAStopStopsToo) {
    SceneBuilder b = stoneInTheWay(2.5);
    b.ball("rider", {0, 8, 0}, 0.5);
    b.weight("rider");
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(2) && result.motion->stop(4));
    EXPECT_NEAR(result.motion->stop(2)->time, 7.2, 1e-6);
    EXPECT_THAT(result.motion->stop(2)->sentence, HasSubstr("meets \"comer\", whose motion"));
    EXPECT_NEAR(result.motion->stop(4)->time, std::sqrt(14 / testing::g), 1e-6);
}

// What is held goes its way, and nobody meets a stop that is not in the way.
TEST(Stops, WhatIsHeldPassesWhereAMotionStopped) {
    SceneBuilder b = stoneInTheWay(0);
    b.ball("held", {-9, 0, 0}, 0.5);
    b.hold("held", 0, 8, {{-9, 0, 0}, {-3, 0, 0}, {3, 0, 0}, {9, 0, 0}});
    b.ball("beside", {0, 9, 0}, 0.5).initialVelocity = {0, -1, 1};
    const Result result = simulate(b.scene);
    EXPECT_FALSE(result.motion->stop(4));
    EXPECT_FALSE(result.motion->stop(5));
}

// Whoever is edited into its way, or out of it; and where the stop itself is moved there.
TEST(Stops, EditsMeetAStopAsARunFromTheStartDoes) {
    Resimulation edited;
    SceneBuilder b = stoneInTheWay(1.5);
    EXPECT_TRUE(testing::updated(edited, b.scene).motion->stop(1));
    b.scene.bodies[1].initialPosition.y() = 5;
    EXPECT_FALSE(testing::updated(edited, b.scene).motion->stop(1));
    b.scene.bodies[3].initialVelocity = {0, -8, 0};
    EXPECT_TRUE(testing::updated(edited, b.scene).motion->stop(3));
    b.scene.bodies[0].initialPosition.x() = 6;
    EXPECT_FALSE(testing::updated(edited, b.scene).motion->stop(3));
    b.scene.bodies[0].initialPosition = {1.2, 5, 0};
    const auto stop = testing::updated(edited, b.scene).motion->stop(1);
    ASSERT_TRUE(stop);
    EXPECT_NEAR(stop->time, 1.2, 1e-6);
}

// A ball whose spin has no value from 1 s on, and its way none from 5 s on, is in others' way where
// it is seen last, and nowhere else.
TEST(Stops, ABallIsInTheWayWhereItsWayEnds) {
    SceneBuilder b(10, 1e-6);
    b.ball("stone", {0, 0, 0}, 0.5).initialVelocity = {1, 0, 0};
    b.force("stone", "0", "0", "1e-3*sqrt(5-t)");
    b.force("stone", "0", "0", "1e-3*sqrt(1-t)").couple = true;
    b.ball("comer", {5, 9, 0}, 0.5).initialVelocity = {0, -1.2, 0};
    b.ball("other", {1, 12, 0}, 0.5).initialVelocity = {0, -1.5, 0};
    const Result result = simulate(b.scene);
    const auto met = result.motion->stop(1);
    ASSERT_TRUE(met);
    EXPECT_THAT(met->sentence, HasSubstr("whose motion stopped at t = 5"));
    EXPECT_NEAR(met->time, (9 - 1) / 1.2, 1e-2);
    EXPECT_EQ(result.motion->stop(2), std::nullopt);
}

// Others far away from a body that stops go on meeting each other.
TEST(Stops, AStopConcernsNobodyElse) {
    SceneBuilder b(3, 1e-7);
    b.box("table", {-300, -0.1, 0}, {6, 0.2, 2}).fixed = true;
    b.ball("slowed", {-300, 0.1, 0}).initialVelocity = {0.5, 0, 0};
    b.scene.bodies.back().restitution = 0;
    b.weight("slowed");
    b.force("slowed", "-0.1*sqrt(1-t)", "0", "0");
    b.box("floor", {50, -0.1, 0}, {6, 0.2, 2}).fixed = true;
    b.ball("bouncing", {50, 0.6, 0}).restitution = 1;
    b.weight("bouncing");
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(1));
    const double fall = std::sqrt(2 * 0.5 / testing::g);
    for (double t = 0; t < 3; t += 0.01) {
        const double since = std::remainder(t, 2 * fall);
        EXPECT_NEAR(result.motion->at(3, t).position.y(), 0.6 - testing::g / 2 * since * since,
                    1e-7);
    }
}

TEST(Report, SpeaksOfTheBodyThatASentenceNames) {
    scene::Scene scene = orbit(1);
    scene.bodies[0].source.line = 7;
    scene.bodies[0].source.column = 3;
    EXPECT_EQ(faultOf(scene, "Body \"b\" has no shape.").line, 7);
    EXPECT_EQ(faultOf(scene, "Body \"c\" has no shape.").line, 0);
    scene.simulator.source.emplace().line = 1;
    EXPECT_EQ(faultOf(scene, "The motion would finish after 1e100.").line, 1);
}

} // namespace
} // namespace simulation
