// Integrators alone, on systems written in C++.
#include "solution/explicit_runge_kutta.h"
#include "solution/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace solution;
using solution::testing::FunctionSystem;
using solution::testing::run;

namespace {

// y' = -y + sin t has the solution 1.5 e^-t + (sin t - cos t)/2 from 1.
FunctionSystem drivenDecay() {
    return {1, [](double t, auto y, auto f) { f[0] = -y[0] + std::sin(t); }};
}

FunctionSystem oscillator(double w = 1) {
    FunctionSystem system(2, [w](double, auto y, auto f) {
        f[0] = y[1];
        f[1] = -w * w * y[0];
    });
    system.positions = {{0, 1}};
    return system;
}

std::vector<double> oscillation(double t) { return {std::cos(t), -std::sin(t)}; }

double errorAtFixedStep(const std::string& method, double h) {
    FunctionSystem system = oscillator();
    const auto result = run(method, system, {1, 0}, 2, 1e-14, h);
    return std::hypot(result.end[0] - std::cos(2), result.end[1] + std::sin(2));
}

} // namespace

// Sum of b = 1, sum of a row = c, sum b c^(q-1) = 1/q up to the order; the error estimate weighs
// a constant slope by nothing; dense output ends at the step's own end.
TEST(Tableaus, KeepTheQuadratureConditions) {
    for (const char* name : {"dop853", "dopri5", "rk4", "forward-euler"}) {
        const Tableau& t = *tableauNamed(name);
        const std::vector<double>& b = t.a[t.stages];
        for (std::size_t q = 1; q <= t.order; ++q) {
            double sum = 0;
            for (std::size_t i = 0; i < b.size(); ++i)
                sum += b[i] * std::pow(t.c[i], static_cast<double>(q - 1));
            EXPECT_NEAR(sum, 1.0 / static_cast<double>(q), 1e-14) << name << " " << q;
        }
        for (std::size_t i = 0; i < t.a.size(); ++i) {
            double sum = 0;
            for (const double x : t.a[i])
                sum += x;
            EXPECT_NEAR(sum, t.c[i], 2e-14) << name << " row " << i;
        }
        double error = 0, second = 0;
        for (const double e : t.error)
            error += e;
        for (const double e : t.secondError)
            second += e;
        EXPECT_NEAR(error, 0, 1e-14) << name;
        EXPECT_NEAR(second, 0, 1e-14) << name;
        for (std::size_t i = 0; i < t.dense.size(); ++i) {
            double sum = 0;
            for (const double x : t.dense[i])
                sum += x;
            EXPECT_NEAR(sum, i < b.size() ? b[i] : 0, 1e-11) << name << " dense " << i;
        }
    }
}

TEST(Methods, ConvergeWithTheirOrder) {
    const struct {
        const char* name;
        double order, h;
    } methods[] = {{"forward-euler", 1, 0.01},
                   {"rk4", 4, 0.1},
                   {"dopri5", 5, 0.2},
                   {"dop853", 8, 0.5},
                   {"radau5", 5, 0.25}};
    for (const auto& [name, order, h] : methods) {
        const double measured =
            std::log2(errorAtFixedStep(name, h) / errorAtFixedStep(name, h / 2));
        EXPECT_NEAR(measured, order, 0.35) << name;
    }
}

// Between the steps a solution is as good as at their ends, positions in particular.
TEST(Methods, AreAsAccurateBetweenStepsAsAtTheirEnds) {
    for (const char* name : {"dop853", "dopri5", "radau5"})
        for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
            FunctionSystem system = oscillator();
            const auto result =
                run(name, system, {1, 0}, 10, tolerance, 0, oscillation,
                    {{UnknownScale::Kind::position, 1, 1}, {UnknownScale::Kind::velocity, 1, 0}});
            const double atEnd =
                std::hypot(result.end[0] - std::cos(10), result.end[1] + std::sin(10));
            EXPECT_LT(result.worstDense, 4 * atEnd + 2 * tolerance) << name << " " << tolerance;
            EXPECT_LT(result.worstDense, 200 * tolerance) << name << " " << tolerance;
        }
}

TEST(Methods, FollowADrivenDecayToTheToleranceAsked) {
    for (const char* name : {"dop853", "dopri5", "radau5", "rk4"})
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
            FunctionSystem system = drivenDecay();
            const auto result = run(name, system, {1}, 10, tolerance);
            const double exact = 1.5 * std::exp(-10.0) + (std::sin(10) - std::cos(10)) / 2;
            EXPECT_NEAR(result.end[0], exact, 10 * tolerance) << name << " " << tolerance;
        }
}

// Van der Pol with mu = 1000: an explicit method would need over a million evaluations.
TEST(Radau, SolvesVanDerPolInFewSteps) {
    FunctionSystem system(2, [](double, auto y, auto f) {
        f[0] = y[1];
        f[1] = 1000 * (1 - y[0] * y[0]) * y[1] - y[0];
    });
    // Against the same at a hundredth of the tolerance.
    const auto rough = run("radau5", system, {2, 0}, 2000, 1e-6);
    const auto fine = run("radau5", system, {2, 0}, 2000, 1e-8);
    EXPECT_NEAR(rough.end[0], fine.end[0], 1e-4);
    EXPECT_LT(rough.steps, 700u);
    EXPECT_LT(rough.counts.evaluations, 12000u);
}

// A spring of k = 1e12 released from a micron: it comes to rest at once and stays quiet.
TEST(Radau, IsQuietOnAStiffSpring) {
    FunctionSystem system(2, [](double, auto y, auto f) {
        const double k = 1e12;
        f[0] = y[1];
        f[1] = -k * y[0] - 2 * std::sqrt(k) * y[1] - 10;
    });
    system.positions = {{0, 1}};
    const auto result =
        run("radau5", system, {1e-6, 0}, 10, 1e-8, 0, {},
            {{UnknownScale::Kind::position, 1, 1}, {UnknownScale::Kind::velocity, 1, 0}});
    EXPECT_NEAR(result.end[0], -1e-11, 1e-13);
    EXPECT_NEAR(result.end[1], 0, 1e-9);
    EXPECT_LT(result.steps, 200u);
}

TEST(Dop853, SeesThatAStepIsBoundByStability) {
    FunctionSystem system(1, [](double t, auto y, auto f) { f[0] = -1e4 * (y[0] - std::cos(t)); });
    ErrorControl control({UnknownScale{}}, 1e-5);
    const auto method = makeMethod("dop853", system, control, false);
    const std::vector<double> start = {1};
    control.observe(start);
    ASSERT_TRUE(method->begin(0, start));
    double h = method->firstStep(1), sum = 0;
    std::vector<double> y;
    for (int accepted = 0; accepted < 200;) {
        const Attempt attempt = method->attempt(h);
        h = attempt.next;
        if (attempt.outcome != Attempt::Outcome::accepted)
            continue;
        ++accepted;
        y.assign(method->state().begin(), method->state().end());
        control.observe(y);
        ASSERT_TRUE(method->proceed(y));
        if (accepted > 100)
            sum += method->stabilityUsed() / 100;
    }
    EXPECT_NEAR(sum, 1, 0.15);
}
