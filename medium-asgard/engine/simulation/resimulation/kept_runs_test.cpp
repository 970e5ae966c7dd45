// A run that goes on is the run that was longer from the start, and the runs of a search are made
// once, however often the search is repeated.
#include "resimulation/kept_runs.h"

#include "run/budget.h"
#include "simulation/testing.h"

namespace simulation::testing {
namespace {

using ::testing::ElementsAre;

// A ball that bounces on the floor, and one that swings beside it.
SceneBuilder bounceAndSwing(double finish) {
    SceneBuilder b(finish);
    b.floor();
    b.ball("bouncing", {0, 1, 0}).restitution = 0.8;
    b.ball("swinging", {5, 3, 0});
    b.weight("bouncing");
    b.force("swinging", "0", "-4*(swinging.y - 2)^3", "0");
    return b;
}

std::shared_ptr<Problem> posed(const SceneBuilder& builder) {
    return std::get<std::shared_ptr<Problem>>(problemOf(builder.scene, {}));
}

std::vector<double> tolerancesOf(const Problem& problem, double tolerance = 1e-6) {
    return std::vector<double>(problem.bodies->size(), tolerance);
}

std::vector<double> rowsOf(const Run& run, const Problem& problem) {
    const MotionPointer motion = run.motion(problem, false);
    std::vector<double> all;
    for (std::size_t body = 0; body < problem.bodies->size(); ++body)
        std::ranges::copy(rows(*motion, body), std::back_inserter(all));
    return all;
}

struct Scratch {
    explicit Scratch(double finish) : problem(posed(bounceAndSwing(finish))) {
        run = OpenRun(*problem, tolerancesOf(*problem)).upToFinish({}, nullptr);
    }
    std::shared_ptr<Problem> problem;
    Run run;
};

TEST(OpenRuns, GoesOnAndBackAsRunsFromTheStart) {
    const auto problem = posed(bounceAndSwing(1));
    OpenRun open(*problem, tolerancesOf(*problem));
    std::size_t steps = 0;
    for (const double finish : {1.0, 2.3, 0.7, 2.3, 3.0}) {
        problem->scene.simulator.finish = finish;
        ASSERT_TRUE(open.canGoOn(nullptr)) << finish;
        const auto run = open.upToFinish({}, nullptr);
        const Scratch scratch(finish);
        EXPECT_EQ(rowsOf(run, *problem), rowsOf(scratch.run, *scratch.problem)) << finish;
        EXPECT_EQ(run.impacts.size(), scratch.run.impacts.size()) << finish;
        EXPECT_GE(run.statistics.steps, steps); // all that it ever took
        steps = run.statistics.steps;
    }
    EXPECT_EQ(steps, Scratch(3).run.statistics.steps);
    EXPECT_GT(steps, 10u);
}

// Whether a hit at the finish belongs to the motion depends on where the motion ends.
TEST(OpenRuns, DoesNotGoOnFromAHit) {
    SceneBuilder b(2);
    b.room();
    b.ball("ball", {0, 0, 0}).initialVelocity = {1, 0, 0};
    const auto longer = posed(b), problem = posed(b);
    const auto run = OpenRun(*longer, tolerancesOf(*longer)).upToFinish({}, nullptr);
    problem->scene.simulator.finish = run.impacts.all().at(0).time;
    OpenRun open(*problem, tolerancesOf(*problem));
    (void)open.upToFinish({}, nullptr);
    problem->scene.simulator.finish = 3;
    EXPECT_FALSE(open.canGoOn(nullptr));
}

class KeptRunsTest : public ::testing::Test {
protected:
    // One search: a run at the tolerance, and a rougher one.
    std::vector<std::size_t> search(KeptRuns& runs, double rougher = 1e-4) {
        runs.begin(problem->bodies->size());
        std::vector<std::size_t> steps;
        for (const auto& [kind, tolerance] : {std::pair(RunSource::Kind::compared, 1e-6),
                                              std::pair(RunSource::Kind::rougher, rougher)}) {
            const auto tolerances = tolerancesOf(*problem, tolerance);
            const auto run = runs.next(*problem, {.kind = kind, .tolerances = tolerances}, {});
            steps.push_back(run ? run->statistics.steps - run->before.steps : 0);
        }
        return steps;
    }
    std::shared_ptr<Problem> problem = posed(bounceAndSwing(1));
};

TEST_F(KeptRunsTest, AreMadeOnceAndTakenFurther) {
    KeptRuns runs(mostBytes());
    const auto first = search(runs);
    EXPECT_GT(first[0], first[1]);
    EXPECT_GT(first[1], 0u);
    EXPECT_GT(runs.bytes(), 0u);
    EXPECT_THAT(search(runs), ElementsAre(0, 0));
    problem->scene.simulator.finish = 2;
    const auto more = search(runs);
    EXPECT_EQ(first[0] + more[0], Scratch(2).run.statistics.steps);
    EXPECT_EQ(std::ranges::count(runs.marked(), true), 0);
}

TEST_F(KeptRunsTest, AnotherToleranceMarksAndNoRunIsMadeAnew) {
    KeptRuns runs(mostBytes());
    (void)search(runs);
    EXPECT_THAT(search(runs, 1e-5), ElementsAre(0, 0));
    EXPECT_EQ(std::ranges::count(runs.marked(), false), 0);
    const auto tolerances = tolerancesOf(*problem);
    EXPECT_FALSE(
        runs.next(*problem, {.kind = RunSource::Kind::nudged, .tolerances = tolerances}, {}));
    EXPECT_THAT(search(runs), ElementsAre(0, 0)); // as before: nothing is marked any more
    EXPECT_EQ(std::ranges::count(runs.marked(), true), 0);
}

TEST_F(KeptRunsTest, AreForgottenWhereTheyAreTooLarge) {
    KeptRuns runs(1);
    EXPECT_THAT(search(runs), ElementsAre(::testing::Gt(0u), ::testing::Gt(0u)));
    EXPECT_EQ(runs.bytes(), 0u);
    EXPECT_TRUE(runs.areForgotten());
    EXPECT_THAT(search(runs), ElementsAre(0, 0)); // again: nothing is told
}

// A search that is repeated says nothing of those whom a run concerns that was not made before.
TEST_F(KeptRunsTest, MarkWhomAMissingRunConcerns) {
    KeptRuns runs(mostBytes());
    (void)search(runs);
    runs.begin(problem->bodies->size());
    const auto tolerances = tolerancesOf(*problem);
    EXPECT_FALSE(runs.next(*problem,
                           {.kind = RunSource::Kind::nudged,
                            .tolerances = tolerances,
                            .concerned = {false, true, false}},
                           {}));
    EXPECT_THAT(runs.marked(), ElementsAre(false, true, false));
}

TEST(FreshRuns, AreMadeEachTime) {
    const auto problem = posed(bounceAndSwing(1));
    const auto tolerances = tolerancesOf(*problem);
    FreshRuns runs;
    for (int again = 0; again < 2; ++again) {
        const auto run = runs.next(*problem, {.tolerances = tolerances}, {});
        ASSERT_TRUE(run);
        EXPECT_EQ(run->before.steps, 0u);
        EXPECT_EQ(run->statistics.steps, Scratch(1).run.statistics.steps);
    }
}

} // namespace
} // namespace simulation::testing
