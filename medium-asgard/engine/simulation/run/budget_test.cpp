// A motion that needs more memory than a process has for it stops, with a sentence and at the same
// time on every run; simulate() and an editor's Resimulation agree.
#include "reports/report.h"
#include "resimulation/resimulation_testing.h"
#include "run/budget.h"

namespace simulation::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class Budget : public ::testing::Test {
protected:
    Budget() { setMostBytes(1'000'000); }
    ~Budget() override { setMostBytes(usualBytes); }
};

// A ball that is shaken fast beside one that swings.
SceneBuilder shaken() {
    SceneBuilder b(10);
    b.scene.simulator.collisions = false;
    b.ball("shaken", {0, 0, 0});
    b.force("shaken", "sin(1e9*t)", "0", "0");
    b.ball("swinging", {5, 1, 0});
    b.force("swinging", "0", "-9*swinging.y^3", "0");
    return b;
}

TEST_F(Budget, WhereItIsSpentMotionStopsWithASentence) {
    const scene::Scene scene = shaken().scene;
    const Result first = simulate(scene);
    const auto stop = first.motion->stop(0);
    ASSERT_TRUE(stop);
    EXPECT_GT(stop->time, 0);
    EXPECT_LT(stop->time, 1);
    EXPECT_THAT(stop->sentence, HasSubstr("the motion up to here takes 1 MB, which is the limit, "
                                          "most of it for body \"shaken\"; let its forces "));
    EXPECT_LE(first.statistics.historyBytes, 1'010'000u);
    EXPECT_THAT(reportOf(scene, *first.motion), SizeIs(1)) << "one sentence for all";

    Options threads;
    threads.threads = 3;
    Observer observer;
    observer.progress = [](const MotionPointer&) {};
    const Result again = simulate(scene, threads, observer);
    EXPECT_EQ(again.motion->stop(0)->time, stop->time);
    EXPECT_FALSE(first.motion->stop(1)) << "what needs little goes on";
    EXPECT_FALSE(again.motion->stop(1));
    EXPECT_EQ(rows(*again.motion, 0), rows(*first.motion, 0));
    EXPECT_EQ(rows(*again.motion, 1), rows(*first.motion, 1));
}

TEST_F(Budget, AnEditedMotionStopsAsOneFromScratch) {
    SceneBuilder b = shaken();
    b.scene.forces.clear();
    b.force("swinging", "0", "-9*swinging.y^3", "0");
    Resimulation kept;
    (void)updated(kept, b.scene);
    b.scene = shaken().scene;
    const Result full = updated(kept, b.scene);
    ASSERT_TRUE(full.motion->stop(0));
    EXPECT_EQ(full.motion->stop(0)->time, simulate(b.scene).motion->stop(0)->time);
    b.scene.bodies[1].initialPosition.y() = 2; // who stopped because of it, too
    (void)updated(kept, b.scene);
    b.scene.simulator.finish = 5;
    (void)updated(kept, b.scene);
    b.scene.forces.erase(b.scene.forces.begin());
    EXPECT_FALSE(updated(kept, b.scene).motion->stop(1));
}

// Runs that are kept for another finish are forgotten when together they are too large, and the
// motion is the same.
TEST_F(Budget, RunsThatAreTooLargeAreNotKept) {
    SceneBuilder b(4, 1e-9);
    b.scene.simulator.collisions = false;
    b.ball("swinging", {5, 1, 0});
    b.force("swinging", "0", "-9e3*swinging.y^3", "0");
    const std::size_t bytes = simulate(b.scene).statistics.historyBytes;
    setMostBytes(bytes * 5 / 4);
    Resimulation kept;
    (void)updated(kept, b.scene);
    b.scene.simulator.finish = 4.2;
    const Result longer = updated(kept, b.scene);
    EXPECT_FALSE(longer.motion->stop(0));
    b.scene.simulator.finish = 40;
    EXPECT_TRUE(updated(kept, b.scene).motion->stop(0));
}

// What balls hit counts as well.
TEST_F(Budget, HitsTakeMemoryToo) {
    setMostBytes(20'000);
    SceneBuilder b(1000);
    b.scene.simulator.accuracy = 1e-3;
    b.room();
    for (int i = 0; i < 2; ++i) {
        scene::Body& ball = b.ball("b" + std::to_string(i), {i - 0.5, 0.1, 0});
        ball.initialVelocity = {1 - 2.0 * i, 0, 0};
    }
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(6));
    EXPECT_THAT(result.motion->stop(6)->sentence, HasSubstr("which is the limit"));
    EXPECT_GT(result.motion->impacts().size(), 20u);
    EXPECT_LT(result.motion->impacts().size(), 1000u);
    EXPECT_EQ(simulate(b.scene).motion->stop(6)->time, result.motion->stop(6)->time);
}

} // namespace
} // namespace simulation::testing
