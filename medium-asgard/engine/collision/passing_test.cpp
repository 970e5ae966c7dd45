// What touches edges or vertices and goes by: seams of faces in one plane, faces beside each other,
// doorways as wide as what goes through. And what only just does not.
#include "collision/contact.h"
#include "collision/flying_body.h"
#include "collision/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision {
namespace {

// A tile whose upper side is y = 0 and that begins at x = 0.
FlyingBody tile(double higher = 0) { return flyingBox({4, 1, 4}, {2, -0.5 + higher, 0}); }

// A box on y = 0, two lengths before the tile.
FlyingBody slider(const Vector& velocity = {2, 0, 0}) {
    return flyingBox({1, 1, 1}, {-2.5, 0.5, 0}, velocity);
}

TEST(Passing, TheSeamOfFacesInOnePlaneIsNoHit) {
    for (const double far : {0.0, 1e6})
        for (const double turned : {0.0, 0.3, M_PI / 4}) {
            auto box = slider(), next = tile();
            for (FlyingBody* body : {&box, &next})
                body->position += Vector(far, -far / 2, far);
            box.attitude = geometry::fromRotationVector({0, turned, 0});
            const Encounter e = timeOfImpact(box, next, {0, 2});
            EXPECT_FALSE(e.hit) << far << ' ' << turned;
            EXPECT_EQ(e.overlap, 0);
            EXPECT_LT(e.evaluations, 50u);
        }
}

TEST(Passing, AStepIsAHitAgainstItsSide) {
    for (const double step : {1e-3, 1e-6, 1e-8}) {
        const Encounter e = timeOfImpact(slider(), tile(step), {0, 2});
        ASSERT_TRUE(e.hit) << step;
        EXPECT_NEAR(e.hit->time, 1, 1e-14);
        EXPECT_LT((e.hit->contact.normal - Vector(-1, 0, 0)).norm(), 1e-12) << step;
        EXPECT_EQ(e.hit->contact.closingSpeed, 2);
    }
    EXPECT_FALSE(timeOfImpact(slider(), tile(-1e-8), {0, 2}).hit);
    // How exactly a body's rest is known, so low a step counts.
    EXPECT_FALSE(timeOfImpact(slider(), tile(1e-8), {0, 2}, nullptr, 1e-7).hit);
    EXPECT_TRUE(timeOfImpact(slider(), tile(1e-6), {0, 2}, nullptr, 1e-7).hit);
}

// Approaching along the side and along the upper face, an edge hits the other one.
TEST(Passing, EdgesThatApproachAlongEveryAxisHit) {
    auto box = slider({2, -2, 0});
    box.position.y() += 2;
    const Encounter e = timeOfImpact(box, tile(), {0, 2});
    ASSERT_TRUE(e.hit);
    EXPECT_NEAR(e.hit->time, 1, 1e-12);
    EXPECT_LT((e.hit->contact.normal - Vector(-1, 1, 0).normalized()).norm(), 1e-6);
}

// A wall that ends where the box begins: it falls along it, and so it does between two.
TEST(Passing, AlongAWallAndThroughADoorOfItsOwnWidth) {
    auto box = flyingBox({1, 1, 1}, {0, 5, 0});
    box.acceleration = {0, -10, 0};
    for (const double side : {-1.0, 1.0})
        EXPECT_FALSE(timeOfImpact(box, flyingBox({1, 2, 3}, {side, 0, 0}), {0, 2}).hit);
}

// A spin about the faces' normal moves nothing along it, over edges neither.
TEST(Passing, ASpinningBoxSlidesOverTheSeam) {
    auto box = slider();
    box.spin = {0, 3, 0};
    for (const FlyingBody& under : {tile(), flyingBox({4, 1, 4}, {-2, -0.5, 0})}) {
        const Encounter e = timeOfImpact(box, under, {0, 2});
        EXPECT_FALSE(e.hit);
        EXPECT_LT(e.evaluations, 2000u);
    }
}

// A box that turns about its lower front edge, which lies on the seam, falls over onto the tile
// after a quarter of a turn, and not at once.
TEST(Passing, ABoxThatTurnsAboutTheSeamHitsWhenItLiesThere) {
    auto box = flyingBox({1, 1, 1}, {-0.5, 0.5, 0});
    box.spin = {0, 0, -1};
    const Vector arm(-0.5, 0.5, 0); // from the edge to the centre, whose motion is about it
    box.velocity = box.spin.cross(arm);
    const Encounter e = timeOfImpact(box, tile(), {0, 0.01});
    EXPECT_FALSE(e.hit);
}

TEST(Passing, ContactsLeaveOutWhatIsTouchedAlongSeveralAxes) {
    // The front edge lies on the seam; the box lies on the tile behind.
    const auto box = flyingBox({1, 1, 1}, {-0.5, 0.5, 0});
    EXPECT_TRUE(contactsAt(box, tile(), 0, 1e-9).empty());
    const auto behind = contactsAt(box, flyingBox({4, 1, 4}, {-2, -0.5, 0}), 0, 1e-9);
    ASSERT_EQ(behind.size(), 1u);
    EXPECT_EQ(behind[0].normal, Vector(0, 1, 0));
}

// What falls from rest was nowhere near a moment before, however slowly it drifts.
TEST(Passing, TheNormalOfWhatIsPressedDownAndDriftsIsTheFloors) {
    const auto floor = flyingBox({40, 1, 10}, {0, -0.5, 0});
    for (const double drift : {1e-3, 1e-6, 1e-9}) {
        auto box = flyingBox({1, 1, 1}, {0, 0.5, 0}, {drift, 0, 0});
        box.acceleration = {0, -9.81, 0};
        const Encounter e = timeOfImpact(floor, box, {0, 1});
        ASSERT_TRUE(e.hit) << drift;
        EXPECT_TRUE(e.hit->pressing);
        EXPECT_EQ(e.hit->contact.normal, Vector(0, -1, 0));
    }
}

} // namespace
} // namespace collision
