// Runs on a thread of their own: the same as on the caller's, and ended when nobody wants them.
#include "accuracy/run_ahead.h"

#include "accuracy/run_source.h"
#include "simulation/testing.h"

#include <thread>

namespace simulation::testing {
namespace {

using namespace std::chrono_literals;

// Three boxes that fall on each other.
scene::Scene falling(double finish = 0.22) {
    SceneBuilder b(finish, 1e-4);
    b.floor();
    for (int i = 0; i < 3; ++i) {
        const std::string name = "box" + std::to_string(i);
        scene::Body& box = b.box(name, {0.03 * i, 0.3 + 0.6 * i, 0.01 * i}, {0.6, 0.5, 0.6});
        box.friction = 0.5;
        box.restitution = 0.2;
        b.weight(name);
    }
    b.scene.bodies[0].friction = 0.5;
    return b.scene;
}

std::shared_ptr<Problem> posed(const scene::Scene& scene, int threads = 2) {
    Options options;
    options.threads = threads;
    return std::get<std::shared_ptr<Problem>>(problemOf(scene, options));
}

std::vector<double> tolerancesOf(const Problem& problem, double tolerance) {
    return std::vector<double>(problem.bodies->size(), tolerance);
}

std::vector<double> valuesOf(const simulation::Run& run) {
    std::vector<double> values;
    for (std::size_t unknown = 0; unknown < run.histories->unknowns(); ++unknown)
        for (const double t : {0.05, 0.1, 0.15, 0.2})
            values.push_back(run.histories->value(unknown, t));
    return values;
}

TEST(RunAhead, IsTheRunThatTheCallerWouldMake) {
    const auto problem = posed(falling());
    const auto tolerances = tolerancesOf(*problem, 1e-6);
    RunAhead ahead(*problem, tolerances, OpenRun::Use::once);
    ahead.begin(0ms);
    const auto solved = ahead.take({});
    ASSERT_TRUE(solved);
    const simulation::Run run = solved->upToFinish({}, nullptr);
    const simulation::Run own = OpenRun(*problem, tolerances).upToFinish({}, nullptr);
    EXPECT_EQ(valuesOf(run), valuesOf(own));
    EXPECT_FALSE(run.cancelled);
    EXPECT_EQ(run.impacts.size(), own.impacts.size());
    EXPECT_EQ(run.statistics.steps, own.statistics.steps);
    EXPECT_EQ(run.statistics.evaluations, own.statistics.evaluations);
    EXPECT_EQ(run.before.steps, 0u) << "all of its work counts";
    EXPECT_GT(run.secondsMoving, 0);
}

TEST(RunAhead, BeginsWhenTheCallerHasWorkedForAWhile) {
    const auto problem = posed(falling());
    RunAhead ahead(*problem, tolerancesOf(*problem, 1e-6), OpenRun::Use::once);
    ahead.begin(1h);
    EXPECT_FALSE(ahead.take({}));
}

TEST(RunAhead, EndsWhereTheCallerIsCancelled) {
    const auto problem = posed(falling(1e9));
    RunAhead ahead(*problem, tolerancesOf(*problem, 1e-9), OpenRun::Use::once);
    ahead.begin(0ms);
    int asked = 0;
    const std::thread::id caller = std::this_thread::get_id();
    Observer observer;
    observer.cancelled = [&] {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return ++asked == 3;
    };
    EXPECT_FALSE(ahead.take(observer));
    EXPECT_EQ(asked, 3);
    RunAhead other(*problem, tolerancesOf(*problem, 1e-9), OpenRun::Use::once);
    other.begin(0ms); // and with it its run
}

// A run that it opens has memory if it is solved already.
class Opening final : public RunSource {
public:
    void begin(std::size_t) override {}
    std::optional<simulation::Run> next(const Problem&, const Wanted&, const Observer&) override {
        return {};
    }
    std::size_t bytesOf(const Problem& problem, const Wanted& wanted) {
        return open(problem, wanted, {})->bytes();
    }
    std::size_t expected(const Problem& problem, const std::vector<double>& expected,
                         const Wanted& wanted) {
        expect(problem, expected);
        std::this_thread::sleep_for(60ms);
        beginExpected();
        return bytesOf(problem, wanted);
    }
};

TEST(RunSource, HasTheRunThatItExpects) {
    const auto problem = posed(falling(0.1)), alone = posed(falling(0.1), 1);
    const auto tight = tolerancesOf(*problem, 1e-6), other = tolerancesOf(*problem, 1e-7);
    Opening runs;
    EXPECT_EQ(runs.bytesOf(*problem, {.tolerances = tight}), 0u);
    EXPECT_GT(runs.expected(*problem, tight, {.tolerances = tight}), 0u);
    EXPECT_EQ(runs.bytesOf(*problem, {.tolerances = tight}), 0u) << "once";
    EXPECT_EQ(runs.expected(*problem, tight, {.tolerances = other}), 0u);
    EXPECT_TRUE(runs.expects(tight)) << "the other one was solved beside it";
    EXPECT_EQ(runs.bytesOf(*problem, {.kind = RunSource::Kind::nudged, .tolerances = other}), 0u);
    EXPECT_TRUE(runs.expects(tight));
    EXPECT_EQ(runs.bytesOf(*problem, {.tolerances = other}), 0u);
    EXPECT_FALSE(runs.expects(tight)) << "nobody wants it any more";
    EXPECT_EQ(
        runs.expected(*problem, tight, {.kind = RunSource::Kind::nudged, .tolerances = tight}), 0u);
    EXPECT_EQ(runs.expected(*alone, tight, {.tolerances = tight}), 0u) << "one thread";
}

TEST(RunAhead, SearchesAreTheSameOnOneThreadAndOnTwo) {
    const scene::Scene scene = falling();
    Options one, two;
    one.threads = 1;
    two.threads = 2;
    const Result a = simulate(scene, one, {}), b = simulate(scene, two, {});
    for (std::size_t body = 1; body < scene.bodies.size(); ++body)
        EXPECT_EQ(rows(*a.motion, body), rows(*b.motion, body));
    EXPECT_EQ(a.statistics.steps, b.statistics.steps);
    EXPECT_EQ(a.statistics.evaluations, b.statistics.evaluations);
    EXPECT_EQ(a.statistics.errorEstimate, b.statistics.errorEstimate);
    EXPECT_EQ(a.statistics.predictableUntil, b.statistics.predictableUntil);
}

} // namespace
} // namespace simulation::testing
