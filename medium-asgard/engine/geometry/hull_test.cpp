#include "geometry/hull.h"

#include "geometry/hull_trials.h"
#include "geometry/predicates.h"
#include "geometry/quickhull.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace geometry {
namespace {

using ::testing::HasSubstr;

std::vector<Vector> cubeCorners(double size, const Vector& offset = Vector::Zero()) {
    std::vector<Vector> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(offset + size * Vector(i & 1, (i >> 1) & 1, i >> 2));
    return corners;
}

std::string refusalOf(const std::vector<Vector>& points) {
    const auto result = convexHull(points);
    const auto* refusal = std::get_if<HullRefusal>(&result);
    return refusal ? refusal->sentence : "";
}

TEST(Orientation, IsExactWhereRoundingWouldDecide) {
    // d is moved off the plane x + y + z = 1.5 by one unit in the last place.
    const Vector a(1, 0.5, 0), b(0, 1, 0.5), c(0.5, 0, 1);
    const Vector d(0.5, 0.5, 0.5);
    const double up = std::nextafter(0.5, 1), down = std::nextafter(0.5, 0);
    EXPECT_EQ(orientation(a, b, c, d), 0);
    EXPECT_EQ(orientation(a, b, c, {0.5, 0.5, up}), -orientation(a, b, c, {0.5, 0.5, down}));
    EXPECT_NE(orientation(a, b, c, {0.5, 0.5, up}), 0);
}

TEST(ConvexHull, OfACubeHasSixSquaresAndTwelveEdgesAtAnyScaleAndPlace) {
    for (double size : {1e-50, 1e-3, 1.0, 1e50})
        for (double away : {0.0, 1e6}) {
            auto points = cubeCorners(size, size * away * Vector(1, -1, 0.3));
            points.push_back(points[0] + Vector::Constant(size / 2)); // inside
            points.push_back(points[1]);                              // twice
            points.emplace_back((points[0] + points[1]) / 2);         // on an edge
            const auto result = convexHull(points);
            ASSERT_TRUE(std::holds_alternative<Hull>(result)) << refusalOf(points);
            const Hull& hull = std::get<Hull>(result);
            EXPECT_EQ(hull.polyhedron.vertices.size(), 8u);
            EXPECT_EQ(hull.polyhedron.faces.size(), 6u);
            EXPECT_EQ(hull.polyhedron.edges.size(), 12u);
            for (std::size_t i = 0; i < hull.sources.size(); ++i)
                EXPECT_EQ(points[hull.sources[i]], hull.polyhedron.vertices[i]);
        }
}

TEST(ConvexHull, OfARotatedCubeStillHasSixFaces) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (int i = 0; i < 200; ++i) {
        const Quaternion q =
            fromRotationVector({uniform(random), uniform(random), uniform(random)});
        auto points = cubeCorners(1);
        for (Vector& p : points)
            p = q * p;
        const auto result = convexHull(points);
        ASSERT_TRUE(std::holds_alternative<Hull>(result));
        EXPECT_EQ(std::get<Hull>(result).polyhedron.faces.size(), 6u);
    }
}

TEST(ConvexHull, RefusesWithASentence) {
    EXPECT_THAT(refusalOf({}), HasSubstr("fewer than four"));
    EXPECT_THAT(refusalOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}}),
                HasSubstr("fewer than four different"));
    EXPECT_THAT(refusalOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), HasSubstr("one line"));
    EXPECT_THAT(refusalOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), HasSubstr("one plane"));
    auto points = cubeCorners(1);
    points[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusalOf(points), HasSubstr("not finite"));
    EXPECT_THAT(refusalOf(std::vector<Vector>(mostHullPoints + 1)), HasSubstr("more than"));
    EXPECT_THAT(refusalOf(cubeCorners(1e80)), HasSubstr("1e60"));
}

TEST(ConvexHull, OfAnySetIsClosedConvexAndCompleteOrRefused) {
    std::mt19937_64 random(20261120);
    int hulls = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto points = drawPoints(random);
        const auto result = convexHull(points);
        hulls += std::holds_alternative<Hull>(result);
        EXPECT_EQ(faultOf(points, result), "") << "set " << i;
    }
    EXPECT_GT(hulls, 5'000); // the sets are not all degenerate
}

// Where all points are corners: on a ball, on the rims of a cylinder, and on a plate's lattice.
TEST(ConvexHull, OfTwiceThePointsTakesLittleMoreThanTwiceTheVisits) {
    const auto visits = [](int kind, int count) {
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        std::vector<Vector> points;
        for (int i = 0; i < count; ++i) {
            const double turn = 6.283185307179586 * i / count;
            if (kind == 0)
                points.push_back(
                    Vector(normal(random), normal(random), normal(random)).normalized());
            else if (kind == 1)
                points.emplace_back(std::cos(turn), std::sin(turn), i % 2);
            else
                points.emplace_back(i % 100, (i / 100) % 10, i / 1000);
        }
        const auto grid = toGrid(points);
        const std::array<std::size_t, 4> first{0, 1, static_cast<std::size_t>(count) / 3,
                                               static_cast<std::size_t>(count) - 2};
        return static_cast<double>(quickhull(grid, first).visits);
    };
    for (const int kind : {0, 1, 2}) {
        EXPECT_LT(visits(kind, 8000), 2.6 * visits(kind, 4000)) << kind;
        EXPECT_LT(visits(kind, 8000), 200 * 8000) << kind;
    }
}

TEST(ConvexHull, OfManyPointsCanBeEndedMeanwhile) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::vector<Vector> points;
    for (int i = 0; i < 5000; ++i)
        points.emplace_back(Vector(normal(random), normal(random), normal(random)).normalized());
    struct Ended {};
    int asked = 0;
    const auto end = [&asked] {
        if (++asked == 3)
            throw Ended{};
    };
    EXPECT_THROW((void)convexHull(points, end), Ended);
    EXPECT_EQ(asked, 3);
}

TEST(Support, FindsTheFurthestVertexByClimbing) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::vector<Vector> points;
    for (int i = 0; i < 300; ++i)
        points.push_back(Vector(normal(random), normal(random), normal(random)).normalized());
    const Polyhedron p = std::get<Hull>(convexHull(points)).polyhedron;
    ASSERT_EQ(p.vertices.size(), 300u);
    for (int i = 0; i < 1000; ++i) {
        const Vector d(normal(random), normal(random), normal(random));
        double best = -1e9;
        for (const Vector& v : p.vertices)
            best = std::max(best, d.dot(v));
        EXPECT_EQ(d.dot(p.vertices[support(p, d, random() % 300)]), best);
    }
}

} // namespace
} // namespace geometry
