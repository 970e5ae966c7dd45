// When the first of several watches falls.
#include "dense/first_violation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

using namespace solution;

namespace {

std::optional<Violation> violationOf(const std::function<double(double)>& f, double from,
                                     double to) {
    return firstViolation(
        1, [&](double t, std::span<double> out) { out[0] = f(t); }, from, to);
}

} // namespace

TEST(FirstViolation, IsTheFirstRootToTheLastBit) {
    const auto found = violationOf([](double t) { return std::cos(t); }, 0, 20);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->time, std::numbers::pi / 2, 1e-15);
    EXPECT_LE(std::cos(found->time), 0);
    EXPECT_GT(std::cos(std::nextafter(found->time, 0)), 0);
}

TEST(FirstViolation, AsksForOneWatchADozenTimes) {
    int asked = 0;
    const auto all = [](double t, std::span<double> out) {
        out[0] = 2;
        out[1] = std::cos(t);
    };
    const auto one = [&](double t, std::size_t watch) {
        ++asked;
        return watch == 0 ? 2 : std::cos(t);
    };
    const auto found = firstViolation(2, all, 0, 2, Care::great, one);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->watches, std::vector<std::size_t>{1});
    EXPECT_LE(std::cos(found->time), 0);
    EXPECT_GT(std::cos(std::nextafter(found->time, 0)), 0);
    EXPECT_LE(asked, 14); // bisection: 31
}

// Each value of the watches may be a solution for the forces of many contacts.
TEST(FirstViolation, TakesNoMoreValuesThanASmoothWatchNeeds) {
    int asked = 0;
    const auto valuesFor = [&](const std::function<double(double)>& f) {
        asked = 0;
        EXPECT_FALSE(violationOf(
            [&](double t) {
                ++asked;
                return f(t);
            },
            0, 1));
        return asked;
    };
    EXPECT_EQ(valuesFor([](double t) { return 1 - t * t / 2; }), 5);
    EXPECT_EQ(valuesFor([](double t) { return 1 + std::sin(2 * t - 1); }), 9);
    // A watch that no polynomial of low degree follows is looked at closely.
    EXPECT_GE(valuesFor([](double t) { return 1.1 + std::sin(20 * t); }), 26);
}

TEST(FirstViolation, IsFoundAmongManyOscillations) {
    const auto found = violationOf([](double t) { return std::sin(1e5 * t) + 0.5; }, 0, 10);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->time, std::numbers::pi * 7 / 6 / 1e5, 1e-18);
}

TEST(FirstViolation, ShortDipsAreFoundAndNarrowMissesAreNot) {
    EXPECT_TRUE(violationOf([](double t) { return std::pow(t - 0.7123, 2) - 1e-10; }, 0, 1));
    EXPECT_FALSE(violationOf([](double t) { return std::pow(t - 0.7123, 2) + 1e-10; }, 0, 1));
}

// Wherever they lie, and between the points of whatever polynomials they are compared with.
TEST(FirstViolation, KinksAndTouchesAreFollowedToTheirGround) {
    for (double at = 0.003; at < 1; at += 0.0037) {
        EXPECT_TRUE(violationOf([at](double t) { return std::abs(t - at) - 1e-5; }, 0, 1)) << at;
        EXPECT_FALSE(violationOf([at](double t) { return std::abs(t - at) + 1e-5; }, 0, 1)) << at;
        EXPECT_TRUE(violationOf([at](double t) { return std::pow(t - at, 2) - 1e-22; }, 0, 1))
            << at;
    }
}

// As a normal force does where a slip passes by 0 and turns: there is no root near it.
TEST(FirstViolation, AJumpFarAboveZeroIsLeftAlone) {
    int asked = 0;
    const auto jumps = [&](double t) {
        ++asked;
        return t < 0.7123 ? 2.9 : 2.2;
    };
    EXPECT_FALSE(violationOf(jumps, 0, 1));
    EXPECT_LE(asked, 400); // to the ground: 860
    EXPECT_TRUE(violationOf([](double t) { return t < 0.7123 ? 2.9 : -0.1; }, 0, 1));
}

// More waves than one search has pieces for; the last one alone goes below 0.
TEST(FirstViolation, IsFoundBehindManyOscillations) {
    const auto found = violationOf(
        [](double t) { return 1.01 + std::sin(1000 * t) - (t > 19.999 ? 1 : 0); }, 0, 20);
    ASSERT_TRUE(found);
    EXPECT_GE(found->time, 19.999);
}

// A watch that starts at zero is followed once it has risen; one that only falls is wrong from the
// start.
TEST(FirstViolation, StartsArmedOnlyAboveZero) {
    const auto later = violationOf([](double t) { return t * (1 - t); }, 0, 2);
    ASSERT_TRUE(later);
    EXPECT_EQ(later->time, 1);
    const auto now = violationOf([](double t) { return -t; }, 0, 2);
    ASSERT_TRUE(now);
    EXPECT_EQ(now->time, 0);
    EXPECT_FALSE(violationOf([](double) { return 0.0; }, 0, 2));
}

// A contact that opens at once within a step as long as the one before.
TEST(FirstViolation, WhatIsBehindAFallIsNotFollowed) {
    int asked = 0;
    const auto opens = [&](double t) {
        ++asked;
        return 1e-6 - t - 0.5 * std::abs(std::sin(40 * t)) * t; // with kinks behind
    };
    const auto found = violationOf(opens, 0, 1);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->time, 1e-6, 1e-10);
    EXPECT_LE(asked, 40); // where the kinks are followed: 62
}

TEST(FirstViolation, OfManyWatchesTheFirstAloneIsAskedToTheLastBit) {
    constexpr std::size_t many = 50;
    std::vector<int> asked(many);
    const auto value = [](std::size_t k, double t) {
        return 0.5 + 0.01 * static_cast<double>(many - k) - t; // the last falls first
    };
    const auto all = [&](double t, std::span<double> out) {
        for (std::size_t k = 0; k < many; ++k)
            out[k] = value(k, t);
    };
    const auto one = [&](double t, std::size_t watch) {
        ++asked[watch];
        return value(watch, t);
    };
    const auto found = firstViolation(many, all, 0, 1, Care::great, one);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->watches, std::vector<std::size_t>{many - 1});
    EXPECT_EQ(std::accumulate(asked.begin(), asked.end() - 1, 0), 0);
}
