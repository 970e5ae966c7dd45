#include "collision/curved_separation.h"
#include "collision/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace collision {
namespace {

using namespace geometry;

Separation apart(const Part& a, const Part& b, const Vector& offset,
                 const Vector& rotation = Vector::Zero()) {
    WarmStart cold;
    const Matrix turn = fromRotationVector(rotation).toRotationMatrix();
    return separate({&a, turn, offset}, {&b, Matrix::Identity(), Vector::Zero()}, cold);
}

void expectGap(const Separation& s, double gap, const Vector& normal, double tolerance = 2e-15) {
    EXPECT_NEAR(s.gap, gap, tolerance);
    EXPECT_LT((s.normal - normal.normalized()).norm(), 1e-14 + tolerance) << s.normal.transpose();
}

const double gaps[] = {2, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 0, -1e-12, -1e-9, -1e-6};

TEST(CurvedSeparation, OverAHalfSpaceIsTheLowestPointsHeight) {
    const Part floor = planePart();
    for (const double gap : gaps) {
        const Vector up(0, 1, 0);
        expectGap(apart(spherePart(0.5), floor, {3, 0.5 + gap, 1}), gap, up);
        expectGap(apart(capsulePart(0.5, 2), floor, {3, 1.5 + gap, 1}), gap, up);
        const double lean = 0.5 + std::cos(0.3);
        expectGap(apart(capsulePart(0.5, 2), floor, {1e3, lean + gap, 1}, {0, 0, 0.3}), gap, up);
        const double edge = std::cos(0.3) + 0.5 * std::sin(0.3);
        expectGap(apart(cylinderPart(0.5, 2), floor, {0, edge + gap, 1}, {0.3, 0, 0}), gap, up);
        expectGap(
            apart(cylinderPart(0.5, 2), floor, {0, 0.5 + gap, 1}, {std::numbers::pi / 2, 0, 0}),
            gap, up);
        expectGap(apart(conePart(0.5, 2), floor, {0, 1 + gap, 1}, {std::numbers::pi, 0, 0}), gap,
                  up);
        const double low = std::hypot(0.5 * std::sin(0.3), 2 * std::cos(0.3));
        expectGap(apart(ellipsoidPart({0.5, 2, 1}), floor, {0, low + gap, 1}, {0, 0, 0.3}), gap,
                  up);
    }
    // The half space as the first part, and turned.
    const Part ball = spherePart(1);
    WarmStart cold;
    const Matrix turn = fromRotationVector({0, 0, 0.5}).toRotationMatrix();
    const Separation s = separate({&floor, turn, {1, 0, 0}}, {&ball, turn, {0, 5, 0}}, cold);
    expectGap(s, turn.col(1).dot(Vector(-1, 5, 0)) - 1, -turn.col(1));
}

TEST(CurvedSeparation, OfCapsulesIsThatOfTheirAxes) {
    const Part one = capsulePart(0.3, 2), other = capsulePart(0.2, 4);
    for (const double gap : gaps) {
        // Crossed; side by side; an end over a side; a ball over an end.
        expectGap(apart(one, other, {0, 0.7, 0.5 + gap}, {0, 0, 1.1}), gap, {0, 0, 1});
        expectGap(apart(one, other, {0.5 + gap, 0.7, 0}), gap, {1, 0, 0});
        expectGap(apart(one, other, {1.5 + gap, 0.7, 0}, {0, 0, std::numbers::pi / 2}), gap,
                  {1, 0, 0});
        expectGap(apart(spherePart(0.3), other, {0.3 * (0.5 + gap), 2 + 0.4 * (0.5 + gap), 0}),
                  gap / 2 - 0.25, {3, 4, 0});
        expectGap(apart(one, polyhedronPart(box({2, 2, 2})), {0, 2.3 + gap, 0.2}), gap, {0, 1, 0});
    }
}

TEST(CurvedSeparation, OfCylinders) {
    const Part drum = cylinderPart(1, 2), ball = spherePart(0.5);
    const Part cube = polyhedronPart(box({2, 2, 2}));
    for (const double gap : gaps) {
        expectGap(apart(ball, drum, {0.9 * (1.5 + gap), 0.3, std::sqrt(0.19) * (1.5 + gap)}), gap,
                  {0.9, 0, std::sqrt(0.19)});
        expectGap(apart(ball, drum, {0.3, 1.5 + gap, 0.2}), gap, {0, 1, 0});
        const double r = 0.5 + gap; // beyond the rim
        expectGap(apart(ball, drum, {1 + 0.6 * r, 1 + 0.8 * r, 0}), gap, {0.6, 0.8, 0});
        // Two lying across each other, an end on an end, a rim leaning on a face.
        expectGap(apart(drum, drum, {0.2, 0, 2 + gap}, {0, 0, std::numbers::pi / 2}), gap,
                  {0, 0, 1});
        expectGap(apart(drum, drum, {1.2, 2 + gap, 0.3}), gap, {0, 1, 0});
        const double low = std::cos(0.4) + std::sin(0.4);
        expectGap(apart(drum, cube, {0, 1 + low + gap, 0}, {0.4, 0, 0}), gap, {0, 1, 0});
        // The side of a drum on a vertical edge of the cube, and a rim across an edge of it.
        const double d = std::sqrt(0.5) * (1 + gap);
        expectGap(apart(drum, cube, {1 + d, 0, 1 + d}), gap, {1, 0, 1});
        // Tilted by 0.4 about z, the rim's lowest point lies in the plane of the drum's tilt.
        expectGap(apart(drum, cube, {1 + low + gap, 0, 0}, {0, 0, std::numbers::pi / 2 - 0.4}), gap,
                  {1, 0, 0});
    }
}

// Over the edge of a cube that is turned by 45 degrees about it: a coin's side along the edge; and
// the rim of one that leans by 0.4 along the edge, its tangent at right angles to it.
TEST(CurvedSeparation, OfASideAlongAnEdgeAndARimAcrossIt) {
    const Part coin = cylinderPart(1, 0.1);
    const Part cube = polyhedronPart(
        box({2, 2, 2}), {Vector::Zero(), fromRotationVector({0, 0, std::numbers::pi / 4})});
    const double right = std::numbers::pi / 2, lean = 0.4;
    const double low = std::cos(lean) + 0.05 * std::sin(lean);
    for (const double gap : gaps) {
        expectGap(apart(coin, cube, {0, std::sqrt(2) + 1 + gap, 0}, {right, 0, 0}), gap, {0, 1, 0},
                  4e-15);
        expectGap(apart(coin, cube, {0, std::sqrt(2) + low + gap, 0.2}, {right - lean, 0, 0}), gap,
                  {0, 1, 0}, 4e-15);
    }
}

TEST(CurvedSeparation, OfCones) {
    const Part cone = conePart(1, 2), ball = spherePart(0.5);
    const Vector side = Vector(2, 1, 0).normalized(); // outward at the side towards x
    for (const double gap : gaps) {
        expectGap(apart(cone, polyhedronPart(box({4, 2, 4})), {0.3, 2 + gap, 0.1},
                        {std::numbers::pi, 0, 0}),
                  gap, {0, 1, 0});
        const Vector middle(0.5, 0, 0);
        expectGap(apart(ball, cone, middle + (0.5 + gap) * side), gap, side);
        expectGap(apart(ball, cone, {0, 1.5 + gap, 0}), gap, {0, 1, 0});
        // Two cones side by side, the one upside down: along a common line of their sides.
        const double across = std::sqrt(5) / 2; // of the gap along x, to that across the sides
        expectGap(apart(cone, cone, {1 + gap * across, 0, 0}, {std::numbers::pi, 0, 0}), gap, side);
        // A cylinder that lies on its side, its rims across the line.
        const Part rod = cylinderPart(0.25, 6);
        const double tilt = std::atan2(1, 2);
        expectGap(apart(rod, cone, middle + (0.25 + gap) * side, {0, 0, tilt}), gap, side);
    }
}

TEST(CurvedSeparation, OfEllipsoidsWhoseAxesAlign) {
    const Part egg = ellipsoidPart({1, 2, 3}), flat = ellipsoidPart({2, 0.5, 2});
    for (const double gap : gaps) {
        expectGap(apart(egg, flat, {3 + gap, 0, 0}), gap, {1, 0, 0}, 4e-15);
        expectGap(apart(egg, flat, {0, 2.5 + gap, 0}), gap, {0, 1, 0}, 4e-15);
        expectGap(apart(egg, flat, {0, 0, 5 + gap}), gap, {0, 0, 1}, 4e-15);
        // Along any other normal n: the points with this normal, `gap` apart.
        const Vector n = Vector(0.3, 0.5, 0.4).normalized();
        const auto point = [&](const Vector& a) {
            return Vector(a.cwiseProduct(a).cwiseProduct(n) / a.cwiseProduct(n).norm());
        };
        expectGap(apart(egg, flat, point({1, 2, 3}) + point({2, 0.5, 2}) + gap * n), gap, n, 4e-15);
        expectGap(apart(spherePart(0.5), egg, point({1, 2, 3}) + (0.5 + gap) * n), gap, n, 4e-15);
    }
}

// Convex parts that are apart have one nearest pair: where no direction near n has a larger gap,
// none has.
class RandomParts {
public:
    explicit RandomParts(unsigned seed) : random_(seed) {}
    double number(double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random_);
    }
    Vector direction() {
        std::normal_distribution<> normal;
        return Vector(normal(random_), normal(random_), normal(random_)).normalized();
    }
    Part part() {
        const double r = number(0.1, 1), h = number(0, 1) < 0.1 ? 0 : number(0.1, 2);
        switch (std::uniform_int_distribution<>(0, 5)(random_)) {
        case 0:
            return spherePart(r);
        case 1:
            return capsulePart(r, h);
        case 2:
            return cylinderPart(r, h);
        case 3:
            return conePart(r, h + 0.1);
        case 4:
            return ellipsoidPart({r, number(0.1, 2), number(0.1, 2)});
        default:
            return polyhedronPart(box({r, h + 0.1, number(0.1, 2)}));
        }
    }
    Matrix turn() {
        return fromRotationVector(number(0, std::numbers::pi) * direction()).toRotationMatrix();
    }

private:
    std::mt19937_64 random_;
};

double gapAlong(const Posed& a, const Posed& b, const Vector& n) {
    return n.dot(a.furthest(-n) - b.furthest(n)) - a.part->radius - b.part->radius;
}

TEST(CurvedSeparation, OfRandomPartsCannotBeLarger) {
    RandomParts random(7);
    for (int i = 0; i < 3000; ++i) {
        const Part one = random.part(), other = random.part();
        const double reach = radiusAbout(one, Vector::Zero()) + radiusAbout(other, Vector::Zero());
        const Posed b{&other, random.turn(), Vector::Zero()};
        Posed a{&one, random.turn(), random.number(0.6, 3) * reach * random.direction()};
        WarmStart cold;
        Separation s = separate(a, b, cold);
        if (s.gap > 0 && i % 3 > 0) { // near each other, and all but touching
            a.offset -= (s.gap - (i % 3 == 1 ? 1e-3 : 1e-10)) * s.normal;
            s = separate(a, b, cold);
        }
        if (!(s.gap > 0) || !isCurvedPair(one, other))
            continue;
        EXPECT_NEAR(gapAlong(a, b, s.normal), s.gap, 1e-14 * reach);
        double most = s.gap;
        for (int k = 0; k < 300; ++k) {
            const double way = std::pow(10, random.number(-7, 0));
            const Vector n = (s.normal + way * random.direction()).normalized();
            most = std::max(most, gapAlong(a, b, n));
        }
        EXPECT_LE(most, s.gap + 1e-14 * reach)
            << i << ": " << s.gap << " of " << reach << ", along " << s.normal.transpose();
    }
}

TEST(CurvedSeparation, IsTheSameFromBothSides) {
    RandomParts random(11);
    for (int i = 0; i < 300; ++i) {
        const Part one = random.part(), other = random.part();
        const Posed b{&other, random.turn(), Vector::Zero()};
        const Posed a{&one, random.turn(), random.number(0, 4) * random.direction()};
        WarmStart cold;
        const Separation s = separate(a, b, cold), back = separate(b, a, cold);
        if (s.gap > 0)
            EXPECT_NEAR(s.gap, back.gap, 1e-14);
        else
            EXPECT_LE(back.gap, 0);
    }
}

} // namespace
} // namespace collision
