// How far apart two motions are, where that is known by construction; and real scenes in which
// nothing may be off silently.
#include "accuracy/accuracy.h"

#include "run/open_run.h"
#include "simulation/testing.h"

#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::shared_ptr<const Problem> posed(const SceneBuilder& builder, const Options& options = {}) {
    return std::get<std::shared_ptr<Problem>>(problemOf(builder.scene, options));
}

Run runOf(const Problem& problem) {
    return OpenRun(problem, std::vector<double>(problem.bodies->size(), 1e-6))
        .upToFinish({}, nullptr);
}

SceneBuilder flying(double speed) {
    SceneBuilder b(10);
    b.ball("ball", {0, 0, 0}, 0.5).initialVelocity = {speed, 0, 0};
    return b;
}

TEST(CompareRuns, ScalesByTheBoxOfWhatMovesAndTellsWhenItPartsByMore) {
    const auto truth = posed(flying(1)), other = posed(flying(1.01));
    const auto errors = compareRuns(*truth, runOf(*other), runOf(*truth), 1e-3);
    ASSERT_EQ(errors.size(), 1u);
    const double size = 10 + 2 * 0.5;
    EXPECT_NEAR(errors[0].size, size, 1e-12);
    EXPECT_NEAR(errors[0].far, 10.5, 1e-12);
    EXPECT_NEAR(errors[0].largest, 0.1 / size, 1e-12);
    EXPECT_EQ(errors[0].beyondFrom(0.1 / size * 1.001), solution::infinity);
    EXPECT_NEAR(errors[0].beyondFrom(0.05 / size), 5, 1);
}

// A hundred hops: its steps are flights, and the first of them begins at the top.
TEST(CompareRuns, ScalesByTheWholeWayOfLongSteps) {
    SceneBuilder b(30);
    b.floor();
    b.ball("ball", {0, 10.1, 0}).restitution = 0.9;
    b.weight("ball");
    const auto truth = posed(b);
    const auto run = runOf(*truth);
    EXPECT_GT(run.impacts.size(), 64u);
    EXPECT_NEAR(compareRuns(*truth, runOf(*truth), run, 1)[1].size, 10.2, 0.1);
}

TEST(CompareRuns, AnAngleCountsByTheRadius) {
    SceneBuilder b = flying(0);
    b.scene.bodies[0].initialAngularVelocity = {0, 0, 0.3};
    SceneBuilder c = flying(0);
    c.scene.bodies[0].initialAngularVelocity = {0, 0, 0.301};
    const auto truth = posed(b), other = posed(c);
    const auto errors = compareRuns(*truth, runOf(*other), runOf(*truth), 1);
    EXPECT_NEAR(errors[0].largest, 0.01 * 0.5 / 1, 1e-9);
}

TEST(CompareRuns, SaysNothingOfFixedBodiesAndOfWhatTheSecondTookFromTheFirst) {
    const auto truth = posed(flying(1)), other = posed(flying(2));
    auto second = runOf(*truth);
    second.isTaken = {true};
    EXPECT_EQ(compareRuns(*truth, runOf(*other), second, 1)[0].largest, 0);
}

// Both times that it looks at all places: for the largest difference, and for how it grows.
TEST(CompareRuns, AsksOftenWhetherItIsCancelledAndEndsAtOnce) {
    const auto flock = [](double speed) {
        SceneBuilder b(10);
        b.scene.simulator.collisions = false;
        for (int i = 0; i < 100; ++i)
            b.ball("ball" + std::to_string(i), {0, 3.0 * i, 0}).initialVelocity = {speed, 0, 0};
        return posed(b);
    };
    const auto truth = flock(1), other = flock(2);
    const auto first = runOf(*other), second = runOf(*truth);
    std::size_t asked = 0, stopAt = 0;
    const auto cancelled = [&] { return ++asked == stopAt; };
    const std::size_t places = 100 * 65; // each at 64 times and at the end
    (void)compareRuns(*truth, first, second, 1e3, cancelled);
    const std::size_t once = asked;
    EXPECT_GE(once, places / comparisonsPerPoll);
    asked = 0;
    (void)compareRuns(*truth, first, second, 0, cancelled);
    const std::size_t twice = asked;
    EXPECT_GE(twice, 2 * places / comparisonsPerPoll);
    for (stopAt = 1; stopAt <= twice; ++stopAt) {
        asked = 0;
        (void)compareRuns(*truth, first, second, 0, cancelled);
        EXPECT_EQ(asked, stopAt);
    }
}

// A body that falls out of step after more than 100,000 of its steps, and only then: the finish,
// and all before, do not show it.
TEST(CompareRuns, SeesWhatHappensAfterAHundredThousandSteps) {
    const auto stepped = [](const std::string& kick) {
        SceneBuilder b(13);
        b.ball("ball", {1, 0, 0});
        b.force("ball", "-ball.mass*ball.x" + kick, "0", "0");
        Options options;
        options.method = "rk4";
        options.fixedStep = 1e-4;
        return posed(b, options);
    };
    const auto truth = stepped(""), other = stepped("+(t>10.5&&t<10.6?3:0)");
    const auto second = runOf(*truth);
    ASSERT_GT(second.statistics.steps, 120'000u);
    const IslandError error = compareRuns(*truth, runOf(*other), second, 1e-6)[0];
    EXPECT_GT(error.largest, 0.01);
    EXPECT_GT(error.beyondFrom(1e-4), 10.5);
    EXPECT_LT(error.beyondFrom(1e-4), 10.6);
}

TEST(Trace, HasSoManyEqualPartsOfTheMotionAndItsPlaces) {
    const Result result = simulate(flying(3).scene);
    const Trace trace = traceOf(*result.motion, 4);
    ASSERT_EQ(trace.times, (std::vector<double>{0, 2.5, 5, 7.5, 10}));
    for (std::size_t i = 0; i < trace.times.size(); ++i) {
        ASSERT_EQ(trace.places[i].size(), 1u);
        EXPECT_NEAR(trace.places[i][0]->position.x(), 3 * trace.times[i], 1e-12);
        EXPECT_TRUE(trace.places[i][0]->attitude);
    }
}

TEST(ScaledError, IsTheLargestOfTheIslandsEachByItsOwnSize) {
    SceneBuilder b = flying(1);
    b.ball("slow", {0, 0, 50}, 0.5).initialVelocity = {0.1, 0, 0};
    const auto problem = posed(b);
    const Result result = simulate(b.scene);
    Trace truth = traceOf(*result.motion, 10);
    EXPECT_EQ(scaledError(*problem, {0, 1}, truth, *result.motion), 0);
    truth.places[5][0]->position.y() += 0.22; // of 11
    truth.places[5][1]->position.y() += 0.1;  // of 2
    const double alone = scaledError(*problem, {0, 1}, truth, *result.motion);
    EXPECT_NEAR(alone, 0.05, 1e-9);
    // Together they are as large as what holds both.
    EXPECT_NEAR(scaledError(*problem, {0, 0}, truth, *result.motion), 0.22 / 51, 1e-9);
    truth.places[5] = {std::nullopt, std::nullopt};
    EXPECT_EQ(scaledError(*problem, {0, 1}, truth, *result.motion), 0) << "nothing is said there";
}

TEST(ScaledError, IsInfiniteWhereTheMotionIsNotKnown) {
    const auto problem = posed(flying(1));
    Trace truth = traceOf(*simulate(flying(1).scene).motion, 10);
    SceneBuilder shorter = flying(1);
    shorter.scene.simulator.finish = 5;
    const Result result = simulate(shorter.scene);
    EXPECT_EQ(scaledError(*problem, {0}, truth, *result.motion), solution::infinity);
}

// --- nothing is off silently ------------------------------------------------------------------

TEST(Silence, APushThatLastsAMomentIsNotPassedOver) {
    for (const double accuracy : {1e-2, 1e-4, 1e-6})
        for (const double width : {1.0, 0.7, 0.3, 0.1, 0.05}) {
            SceneBuilder b(10, accuracy);
            b.ball("cart", {0, 0, 0});
            b.force("cart", "5*exp(-((t-4)/" + std::to_string(width) + ")^2)", "0", "0");
            const Result result = simulate(b.scene);
            const double speed = 5 * width * std::sqrt(std::numbers::pi);
            const Vector place = result.motion->at(0, 10).position;
            EXPECT_NEAR(place.x(), 6 * speed, accuracy * (6 * speed + 0.2)) << width;
            EXPECT_GT(*result.statistics.errorEstimate, 0) << width;
            EXPECT_THAT(result.motion->notes(), IsEmpty()) << width;
        }
}

TEST(Silence, AMagnetThatABodyFliesPastIsNotPassedOver) {
    SceneBuilder b(20, 1e-4);
    b.ball("ball", {0, 0, 0}).initialVelocity = {1, 0, 0};
    b.force("ball", "0", "2*exp(-((ball.x-9)/0.4)^2)", "0.5*ball.dy-ball.z");
    const Result result = simulate(b.scene);
    const double speed = 0.8 * std::sqrt(std::numbers::pi);
    EXPECT_NEAR(result.motion->at(0, 20).position.y(), 11 * speed, 20.2 * 1e-4);
}

// No error shows where the motion leaves its rest, and each grows with it.
TEST(Silence, WhatLeavesAnUnstableRestIsNotOffByItsFirstSteps) {
    const auto at = [](double accuracy, double finish) {
        SceneBuilder b(finish, accuracy);
        b.ball("bob", {1e-9, 0, 0}, 0.1);
        b.force("bob", "100*sin(bob.x)", "0", "0");
        const Result result = simulate(b.scene);
        EXPECT_THAT(result.motion->notes(), IsEmpty()) << finish;
        return std::pair(result.motion->at(0, finish).position.x(),
                         *result.statistics.errorEstimate);
    };
    for (const auto& [finish, exact] : {std::pair(2.0, 0.24228585446), {1.5, 1.6345085953e-3}})
        for (const double accuracy : {1e-4, 1e-5, 1e-6}) {
            const auto [place, estimate] = at(accuracy, finish);
            const double error = std::abs(place - exact) / 0.2;
            EXPECT_LT(error, accuracy) << finish;
            EXPECT_LT(error, 30 * estimate) << finish;
        }
}

TEST(Silence, APushWithFewStepsElsewhereIsTheSameBesideOtherBodies) {
    const auto place = [](bool others) {
        SceneBuilder b(10);
        b.ball("cart", {0, 0, 0});
        b.force("cart", "5*exp(-((t-4)/0.3)^2)", "0", "0");
        if (others) {
            b.ball("far", {0, 50, 0});
            b.force("far", "sin(7*t)*far.x", "1/(1+(t-6)^2)", "0");
        }
        return rows(*simulate(b.scene).motion, 0);
    };
    EXPECT_EQ(place(false), place(true));
}

TEST(Silence, WhatIsOverTheLargestNumbersStops) {
    SceneBuilder b(10);
    b.ball("far", {1e300, 0, 0});
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_THAT(result.motion->stop(0)->sentence, HasSubstr("far.x grows over 1e100"));
}

TEST(Silence, AFinishThatIsOutOfReachIsRefused) {
    SceneBuilder b(1e300);
    b.ball("planet", {1, 0, 0});
    EXPECT_THAT(simulate(b.scene).refusal[0], HasSubstr("after 1e100"));
}

// Balls in a room amplify rounding, whoever reads them from afar.
TEST(Horizon, OfBallsIsFoundBesideWhatIsIntegrated) {
    const auto horizon = [](bool isRead) {
        SceneBuilder b(60, 1e-4);
        b.room();
        for (int i = 0; i < 8; ++i) {
            scene::Body& ball = b.ball("ball" + std::to_string(i),
                                       {i % 2 - 0.5, (i / 2) % 2 - 0.5, (i / 4) % 2 - 0.5}, 0.2);
            ball.initialVelocity = {std::sin(i + 1.0), std::cos(2.0 * i), std::sin(3.0 * i + 1)};
        }
        if (isRead) {
            b.ball("far", {100, 0, 0});
            b.force("far", "0.01*sin(ball3.x)", "0", "0");
        }
        return simulate(b.scene).statistics.predictableUntil;
    };
    const auto alone = horizon(false), read = horizon(true);
    ASSERT_TRUE(alone && read);
    EXPECT_NEAR(*read, *alone, 0.25 * *alone);
}

// Robertson's reaction: a loose run takes a concentration below 0, from where the equations grow
// without bound. The motion ends there only if a tighter run says so too.
TEST(Accuracy, AnEndThatOnlyOneRunComesToIsNotBelieved) {
    for (const double accuracy : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
        SceneBuilder b(4000, accuracy);
        b.ball("b", Vector::Zero()).initialVelocity = {1, 0, 0};
        b.scene.simulator.collisions = false;
        b.force("b", "-0.04*b.dx+1e4*b.dy*b.dz", "0.04*b.dx-1e4*b.dy*b.dz-3e7*b.dy^2",
                "3e7*b.dy^2");
        const Result result = simulate(b.scene);
        EXPECT_EQ(result.motion->stop(0), std::nullopt) << accuracy;
        EXPECT_NEAR(result.motion->at(0, 4000).velocity.x(), 0.18320226, 1e-3 * accuracy + 1e-6)
            << accuracy;
    }
}

// Seconds since 1970: impacts are known to 2e-7 s then, which the nudged run shows.
TEST(Accuracy, FarFromTheStartOfTimeWhatItsResolutionTakesIsSaid) {
    for (const double start : {0.0, 1.7e9}) {
        SceneBuilder b(start + 10, 1e-8);
        b.scene.simulator.start = start;
        b.floor();
        b.ball("ball", {0, 2, 0}).restitution = 0.8;
        b.weight("ball");
        const Result result = simulate(b.scene);
        ASSERT_TRUE(result.motion->errorEstimate());
        EXPECT_EQ(result.motion->predictableUntil().has_value(), start > 0);
        EXPECT_LT(*result.motion->errorEstimate(), start > 0 ? 1e-4 : 1e-10);
        EXPECT_GT(*result.motion->errorEstimate(), start > 0 ? 1e-7 : 0);
    }
}

// A box that tumbles and hits a floor with its corners has an arm to them of few digits there.
TEST(Accuracy, FarFromTheOriginWhatRoundingOfTheArmsTakesIsSaid) {
    const auto tumbled = [](double far) {
        SceneBuilder b(2.5, 1e-8);
        b.box("floor", {far, -1, 0}, {40, 2, 40}).fixed = true;
        scene::Body& box = b.box("box", {far, 1.5, 0}, {1, 0.6, 0.4});
        box.initialAttitude = geometry::fromRotationVector({0, 0, 0.3});
        box.initialVelocity = {0.5, 0, 0};
        box.initialAngularVelocity = {0, 0, 0.7};
        b.weight("box");
        return simulate(b.scene);
    };
    const Result near = tumbled(0);
    ASSERT_FALSE(near.motion->predictableUntil());
    for (const double far : {1e5, 1e6, 1e7}) {
        const Result result = tumbled(far);
        const double error = std::abs(result.motion->at(1, 2.5).position.y() -
                                      near.motion->at(1, 2.5).position.y()) /
                             2.5; // what moves is about as large
        EXPECT_GT(*result.motion->errorEstimate(), 0.3 * error) << far;
        EXPECT_LT(*result.motion->errorEstimate(), 300 * error) << far;
        EXPECT_TRUE(result.motion->predictableUntil()) << far;
    }
}

// Far from time 0, too, what is hit at the start or soon after it is not late by as much as it has
// taken.
TEST(Accuracy, WhatIsHitSoonAfterALateStartIsPredictable) {
    for (const double start : {10.0, 1e6})
        for (const double gap : {0.0, 1e-9, 1e-3}) {
            SceneBuilder b(start + 2, 1e-4);
            b.scene.simulator.start = start;
            b.floor();
            scene::Body& ball = b.ball("ball", {0, 0.5 + gap, 0}, 0.5);
            ball.initialVelocity = {0, -1, 0};
            b.weight("ball");
            b.ball("resting", {5, 0.5, 0}, 0.5);
            b.ball("hitting", {4 - gap, 0.5, 0}, 0.5).initialVelocity = {1, 0, 0};
            const Result result = simulate(b.scene);
            ASSERT_TRUE(result.motion->errorEstimate());
            EXPECT_LT(*result.motion->errorEstimate(), 5e-5) << start << " " << gap;
            EXPECT_FALSE(result.motion->predictableUntil()) << start << " " << gap;
            EXPECT_NEAR(result.motion->at(2, start + 2).position.x(), 7 - gap, 1e-6);
        }
}

// Balls on two wheels in mesh, which a couple drives; each hinge is so far from its ball's centre.
SceneBuilder wheelsInMesh(const Vector& offset, double couple, double inertia, double ratio) {
    SceneBuilder b(4.05, 1e-5);
    for (const char* name : {"a", "b"}) {
        const Vector hinged(0, 0, *name == 'a' ? 0.0 : 5.0);
        scene::Body& ball = b.ball(name, hinged - offset, 0.1);
        ball.mass = 1;
        ball.inertia = {inertia, inertia, inertia, 0, 0, 0};
        scene::Joint hinge;
        hinge.name = std::string(name) + "j";
        hinge.type = scene::JointType::hinge;
        hinge.body1 = name;
        hinge.offset1 = offset;
        hinge.coordinates.resize(1);
        b.scene.joints.push_back(hinge);
    }
    b.scene.joints[0].coordinates[0].motor = std::to_string(couple);
    scene::Gear gear;
    gear.name = "g";
    gear.terms = {{"aj", 0, 1}, {"bj", 0, -ratio}};
    b.scene.gears.push_back(gear);
    return b;
}

// The arm makes more of an error of the attitude than the ball's radius does.
TEST(Accuracy, ErrorsOfAttitudesCountWithTheArmsOfJoints) {
    const double arm = 0.713, couple = 0.923, inertia = 1.172, ratio = 1.0045;
    const SceneBuilder b = wheelsInMesh({-arm, 0, 0}, couple, inertia, ratio);
    const Result result = simulate(b.scene);
    const double about = inertia + arm * arm;
    const double acceleration = couple / (about + about / (ratio * ratio));
    double error = 0;
    for (int i = 1; i <= 400; ++i) {
        const double t = 4.05 * i / 400, angle = acceleration * t * t / 2;
        const Vector there{arm * std::cos(angle), arm * std::sin(angle), 0};
        error = std::max(error, (result.motion->at(0, t).position - there).norm() / 5.2);
    }
    ASSERT_GT(error, 1e-9);
    EXPECT_GT(*result.motion->errorEstimate(), 0.5 * error);
    EXPECT_LT(*result.motion->errorEstimate(), 30 * error);
}

// A long axle turns with its wheel in place: that takes no more steps.
TEST(Accuracy, AnArmAlongTheAxisOfItsHingeMovesNothing) {
    const auto steps = [](double axle) {
        return simulate(wheelsInMesh({0, 0, axle}, 0.923, 1.172, 1.0045).scene).statistics.steps;
    };
    const auto none = steps(0);
    ASSERT_GT(none, 10U);
    EXPECT_LT(steps(10), none + none / 4); // nearly twice as many with the whole arm
}

// Where the drive is 0 the first step would be as long as the motion so far: whole half periods, in
// which an explicit method sees nothing of it, at all tolerances alike.
TEST(Accuracy, ARectifiedDriveLosesNoHalfWave) {
    for (const double accuracy : {1e-6, 1e-7}) {
        SceneBuilder b(1000, accuracy);
        b.scene.simulator.collisions = false;
        b.ball("b", Vector::Zero());
        b.force("b", "b.mass*abs(sin(20*t))", "0", "0");
        const Result result = simulate(b.scene);
        const double size = result.motion->at(0, 1000).position.x(), half = std::numbers::pi / 20;
        double x = 0; // after each half wave, by 0.1 faster
        for (int n = 0; n < 6300; ++n, x += half * (0.1 * n - 0.05))
            ASSERT_NEAR(result.motion->at(0, half * n).position.x(), x, accuracy * size)
                << accuracy << ", half wave " << n;
    }
}

// Two runs make all but the same steps where switches cut them, and erred alike: by 26 and 15 times
// the accuracy, and estimated 0.2 and 0.4 of it.
TEST(Accuracy, WhatRestartsAfterFewStepsErrsByNoMoreThanIsAsked) {
    struct Case {
        double from, finish;
        std::string force;
        double accuracy;
    };
    for (const Case& c : {Case{2.13, 88.956, "-9.81+(p.x<0?-400*p.x:0)", 1e-2},
                          Case{2, 243.563, "abs(p.x)<1 ? -p.x : -sign(p.x)", 1e-3}}) {
        const auto solved = [&c](double accuracy) {
            SceneBuilder b(c.finish, accuracy);
            b.ball("p", {c.from, 0, 0}, 0.1);
            b.force("p", c.force, "0", "0");
            return simulate(b.scene);
        };
        const Result result = solved(c.accuracy), fine = solved(1e-9);
        double error = 0, least = c.from, most = c.from;
        for (int i = 0; i <= 5000; ++i) {
            const double t = c.finish * i / 5000;
            const double x = fine.motion->at(0, t).position.x();
            error = std::max(error, std::abs(result.motion->at(0, t).position.x() - x));
            least = std::min(least, x);
            most = std::max(most, x);
        }
        EXPECT_LE(error, c.accuracy * (most - least + 0.2)) << c.force;
    }
}

} // namespace
} // namespace simulation::testing
