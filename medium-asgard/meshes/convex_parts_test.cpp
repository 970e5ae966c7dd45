#include "meshes/clipping.h"
#include "meshes/convex_parts.h"
#include "meshes/cuts.h"
#include "meshes/hulls.h"
#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

#include <random>

namespace meshes {
namespace {

// Whether the hull of the points holds the place, or nearly.
bool holds(const std::vector<Vector>& part, const Vector& place, double tolerance) {
    std::vector<Vector> more = part;
    more.push_back(place);
    const double before = hullVolume(part);
    return hullVolume(more) - before <= tolerance;
}

TEST(ConvexPartsTest, WhatIsConvexStaysWhole) {
    const ConvexParts made = convexParts(solidsOf(boxMesh({0, 0, 0}, {1, 2, 3})), {});
    ASSERT_EQ(made.parts.size(), 1U);
    EXPECT_EQ(made.parts[0].size(), 8U);
    EXPECT_NEAR(made.volume, 6, 1e-12);
    EXPECT_NEAR(made.partsVolume, 6, 1e-12);
}

// Solids with flat faces fall apart along them: their own corners, and no volume too much.
TEST(ConvexPartsTest, FlatFacesComeOutExactly) {
    const ConvexParts angle = convexParts(solidsOf(prism(ell, 1)), {.surplus = 1e-6});
    EXPECT_EQ(angle.parts.size(), 2U);
    EXPECT_NEAR(angle.partsVolume, 4, 1e-9);
    const ConvexParts plus = convexParts(solidsOf(prism(cross, 0.5)), {.surplus = 1e-6});
    EXPECT_EQ(plus.parts.size(), 3U);
    EXPECT_NEAR(plus.partsVolume, 2.5, 1e-9);
    const Mesh hollow =
        together(boxMesh({0, 0, 0}, {3, 3, 3}), insideOut(boxMesh({1, 1, 1}, {2, 2, 2})));
    const ConvexParts walls = convexParts(solidsOf(hollow), {.surplus = 1e-6});
    EXPECT_EQ(walls.parts.size(), 6U);
    EXPECT_NEAR(walls.partsVolume, 26, 1e-9);
}

TEST(ConvexPartsTest, PiecesApartAreParts) {
    const Mesh two = together(boxMesh({0, 0, 0}, {1, 1, 1}), boxMesh({5, 0, 0}, {6, 1, 1}));
    EXPECT_EQ(convexParts(solidsOf(two), {}).parts.size(), 2U);
    // Unless fewer are wanted than there are.
    EXPECT_EQ(convexParts(solidsOf(two), {.parts = 1}).parts.size(), 1U);
}

// The surplus is as small as wanted, or the parts are as many as allowed; no place of the solid is
// left out.
TEST(ConvexPartsTest, ARingIsFilledAsFarAsWanted) {
    const Solids ring = solidsOf(torus(2, 0.5, 16, 8));
    const double volume = ring.solids.at(0).volume;
    const ConvexParts made = convexParts(ring, {.surplus = 0.1, .parts = 16});
    EXPECT_LE(made.parts.size(), 16U);
    EXPECT_LE(made.partsVolume, 1.12 * volume); // joining measures on fewer points
    EXPECT_GE(made.partsVolume, 0.99 * volume);
    for (const auto& part : made.parts) // and its hole stays open
        EXPECT_FALSE(holds(part, {0, 0, 0}, 1e-6));
    const ConvexParts coarse = convexParts(ring, {.surplus = 0.1, .parts = 3});
    EXPECT_LE(coarse.parts.size(), 3U);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-2.5, 2.5);
    for (int i = 0; i < 300; ++i) {
        const Vector p(any(random), any(random), any(random) / 5);
        if (windingNumber(ring.solids[0].surface, p) < 0.5)
            continue;
        EXPECT_TRUE(std::ranges::any_of(made.parts, [&](const auto& part) {
            return holds(part, p, 1e-4);
        })) << p.transpose();
    }
}

TEST(ConvexPartsTest, CanBeToldToStop) {
    int asked = 0;
    const ConvexParts made =
        convexParts(solidsOf(torus(2, 0.5, 24, 12)), {.surplus = 1e-9}, [&](double share) {
            EXPECT_GE(share, 0);
            EXPECT_LE(share, 1);
            return ++asked < 5;
        });
    EXPECT_TRUE(made.cancelled);
    EXPECT_EQ(asked, 5);
}

TEST(ConvexPartsTest, CanBeToldToStopBeforeTheFirstCut) {
    Mesh row = boxMesh({0, 0, 0}, {1, 1, 1});
    for (int i = 1; i < 6; ++i)
        row = together(row, boxMesh({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}));
    const Solids six = solidsOf(row);
    int asked = 0;
    const ConvexParts made = convexParts(six, {}, [&](double) { return ++asked < 3; });
    EXPECT_TRUE(made.cancelled);
    EXPECT_EQ(asked, 3); // one for each solid
    EXPECT_EQ(made.parts.size(), 2U);
}

// As far out as files may have it, and a few units of the last place large.
TEST(ConvexPartsTest, FacesOfASmallSolidFarOutAreToldApart) {
    const Solid near{prism(cross, 1), 5};
    Solid far = near;
    const double unit = std::ldexp(1, -13), away = std::ldexp(7, 37);
    for (Vector& v : far.surface.vertices)
        v = Vector::Constant(away) + unit * v;
    EXPECT_GT(concavePlanes(near, 48).size(), 4U);
    EXPECT_EQ(concavePlanes(far, 48).size(), concavePlanes(near, 48).size());
}

TEST(ConvexPartsTest, FewerPointsFillTheHullFromTheInside) {
    std::mt19937 random(7);
    std::normal_distribution<double> any;
    std::vector<Vector> ball;
    for (int i = 0; i < 500; ++i)
        ball.push_back(Vector(any(random), any(random), any(random)).normalized());
    const auto fewer = fewerPoints(ball, 40);
    EXPECT_EQ(fewer.size(), 40U);
    EXPECT_GT(hullVolume(fewer), 0.75 * hullVolume(ball));
    EXPECT_LT(hullVolume(fewer), hullVolume(ball));
}

TEST(ConvexPartsTest, MorePointsThanAHullTakesAtOnce) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<Vector> many;
    for (int i = 0; i < 50'000; ++i)
        many.emplace_back(any(random), any(random), any(random) * (i < 20'000 ? 0 : 1));
    const double whole = hullVolume(many);
    EXPECT_GT(whole, 7.8);
    EXPECT_NEAR(hullVolume(hullPoints(many)), whole, 1e-12);
}

// Both sides of a cut have the volume of the whole, wherever it passes.
TEST(ClippingTest, CutsKeepTheVolume) {
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    for (const Mesh& mesh : {prism(cross, 1), torus(2, 0.5, 24, 12)}) {
        const Solids solids = solidsOf(mesh);
        const Solid& solid = solids.solids.at(0);
        for (int i = 0; i < 20; ++i) {
            std::vector<Piece> pieces = {pieceOf(solid)};
            for (int cut = 0; cut < 3; ++cut) {
                const Vector normal = Vector(any(random), any(random), any(random)).normalized();
                const Plane plane{normal, normal.dot(solid.surface.vertices[0]) * any(random)};
                std::vector<Piece> next;
                for (const Piece& piece : pieces)
                    for (const Plane& side : {plane, plane.flipped()})
                        next.push_back(below(piece, side, solid, 1e-9));
                pieces = next;
            }
            double volume = 0;
            for (const Piece& piece : pieces) {
                EXPECT_GE(piece.volume(), -1e-9);
                EXPECT_GE(hullVolume(piece.points()), piece.volume() - 1e-9);
                volume += piece.volume();
            }
            EXPECT_NEAR(volume, solid.volume, 1e-9);
        }
    }
}

} // namespace
} // namespace meshes
