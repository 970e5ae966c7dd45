// The engine as its callers see it: motion against closed form, work that is counted, bits that
// repeat, and faults that are told.
#include "simulation/testing.h"

#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Simulation, AThrownBodyFollowsItsParabola) {
    SceneBuilder b(2);
    scene::Body& ball = b.ball("ball", {1, 2, 3});
    ball.initialVelocity = {4, 5, 6};
    b.weight("ball");
    const Result result = simulate(b.scene);
    EXPECT_LT(
        distance(result.motion->at(0, 2).position, {1 + 4 * 2, 2 + 5 * 2 - 0.5 * g * 4, 3 + 6 * 2}),
        1e-12);
    EXPECT_EQ(result.statistics.errorEstimate, 0);
    EXPECT_EQ(result.statistics.steps, 0u);
}

// What is held in the end was integrated before: then it is not exact.
TEST(Simulation, TheErrorOfEarlierPhasesCounts) {
    SceneBuilder b(4, 1e-3);
    b.ball("ball", {0, 0, 0}).initialVelocity = {3, 0, 0};
    b.force("ball", "-2*ball.dx^2", "0", "0");
    b.hold("ball", 2, 4, {{7, 0, 0}, {8, 0, 0}});
    const Result result = simulate(b.scene);
    EXPECT_GT(result.statistics.steps, 0u);
    ASSERT_TRUE(result.statistics.errorEstimate);
    EXPECT_GT(*result.statistics.errorEstimate, 0);
    const double c = 2 / b.scene.bodies[0].mass.value_or(1); // x = log(1 + 3 c t)/c
    EXPECT_NEAR(result.motion->at(0, 1.5).position.x(), std::log1p(3 * c * 1.5) / c, 1e-3);
}

// A compound pendulum released from rest at angle a swings back after 4 sqrt(I/(m g d))
// K(sin(a/2)).
TEST(Simulation, APendulumReturnsAfterOneExactPeriod) {
    const double a = 1.2, k = 3.0;
    for (const double accuracy : {1e-4, 1e-7, 1e-10}) {
        SceneBuilder b(10, accuracy);
        scene::Body& rod = b.box("rod", {0, 0, 0}, {1, 0.1, 0.1});
        rod.initialAttitude = Quaternion(Eigen::AngleAxisd(a, Vector::UnitZ()));
        b.force("rod", "0", "0", "-3*sin(2*atan2(rod.qz,rod.qw))").couple = true;
        const double inertia = (1.0 + 0.01) / 12;
        const double period = 4 * std::sqrt(inertia / k) * std::comp_ellint_1(std::sin(a / 2));
        const Result result = simulate(b.scene);
        const auto angle = [&](double t) {
            const Quaternion q = result.motion->at(0, t).attitude;
            return 2 * std::atan2(q.z(), q.w());
        };
        EXPECT_NEAR(angle(period), a, 2 * accuracy) << accuracy;
        EXPECT_NEAR(angle(5 * period), a, 2 * accuracy) << accuracy;
        ASSERT_TRUE(result.statistics.errorEstimate);
        EXPECT_LE(*result.statistics.errorEstimate, accuracy);
    }
}

// Along the line of centres v1' = (m1 - e m2) v / (m1 + m2), v2' = (1 + e) m1 v / (m1 + m2).
TEST(Simulation, AnObliqueImpactGivesTheExactVelocities) {
    SceneBuilder b(0.5);
    scene::Body& striker = b.ball("striker", {-1.5, 0, 0}, 0.25);
    striker.mass = 2;
    striker.restitution = 0.8;
    striker.initialVelocity = {3, 0, 0};
    b.ball("ball", {0, 0.25, 0}, 0.25).restitution = 0.8;
    const Result result = simulate(b.scene);
    ASSERT_EQ(result.motion->impacts().size(), 1u);
    EXPECT_NEAR(result.motion->impacts()[0].time, (1.5 - 0.25 * std::sqrt(3.0)) / 3, 1e-14);
    const double along = 3 * std::cos(std::numbers::pi / 6);
    const Vector line(std::cos(std::numbers::pi / 6), std::sin(std::numbers::pi / 6), 0);
    EXPECT_LT(distance(result.motion->at(1, 0.5).velocity, 1.2 * along * line), 1e-13);
    EXPECT_LT(distance(result.motion->at(0, 0.5).velocity, Vector(3, 0, 0) - 0.6 * along * line),
              1e-13);
}

TEST(Simulation, ABallBouncesWithItsRestitution) {
    SceneBuilder b(1);
    b.floor();
    b.ball("ball", {0, 1.1, 0}).restitution = 0.8;
    b.weight("ball");
    const Result result = simulate(b.scene);
    const double fall = std::sqrt(2 / g);
    ASSERT_FALSE(result.motion->impacts().empty());
    EXPECT_NEAR(result.motion->impacts()[0].time, fall, 1e-13);
    EXPECT_NEAR(result.motion->impacts()[0].impulse, 1.8 * g * fall, 1e-12);
    const double t = 1 - fall;
    EXPECT_NEAR(result.motion->at(1, 1).position.y(), 0.1 + 0.8 * g * fall * t - g * t * t / 2,
                1e-12);
}

// Hit at the middle of an edge, whose faster end then sinks in and is hit on its own: all that
// changed the momentum is told.
TEST(Simulation, ImpulsesAtAnEdgeAndAtItsEndsAreAllTold) {
    SceneBuilder b(0.1);
    b.floor(8);
    scene::Body& box = b.box("box", {0, std::sqrt(0.5), 0}, {1, 1, 1});
    box.initialAttitude = geometry::fromRotationVector({0, 0, std::numbers::pi / 4});
    box.initialVelocity = {0, -1, 0};
    box.initialAngularVelocity = {1, 0, 0};
    box.restitution = 0.3;
    const Result result = simulate(b.scene);
    const auto impacts = result.motion->impacts();
    ASSERT_GE(impacts.size(), 2u);
    double impulses = 0;
    Vector moment = Vector::Zero(); // about where its centre was
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        EXPECT_LT(impacts[i].time, 1e-9);
        impulses += impacts[i].impulse;
        moment +=
            impacts[i].impulse * (impacts[i].point - box.initialPosition).cross(Vector(0, 1, 0));
    }
    const BodyState after = result.motion->at(1, 0.05);
    EXPECT_NEAR(impulses, after.velocity.y() + 1, 1e-12);
    const double inertia = 1.0 / 6;
    EXPECT_LT(distance(box.initialAngularVelocity + moment / inertia, after.angularVelocity),
              1e-12);
}

// --- islands ----------------------------------------------------------------------------------

void addSwinging(SceneBuilder& b, const std::string& name, double x) {
    b.ball(name, {x, 1, 0}).collisionGroup = 1;
    b.force(name, "-4*(" + name + ".x-" + std::to_string(x - 0.5) + ")^3", "-" + name + ".y", "0");
}

TEST(Simulation, ABodyThatMeetsNobodyMovesTheSameWithAndWithoutOthers) {
    SceneBuilder alone(5), among(5);
    addSwinging(alone, "one", 0);
    addSwinging(among, "one", 0);
    among.floor().collisionGroup = 1;
    among.ball("falling", {50, 3, 0}).restitution = 0.5;
    among.weight("falling");
    const Result a = simulate(alone.scene), b = simulate(among.scene);
    EXPECT_EQ(rows(*a.motion, 0), rows(*b.motion, 0));
}

TEST(Simulation, AnUnrelatedBodyCostsOnlyItself) {
    SceneBuilder one(5), two(5);
    addSwinging(one, "one", 0);
    addSwinging(two, "one", 0);
    addSwinging(two, "two", 0);
    const Result a = simulate(one.scene), b = simulate(two.scene);
    EXPECT_GT(a.statistics.equationEvaluations, 100u);
    EXPECT_EQ(b.statistics.equationEvaluations, 2 * a.statistics.equationEvaluations);
    EXPECT_EQ(b.statistics.steps, 2 * a.statistics.steps);
}

// --- orientations ------------------------------------------------------------------------------

// A brick on a spring, which tumbles or not.
SceneBuilder tumbling(const Vector& spin) {
    SceneBuilder b(5);
    b.box("brick", {1, 0, 0}, {1, 2, 3}).initialAngularVelocity = spin;
    b.force("brick", "-sin(brick.x)", "-sin(brick.y)", "0");
    return b;
}

std::size_t evaluationsOf(const Result& result, std::size_t unknowns) {
    std::size_t sum = 0;
    for (const ComponentStatistics& c : result.statistics.componentList)
        sum += c.unknowns == unknowns ? c.evaluations : 0;
    return sum;
}

// What it does in space does not depend on how it turns, and costs nothing more.
TEST(Orientation, ThatNothingReadsIsInNoSystemThatIsSolved) {
    const Result still = simulate(tumbling({0, 0, 0}).scene);
    const Result turns = simulate(tumbling({1, 2, 3}).scene);
    EXPECT_GT(evaluationsOf(still, 2), 50u); // x with its velocity
    EXPECT_EQ(evaluationsOf(turns, 2), evaluationsOf(still, 2));
    EXPECT_GT(evaluationsOf(turns, 4), 50u); // the attitude, by itself
    EXPECT_EQ(evaluationsOf(still, 4), 0u);
    for (const double t : {0.5, 1.0, 2.7, 5.0})
        EXPECT_EQ(turns.motion->at(0, t).position, still.motion->at(0, t).position);
}

// It can be seen at any time, as well as it was asked for: 1 rad/s about a principal axis.
TEST(Orientation, ThatNothingReadsIsSeenAsItIs) {
    const Result result = simulate(tumbling({0, 0, 1}).scene);
    for (const double t : {0.0, 0.1, 1.7, 5.0})
        EXPECT_LT(result.motion->at(0, t).attitude.angularDistance(
                      Quaternion(Eigen::AngleAxisd(t, Vector::UnitZ()))),
                  1e-12);
}

// Of expressions that are all that is asked for, it is solved where one of them reads it.
TEST(Orientation, ThatNobodyAsksForIsNotSolved) {
    const scene::Scene scene = tumbling({1, 2, 3}).scene;
    Options options;
    options.only = {"brick.x", "brick.dy^2"};
    const Result places = simulate(scene, options);
    EXPECT_EQ(places.statistics.equationEvaluations,
              simulate(tumbling({0, 0, 0}).scene, options).statistics.equationEvaluations);
    options.only = {"brick.x", "scene.energy"};
    const Result energy = simulate(scene, options);
    EXPECT_GT(evaluationsOf(energy, 3), 0u); // spins
    EXPECT_EQ(evaluationsOf(energy, 4), 0u);
    options.only = {"brick.px(1,0,0)"};
    EXPECT_GT(evaluationsOf(simulate(scene, options), 4), 0u);
    const Result all = simulate(scene);
    std::vector<std::string> faults;
    for (const Result* result : {&places, &energy})
        for (const double t : {0.0, 1.3, 5.0})
            EXPECT_EQ(Quantities(scene, options, result->motion, {"brick.x"}, faults).at(t),
                      Quantities(scene, {}, all.motion, {"brick.x"}, faults).at(t));
}

// A force that reads it makes it part of what is solved, whatever is asked for; so do collisions.
TEST(Orientation, ThatSomethingReadsIsSolved) {
    Options options;
    options.only = {"brick.x"};
    SceneBuilder read = tumbling({1, 2, 3});
    read.force("brick", "0", "0", "brick.qx");
    EXPECT_EQ(simulate(read.scene, options).statistics.equationEvaluations,
              simulate(read.scene).statistics.equationEvaluations);
    SceneBuilder meets = tumbling({1, 2, 3});
    meets.ball("other", {50, 0, 0});
    EXPECT_EQ(simulate(meets.scene, options).statistics.equationEvaluations,
              simulate(meets.scene).statistics.equationEvaluations);
}

// --- planes ------------------------------------------------------------------------------------

// A rod that swings on a link, in the plane z = 0, and a ball that comes along z and meets it at t
// = 1.
SceneBuilder planarRod(double speed) {
    SceneBuilder b(1.5, 1e-4);
    scene::Body& rod = b.box("rod", {0, -0.5, 0}, {0.1, 1, 0.1});
    rod.initialVelocity = {0.25, 0, 0};
    rod.initialAngularVelocity = {0, 0, 0.5};
    b.weight("rod");
    scene::Link link;
    link.first = {"rod", Vector(0, 0.5, 0)};
    link.second = scene::PointEnd{{"0", "0", "0"}};
    link.tightness = 400;
    b.scene.links.push_back(link);
    b.ball("ball", {0, -0.6, -1.15}).initialVelocity = {0, 0, speed};
    return b;
}

// Seven of a body's thirteen unknowns move; the others cost nothing until an event wakes them.
TEST(Planes, CostWhatAPlanarProgramCostsUntilAnEvent) {
    Options until;
    until.finish = 0.9;
    const Statistics before = simulate(planarRod(1).scene, until).statistics;
    EXPECT_EQ(before.largestComponent, 7u);
    const Statistics alone = simulate(planarRod(-1).scene, until).statistics;
    EXPECT_EQ(before.equationEvaluations, alone.equationEvaluations);
    const Result result = simulate(planarRod(1).scene);
    ASSERT_GE(result.statistics.collisions, 1u);
    EXPECT_GT(result.statistics.largestComponent, 7u);
    EXPECT_NE(result.motion->at(0, 1.5).position.z(), 0);
    EXPECT_EQ(result.motion->at(0, 0.9).position.z(), 0);
}

// ------------------------------------------------------------------------------------------------

TEST(Simulation, TheSameSceneGivesTheSameBits) {
    SceneBuilder b(3, 1e-4);
    b.floor();
    scene::Body& box = b.box("box", {0, 1, 0}, {0.3, 0.2, 0.4});
    box.restitution = 0.5;
    box.initialAngularVelocity = {1, 2, 3};
    b.weight("box");
    const Result first = simulate(b.scene), second = simulate(b.scene);
    EXPECT_EQ(rows(*first.motion, 1), rows(*second.motion, 1));
    EXPECT_EQ(first.statistics.evaluations, second.statistics.evaluations);
}

// --- faults -----------------------------------------------------------------------------------

TEST(Simulation, AForceThatIsNotFiniteIsNamedAndTheOthersGoOn) {
    SceneBuilder b(3);
    b.ball("bad", {0, 0, 0});
    b.ball("good", {5, 0, 0}).initialVelocity = {1, 0, 0};
    b.force("bad", "sqrt(1-t)", "0", "0").source.line = 12;
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_NEAR(result.motion->stop(0)->time, 1, 1e-6);
    EXPECT_THAT(result.motion->stop(0)->sentence, HasSubstr("body \"bad\""));
    EXPECT_THAT(result.motion->stop(0)->sentence, HasSubstr("not a number"));
    EXPECT_FALSE(result.motion->stop(1));
    EXPECT_LT(distance(result.motion->at(1, 3).position, {8, 0, 0}), 1e-12);
    EXPECT_TRUE(result.motion->at(0, 3).position.allFinite());
}

// By the state as well as by the time; what reads the body that stops ends with it, what does not
// goes on.
TEST(Simulation, AnExpressionThatIsNotFiniteIsNamed) {
    SceneBuilder b(3);
    b.ball("bad", {0, 0, 0}).initialVelocity = {1, 0, 0};
    b.ball("reader", {5, 0, 0});
    b.ball("good", {0, 5, 0}).initialVelocity = {0, 1, 0};
    b.ball("turned", {0, 0, 5});
    b.force("bad", "0", "sqrt(2-bad.x)", "0");
    b.force("reader", "bad.y", "0", "0");
    b.force("turned", "log(1-t)", "0", "0").couple = true;
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(0));
    EXPECT_NEAR(result.motion->stop(0)->time, 2, 1e-6);
    EXPECT_THAT(result.motion->stop(0)->sentence,
                HasSubstr("the force on body \"bad\" is not finite: its y, \"sqrt(2-bad.x)\", is "
                          "not a number"));
    ASSERT_TRUE(result.motion->stop(1));
    EXPECT_NEAR(result.motion->stop(1)->time, 2, 1e-6);
    EXPECT_FALSE(result.motion->stop(2));
    EXPECT_LT(distance(result.motion->at(2, 3).position, {0, 8, 0}), 1e-12);
    ASSERT_TRUE(result.motion->stop(3));
    EXPECT_NEAR(result.motion->stop(3)->time, 1, 1e-6);
    EXPECT_THAT(result.motion->stop(3)->sentence, HasSubstr("its x, \"log(1-t)\","));
}

// A million lengths from the origin positions are known to 1e-10; near the centre of attraction
// that is amplified, and two runs at tolerances below it are equal, bit for bit, and wrong.
TEST(Simulation, RunsThatAreEqualByRoundingDoNotProveEachOther) {
    for (const double accuracy : {1e-6, 1e-9}) {
        SceneBuilder b(2, accuracy);
        b.ball("planet", {1e6 + 1.99, 1e6, 0}, 0.001).initialVelocity = {0, 0.4455, 0};
        const std::string x = "(planet.x-1000000)", y = "(planet.y-1000000)";
        const std::string pull = "-39.478/(" + x + "^2+" + y + "^2)^1.5*";
        b.force("planet", pull + x, pull + y, "0");
        const Result result = simulate(b.scene);
        ASSERT_TRUE(result.statistics.errorEstimate);
        EXPECT_GT(*result.statistics.errorEstimate, accuracy);
        EXPECT_TRUE(result.statistics.predictableUntil);
    }
}

TEST(Simulation, WhatCannotBeComputedIsRefusedWithSentences) {
    SceneBuilder b(3);
    b.ball("ball", {0, 0, 0});
    Options options;
    options.method = "magic";
    const Result method = simulate(b.scene, options);
    EXPECT_EQ(method.motion, nullptr);
    EXPECT_THAT(method.refusal, ElementsAre(HasSubstr("no method \"magic\" (methods here: auto")));
    options = {};
    options.parameters = {{"k", 1.0}};
    EXPECT_THAT(simulate(b.scene, options).refusal,
                ElementsAre("The scene has no parameter \"k\"."));
    options = {};
    options.finish = -1;
    EXPECT_THAT(simulate(b.scene, options).refusal,
                ElementsAre("The motion would finish before it starts."));
    b.scene.bodies[0].shape = "nothing";
    EXPECT_THAT(simulate(b.scene).refusal, ElementsAre(HasSubstr("Body \"ball\" has no shape")));
}

// Where a turn about a moving axis ends at no rotation, parts of the spin are differences of larger
// numbers, and no polynomial fits them as closely as they are small.
TEST(Simulation, ATurnThatEndsAtNoRotationTakesFewSteps) {
    SceneBuilder b(6);
    b.box("held", {0, 0, 0}, {1, 1, 1});
    scene::Trajectory turn;
    turn.name = "turn";
    turn.curves = {{.from = 0,
                    .to = 1,
                    .control = {{0, 0, 0}, {0, 0, 1. / 3}, {-1. / 9, 0, 7. / 9}, {0, 0, 1}}},
                   {.from = 1,
                    .to = 3,
                    .control = {{0, 0, 1}, {2. / 9, 0, 13. / 9}, {1, 0, 13. / 6}, {1, 0, 2}}},
                   {.from = 3,
                    .to = 5,
                    .control = {{1, 0, 2}, {1, 0, 11. / 6}, {1. / 3, 0, 2. / 3}, {0, 0, 0}}}};
    b.scene.trajectories.push_back(turn);
    scene::Constraint attitude;
    attitude.body = "held";
    attitude.trajectory = "turn";
    attitude.held = scene::Held::attitude;
    b.scene.constraints.push_back(attitude);
    std::size_t polls = 0;
    const Result result =
        simulate(b.scene, {}, {.cancelled = [&] { return ++polls > 20'000; }, .progress = {}});
    ASSERT_FALSE(result.cancelled);
    EXPECT_LT(result.statistics.steps, 2000u);
    const BodyState end = result.motion->at(0, 5);
    EXPECT_NEAR(end.attitude.w(), 1, 1e-12);
    EXPECT_NEAR(end.angularVelocity.x(), -0.5, 1e-9); // the curve's slope at its end
    EXPECT_NEAR(end.angularVelocity.z(), -1, 1e-9);
}

TEST(Simulation, HeldBodiesThatMeetPassAndTheLogSaysSoOnce) {
    SceneBuilder b(3);
    b.ball("left", {0, 0, 0});
    b.ball("right", {0, 0, 0});
    b.hold("left", 0, 3, {{-1, 0, 0}, {1, 0, 0}});
    b.hold("right", 0, 3, {{1, 0, 0}, {-1, 0, 0}});
    const Result result = simulate(b.scene);
    EXPECT_THAT(result.motion->notes(), ElementsAre(HasSubstr("are both held where they meet")));
    EXPECT_THAT(result.motion->impacts(), IsEmpty());
}

// --- observers --------------------------------------------------------------------------------

TEST(Simulation, CancellingKeepsWhatThereIs) {
    SceneBuilder b(1000);
    addSwinging(b, "one", 0);
    int asked = 0;
    const Result result =
        simulate(b.scene, {}, {.cancelled = [&] { return ++asked > 200; }, .progress = {}});
    EXPECT_TRUE(result.cancelled);
    ASSERT_NE(result.motion, nullptr);
    EXPECT_TRUE(result.motion->draft());
    EXPECT_GT(result.motion->computed(), 0);
    EXPECT_LT(result.motion->computed(), 1000);
    EXPECT_LT(asked, 210);
}

TEST(Simulation, ProgressPublishesDraftsThatGrowAndChangeNothing) {
    SceneBuilder b(20);
    addSwinging(b, "one", 0);
    std::vector<double> reached;
    const Result watched =
        simulate(b.scene, {}, {.cancelled = {}, .progress = [&](const MotionPointer& motion) {
                                   EXPECT_TRUE(motion->draft());
                                   reached.push_back(motion->computed());
                               }});
    EXPECT_GT(reached.size(), 10u);
    EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end()));
    EXPECT_EQ(rows(*watched.motion, 0), rows(*simulate(b.scene).motion, 0));
    EXPECT_FALSE(watched.motion->draft());
}

// --- quantities -------------------------------------------------------------------------------

TEST(Quantities, ReadTheMotionAndTheCollisions) {
    SceneBuilder b(1);
    b.floor();
    b.ball("ball", {0, 1.1, 0});
    b.weight("ball");
    const Result result = simulate(b.scene);
    std::vector<std::string> faults;
    const Quantities q(b.scene, {}, result.motion,
                       {"ball.y", "events.collisions", "scene.py", "2*t"}, faults);
    EXPECT_THAT(faults, IsEmpty());
    const std::vector<double> before = q.at(0.4), after = q.at(0.5);
    EXPECT_NEAR(before[0], 1.1 - g * 0.08, 1e-12);
    EXPECT_EQ(before[1], 0);
    EXPECT_EQ(after[1], 1);
    EXPECT_NEAR(before[2], -g * 0.4, 1e-12);
    EXPECT_EQ(before[3], 0.8);
}

TEST(Quantities, TellWhatTheyCannotRead) {
    SceneBuilder b(1);
    b.ball("ball", {0, 0, 0});
    const Result result = simulate(b.scene);
    std::vector<std::string> faults;
    const Quantities q(b.scene, {}, result.motion, {"bell.y"}, faults);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_THAT(faults[0], HasSubstr("\"bell.y\""));
    EXPECT_THAT(faults[0], HasSubstr("ball"));
    EXPECT_TRUE(std::isnan(q.at(0)[0]));
}

} // namespace
} // namespace simulation::testing
