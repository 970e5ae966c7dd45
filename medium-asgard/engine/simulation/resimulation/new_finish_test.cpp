// An edit of the end time, told as work, and that the motion is that of a run from scratch. Random
// ones over all scenes: tests/edits.
#include "resimulation/resimulation_testing.h"

#include <cmath>
#include <random>

namespace simulation::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

void expectNoWork(const Result& result) {
    EXPECT_EQ(result.statistics.steps, 0u);
    EXPECT_EQ(result.statistics.rejectedSteps, 0u);
    EXPECT_EQ(result.statistics.evaluations, 0u);
    EXPECT_EQ(result.statistics.pairTests, 0u);
}

TEST(NewFinish, AnEarlierOneSolvesNothing) {
    SceneBuilder b = row(20);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.simulator.finish = 1.3;
    expectNoWork(updated(kept, b.scene));
    EXPECT_EQ(kept.work().print(), "solved:; kept: 20; rounds: 0");
    b.scene.simulator.finish = 2; // what there was
    expectNoWork(updated(kept, b.scene));
}

TEST(NewFinish, ALaterOneGoesOnFromWhereTheMotionStood) {
    SceneBuilder b = row(20);
    Resimulation kept;
    Result result = kept.update(shared(b.scene));
    std::size_t steps = result.statistics.steps, evaluations = result.statistics.evaluations;
    for (const double finish : {2.3, 2.31, 3.0, 5.0}) {
        b.scene.simulator.finish = finish;
        result = updated(kept, b.scene);
        EXPECT_EQ(kept.work().print(), "solved:; kept: 20; rounds: 0");
        const Result scratch = simulate(b.scene);
        steps += result.statistics.steps;
        evaluations += result.statistics.evaluations;
        EXPECT_EQ(steps, scratch.statistics.steps) << finish;
        EXPECT_EQ(evaluations, scratch.statistics.evaluations) << finish;
    }
}

TEST(NewFinish, ComesWithOtherEdits) {
    SceneBuilder b = row(5);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.simulator.finish = 1.5;
    b.scene.bodies[2].initialVelocity = {0, 2, 0};
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball2; kept: 4; rounds: 1");
    b.scene.simulator.finish = 2.5; // two parts go on
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved:; kept: 5; rounds: 0");
}

// What was there would bounce from wall to wall 200,000 times in the time that is added, if it were
// not edited too.
TEST(NewFinish, OfWhatIsEditedTooIsNotTakenFurtherForLong) {
    SceneBuilder b(1e-3);
    b.room();
    b.ball("first", {0.3, 0.01, 0}).initialVelocity = {2e5, 0, 0};
    b.ball("second", {-0.3, 0, 0}).initialVelocity = {-1e5, 0, 0};
    b.weight("first");
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.simulator.finish = 1;
    b.scene.bodies[6].initialVelocity = b.scene.bodies[7].initialVelocity = {0, 0, 0};
    std::size_t polls = 0;
    const Result result = kept.update(shared(b.scene), {},
                                      {.cancelled =
                                           [&polls] {
                                               ++polls;
                                               return false;
                                           },
                                       .progress = {}});
    EXPECT_LT(polls, 5000u);
    EXPECT_FALSE(kept.work().whole);
    EXPECT_EQ(rows(*result.motion, 6), rows(*simulate(b.scene).motion, 6));
}

TEST(NewFinish, BouncesGoOn) {
    SceneBuilder b(1);
    b.floor();
    b.ball("ball", {0, 1, 0}).restitution = 0.8;
    b.weight("ball");
    Resimulation kept;
    const std::size_t first = kept.update(shared(b.scene)).motion->impacts().size();
    b.scene.simulator.finish = 3;
    EXPECT_GT(updated(kept, b.scene).motion->impacts().size(), first);
    EXPECT_EQ(kept.work().print(), "solved:; kept: 1; rounds: 0");
    b.scene.simulator.finish = 1;
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), SizeIs(first));
}

TEST(NewFinish, WhoMeetsInTheTimeThatIsAddedIsSolvedTogether) {
    SceneBuilder b = row(4);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[0].initialVelocity = {2, 1, 0}; // it would be there after 5 s
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), IsEmpty());
    EXPECT_EQ(kept.work().print(), "solved: ball0; kept: 3; rounds: 1");
    b.scene.simulator.finish = 6;
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), SizeIs(1));
    EXPECT_EQ(kept.work().print(), "solved: ball0 ball1; kept: 2; rounds: 1");
}

// What was solved with the others once and moves otherwise now goes on in their part, unseen.
TEST(NewFinish, WhoWouldHaveMetTheMotionBeforeAnEditIsSolvedAgain) {
    SceneBuilder b = row(4);
    b.scene.bodies[0].initialVelocity = {2, 1, 0};
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[0].initialVelocity = {-2, 1, 0};
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball0; kept: 3; rounds: 1");
    b.scene.simulator.finish = 6;
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), IsEmpty());
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 3; rounds: 1");
}

TEST(NewFinish, AFixedBodyThatCameLaterIsMetInTheTimeThatIsAdded) {
    SceneBuilder b = row(2);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.box("wall", {10, 2.4, 0}, {1, 1, 1}).fixed = true; // ball1 does not get there in 2 s
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), IsEmpty());
    EXPECT_EQ(kept.work().print(), "solved:; kept: 2; rounds: 1");
    b.scene.simulator.finish = 5;
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), SizeIs(1));
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 1; rounds: 1");
}

// Rounding grows with each hit until nothing is left of the accuracy: other tolerances are wanted.
TEST(NewFinish, OnlyWhoseAccuracyAsksForItIsSolvedAgain) {
    SceneBuilder b = row(3);
    b.scene.simulator.accuracy = 1e-3;
    b.force("ball1", "60*sin(7*ball1.x)", "0", "0"); // runs away from its neighbours
    Resimulation kept;
    bool isSeen = false;
    (void)kept.update(shared(b.scene));
    for (int i = 1; i <= 12; ++i) {
        b.scene.simulator.finish = 2 + 0.25 * i;
        (void)updated(kept, b.scene);
        const std::string work = kept.work().print();
        EXPECT_TRUE(work.starts_with("solved:; kept: 3") ||
                    work.starts_with("solved: ball1; kept: 2"))
            << work;
        isSeen = isSeen || !kept.work().solved.empty();
    }
    EXPECT_TRUE(isSeen);
}

// What swings, is chaotic, stiff, switched, hit; far from each other.
SceneBuilder manyKinds(double accuracy) {
    SceneBuilder b(1, accuracy);
    b.ball("swing", {1, 0, 0});
    b.force("swing", "-3*sin(swing.x)", "0", "0");
    b.ball("a", {2.1, 0, 40});
    b.ball("b", {3, 0, 42});
    b.force("a", "-20*sin(a.x)+5*sin(b.x-a.x)", "0", "0");
    b.force("b", "-9*sin(b.x)-5*sin(b.x-a.x)", "0", "0");
    b.ball("stiff", {0, 0, 80});
    b.force("stiff", "1e6*(cos(stiff.y)-stiff.x)-2e3*stiff.dx", "1", "0");
    b.ball("switched", {1, 0, 120});
    b.force("switched", "-4*sign(switched.x)-0.1*switched.dx", "0", "0");
    scene::Body& box = b.box("box", {0, 0.4, 160}, {0.3, 0.2, 0.4});
    box.initialAngularVelocity = {1, 2, 3};
    b.weight("box");
    b.box("table", {0, -0.5, 160}, {4, 0.2, 4}).fixed = true;
    return b;
}

// From a millionth of a second to many periods, to and fro.
TEST(NewFinish, IsAsFromScratchHoweverFarItGoes) {
    std::mt19937 random(7);
    for (const double accuracy : {1e-2, 1e-4, 1e-6}) {
        SceneBuilder b = manyKinds(accuracy);
        Resimulation kept;
        for (int i = 0; i < 12; ++i) {
            const double part = static_cast<double>(random()) / 0x1p32;
            b.scene.simulator.finish = std::pow(10, i == 0 ? -6 : -6 + 7.2 * part);
            SCOPED_TRACE(b.scene.simulator.finish);
            (void)updated(kept, b.scene);
        }
    }
}

TEST(NewFinish, WhatWasCancelledOnTheWayGoesOnToo) {
    SceneBuilder b = row(10);
    Resimulation kept;
    std::size_t steps = kept.update(shared(b.scene)).statistics.steps;
    b.scene.simulator.finish = 4;
    std::size_t cuts = 0;
    for (int polls = 1; polls <= 31; polls += 10) {
        int asked = 0;
        const auto stop = [&] { return ++asked > polls; };
        const Result cut = kept.update(shared(b.scene), {}, {.cancelled = stop, .progress = {}});
        cuts += cut.cancelled ? 1 : 0;
        EXPECT_EQ(cut.motion->draft(), cut.cancelled);
        steps += cut.statistics.steps;
    }
    EXPECT_GE(cuts, 3u);
    const Result result = updated(kept, b.scene);
    steps += result.statistics.steps;
    EXPECT_EQ(steps, simulate(b.scene).statistics.steps);
    b.scene.simulator.finish = 1;
    expectNoWork(updated(kept, b.scene));
}

TEST(NewFinish, DraftsGrowFromWhatWasKnown) {
    SceneBuilder b = row(3);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.simulator.finish = 6;
    const Result whole = simulate(b.scene);
    std::vector<double> reached;
    const auto watch = [&](const MotionPointer& motion) {
        reached.push_back(motion->computed());
        EXPECT_TRUE(motion->draft());
        EXPECT_LT(distance(motion->at(1, 1).position, whole.motion->at(1, 1).position), 1e-3);
    };
    (void)kept.update(shared(b.scene), {}, {.cancelled = {}, .progress = watch});
    ASSERT_FALSE(reached.empty());
    EXPECT_GE(reached.front(), 2);
    EXPECT_TRUE(std::ranges::is_sorted(reached));
}

} // namespace
} // namespace simulation::testing
