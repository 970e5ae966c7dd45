// What an edit makes solve again, told as work, and that the motion is that of a run from scratch.
// Random edits of all kinds over all scenes: tests/edits.
#include "resimulation/resimulation_testing.h"

#include <gmock/gmock.h>

namespace simulation::testing {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Resimulation, AnEditToOneOfManyBodiesSolvesThatOne) {
    SceneBuilder b = row(100);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[7].initialVelocity.z() = 0.5;
    const Result result = updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball7; kept: 99; rounds: 1");
    SceneBuilder alone = row(1);
    alone.scene.bodies[0].initialVelocity.z() = 0.5;
    EXPECT_EQ(result.statistics.steps, simulate(alone.scene).statistics.steps);
    EXPECT_EQ(result.statistics.components, simulate(b.scene).statistics.components);
}

TEST(Resimulation, WhatIsNoPartOfMotionSolvesNothing) {
    SceneBuilder b = row(3);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[1].appearance.color = scene::Color{1, 0, 0};
    b.scene.bodies[2].source.line = 12;
    b.scene.lights.emplace_back();
    b.scene.plots.emplace_back();
    const Result result = updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved:; kept: 3; rounds: 0");
    EXPECT_EQ(result.statistics.steps, 0u);
    EXPECT_EQ(result.statistics.evaluations, 0u);
}

TEST(Resimulation, WhoIsMetIsSolvedToo) {
    SceneBuilder b = row(4);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[0].initialVelocity = {5.5, 1, 0}; // reaches the next one
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), ::testing::SizeIs(1));
    EXPECT_EQ(kept.work().print(), "solved: ball0 ball1; kept: 2; rounds: 2");
    b.scene.bodies[0].initialVelocity = {0, 1, 0}; // and does no more
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), IsEmpty());
    EXPECT_EQ(kept.work().print(), "solved: ball0 ball1; kept: 2; rounds: 1");
    b.scene.bodies[1].initialVelocity = {0, 2, 0};
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 3; rounds: 1");
}

TEST(Resimulation, AFixedBodyThatMovesConcernsWhomItMeets) {
    SceneBuilder b = row(3);
    b.box("wall", {5, 50, 0}, {1, 1, 1}).fixed = true;
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[3].initialPosition = {20, 1.5, 0}; // in the way of ball2
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), ::testing::SizeIs(1));
    EXPECT_EQ(kept.work().print(), "solved: ball2; kept: 2; rounds: 2");
    b.scene.bodies[3].initialPosition = {5, 50, 0};
    EXPECT_THAT(updated(kept, b.scene).motion->impacts(), IsEmpty());
    EXPECT_EQ(kept.work().print(), "solved: ball2; kept: 2; rounds: 1");
}

TEST(Resimulation, BodiesThatReadEachOtherAreSolvedTogether) {
    SceneBuilder b = row(4);
    b.force("ball2", "0.1*ball1.x", "0", "0");
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[1].initialVelocity = {0, 1.5, 0};
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball1 ball2; kept: 2; rounds: 1");
    b.scene.forces.pop_back();
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball1 ball2; kept: 2; rounds: 1");
    b.scene.bodies[1].initialVelocity = {0, 1, 0};
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 3; rounds: 1");
}

TEST(Resimulation, AParameterConcernsWhoReadsIt) {
    SceneBuilder b = row(3);
    scene::Parameter parameter;
    parameter.name = "wind";
    parameter.value = 1;
    b.scene.parameters.push_back(parameter);
    b.force("ball1", "wind", "0", "0");
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.parameters[0].value = 2;
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 2; rounds: 1");
    Options options; // as a slider does
    options.parameters["wind"] = 3;
    (void)kept.update(shared(b.scene), options);
    EXPECT_EQ(kept.work().print(), "solved: ball1; kept: 2; rounds: 1");
    options.parameters["rain"] = 3;
    EXPECT_EQ(kept.update(shared(b.scene), options).refusal, simulate(b.scene, options).refusal);
}

TEST(Resimulation, BodiesAreAddedAndRemovedAlone) {
    SceneBuilder b = row(4);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    scene::Body added = b.scene.bodies[0];
    added.name = "added";
    added.initialPosition = {0, 0, 30};
    b.scene.bodies.insert(b.scene.bodies.begin() + 1, added);
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: added; kept: 4; rounds: 1");
    b.scene.bodies.erase(b.scene.bodies.begin());
    b.scene.forces.erase(b.scene.forces.begin());
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved:; kept: 4; rounds: 0");
}

TEST(Resimulation, WhatIsCancelledChangesNothingThatIsKept) {
    SceneBuilder b = row(3);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[0].initialVelocity = {0, 3, 0};
    const Result cut =
        kept.update(shared(b.scene), {}, {.cancelled = [] { return true; }, .progress = {}});
    EXPECT_TRUE(cut.cancelled);
    EXPECT_TRUE(cut.motion->draft());
    EXPECT_EQ(cut.motion->bodies(), 3u);
    (void)updated(kept, b.scene);
    EXPECT_EQ(kept.work().print(), "solved: ball0; kept: 2; rounds: 1");
}

TEST(Resimulation, DraftsShowWhatIsKeptBesideWhatGrows) {
    SceneBuilder b = row(3);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[0].initialVelocity = {0, 3, 0};
    std::vector<double> reached;
    std::vector<bool> drafts;
    const Result whole = simulate(b.scene);
    const auto watch = [&](const MotionPointer& motion) {
        reached.push_back(motion->computed());
        drafts.push_back(motion->draft());
        const double t = motion->computed() / 2;
        EXPECT_EQ(motion->at(2, t).position, whole.motion->at(2, t).position);
    };
    (void)kept.update(shared(b.scene), {}, {.cancelled = {}, .progress = watch});
    EXPECT_FALSE(reached.empty());
    EXPECT_TRUE(std::ranges::is_sorted(reached));
    EXPECT_THAT(drafts, Each(true));
}

TEST(Resimulation, QuantitiesReadMotionThatWasSolvedInParts) {
    SceneBuilder b = row(3);
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[1].initialVelocity = {0, 2, 0};
    const std::vector<std::string> expressions{"ball0.y", "ball1.dy", "scene.energy"};
    std::vector<std::string> faults;
    const Quantities inParts(b.scene, {}, updated(kept, b.scene).motion, expressions, faults);
    const Quantities atOnce(b.scene, {}, simulate(b.scene).motion, expressions, faults);
    EXPECT_THAT(faults, IsEmpty());
    EXPECT_EQ(inParts.at(1.25), atOnce.at(1.25));
}

} // namespace
} // namespace simulation::testing
