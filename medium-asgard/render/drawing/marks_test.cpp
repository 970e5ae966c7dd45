// Letters, maps of shadows, round numbers.
#include "drawing/round_numbers.h"
#include "drawing/shadow_map.h"
#include "drawing/stroke_text.h"
#include "framing/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

TEST(Grid, ItsStepsAreOfTheSeriesOneTwoFive) {
    EXPECT_DOUBLE_EQ(roundAbove(1), 1);
    EXPECT_DOUBLE_EQ(roundAbove(1.1), 2);
    EXPECT_DOUBLE_EQ(roundAbove(0.021), 0.05);
    EXPECT_DOUBLE_EQ(roundAbove(6), 10);
    EXPECT_DOUBLE_EQ(roundBelow(1), 1);
    EXPECT_DOUBLE_EQ(roundBelow(4.9), 2);
    EXPECT_DOUBLE_EQ(roundBelow(0.0009), 0.0005);
}

TEST(StrokeText, WritesAsFewDigitsAsTheStepNeeds) {
    EXPECT_EQ(coordinateText(3, 1), "3");
    EXPECT_EQ(coordinateText(-20, 10), "-20");
    EXPECT_EQ(coordinateText(0.5, 0.5), "0.5");
    EXPECT_EQ(coordinateText(1e-17, 0.1), "0");
    EXPECT_EQ(coordinateText(0.15, 0.05), "0.15");
    EXPECT_EQ(coordinateText(3e7, 1e7), "3e7");
    EXPECT_EQ(coordinateText(2e-7, 1e-7), "2e-7");
    EXPECT_GT(textWidth("10", 8), textWidth("1", 8));
    EXPECT_EQ(textWidth("", 8), 0);
}

// Every solid lies within the map, seen from afar and from a place.
TEST(ShadowMap, HoldsAllThatThrowsAShadow) {
    scene::Scene scene;
    addBody(scene, sphere(0.3), {-0.5, 0.2, 0}, {});
    addBody(scene, box({0.4, 0.6, 0.2}), {0.5, -0.2, 0.3}, {});
    Drawing drawing;
    drawing.scene = &scene;
    const Frame frame(drawing, {320, 240});
    const auto solids = solidsOf(drawing, extentOf(scene, nullptr), frame);
    const auto room = visibleRoom(frame, 2, -5);
    Light light;
    for (const Vector& place : {Vector(0.3, 0.8, 0.5), Vector(-3, 4, 2)}) {
        light.isPoint = place.norm() > 2;
        light.place = light.isPoint ? place : Vector(place.normalized());
        const auto sight = sightOf(light, solids, room, 512);
        ASSERT_TRUE(sight);
        for (const Solid& solid : solids)
            for (const Vector& side : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)})
                for (const double sign : {-1.0, 1.0}) {
                    const Vector p = sight->toMap(solid.middle + sign * solid.radius * side);
                    EXPECT_LE(p.cwiseAbs().maxCoeff(), 1) << place.transpose();
                }
        // A point nearer to the light has the lesser depth.
        const Vector to = light.isPoint ? Vector(light.place.normalized()) : light.place;
        EXPECT_LT(sight->toMap(0.1 * to).z(), sight->toMap(-0.1 * to).z());
        EXPECT_GT(sight->texel, 0);
        EXPECT_LT(sight->texel, 0.02);
    }
    EXPECT_FALSE(sightOf(light, {}, room, 512));
    light.place = solids[0].middle; // within the ball about them
    EXPECT_FALSE(sightOf(light, solids, room, 512));
}

} // namespace
} // namespace render
