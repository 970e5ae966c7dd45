#include "scene/scene.h"

#include "geometry/mass.h"
#include "scene/shape_of.h"

#include <gtest/gtest.h>

#include <numbers>

namespace scene {
namespace {

TEST(Scene, FindsElementsByName) {
    Scene scene;
    scene.bodies.resize(2);
    scene.bodies[1].name = "bob";
    scene.trajectories.resize(1);
    scene.trajectories[0].name = "path";
    EXPECT_EQ(findBody(scene, "bob"), &scene.bodies[1]);
    EXPECT_EQ(findTrajectory(scene, "path"), &scene.trajectories[0]);
    EXPECT_EQ(findBody(scene, "path"), nullptr);
    EXPECT_EQ(findShapeSet(scene, "bob"), nullptr);
}

TEST(ShapeOf, TurnsAPartAndThenMovesIt) {
    ShapeSet set;
    set.parts.push_back({BoxShape{{2, 4, 6}}, {1, 0, 0}, {0, 0, std::numbers::pi / 2}, {}});
    set.parts.push_back({SphereShape{0.5}, {0, 9, 0}, Vector::Zero(), {}});
    const auto shape = std::get<geometry::Shape>(shapeOf(set));
    const geometry::Box first = geometry::bounds({{shape.parts[0]}});
    EXPECT_LT((first.min() - Vector(-1, -1, -3)).norm(), 1e-15);
    EXPECT_LT((first.max() - Vector(3, 1, 3)).norm(), 1e-15);
    EXPECT_EQ(shape.parts[1].center(), Vector(0, 9, 0));
    EXPECT_NEAR(geometry::massProperties(shape, 1).volume, 48 + std::numbers::pi / 6, 1e-12);
}

TEST(ShapeReader, MakesEachShapeOnce) {
    ShapeSet set;
    set.parts.push_back({BoxShape{{2, 4, 6}}, Vector::Zero(), Vector::Zero(), {}});
    ShapeReader reader;
    EXPECT_EQ(&reader.of(set), &reader.of(set));
}

TEST(ShapeOf, SaysWhyAPartHasNoVolume) {
    ShapeSet set;
    set.parts.push_back({SphereShape{}, Vector::Zero(), Vector::Zero(), {}});
    set.parts.push_back({HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
                         Vector::Zero(),
                         Vector::Zero(),
                         {}});
    EXPECT_EQ(std::get<std::string>(shapeOf(set)),
              "its points lie in one plane, which bounds no volume");
}

TEST(ShapeOf, SaysOfWhatSizeNothingCanBeComputed) {
    ShapeSet set;
    for (const double radius : {1e-45, 1e45}) {
        set.parts = {{SphereShape{radius}, Vector::Zero(), Vector::Zero(), {}}};
        EXPECT_TRUE(std::holds_alternative<geometry::Shape>(shapeOf(set)));
    }
    set.parts = {{SphereShape{1e-150}, Vector::Zero(), Vector::Zero(), {}}};
    EXPECT_EQ(std::get<std::string>(shapeOf(set)),
              "a part of it is 2e-150 long, and sizes from 1e-50 to 1e+50 can be computed with");
    set.parts = {{SphereShape{1e150}, Vector::Zero(), Vector::Zero(), {}}};
    EXPECT_EQ(std::get<std::string>(shapeOf(set)),
              "a part of it is 2e+150 long, and sizes from 1e-50 to 1e+50 can be computed with");
}

} // namespace
} // namespace scene
