#include "collision/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace collision {
namespace {

Polynomial of(std::initializer_list<double> terms) {
    Polynomial p;
    p.count = 0;
    for (double t : terms)
        p.terms[p.count++] = t;
    return p;
}

TEST(FirstDescent, FindsTheFirstOfSeveralRoots) {
    // (s - 1)(s - 2)(s - 3) negated: from positive to negative at 1.
    EXPECT_NEAR(*firstDescent(of({6, -11, 6, -1}), 10), 1, 1e-15);
    EXPECT_FALSE(firstDescent(of({6, -11, 6, -1}), 0.9));
}

TEST(FirstDescent, OfATouchIsNone) {
    EXPECT_FALSE(firstDescent(of({1, -2, 1}), 3)); // (s - 1)^2
    EXPECT_TRUE(firstDescent(of({1 - 1e-12, -2, 1}), 3));
    EXPECT_FALSE(firstDescent(of({1 + 1e-12, -2, 1}), 3));
    EXPECT_FALSE(firstDescent(of({0}), 3));
}

TEST(FirstDescent, AtTheStart) {
    EXPECT_EQ(*firstDescent(of({-1, 1}), 3), 0);
    EXPECT_EQ(*firstDescent(of({0, -1}), 3), 0);
    EXPECT_EQ(*firstDescent(of({0, 1, -1}), 3), 1);
    EXPECT_FALSE(firstDescent(of({0, 1}), 3));
}

TEST(FirstDescent, IsExactOnRoundTimes) { // a fall of 5 m at 10 m/s^2
    EXPECT_EQ(*firstDescent(of({5, 0, -5}), 10), 1);
}

TEST(FirstDescent, MissesNoRootOfRandomPolynomialsUpToDegreeSixteen) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        Polynomial p;
        p.count = 1 + random() % maximumTerms;
        for (std::size_t k = 0; k < p.count; ++k)
            p.terms[k] = uniform(random);
        p.terms[0] = std::abs(p.terms[0]);
        const auto found = firstDescent(p, 1.5);
        for (double s = 0; s < found.value_or(1.5) - 1e-9; s += 1e-3)
            ASSERT_GE(p.value(s), -1e-12) << "trial " << trial;
        if (found) {
            ASSERT_LT(p.value(*found + 1e-9), 1e-12);
        }
    }
}

} // namespace
} // namespace collision
