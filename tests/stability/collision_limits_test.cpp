// Cases in which searches for impacts fail, and ours does not (docs/numerics/measurements.md,
// Stability, 25 to 29).
#include "marks.h"

#include "collision/flying_body.h"
#include "collision/separation.h"
#include "collision/time_of_impact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace collision {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Real = long double;

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vector direction() {
        std::normal_distribution<double> normal;
        return Vector(normal(random_), normal(random_), normal(random_)).normalized();
    }
    Vector across(const Vector& axis) { return axis.cross(direction()).normalized(); }

private:
    std::mt19937_64 random_;
};

// |p + v t + a t^2/2|^2 - R^2 and its rate in long double: a root by Newton's method from beside
// it.
Real impactOf(const FlyingBody& moving, double radius, Real t) {
    for (int i = 0; i < 100; ++i) {
        Real value = -static_cast<Real>(radius) * radius, rate = 0;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Real v = moving.velocity[k], a = moving.acceleration[k];
            const Real place = moving.position[k] + v * t + a * t * t / 2;
            value += place * place;
            rate += 2 * place * (v + a * t);
        }
        t -= value / rate;
    }
    return t;
}

// 25. Ferrari's quartic divides by the square of the relative acceleration: at 1e-9 it loses all
// hits. Descartes' rule divides by nothing.
TEST(Limits, TimesOfImpactOfSpheresAsTheirRelativeAccelerationVanishes) {
    constexpr int trials = 2000;
    Draw draw(25);
    for (const double acceleration : {1e-2, 1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
        int missed = 0;
        double worst = 0;
        for (int n = 0; n < trials; ++n) {
            const Vector along = draw.direction();
            const double away = draw.between(2, 5), speed = draw.between(1, 3);
            FlyingBody a = flyingSphere(
                0.5, -away * along + draw.between(0, 0.8) * draw.across(along), speed * along);
            a.acceleration = acceleration * draw.direction();
            const Encounter e = timeOfImpact(a, flyingSphere(0.5, Vector::Zero()), {0, 10});
            missed += !e.hit;
            if (e.hit)
                worst = std::max(worst, std::abs(static_cast<double>(e.hit->time -
                                                                     impactOf(a, 1, e.hit->time))));
        }
        EXPECT_EQ(missed, 0) << acceleration;
        EXPECT_LT(worst, 1e-13) << acceleration;
    }
}

// 26. A hit that goes R d deep is ill-conditioned: no method's time is better than eps/sqrt(d).
TEST(Limits, GrazingSpheresAreAsExactAsTheProblemIs) {
    constexpr int trials = 1000;
    Draw draw(26);
    for (const double depth : {1e-2, 1e-4, 1e-8, 1e-10, 1e-12}) {
        std::vector<double> errors;
        for (int n = 0; n < trials; ++n) {
            const Vector along = draw.direction();
            const FlyingBody a =
                flyingSphere(0.5, -3 * along + (1 - depth) * draw.across(along), along);
            const Encounter e = timeOfImpact(a, flyingSphere(0.5, Vector::Zero()), {0, 6});
            ASSERT_TRUE(e.hit) << depth;
            const Real before = 3 - 1.5 * std::sqrt(2 * depth);
            errors.push_back(std::abs(static_cast<double>(e.hit->time - impactOf(a, 1, before))));
        }
        std::ranges::sort(errors);
        mark("grazing", "median", depth, errors[trials / 2]);
        mark("grazing", "largest", depth, errors.back());
        mark("grazing", "eps / sqrt(d)*", depth, eps / std::sqrt(depth));
        EXPECT_LT(errors[trials / 2], 10 * eps / std::sqrt(depth)) << depth;
        EXPECT_LT(errors.back(), 200 * eps / std::sqrt(depth)) << depth;
    }
}

// 27. Plain conservative advancement takes 1/sqrt(d) steps to a grazing hit. A rod's corner sweeps
// over a ball: the law of cosines has the time.
TEST(Limits, GrazingAdvancementTakesAsManyStepsAsADirectHit) {
    const double reach = std::hypot(1, 0.05), radius = 0.2;
    for (const double depth : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
        const double away = reach + radius * (1 - depth);
        FlyingBody rod = flyingBox({2, 0.1, 0.1}, {0, 0, 0});
        rod.spin = {0, 0, 3};
        const FlyingBody ball =
            flyingSphere(radius, {away * std::cos(1.0), away * std::sin(1.0), 0});
        const double angle =
            std::acos((reach * reach + away * away - radius * radius) / (2 * reach * away));
        const Encounter e = timeOfImpact(rod, ball, {0, 1});
        ASSERT_TRUE(e.hit) << depth;
        EXPECT_NEAR(e.hit->time, (1 - std::atan(0.05) - angle) / 3, 100 * eps / std::sqrt(depth));
        EXPECT_LT(e.evaluations, 60u) << depth;
    }
}

// 28. Two cubes shifted along one axis: another library's answer is depth 0 and no direction.
TEST(Limits, CubesShiftedAlongAnAxisHaveADepth) {
    const Part cube = geometry::polyhedronPart(geometry::box({2, 2, 2}));
    const Posed here{&cube, Matrix::Identity(), Vector::Zero()};
    const Posed there{&cube, Matrix::Identity(), {0, 0, 1.9}};
    WarmStart cold;
    for (const Separation& s : {separate(there, here, cold), separateByAxes(there, here)}) {
        EXPECT_NEAR(s.gap, -0.1, 4 * eps);
        EXPECT_EQ(s.normal, Vector(0, 0, 1));
    }
}

// 29. The depth of overlapping boxes is the least over the 15 axes that can separate boxes; portal
// refinement is up to twice that.
TEST(Limits, DepthsOfRandomCubesAreTheLeast) {
    Draw draw(29);
    const Part cube = geometry::polyhedronPart(geometry::box({2, 2, 2}));
    int overlapping = 0;
    for (int n = 0; n < 3000; ++n) {
        const auto turned = [&] {
            return Matrix(Eigen::AngleAxisd(draw.between(0, 3), draw.direction()));
        };
        const Matrix a = turned(), b = turned();
        const Vector offset = draw.between(0.5, 2) * draw.direction();
        double depth = HUGE_VAL;
        const auto tryAxis = [&](const Vector& axis) {
            if (axis.norm() < 1e-9)
                return;
            const Vector u = axis.normalized();
            const double reach = (a.transpose() * u).lpNorm<1>() + (b.transpose() * u).lpNorm<1>();
            depth = std::min(depth, reach - std::abs(u.dot(offset)));
        };
        for (Eigen::Index i = 0; i < 3; ++i) {
            tryAxis(a.col(i));
            tryAxis(b.col(i));
            for (Eigen::Index k = 0; k < 3; ++k)
                tryAxis(a.col(i).cross(b.col(k)));
        }
        if (depth < 1e-6)
            continue;
        ++overlapping;
        const Separation s = separateByAxes({&cube, a, offset}, {&cube, b, Vector::Zero()});
        EXPECT_NEAR(s.gap, -depth, 1e-12) << n;
    }
    EXPECT_GT(overlapping, 1000);
}

} // namespace
} // namespace collision
