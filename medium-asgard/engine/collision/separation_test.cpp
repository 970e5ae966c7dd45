#include "collision/separation.h"

#include "collision/overlap.h"
#include "collision/separation_trials.h"

#include <ccd/ccd.h>
#include <ccd/vec3.h>

#include <gtest/gtest.h>

namespace collision {
namespace {

using geometry::box;
using geometry::polyhedronPart;
using geometry::spherePart;

Separation apart(const Part& a, const Part& b, const Vector& offset) {
    WarmStart cold;
    return separate({&a, Matrix::Identity(), offset}, {&b, Matrix::Identity(), Vector::Zero()},
                    cold);
}

TEST(Separation, OfFacesKeepsItsDigitsHoweverSmallTheGap) {
    const Part cube = polyhedronPart(box({2, 2, 2}));
    for (double gap : {1e-3, 1e-6, 1e-9, 1e-12, 0.0, -1e-12, -1e-9, -0.1}) {
        const Separation s = apart(cube, cube, {0.3, 0.1, 2 + gap});
        EXPECT_NEAR(s.gap, gap, 1e-15);
        EXPECT_EQ(s.normal, Vector(0, 0, 1));
    }
}

// A box that lies on a plate, as it was found: the common perpendicular of two edges that are
// parallel but for 2e-9 is rounding's, and the gap along it, of 1e-7, was none.
TEST(Separation, OfEdgesThatAreAllButParallelIsNoGuess) {
    const Part cube =
        polyhedronPart(box({1.000367887308368, 0.98145589105687558, 1.0523400736339878}));
    const Part plate = polyhedronPart(box({6, 1, 6}));
    Matrix turned, slope;
    turned << 0.69207964341814576, 0.7218211462448384, 1.8117641241921479e-09, //
        -0.7218211462448384, 0.69207964341814576, 1.7371132385797118e-09,      //
        -4.1359030627651384e-25, -2.509990367582839e-09, 1;
    slope << 0.72182114624483829, -0.69207964341814565, 0, //
        0.69207964341814565, 0.72182114624483829, 0,       //
        0, 0, 1;
    const Posed first{&cube, turned, Vector::Zero()};
    const Posed second{&plate, slope, {1.7816314304774119, 0.32258254370148765, 0}};
    WarmStart cold;
    EXPECT_NEAR(separate(first, second, cold).gap, 0, 1e-14);
    const auto axes = axesOfTouch(first, second, 1e-2);
    EXPECT_FALSE(axes.empty());
    for (const Separation& axis : axes)
        EXPECT_LE(axis.gap, 1e-14);
}

// Two cubes shifted along one axis: libccd's penetration says depth 0 and no direction here.
TEST(Separation, OfCubesThatOverlapIsTheSmallestDepth) {
    const Part cube = polyhedronPart(box({2, 2, 2}));
    const Separation s = apart(cube, cube, {0, 0, 1.9});
    EXPECT_NEAR(s.gap, -0.1, 1e-15);
    EXPECT_EQ(s.normal, Vector(0, 0, 1));
}

TEST(Separation, OfSpheresAndBoxes) {
    const Part ball = spherePart(0.5), cube = polyhedronPart(box({2, 2, 2}));
    EXPECT_NEAR(apart(ball, ball, {3, 0, 4}).gap, 4, 1e-15);
    EXPECT_EQ(apart(ball, cube, {0.2, 0.3, 2}).gap, 0.5);
    EXPECT_NEAR(apart(ball, cube, {2, 2, 0}).gap, std::sqrt(2.0) - 0.5, 1e-15); // edge
    EXPECT_NEAR(apart(ball, cube, {2, 2, 2}).gap, std::sqrt(3.0) - 0.5, 1e-15); // vertex
    EXPECT_NEAR(apart(ball, cube, {0, 0, 0.9}).gap, -0.6, 1e-15);               // centre inside
}

TEST(Separation, WarmStartSavesIterations) {
    const Part cube = polyhedronPart(box({2, 2, 2}));
    WarmStart warm;
    const Matrix turned = geometry::fromRotationVector({0.3, 0.2, 0.1}).toRotationMatrix();
    const Posed still{&cube, Matrix::Identity(), Vector::Zero()};
    std::size_t iterations = 0;
    (void)separate({&cube, turned, {1, 2, 4}}, still, warm);
    for (int i = 1; i <= 100; ++i)
        iterations += separate({&cube, turned, {1 + 1e-3 * i, 2, 4}}, still, warm).iterations;
    EXPECT_LE(iterations, 5u);
}

TEST(Separation, AgreesWithBruteForceOnRandomAndDegeneratePairs) {
    std::mt19937_64 random(20261120);
    for (int i = 0; i < 20'000; ++i)
        ASSERT_EQ(separationFault(drawPair(random)), "") << "pair " << i;
}

// The depth is the shortest way out: along the normal it is enough, any other way is longer.
TEST(Separation, DepthIsTheShortestWayOut) {
    std::mt19937_64 random(13);
    std::normal_distribution<double> normal;
    int overlaps = 0;
    for (int i = 0; i < 5'000; ++i) {
        const PosedPair pair = drawPair(random);
        Posed a = pair.posedFirst, b = pair.posedSecond;
        a.part = &pair.first;
        b.part = &pair.second;
        WarmStart cold;
        const Separation s = separate(a, b, cold);
        const double size =
            pair.first.core.vertices[0].norm() + pair.second.core.vertices[0].norm();
        if (s.gap > -1e-6 * size || pair.first.isSphere() || pair.second.isSphere())
            continue;
        ++overlaps;
        const Vector start = a.offset;
        a.offset = start - 1.000001 * s.gap * s.normal;
        EXPECT_GT(bruteForceGap(a, b), 0) << "pair " << i;
        for (int k = 0; k < 20; ++k) {
            const Vector way = Vector(normal(random), normal(random), normal(random)).normalized();
            a.offset = start - 0.999999 * s.gap * way;
            EXPECT_EQ(bruteForceGap(a, b), 0) << "pair " << i;
        }
    }
    EXPECT_GT(overlaps, 500);
}

// libccd's support function of a Posed.
void supportOf(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* result) {
    const auto* posed = static_cast<const Posed*>(object);
    const Vector d(direction->v[0], direction->v[1], direction->v[2]);
    const Vector v = posed->world(posed->support(d)) + posed->part->radius * d.normalized();
    ccdVec3Set(result, v.x(), v.y(), v.z());
}

TEST(Separation, AgreesWithLibccdOnWhoOverlaps) {
    std::mt19937_64 random(5);
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = supportOf;
    ccd.max_iterations = 500;
    int overlaps = 0, compared = 0;
    for (int i = 0; i < 20'000; ++i) {
        const PosedPair pair = drawPair(random);
        Posed a = pair.posedFirst, b = pair.posedSecond;
        a.part = &pair.first;
        b.part = &pair.second;
        WarmStart cold;
        const double gap = separate(a, b, cold).gap;
        if (std::abs(gap) < 1e-4 || a.part->core.vertices[0].norm() > 100 ||
            b.part->core.vertices[0].norm() > 100)
            continue; // within libccd's own tolerance
        ++compared;
        overlaps += gap < 0;
        ASSERT_EQ(ccdGJKIntersect(&a, &b, &ccd) != 0, gap < 0) << "pair " << i << " gap " << gap;
    }
    EXPECT_GT(compared, 8'000);
    EXPECT_GT(overlaps, 1'000);
}

TEST(OverlappingParts, AreFoundAndTouchingOnesAreNot) {
    geometry::Shape shape;
    shape.parts = {polyhedronPart(box({1, 1, 1})),
                   polyhedronPart(box({1, 1, 1}), {{1, 0, 0}, geometry::Quaternion::Identity()}),
                   spherePart(0.5, {0, 0.9, 0})};
    const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 2}};
    EXPECT_EQ(overlappingParts(shape), expected);
}

} // namespace
} // namespace collision
