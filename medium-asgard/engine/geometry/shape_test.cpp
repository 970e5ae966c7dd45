#include "geometry/shape.h"

#include <gtest/gtest.h>

namespace geometry {
namespace {

TEST(Box, HasExactPlanesAndOutwardFaces) {
    const Polyhedron b = box({2, 1, 3});
    ASSERT_EQ(b.faces.size(), 6u);
    EXPECT_EQ(b.edges.size(), 12u);
    for (const Face& f : b.faces) {
        EXPECT_EQ(f.normal.cwiseAbs().sum(), 1);
        for (const Vector& v : b.vertices)
            EXPECT_LE(f.normal.dot(v), f.offset);
        const Vector& p = b.vertices[f.vertices[0]];
        const Vector turn = (b.vertices[f.vertices[1]] - p).cross(b.vertices[f.vertices[2]] - p);
        EXPECT_GT(turn.dot(f.normal), 0);
    }
}

TEST(Shape, ReachAndBoundsCoverAllParts) {
    Shape shape;
    shape.parts.push_back(spherePart(0.5, {3, 0, 0}));
    shape.parts.push_back(polyhedronPart(box({2, 2, 2}), {{0, 1, 0}, Quaternion::Identity()}));
    EXPECT_DOUBLE_EQ(radiusAbout(shape, Vector::Zero()), 3.5);
    const Box b = bounds(shape);
    EXPECT_EQ(b.min(), Vector(-1, -0.5, -1));
    EXPECT_EQ(b.max(), Vector(3.5, 2, 1));
}

TEST(Ray, MeetsTheNearestPart) {
    Shape shape;
    shape.parts.push_back(polyhedronPart(box({2, 2, 2})));
    shape.parts.push_back(spherePart(1, {5, 0, 0}));
    const auto fromLeft = castRay(shape, {-10, 0.25, 0}, {1, 0, 0});
    ASSERT_TRUE(fromLeft);
    EXPECT_DOUBLE_EQ(fromLeft->distance, 9);
    EXPECT_EQ(fromLeft->normal, Vector(-1, 0, 0));
    EXPECT_EQ(fromLeft->part, 0u);
    EXPECT_TRUE(fromLeft->face);

    const auto fromRight = castRay(shape, {10, 0, 0}, {-2, 0, 0});
    ASSERT_TRUE(fromRight);
    EXPECT_DOUBLE_EQ(fromRight->distance, 2);
    EXPECT_EQ(fromRight->part, 1u);
    EXPECT_FALSE(fromRight->face);

    EXPECT_FALSE(castRay(shape, {0, 5, 0}, {1, 0, 0}));
    EXPECT_FALSE(castRay(shape, {10, 0, 0}, {1, 0, 0}));
    EXPECT_DOUBLE_EQ(castRay(shape, {0, 0, 0}, {0, 0, 1})->distance, 1); // from inside
}

} // namespace
} // namespace geometry
