// A box that lands on a floor while it turns, with hardly any tilt left or none.
#include "collision/contact.h"
#include "collision/flying_body.h"
#include "collision/patch.h"
#include "collision/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision {
namespace {

// A unit cube above y = 0 that sinks by 1 and turns about z by `spin`, tilted by `tilt` after a
// second, when its middle is half a length above.
FlyingBody lander(double tilt, double spin) {
    auto box = flyingBox({1, 1, 1}, {0, 1.5, 0}, {0, -1, 0});
    box.attitude = geometry::fromRotationVector({0, 0, tilt - spin});
    box.spin = {0, 0, spin};
    return box;
}

// The patch is the edge that is lower, whole, and the normal the floor's.
TEST(Landing, OfABoxThatTurnsIsOnItsLowerEdge) {
    const auto floor = flyingBox({2, 1, 2}, {0.8, -0.5, 0}); // begins at x = -0.2
    for (const double spin : {0.0, 0.15, 1.0})
        for (double size = 7e-9; size < 1e-4; size *= 2.3)
            for (const double sign : {-1.0, 1.0})
                for (const bool isFirst : {true, false}) {
                    SCOPED_TRACE(testing::Message() << spin << ' ' << sign * size);
                    const FlyingBody box = lander(-sign * size, sign * spin);
                    const Encounter e = isFirst ? timeOfImpact(box, floor, {0, 2})
                                                : timeOfImpact(floor, box, {0, 2});
                    ASSERT_TRUE(e.hit);
                    const Contact& c = e.hit->contact;
                    EXPECT_NEAR(e.hit->time, 1, 2 * size);
                    EXPECT_LT((c.normal - Vector(0, isFirst ? 1 : -1, 0)).norm(), 2 * size);
                    ASSERT_EQ(c.patch.size(), 2u);
                    EXPECT_NEAR(c.point.x(), sign > 0 ? 0.5 : -0.2, 2 * size);
                    EXPECT_NEAR(c.point.z(), 0, 1e-12);
                    EXPECT_NEAR(std::abs(c.patch[0].z() - c.patch[1].z()), 1, 1e-12);
                }
}

// Faces of one outline that turn within their plane's tilt: edges come to lie beside each other.
TEST(Landing, OnAFaceOfTheSameOutlineIsOnAWholeEdge) {
    const auto cube = flyingBox({1, 1, 1}, {0, -0.5, 0});
    for (double size = 7e-9; size < 1e-4; size *= 2.3)
        for (const double tilt : {size, -size}) {
            SCOPED_TRACE(tilt);
            const Encounter e = timeOfImpact(lander(tilt, 1), cube, {0, 2});
            ASSERT_TRUE(e.hit);
            EXPECT_EQ(e.hit->contact.patch.size(), 2u);
            EXPECT_NEAR(e.hit->contact.point.z(), 0, 1e-12);
            EXPECT_NEAR(std::abs(e.hit->contact.point.x()), 0.5, 2 * size);
        }
}

TEST(Landing, WithoutTiltIsOnTheWholeFace) {
    const auto floor = flyingBox({2, 1, 2}, {0.8, -0.5, 0});
    for (const double spin : {0.0, 0.15, 1.0})
        for (const double tilt : {0.0, 1e-12, 1e-10, -1e-10}) {
            const Encounter e = timeOfImpact(lander(tilt, spin), floor, {0, 2});
            ASSERT_TRUE(e.hit) << spin << ' ' << tilt;
            EXPECT_EQ(e.hit->contact.patch.size(), 4u);
            EXPECT_NEAR(e.hit->contact.point.x(), 0.15, 1e-8);
            EXPECT_NEAR(e.hit->contact.point.z(), 0, 1e-12);
        }
}

// What of the one is nearest to the other, on both sides of a plane of symmetry.
TEST(Landing, BesideAFaceIsAtItsNearestEdge) {
    const auto box = geometry::polyhedronPart(geometry::box({1, 1, 1}));
    for (const double beside : {1e-9, 1e-6, 1e-3}) {
        const Posed below{&box, Matrix::Identity(), {0, -0.5, 0}};
        const Posed above{&box,
                          geometry::fromRotationVector({0, 0, -1e-2}).toRotationMatrix(),
                          {1 + beside, 0.5, 0}};
        const Patch patch = patchOf(above, below, Vector::UnitY(), 1e-9, 1e-9);
        EXPECT_EQ(patch.corners.size(), 2u) << beside;
        EXPECT_NEAR(patch.centre.z(), 0, 1e-12) << beside;
    }
}

} // namespace
} // namespace collision
