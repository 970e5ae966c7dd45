#include "physics/surface_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace physics {
namespace {

using Kind = SurfacePiece::Kind;

const SurfacePiece floor{.kind = Kind::plane, .place = {3, 0, -5}, .axis = Vector::UnitY()};

SurfacePose posed(const Vector& centre, const Vector& axis, double angle) {
    return {centre, Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()};
}

void expectNear(const Vector& found, const Vector& expected) {
    EXPECT_LT((found - expected).norm(), 1e-14) << found.transpose();
}

// A coin leans by `angle` from the vertical: its lowest point lies below its centre by R cos angle.
TEST(SurfaceGap, OfARimOnAPlaneIsThatOfItsLowestPoint) {
    const double angle = 0.3, radius = 0.2;
    const SurfacePiece rim{
        .kind = Kind::circle, .place = {0, 0, 0.01}, .axis = Vector::UnitZ(), .radius = radius};
    const SurfacePose pose = posed({1, 0.5, 2}, Vector::UnitX(), angle);
    const NearestSurfaces at = nearest({rim, floor, false}, pose, {});
    const Vector centre = Vector(1, 0.5, 2) + pose.rotation * Vector(0, 0, 0.01);
    EXPECT_NEAR(at.gap, centre.y() - radius * std::cos(angle), 1e-15);
    expectNear(at.normal, Vector::UnitY());
    expectNear(at.contact, centre + pose.rotation * Vector(0, -radius, 0));
}

// The same with body and support exchanged: the normal turns, gap and point stay.
TEST(SurfaceGap, IsTheSameFromBothSides) {
    const SurfacePiece rim{
        .kind = Kind::circle, .place = {0, 0.1, 0}, .axis = Vector::UnitZ(), .radius = 0.2};
    const SurfacePose pose = posed({1, 0.5, 2}, {1, 2, 3}, 0.7);
    const NearestSurfaces one = nearest({rim, floor, false}, pose, {}),
                          other = nearest({floor, rim, false}, {}, pose);
    EXPECT_EQ(one.gap, other.gap);
    expectNear(other.normal, -one.normal);
    expectNear(other.contact, one.contact);
}

TEST(SurfaceGap, OfAnEllipsoidOnAPlaneIsThatOfItsLowestPoint) {
    const Vector axes(0.3, 0.2, 0.25);
    SurfacePiece egg{.kind = Kind::ellipsoid};
    egg.axes = axes.asDiagonal();
    const SurfacePose pose = posed({0, 1, 0}, {1, 1, 2}, 1.1);
    const NearestSurfaces at = nearest({egg, floor, false}, pose, {});
    double least = HUGE_VAL;
    for (int i = 0; i < 400; ++i)
        for (int k = 0; k <= 200; ++k) {
            const double a = i * std::numbers::pi / 200, b = k * std::numbers::pi / 200;
            const Vector on(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b));
            least = std::min(least, 1 + (pose.rotation * Vector(axes.cwiseProduct(on))).y());
        }
    EXPECT_NEAR(at.gap, least, 1e-4);
    EXPECT_LE(at.gap, least + 1e-15);
    const Vector local = pose.rotation.transpose() * Vector(at.contact - Vector(0, 1, 0));
    EXPECT_NEAR(local.cwiseQuotient(axes).norm(), 1, 1e-14);
    EXPECT_NEAR(at.contact.y(), at.gap, 1e-15);
}

TEST(SurfaceGap, OfASphereIsThatToSideRimAndCone) {
    const SurfacePiece ball{.kind = Kind::point, .radius = 0.1};
    const SurfacePose high{.centre = {0.6, 0.8, 7}, .rotation = Matrix::Identity()};
    const SurfacePiece side{.kind = Kind::line, .axis = Vector::UnitZ(), .radius = 0.5};
    EXPECT_NEAR(nearest({ball, side, false}, high, {}).gap, 0.4, 1e-15);
    expectNear(nearest({ball, side, false}, high, {}).contact, {0.54, 0.72, 7});

    const SurfacePiece rim{.kind = Kind::circle, .axis = Vector::UnitZ(), .radius = 0.5};
    const SurfacePose above{.centre = {0.48, 0.64, 0.4}, .rotation = Matrix::Identity()};
    const NearestSurfaces at = nearest({ball, rim, false}, above, {});
    EXPECT_NEAR(at.gap, 0.5 - 0.1, 1e-15); // 0.3 out and 0.4 up
    expectNear(at.normal, {0.36, 0.48, 0.8});

    const SurfacePiece cone{.kind = Kind::cone, .axis = Vector::UnitZ(), .sine = 0.6};
    const SurfacePose beside{.centre = {1, 0, 0}, .rotation = Matrix::Identity()};
    EXPECT_NEAR(nearest({ball, cone, false}, beside, {}).gap, 0.8 - 0.1, 1e-15);
    expectNear(nearest({ball, cone, false}, beside, {}).normal, {0.8, 0, 0.6});
}

TEST(SurfaceGap, OfSidesThatCrossIsAlongBothAxesNormal) {
    const SurfacePiece lower{.kind = Kind::line, .axis = Vector::UnitX(), .radius = 0.3};
    const SurfacePiece upper{
        .kind = Kind::line, .place = {0, 0, 2}, .axis = Vector::UnitZ(), .radius = 0.2};
    const SurfacePose pose{.centre = {4, 1, 0}, .rotation = Matrix::Identity()};
    const NearestSurfaces at = nearest({upper, lower, false}, pose, {});
    EXPECT_NEAR(at.gap, 0.5, 1e-15);
    expectNear(at.normal, Vector::UnitY());
    expectNear(at.contact, {4, 0.8, 0});
}

TEST(SurfaceGap, IsKnownOfPairsWithAClosedFormAlone) {
    EXPECT_TRUE(haveGap(Kind::plane, Kind::ellipsoid));
    EXPECT_TRUE(haveGap(Kind::cone, Kind::point));
    EXPECT_FALSE(haveGap(Kind::circle, Kind::circle));
    EXPECT_FALSE(haveGap(Kind::line, Kind::circle));
    EXPECT_FALSE(haveGap(Kind::ellipsoid, Kind::point));
}

} // namespace
} // namespace physics
