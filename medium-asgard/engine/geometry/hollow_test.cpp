#include "geometry/hollow.h"

#include "geometry/mass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace geometry {
namespace {

using Piece = HollowNearest::Piece;

const Curved& curvedOf(const Part& part) { return *part.curved; }

TEST(HollowTest, EveryPieceOfATubeIsNearestToWhatIsBeforeIt) {
    const Part tube = tubePart(1, 2, 4);
    const auto at = [&](double x, double y) { return nearestOf(curvedOf(tube), {0, y, x}); };
    EXPECT_EQ(at(0.75, 1).piece, Piece::hollow);
    EXPECT_DOUBLE_EQ(at(0.75, 1).distance, 0.25);
    EXPECT_EQ(at(0.75, 1).normal, Vector(0, 0, -1));
    EXPECT_EQ(at(0.7, -2.4).piece, Piece::rim);
    EXPECT_DOUBLE_EQ(at(0.7, -2.4).distance, 0.5);
    EXPECT_EQ(at(0.7, -2.4).end, -1);
    EXPECT_EQ(at(1.5, 3).piece, Piece::end);
    EXPECT_DOUBLE_EQ(at(1.5, 3).distance, 1);
    EXPECT_EQ(at(2.3, 2.4).piece, Piece::edge);
    EXPECT_DOUBLE_EQ(at(2.3, 2.4).distance, 0.5);
    EXPECT_EQ(at(2.5, 0).piece, Piece::outside);
    EXPECT_DOUBLE_EQ(at(2.5, 0).distance, 0.5);
    EXPECT_DOUBLE_EQ(at(1.1, 0).distance, -0.1000000000000000888); // within the wall
    EXPECT_DOUBLE_EQ(at(1.5, 1.9).distance, -0.1000000000000000888);
    EXPECT_EQ(at(1.5, 1.9).piece, Piece::end);
}

TEST(HollowTest, EveryPieceOfABowlIsNearestToWhatIsBeforeIt) {
    const Part bowl = bowlPart(1, 2, {{5, 0, 0}, Quaternion::Identity()});
    const auto at = [&](double x, double y) { return nearestOf(curvedOf(bowl), {5, y, x}); };
    EXPECT_EQ(at(0.3, -0.4).piece, Piece::hollow);
    EXPECT_DOUBLE_EQ(at(0.3, -0.4).distance, 0.5);
    EXPECT_NEAR((at(0.3, -0.4).normal - Vector(0, 0.8, -0.6)).norm(), 0, 1e-15);
    EXPECT_EQ(at(0.7, 0.4).piece, Piece::rim);
    EXPECT_EQ(at(1.5, 0.4).piece, Piece::end);
    EXPECT_EQ(at(2.3, 0.4).piece, Piece::edge);
    EXPECT_EQ(at(3, -4).piece, Piece::outside);
    EXPECT_DOUBLE_EQ(at(3, -4).distance, 3);
    EXPECT_EQ(at(0, 0).distance, 1); // in the centre, whichever way
}

// Against a million points that are drawn in the box that holds them.
TEST(HollowTest, MassesAreThoseOfManyPoints) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> draw(-1, 1);
    for (const Part& part : {tubePart(0.6, 1, 2), bowlPart(0.6, 1)}) {
        const MassProperties exact = massProperties(Shape{{part}}, 1);
        Vector sum = Vector::Zero();
        Matrix second = Matrix::Zero();
        int inside = 0;
        constexpr int count = 1'000'000;
        for (int i = 0; i < count; ++i) {
            const Vector p(draw(random), draw(random), draw(random));
            if (nearestOf(curvedOf(part), p).distance >= 0)
                continue;
            ++inside;
            sum += p;
            second += p * p.transpose();
        }
        const double volume = 8.0 * inside / count;
        EXPECT_NEAR(exact.volume, volume, 0.02);
        EXPECT_NEAR((exact.centroid - sum / inside).norm(), 0, 0.005);
        Matrix about = second / inside - sum / inside * (sum / inside).transpose();
        about = volume * (about.trace() * Matrix::Identity() - about);
        EXPECT_NEAR((exact.inertia - about).norm(), 0, 0.02);
    }
    EXPECT_NEAR(massProperties(Shape{{tubePart(1, 2, 3)}}, 1).volume, 9 * std::numbers::pi, 1e-14);
    EXPECT_NEAR(massProperties(Shape{{bowlPart(1, 2)}}, 1).volume, 14 * std::numbers::pi / 3,
                1e-14);
}

TEST(HollowTest, ARayMeetsTheWallBeforeAndBehindTheHollow) {
    const Shape bowl{{bowlPart(1, 2)}};
    EXPECT_DOUBLE_EQ(castRay(bowl, {0, 5, 0}, {0, -1, 0})->distance, 6); // through the mouth
    EXPECT_EQ(castRay(bowl, {0, 5, 0}, {0, -1, 0})->normal, Vector(0, 1, 0));
    EXPECT_DOUBLE_EQ(castRay(bowl, {0, -5, 0}, {0, 1, 0})->distance, 3);
    EXPECT_DOUBLE_EQ(castRay(bowl, {1.5, 5, 0}, {0, -1, 0})->distance, 5); // on the end
    const Shape tube{{tubePart(1, 2, 4)}};
    EXPECT_FALSE(castRay(tube, {0, 5, 0}, {0, -1, 0}));
    EXPECT_DOUBLE_EQ(castRay(tube, {-5, 0, 0}, {1, 0, 0})->distance, 3);
    EXPECT_DOUBLE_EQ(castRay(tube, {0, 0, 0}, {1, 0, 0})->distance, 1);
}

// The hull: no point of it is further along a direction.
TEST(HollowTest, ABowlReachesAsFarAsItsOutsideAndItsEdge) {
    const Part bowl = bowlPart(1, 2);
    EXPECT_EQ(supportPoint(bowl, {0, -1, 0}), Vector(0, -2, 0));
    EXPECT_NEAR((supportPoint(bowl, {1, 1, 0}) - Vector(2, 0, 0)).norm(), 0, 1e-15);
    EXPECT_DOUBLE_EQ(radiusAbout(bowl, {0, 1, 0}), 3);
    EXPECT_DOUBLE_EQ(radiusAbout(bowl, {0, -1, 0}), std::sqrt(5));
}

} // namespace
} // namespace geometry
