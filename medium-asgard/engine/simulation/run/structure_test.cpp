// How much work a scene's structure saves, and that threads change nothing: the five cases of the
// dissertation's section 5.2.4, Figure 5.11's scene, and equal bytes on any number of threads.
// Work is counted; times are in bench/.
#include "simulation/testing.h"

#include <cstdio>

namespace simulation::testing {
namespace {

// A ball on springs that are sines, about where it stands.
void swinging(SceneBuilder& b, const std::string& name, const Vector& place, double push = 0) {
    scene::Body& body = b.ball(name, place, 0.2);
    body.initialVelocity = {push, 0.7 * push, 0};
    const auto spring = [&](const char* axis, double rest) {
        return "-10*sin(" + name + "." + axis + "-(" + std::to_string(rest) + "))";
    };
    b.force(name, spring("x", place.x()), spring("y", place.y()), spring("z", place.z()));
}

// Two of them and a ball between that strikes one and the other, and others that nothing meets.
scene::Scene strikes(std::size_t others) {
    SceneBuilder b(3, 1e-4);
    swinging(b, "left", {-1, 0, 0});
    swinging(b, "right", {1, 0, 0});
    b.ball("ball", {0, 0, 0}, 0.2).initialVelocity = {3, 0, 0};
    for (std::size_t i = 0; i < others; ++i)
        swinging(b, "other" + std::to_string(i), {20.0 + 10 * static_cast<double>(i), 0, 0}, 1.5);
    return b.scene;
}

enum class Case { wholeWithout, partsWithout, whole, parts, partsToTheEnd };

Result resultOf(Case which, std::size_t others, int threads = 1, const std::string& method = "") {
    scene::Scene scene = strikes(others);
    scene.simulator.collisions = which != Case::wholeWithout && which != Case::partsWithout;
    Options options;
    options.threads = threads;
    options.method = method;
    options.whole = which == Case::wholeWithout || which == Case::whole;
    options.eventDriven = which != Case::partsToTheEnd;
    return simulate(scene, options);
}

Statistics workOf(Case which, std::size_t others) { return resultOf(which, others).statistics; }

std::string written(const Result& result) {
    const Statistics& s = result.statistics;
    std::string text;
    for (const std::size_t count :
         {s.steps, s.rejectedSteps, s.discardedSteps, s.evaluations, s.equationEvaluations,
          s.factorisations, s.pairTests, s.collisions, s.components, s.historyBytes})
        text += std::to_string(count) + " ";
    char number[40];
    for (std::size_t body = 0; body < result.motion->bodies(); ++body)
        for (const double x : rows(*result.motion, body)) {
            std::snprintf(number, sizeof number, "%a ", x);
            text += number;
        }
    return text;
}

} // namespace

TEST(FiveCases, AreOneMotion) {
    const Result reference = resultOf(Case::parts, 2);
    EXPECT_GE(reference.statistics.collisions, 3u);
    for (const Case which : {Case::whole, Case::partsToTheEnd}) {
        const Result other = resultOf(which, 2);
        EXPECT_EQ(other.statistics.collisions, reference.statistics.collisions);
        for (std::size_t body = 0; body < 5; ++body)
            EXPECT_LT(distance(other.motion->at(body, 3).position,
                               reference.motion->at(body, 3).position),
                      3e-3);
    }
    const Result late = resultOf(Case::partsToTheEnd, 2); // it throws away more, and that is all
    for (std::size_t body = 0; body < 5; ++body)
        EXPECT_EQ(rows(*late.motion, body), rows(*reference.motion, body));
}

TEST(FiveCases, SolveEverythingOrItsParts) {
    EXPECT_EQ(workOf(Case::wholeWithout, 8).components, 1u);
    EXPECT_EQ(workOf(Case::whole, 8).components, 1u);
    EXPECT_GE(workOf(Case::partsWithout, 8).components, 20u);
    EXPECT_EQ(workOf(Case::partsWithout, 8).collisions, 0u);
}

// With like time constants one component costs little more than many, until bodies collide: then
// every collision restarts everything (Figure 5.11: the third case beside the fourth).
TEST(FiveCases, CollisionsCostTheWholeAndNotItsParts) {
    const auto extra = [](Case with, Case without) {
        return static_cast<double>(workOf(with, 40).equationEvaluations) /
               static_cast<double>(workOf(without, 40).equationEvaluations);
    };
    const double parts = extra(Case::parts, Case::partsWithout);
    const double whole = extra(Case::whole, Case::wholeWithout);
    EXPECT_LT(parts, 1.35);
    EXPECT_GT(whole, parts);
    EXPECT_GT(workOf(Case::whole, 40).equationEvaluations,
              3 * workOf(Case::parts, 40).equationEvaluations);
}

// The dissertation's own rule in each case: Figure 5.11's five lines, in the order in which it has
// them. Equations evaluated with 2 and with 20 others, when this was written:
//
//     1 whole, no collisions   2210   10166      3 whole            8255   37973
//     2 parts, no collisions   1086    6036      4 parts            1305    6255
//                                                5 parts, late      1354    6304
TEST(FiveCases, CostByTheOriginalRuleWhatTheyDidThen) {
    const auto cost = [](Case which, std::size_t others) {
        const Result result = resultOf(which, others, 1, "original");
        for (const ComponentStatistics& c : result.statistics.componentList)
            EXPECT_EQ(c.method, "original");
        EXPECT_EQ(result.statistics.reached, 3);
        return static_cast<double>(result.statistics.equationEvaluations);
    };
    for (const std::size_t others : {2u, 20u}) {
        const double wholeWithout = cost(Case::wholeWithout, others);
        const double partsWithout = cost(Case::partsWithout, others);
        const double whole = cost(Case::whole, others), parts = cost(Case::parts, others);
        const double late = cost(Case::partsToTheEnd, others);
        EXPECT_LT(partsWithout, wholeWithout);
        EXPECT_GT(whole, 3 * wholeWithout); // each collision restarts everything
        EXPECT_GT(whole, 4 * parts);
        EXPECT_GT(parts, partsWithout);
        EXPECT_LT(parts, (1 + 1.0 / static_cast<double>(others)) * partsWithout);
        EXPECT_GT(late, parts); // "the wasted computation becomes less significant"
        EXPECT_LT(late - parts, 0.2 * parts / static_cast<double>(others));
    }
}

// What a collision throws away is within a step of those who meet, whoever else there is.
TEST(FiveCases, ThrowAwayLittle) {
    const Statistics few = workOf(Case::parts, 2), many = workOf(Case::parts, 60);
    EXPECT_LE(many.discardedSteps, few.discardedSteps + 4);
    EXPECT_LT(20 * many.discardedSteps, many.steps);
    // Without the schedule each collision throws away all that was solved behind it ...
    const Statistics late = workOf(Case::partsToTheEnd, 2),
                     lateMany = workOf(Case::partsToTheEnd, 60);
    EXPECT_GT(late.discardedSteps, 3 * few.discardedSteps);
    // ... of those who meet: "the wasted computation becomes less significant as the problem size
    // increases".
    EXPECT_EQ(lateMany.discardedSteps, late.discardedSteps);
}

// Figure 5.11: bodies that meet nobody add their own cost.
TEST(FiveCases, OthersCostTheirOwn) {
    const auto cost = [](std::size_t others) {
        const Statistics s = workOf(Case::parts, others);
        return std::pair{static_cast<double>(s.evaluations), static_cast<double>(s.pairTests)};
    };
    const auto none = cost(0), few = cost(10), many = cost(110);
    const double own = (few.first - none.first) / 10;
    EXPECT_NEAR(many.first - few.first, 100 * own, 0.05 * 100 * own);
    EXPECT_NEAR(many.second, none.second, 4);
}

TEST(Threads, ChangeNeitherMotionNorCounts) {
    for (const Case which : {Case::partsWithout, Case::parts, Case::partsToTheEnd, Case::whole}) {
        const std::string one = written(resultOf(which, 40));
        for (const int threads : {2, 4, 8, 16})
            EXPECT_EQ(written(resultOf(which, 40, threads)), one) << threads;
    }
    const std::string original = written(resultOf(Case::parts, 40, 1, "original"));
    EXPECT_EQ(written(resultOf(Case::parts, 40, 16, "original")), original);
}

// Balls on springs in a crowd: many meet, some at the same instant.
TEST(Threads, ChangeNothingInACrowd) {
    SceneBuilder b(2, 1e-4);
    for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 5; ++k)
            swinging(b, "b" + std::to_string(i) + "x" + std::to_string(k), {0.6 * i, 0.6 * k, 0},
                     ((i + 2 * k) % 5) - 2.0);
    Options options;
    const Result one = simulate(b.scene, options);
    EXPECT_GT(one.statistics.collisions, 20u);
    for (const int threads : {2, 4, 8, 16}) {
        options.threads = threads;
        EXPECT_EQ(written(simulate(b.scene, options)), written(one)) << threads;
    }
}

} // namespace simulation::testing
