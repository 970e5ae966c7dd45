#include "complementarity/convex.h"

#include <gtest/gtest.h>

#include <random>

namespace complementarity {
namespace {

Matrix randomMobility(std::mt19937_64& random, Index n, Index freedoms) {
    std::normal_distribution<double> normal;
    const Matrix j = Matrix::NullaryExpr(n, freedoms, [&] { return normal(random); });
    return j * j.transpose();
}

TEST(Convex, AWeightOnFourFeetIsSharedEvenly) {
    Matrix j(4, 3); // height, and turning about two axes
    j << 1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
    Laws laws;
    for (int i = 0; i < 4; ++i)
        addUnilateral(laws);
    const std::optional<Answer> answer =
        solveConvex(j * j.transpose(), Vector::Constant(4, -9.81), laws);
    ASSERT_TRUE(answer);
    EXPECT_LE((answer->forces - Vector::Constant(4, 9.81 / 4)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Convex, AMotorHoldsUpToItsGreatestForce) {
    const Matrix a = Matrix::Constant(1, 1, 0.5); // the inverse of a mass of 2
    Laws laws;
    addInterval(laws, -10, 10);
    const auto forceAgainst = [&](double acceleration) {
        const auto answer = solveConvex(a, Vector::Constant(1, acceleration), laws);
        return std::pair(answer->forces[0], answer->rates[0]);
    };
    EXPECT_EQ(forceAgainst(-4), std::pair(8.0, 0.0));
    EXPECT_EQ(forceAgainst(-6), std::pair(10.0, -1.0));
    EXPECT_EQ(forceAgainst(6), std::pair(-10.0, 1.0));
}

// The hinge of an arm and its motor: rows that are all but one. A hundred thousandth beyond the
// motor's couple f2, or within it:  f1 = 5 + (f2 + 10),  w2 = 0.01 (-10 - f2).
TEST(Convex, AMotorNearItsGreatestCoupleHoldsOrSlipsBesideAStiffJoint) {
    Matrix j(2, 2);
    j << 20, 0, 20, 0.1;
    const Matrix a = j * j.transpose();
    Laws laws;
    addEquality(laws);
    addInterval(laws, -10, 10);
    for (const double beyond : {1e-3, 1e-5, 1e-6, -1e-6, -1e-5, -1e-3}) {
        const Vector wanted = (Vector(2) << 5, -10 - beyond).finished();
        const auto answer = solveConvex(a, -a * wanted, laws);
        ASSERT_TRUE(answer) << beyond;
        const bool slips = beyond > 0;
        EXPECT_EQ(answer->states[1], slips ? State::low : State::inside) << beyond;
        EXPECT_NEAR(answer->forces[0], slips ? 5 - beyond : 5, 1e-9) << beyond;
        EXPECT_NEAR(answer->forces[1], slips ? -10 : -10 - beyond, 1e-9) << beyond;
        EXPECT_NEAR(answer->rates[1], slips ? 0.01 * beyond : 0, 1e-11) << beyond;
    }
}

TEST(Convex, JointsThatContradictEachOtherHaveNoForces) {
    Laws laws;
    addEquality(laws);
    addEquality(laws);
    const Matrix twice = Matrix::Ones(2, 2);
    EXPECT_FALSE(solveConvex(twice, (Vector(2) << 1, 2).finished(), laws));
    const auto agreed = solveConvex(twice, Vector::Constant(2, -3), laws);
    ASSERT_TRUE(agreed);
    EXPECT_NEAR(agreed->forces[0], 1.5, 1e-14);
    EXPECT_NEAR(agreed->forces[1], 1.5, 1e-14);
}

// A rope over a wheel of 1e-5 kg: the hinge's force along x is 0, beside tensions of 13 N.
TEST(Convex, AForceOfNothingBesideLightThingsIsFoundToTheLastBits) {
    Matrix m(4, 4);
    m << 1, 0, 0, 0, 0, 1, -1, -1, -1e-17, -1, 3 + 1e-5, -1, 1e-17, -1, -1, 3 + 5e-6;
    Laws laws;
    addEquality(laws);
    addEquality(laws);
    addUnilateral(laws);
    addUnilateral(laws);
    const auto answer = solveConvex(99999.999999999985 * m, Vector::Unit(4, 1) * -9.81, laws);
    ASSERT_TRUE(answer);
    EXPECT_NEAR(answer->forces[0], 0, 1e-20);
    EXPECT_NEAR(answer->forces[2], 9.81 / 0.75, 1e-4);
}

// Against every choice of states: the rates are unique, whatever is redundant.
TEST(Convex, RandomRowsAgreeWithEveryChoiceOfStates) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int scene = 0; scene < 300; ++scene) {
        const Index n = 1 + scene % 5;
        const Matrix a = randomMobility(random, n, 3);
        const Vector b = a * Vector::NullaryExpr(n, [&] { return uniform(random); });
        Laws laws;
        for (Index i = 0; i < n; ++i)
            if (i % 3 == 0)
                addUnilateral(laws);
            else
                addInterval(laws, -0.3, i % 3 == 1 ? 0.2 : unbounded);
        const std::optional<Answer> answer = solveConvex(a, b, laws);
        ASSERT_TRUE(answer) << scene;
        EXPECT_LE(violation(a, b, laws, *answer), 1e-11) << scene;
        // The minimum: no allowed step of one or of two forces lowers it.
        const auto energy = [&](const Vector& f) { return f.dot(a * f) / 2 + b.dot(f); };
        for (int step = 0; step < 100; ++step) {
            Vector other =
                answer->forces + 0.1 * Vector::NullaryExpr(n, [&] { return uniform(random); });
            for (Index i = 0; i < n; ++i)
                other[i] = std::clamp(other[i], laws[static_cast<std::size_t>(i)].low,
                                      laws[static_cast<std::size_t>(i)].high);
            EXPECT_GE(energy(other), energy(answer->forces) - 1e-13) << scene;
        }
    }
}

} // namespace
} // namespace complementarity
