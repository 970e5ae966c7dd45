#include "dense/polynomial.h"

#include "dense/dense_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace solution;

TEST(Polynomial, InterpolatesDegreeEightExactly) {
    const Coefficients wanted = {1, -2, 3, 0.5, -1, 2, 0, 1, -0.25};
    std::array<double, maximumCoefficients> values{};
    for (std::size_t i = 0; i <= maximumDegree; ++i)
        values[i] = evaluate(wanted, interpolationPoints()[i]);
    const Coefficients found = interpolate(values);
    for (std::size_t k = 0; k <= maximumDegree; ++k)
        EXPECT_NEAR(found[k], wanted[k], 1e-9) << k;
}

TEST(Polynomial, ReparametrizedIsTheSameCurve) {
    const Coefficients c = {1, -2, 3, 0.5, -1, 2, 0, 1, -0.25};
    const Coefficients moved = reparametrize(c, 0.3, 2.5);
    for (const double r : {-0.5, 0.0, 0.2, 1.0})
        EXPECT_NEAR(evaluate(moved, r), evaluate(c, 0.3 + 2.5 * r), 1e-12);
}

// So short a step that the place does not change at all, but the velocity is known.
TEST(Quintics, ShowNoRoundingOfThePlaceInTheVelocityOfAShortStep) {
    const std::vector<double> y = {0.2, 1.6e-5}, slopes = {1.6e-5, 0};
    const std::vector<std::pair<std::size_t, std::size_t>> pairs = {{0, 1}};
    std::vector<Coefficients> columns(2);
    quintics(columns, pairs,
             {.h = 9e-15, .start = y, .end = y, .startSlope = slopes, .endSlope = slopes});
    for (const double s : {0.0, 0.3, 0.5, 1.0})
        EXPECT_NEAR(evaluate(columns[1], s), 1.6e-5, 1e-15) << s;
}

TEST(Piece, BoundsHoldEveryValueAndAreTightOnShortIntervals) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 300; ++round) {
        Coefficients c{};
        for (double& x : c)
            x = uniform(random);
        const Piece piece{2, 6, 4, CoefficientList(c)};
        const double from = 2 + 2 * (uniform(random) + 1), length = 0.05 * (uniform(random) + 1);
        const Interval values = piece.bounds(from, from + length);
        const Interval slopes = piece.derivativeBounds(from, from + length);
        for (int k = 0; k <= 50; ++k) {
            const double t = from + length * k / 50;
            EXPECT_GE(piece.value(t), values.low);
            EXPECT_LE(piece.value(t), values.high);
            EXPECT_GE(piece.derivative(t), slopes.low);
            EXPECT_LE(piece.derivative(t), slopes.high);
        }
        const double steepest = std::max(std::abs(slopes.low), std::abs(slopes.high));
        EXPECT_LE(values.high - values.low, 2.1 * steepest * length + 1e-12);
    }
}

TEST(Piece, DerivativesAreThoseOfItsCurve) {
    const Coefficients c = {1, 2, 3, 4, 5, 0, 0, 0, 0};
    const Piece piece{1, 3, 2, CoefficientList(c)};
    const double h = 1e-4;
    EXPECT_NEAR(piece.derivative(2), (piece.value(2 + h) - piece.value(2 - h)) / (2 * h), 1e-6);
    EXPECT_NEAR(piece.secondDerivative(2),
                (piece.value(2 + h) - 2 * piece.value(2) + piece.value(2 - h)) / (h * h), 1e-5);
}

TEST(FirstCrossing, FindsTheFirstRootAndIgnoresATouch) {
    // (s - 1/4)^2 (s - 1/2)(s - 7/8): touches at 1/4, crosses at 1/2 and 7/8; positive before.
    const Coefficients c = {0.02734375, -0.3046875, 1.1875, -1.875, 1, 0, 0, 0, 0};
    const auto found = firstCrossing(c, +1, 0, 1, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->high, 0.5, 1e-6);
    const Coefficients positive = {1, 0, 0.5, 0, 0, 0, 0, 0, 0};
    EXPECT_FALSE(firstCrossing(positive, +1, 0, 1, 1e-9));
}
