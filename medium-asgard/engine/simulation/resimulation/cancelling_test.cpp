// An edit while a simulation runs cancels it. How much work is done between two questions whether
// it was, and after the last one? By counts: each simulation is cancelled at a question and at the
// next one, and what was done in between is the difference.
#include "resimulation/resimulation.h"
#include "simulation/testing.h"

#include <random>

namespace simulation::testing {
namespace {

struct Course {
    Result result;
    std::size_t asked = 0, askedAfter = 0; // after it was told to stop
};

// `stopAt`: the question that is answered by yes, and all after it; 0: none.
Course courseOf(const scene::Scene& scene, std::size_t stopAt) {
    Course course;
    const auto cancelled = [&] {
        if (stopAt != 0 && course.asked == stopAt) {
            ++course.askedAfter;
            return true;
        }
        return ++course.asked == stopAt;
    };
    course.result = simulate(scene, {}, {.cancelled = cancelled, .progress = {}});
    return course;
}

struct Most {
    std::size_t evaluations = 0, pairTests = 0;
};

void expectLittleBetweenQuestions(const scene::Scene& scene, const Most& most) {
    const Course whole = courseOf(scene, 0);
    ASSERT_GT(whole.asked, 20u);
    const auto expectLittle = [&](const Course& from, const Course& to, std::size_t question) {
        const Statistics &before = from.result.statistics, &after = to.result.statistics;
        EXPECT_LE(after.evaluations - before.evaluations, most.evaluations) << question;
        EXPECT_LE(after.pairTests - before.pairTests, most.pairTests) << question;
    };
    for (std::size_t i = 0; i < 16; ++i) {
        const std::size_t question = 1 + i * (whole.asked - 2) / 15;
        const Course at = courseOf(scene, question), next = courseOf(scene, question + 1);
        EXPECT_TRUE(at.result.cancelled) << question;
        EXPECT_LE(at.askedAfter, 3u) << question;
        expectLittle(at, next, question);
    }
    expectLittle(courseOf(scene, whole.asked), whole, whole.asked);
}

TEST(Cancelling, AMethodAsksAtEachStep) {
    SceneBuilder b(20, 1e-4);
    b.scene.simulator.collisions = false;
    b.ball("one", {1, 0, 0});
    b.force("one", "-9*sin(one.x)", "0", "0");
    expectLittleBetweenQuestions(b.scene, {.evaluations = 100, .pairTests = 0});
}

TEST(Cancelling, AHullIsMadeOnceAndAsksMeanwhile) {
    SceneBuilder b(0);
    b.scene.simulator.collisions = false;
    b.box("stone", {0, 0, 0}, {1, 1, 1});
    scene::HullShape hull;
    for (int i = 0; i < 1000; ++i) {
        const double height = (2.0 * i + 1) / 1000 - 1, radius = std::sqrt(1 - height * height);
        hull.points.emplace_back(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), height);
    }
    std::size_t ofHull = 0;
    b.scene.shapeSets[0].parts[0].shape = hull;
    ASSERT_EQ(scene::shapeOf(b.scene.shapeSets[0], [&] { ++ofHull; }).index(), 0u);
    ASSERT_GT(ofHull, 5u);
    const Course first = courseOf(b.scene, ofHull / 2), whole = courseOf(b.scene, 0);
    EXPECT_TRUE(first.result.cancelled);
    EXPECT_FALSE(first.result.motion);
    EXPECT_LT(whole.asked, 2 * ofHull);
}

TEST(Cancelling, ASearchForMeetingsAsksAtEachOfThem) {
    constexpr std::size_t perEdge = 4, balls = perEdge * perEdge * perEdge;
    SceneBuilder b(3);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> speed(-2, 2);
    b.room();
    for (std::size_t i = 0; i < balls; ++i) {
        const Vector cell(static_cast<double>(i % perEdge),
                          static_cast<double>(i / perEdge % perEdge),
                          static_cast<double>(i / perEdge / perEdge));
        b.ball("ball" + std::to_string(i), 0.5 * (cell + Vector::Constant(0.5)) - Vector::Ones(),
               0.1)
            .initialVelocity = {speed(random), speed(random), speed(random)};
    }
    // A question looks at each body's neighbourhood once, at most.
    expectLittleBetweenQuestions(b.scene, {.evaluations = 64 * balls, .pairTests = 64 * balls});
}

} // namespace
} // namespace simulation::testing
