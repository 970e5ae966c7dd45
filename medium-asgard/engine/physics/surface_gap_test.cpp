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

// A rim of 0.1 stands on end, with its lowest point at the origin; the other curve goes through the
// same point. Each may turn about it.
struct Curves {
    SurfacePiece rim{
        .kind = Kind::circle, .place = {0, 0.1, 0}, .axis = Vector::UnitZ(), .radius = 0.1};
    SurfacePiece other;
};
Curves curves(Kind kind, double radius) {
    Curves made{.other = {.kind = kind, .axis = Vector(0.3, 0, 1).normalized()}};
    made.rim.foot = -Vector::UnitY();
    if (kind == Kind::line) {
        made.other.place = {0, -radius, 0};
        made.other.radius = radius;
    } else { // its highest point is there
        made.other.axis = Vector(1, 0, 0.3).normalized();
        made.other.place = {0, -radius, 0};
        made.other.radius = radius;
        made.other.foot = Vector::UnitY();
    }
    return made;
}

// The same gap with its feet where its points are now.
SurfaceGap withFeet(SurfaceGap gap, const SurfacePose& body) {
    for (int i = 0; i < 4; ++i) {
        const Vector contact = nearest(gap, body, {}).contact;
        for (SurfacePiece* piece : {&gap.body, &gap.support}) {
            const SurfacePose of = piece == &gap.body ? body : SurfacePose{};
            const Vector off = of.rotation.transpose() * (contact - of.centre) - piece->place;
            piece->foot = (off - piece->axis * piece->axis.dot(off)).normalized();
        }
    }
    return gap;
}

// However they have gone from their feet, within nearFoot(): as from feet that are there.
TEST(SurfaceGap, OfCurvesNearTheirFeetIsExact) {
    int tried = 0;
    for (const auto& [kind, radius] : {std::pair(Kind::line, 0.0), std::pair(Kind::line, 0.04),
                                       std::pair(Kind::line, 0.5), std::pair(Kind::circle, 0.05),
                                       std::pair(Kind::circle, 0.1), std::pair(Kind::circle, 1.0)})
        for (int i = 0; i < 400; ++i) {
            const Curves made = curves(kind, radius);
            const SurfaceGap gap{made.rim, made.other, false};
            const Vector axis(std::cos(i), std::sin(1.7 * i), std::cos(2.3 * i + 1));
            SurfacePose pose = posed(Vector::Zero(), axis, 0.5 * std::sin(0.9 * i));
            pose.centre = pose.rotation * Vector(0.02 * std::sin(0.3 * i), 0, 0);
            const NearestSurfaces apart = nearest(gap, pose, {});
            pose.centre -= apart.normal * apart.gap; // they touch
            const NearestSurfaces found = nearest(gap, pose, {});
            const SurfaceGap anew = withFeet(gap, pose);
            const NearestSurfaces exact = nearest(anew, pose, {});
            const double near = std::cos(nearest(gap, {}, {}).nearFoot());
            if (anew.body.foot.dot(gap.body.foot) < near ||
                (kind == Kind::circle && anew.support.foot.dot(gap.support.foot) < near))
                continue;
            ++tried;
            EXPECT_NEAR(found.gap, exact.gap, 1e-15);
            EXPECT_LT((found.normal - exact.normal).norm(), 2e-12) << int(kind) << ' ' << i;
            EXPECT_LT((found.contact - exact.contact).norm(), 1e-12) << int(kind) << ' ' << i;
        }
    EXPECT_GT(tried, 1000);
}

// A can that is shoved about on another one: their rims cross where the can came from, and that
// goes around both of them. Begun on the sphere the crossing is exact all the way.
TEST(SurfaceGap, OfRimsNearlyInOneAnotherIsExactAllAround) {
    SurfaceGap gap;
    gap.body = {.kind = Kind::circle, .axis = Vector::UnitY(), .radius = 0.4};
    gap.support = gap.body;
    const Vector off(0.0056, 0, 0.0192); // 0.02
    gap.body.foot = gap.support.foot = Vector::UnitY().cross(off).normalized();
    SurfacePose pose{.centre = off};
    gap = withFeet(gap, pose);
    gap = fromSphereIfSteady(gap, pose, {});
    ASSERT_NE(gap.branch, 0);
    for (int i = 0; i < 400; ++i) {
        const Matrix turn =
            posed(Vector::Zero(), Vector::UnitY(), i * std::numbers::pi / 100).rotation;
        const double tilt = 1e-3 * std::sin(0.7 * i);
        pose = posed(turn * off * (1 + 0.5 * std::sin(0.01 * i)), turn.col(0), tilt);
        pose.centre.y() += 0.4 * tilt;
        pose.centre -= nearest(gap, pose, {}).gap * nearest(gap, pose, {}).normal;
        const NearestSurfaces found = nearest(gap, pose, {});
        SurfaceGap anew = gap;
        anew.branch = 0;
        for (SurfacePiece* piece : {&anew.body, &anew.support}) {
            const SurfacePose of = piece == &anew.body ? pose : SurfacePose{};
            piece->foot = of.rotation.transpose() * (found.contact - of.centre) / 0.4;
        }
        const NearestSurfaces exact = nearest(withFeet(anew, pose), pose, {});
        EXPECT_NEAR(found.gap, 0, 1e-14);
        EXPECT_NEAR(exact.gap, 0, 1e-14);
        EXPECT_LT((found.contact - exact.contact).norm(), 1e-11) << i;
        EXPECT_GT(found.contact.dot(turn.col(0)), 0.3); // the same of the two
        EXPECT_NEAR(found.steady, exact.steady, 0.01 * exact.steady);
    }
}

// The lowest point of a rim that stands upright on another one grazes the sphere: its feet stay.
TEST(SurfaceGap, OfARimThatStandsOnAnotherBeginsAtItsFeet) {
    const Curves made = curves(Kind::circle, 0.3);
    const SurfaceGap gap{made.rim, made.other, false};
    EXPECT_EQ(fromSphereIfSteady(gap, {}, {}).branch, 0);
    EXPECT_GT(nearest(gap, {}, {}).steady, 0.5);
}

// Of a rim and a line the gap is the least distance of the rim's points from the line.
TEST(SurfaceGap, OfARimAndALineIsTheirLeastDistance) {
    const Curves made = curves(Kind::line, 0.04);
    const SurfacePose pose = posed({0.01, 0.003, 0.02}, {1, 2, 3}, 0.1);
    const NearestSurfaces at = nearest({made.rim, made.other, false}, pose, {});
    double least = HUGE_VAL;
    for (int i = 0; i < 20000; ++i) {
        const double a = i * std::numbers::pi / 10000;
        const Vector on =
            pose.centre + pose.rotation * Vector(0.1 * std::cos(a), 0.1 + 0.1 * std::sin(a), 0);
        least = std::min(least, made.other.axis.cross(on - made.other.place).norm() - 0.04);
    }
    EXPECT_NEAR(at.gap, least, 1e-9);
    EXPECT_LE(at.gap, least + 1e-15);
}

// Normal and tangents of two rims: the normal is across both, from the other to the rim.
TEST(SurfaceGap, OfRimsAndEdgesThatCrossIsAlongBothTangentsNormal) {
    for (const Kind kind : {Kind::line, Kind::circle}) {
        const Curves made = curves(kind, kind == Kind::line ? 0 : 0.3);
        const SurfacePose pose{.centre = {0, 0.002, 0}, .rotation = Matrix::Identity()};
        NearestSurfaces at = nearest({made.rim, made.other, false}, pose, {});
        if (at.normal.y() < 0)
            at = nearest({made.rim, made.other, true}, pose, {});
        EXPECT_NEAR(at.gap, 0.002, 1e-15);
        expectNear(at.normal, Vector::UnitY());
    }
}

SurfaceMotion after(double time, const SurfaceMotion& m) {
    const auto turn = [](const Vector& by) {
        const double angle = by.norm();
        return Matrix(angle > 0 ? Eigen::AngleAxisd(angle, by / angle).toRotationMatrix()
                                : Matrix(Matrix::Identity()));
    };
    SurfaceMotion moved = m;
    moved.pose.centre += time * m.velocity + time * time / 2 * m.acceleration;
    // The spin turns steadily: to third order.
    moved.pose.rotation = turn(time * m.spin + time * time / 2 * m.spinRate) * m.pose.rotation;
    return moved;
}

TEST(SurfaceGap, AcceleratesAsItsSecondDifferenceSays) {
    const Curves edge = curves(Kind::line, 0), log = curves(Kind::line, 0.04),
                 rim = curves(Kind::circle, 0.3);
    SurfaceGap sphere{rim.rim, rim.other, false};
    sphere.branch = 1;
    sphere.support.place = {0.25, 0.3, 0};
    const SurfacePiece ball{.kind = Kind::point, .radius = 0.1};
    const SurfacePiece below{.kind = Kind::plane, .axis = Vector::UnitY()};
    const SurfaceMotion body{.pose = posed({0.01, 0.2, 0.02}, {1, 2, 3}, 0.1),
                             .velocity = {0.3, -0.2, 0.5},
                             .spin = {2, -3, 1},
                             .acceleration = {0.5, -9.81, 1},
                             .spinRate = {10, 20, -5}};
    const SurfaceMotion support{.pose = {}, .velocity = {-0.1, 0.2, 0}, .spin = {0, 1, -0.5}};
    for (const SurfaceGap& gap :
         {SurfaceGap{edge.rim, edge.other, false}, SurfaceGap{log.rim, log.other, false},
          SurfaceGap{rim.rim, rim.other, false}, SurfaceGap{ball, log.other, false},
          SurfaceGap{edge.rim, below, false}, sphere}) {
        constexpr double h = 1e-4;
        const auto at = [&](double time) {
            return nearest(gap, after(time, body).pose, after(time, support).pose).gap;
        };
        const double difference = (at(h) - 2 * at(0) + at(-h)) / (h * h);
        EXPECT_NEAR(accelerationOf(gap, body, support), difference,
                    1e-4 * (1 + std::abs(difference)))
            << int(gap.support.kind);
    }
}

TEST(SurfaceGap, IsKnownOfPairsWithAFormulaAlone) {
    EXPECT_TRUE(haveGap(Kind::plane, Kind::ellipsoid));
    EXPECT_TRUE(haveGap(Kind::cone, Kind::point));
    EXPECT_TRUE(haveGap(Kind::circle, Kind::circle));
    EXPECT_TRUE(haveGap(Kind::line, Kind::circle));
    EXPECT_FALSE(haveGap(Kind::line, Kind::cone));
    EXPECT_FALSE(haveGap(Kind::ellipsoid, Kind::point));
}

} // namespace
} // namespace physics
