// Integrators alone, on systems written in C++.
#include "integrators/diagonally_implicit.h"
#include "integrators/explicit_runge_kutta.h"
#include "integrators/rosenbrock.h"
#include "integrators/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

using namespace solution;
using solution::testing::Exact;
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

// The order conditions of all trees with up to four nodes, for weights b of stages a with row sums
// c: what each sum is, less what it should be.
std::vector<double> orderDefects(const std::vector<std::vector<double>>& a,
                                 const std::vector<double>& b, const std::vector<double>& c,
                                 std::size_t order) {
    const std::size_t n = b.size();
    const auto apply = [&](const std::vector<double>& x) {
        std::vector<double> y(n, 0.0);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < std::min(n, a[i].size()); ++j)
                y[i] += a[i][j] * x[j];
        return y;
    };
    const auto times = [&](const std::vector<double>& x, const std::vector<double>& y) {
        std::vector<double> z(n);
        for (std::size_t i = 0; i < n; ++i)
            z[i] = x[i] * y[i];
        return z;
    };
    const auto defect = [&](const std::vector<double>& x, double wanted) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            sum += b[i] * x[i];
        return sum - wanted;
    };
    const std::vector<double> one(n, 1.0), ac = apply(c), c2 = times(c, c);
    std::vector<double> result = {defect(one, 1)};
    if (order >= 2)
        result.push_back(defect(c, 1.0 / 2));
    if (order >= 3) {
        result.push_back(defect(c2, 1.0 / 3));
        result.push_back(defect(ac, 1.0 / 6));
    }
    if (order >= 4) {
        result.push_back(defect(times(c, c2), 1.0 / 4));
        result.push_back(defect(times(c, ac), 1.0 / 8));
        result.push_back(defect(apply(c2), 1.0 / 12));
        result.push_back(defect(apply(ac), 1.0 / 24));
    }
    return result;
}

// A driven pendulum with cubic damping: nonlinear, and time appears.
FunctionSystem pendulum() {
    FunctionSystem system(2, [](double t, auto y, auto f) {
        f[0] = y[1];
        f[1] = -4 * std::sin(y[0]) - 0.2 * y[1] * y[1] * y[1] + 3 * std::cos(8 * t);
    });
    system.positions = {{0, 1}};
    return system;
}

// The largest error at three times; one time alone may lie where an error changes its sign.
double errorAtFixedStep(const std::string& method, double h) {
    static std::map<double, std::vector<double>> exact;
    double largest = 0;
    for (const double finish : {4.0, 5.0, 6.0}) {
        FunctionSystem system = pendulum();
        std::vector<double>& truth = exact[finish];
        if (truth.empty())
            truth = run("dop853", system, {1, 0}, finish, 1e-14, 1.0 / 128).end;
        const auto result = run(method, system, {1, 0}, finish, 1e-13, h);
        largest = std::max(largest, std::hypot(result.end[0] - truth[0], result.end[1] - truth[1]));
    }
    return largest;
}

} // namespace

// Sum of b = 1, sum of a row = c, sum b c^(q-1) = 1/q up to the order; the error estimate weighs
// a constant slope by nothing; dense output ends at the step's own end.
TEST(Tableaus, KeepTheQuadratureConditions) {
    for (const char* name : {"dop853", "dopri5", "tsit5", "gbs", "rk4", "forward-euler"}) {
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

TEST(Tableaus, KeepTheOrderConditionsUpToFour) {
    const auto check = [](const char* name, const auto& a, const auto& b, const auto& c,
                          std::size_t order, double within) {
        for (const double defect : orderDefects(a, b, c, order))
            EXPECT_NEAR(defect, 0, within) << name;
    };
    for (const char* name : {"dop853", "dopri5", "tsit5", "gbs", "rk4", "forward-euler"}) {
        const Tableau& t = *tableauNamed(name);
        std::vector<double> b = t.a[t.stages], c = t.c;
        b.resize(t.stages);
        c.resize(t.stages);
        check(name, t.a, b, c, std::min<std::size_t>(t.order, 4), 1e-13);
    }
    for (const char* name : {"backward-euler", "midpoint", "trapezoidal", "tr-bdf2", "sdirk4"}) {
        const DiagonalTableau& t = *diagonalTableauNamed(name);
        for (std::size_t i = 0; i < t.a.size(); ++i) {
            double sum = 0;
            for (const double x : t.a[i])
                sum += x;
            EXPECT_NEAR(sum, t.c[i], 1e-14) << name << " row " << i;
        }
        check(name, t.a, t.b, t.c, t.order, 1e-13);
        if (t.error.empty())
            continue;
        std::vector<double> embedded = t.b;
        for (std::size_t i = 0; i < embedded.size(); ++i)
            embedded[i] -= t.error[i];
        check(name, t.a, embedded, t.c, name == std::string("tr-bdf2") ? 3 : t.errorOrder, 1e-13);
    }
}

// RODAS in the variables of its derivation: with C = the c_ij over the diagonal 1/g, the sums of
// gamma_ij are G = C^-1, a_ij of the stages is A G, and b = m G; row sums are alpha and gamma.
TEST(Tableaus, RodasKeepsItsOwnRelations) {
    const RosenbrockTableau& t = *rosenbrockTableauNamed("rodas4");
    const std::size_t n = t.m.size();
    // G: C = diag(1/g) - c, so that G = C^-1 by forward substitution.
    std::vector<std::vector<double>> g(n, std::vector<double>(n, 0.0));
    for (std::size_t column = 0; column < n; ++column)
        for (std::size_t i = column; i < n; ++i) {
            double sum = i == column ? 1 : 0;
            for (std::size_t j = column; j < i; ++j)
                sum += t.c[i][j] * g[j][column];
            g[i][column] = t.diagonal * sum;
        }
    const auto timesG = [&](const std::vector<double>& row) {
        std::vector<double> result(n, 0.0);
        for (std::size_t j = 0; j < row.size(); ++j)
            for (std::size_t k = 0; k < n; ++k)
                result[k] += row[j] * g[j][k];
        return result;
    };
    const auto sum = [](const std::vector<double>& row) {
        double total = 0;
        for (const double x : row)
            total += x;
        return total;
    };
    // Orders 1 to 3 and the bushy condition of 4 (Hairer and Wanner II, IV.7, table 7.1): with
    // beta = alpha + gamma, stage by stage.
    std::vector<std::vector<double>> alpha, beta(n);
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(sum(g[i]), t.gamma[i], 1e-12) << i;
        alpha.push_back(timesG(t.a[i]));
        EXPECT_NEAR(sum(alpha[i]), t.alpha[i], 1e-12) << i;
        for (std::size_t k = 0; k < n; ++k)
            beta[i].push_back(alpha[i][k] + g[i][k]);
    }
    std::vector<double> embedded = t.m;
    embedded.back() = 0;
    for (const bool main : {true, false}) {
        const std::vector<double> b = timesG(main ? t.m : embedded);
        double one = 0, two = 0, square = 0, chain = 0, cube = 0;
        for (std::size_t i = 0; i < n; ++i) {
            one += b[i];
            two += b[i] * sum(beta[i]);
            square += b[i] * t.alpha[i] * t.alpha[i];
            cube += b[i] * std::pow(t.alpha[i], 3);
            for (std::size_t j = 0; j < n; ++j)
                chain += b[i] * beta[i][j] * sum(beta[j]);
        }
        EXPECT_NEAR(one, 1, 1e-11);
        EXPECT_NEAR(two, 1.0 / 2, 1e-11);
        EXPECT_NEAR(square, 1.0 / 3, 1e-11);
        EXPECT_NEAR(chain, 1.0 / 6, 1e-11);
        if (main) {
            EXPECT_NEAR(cube, 1.0 / 4, 1e-11);
        }
    }
}

// Slope of log error against log step, over a halving; the last is the dissertation's rule.
TEST(Methods, ConvergeWithTheirOrder) {
    const struct {
        const char* name;
        double order, h;
    } methods[] = {{"forward-euler", 1, 0.005}, {"symplectic-euler", 1, 0.005},
                   {"midpoint", 2, 0.02},       {"rk4", 4, 0.05},
                   {"trapezoidal", 2, 0.02},    {"backward-euler", 1, 0.005},
                   {"tsit5", 5, 0.01},          {"dopri5", 5, 0.01},
                   {"dop853", 8, 0.15},         {"gbs", 8, 0.1},
                   {"tr-bdf2", 2, 0.02},        {"radau5", 5, 0.125},
                   {"sdirk4", 4, 0.05},         {"rodas4", 4, 0.05},
                   {"original", 2, 0.02}};
    ASSERT_EQ(std::size(methods), methodNames().size());
    for (const auto& [name, order, h] : methods) {
        const double measured =
            std::log2(errorAtFixedStep(name, h) / errorAtFixedStep(name, h / 2));
        // dopri5's terms of its own order are so small that the next ones show.
        EXPECT_NEAR(measured, order, name == std::string("dopri5") ? 0.4 : 0.3) << name;
        FunctionSystem system = pendulum();
        ErrorControl control({{}, {}}, 1e-6);
        EXPECT_EQ(makeMethod(name, system, control, true)->order(), order) << name;
    }
}

// x = sin t solves x'' = -x^3 + (sin^3 t - sin t). Between the steps, too, the error falls with the
// method's order.
TEST(Methods, HaveDenseOutputOfTheirOrder) {
    const auto errorBetween = [](const std::string& name, double h) {
        FunctionSystem system(2, [](double t, auto y, auto f) {
            f[0] = y[1];
            f[1] = -std::pow(y[0], 3) + std::pow(std::sin(t), 3) - std::sin(t);
        });
        system.positions = {{0, 1}};
        const Exact exact = [](double t) { return std::vector{std::sin(t), std::cos(t)}; };
        return run(name, system, {0, 1}, 3, 1e-13, h, exact).worstDense;
    };
    for (const std::string& name : methodNames()) {
        FunctionSystem system = pendulum();
        ErrorControl control({{}, {}}, 1e-6);
        const auto order = static_cast<double>(makeMethod(name, system, control, true)->order());
        const double h = order >= 8 ? 0.75 : order >= 5 ? 0.3 : 0.05;
        const double measured = std::log2(errorBetween(name, h) / errorBetween(name, h / 4)) / 2;
        EXPECT_GT(measured, order - 0.4) << name;
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
    for (const char* name :
         {"dop853", "dopri5", "radau5", "rk4", "tsit5", "gbs", "sdirk4", "rodas4"})
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
            FunctionSystem system = drivenDecay();
            const auto result = run(name, system, {1}, 10, tolerance);
            const double exact = 1.5 * std::exp(-10.0) + (std::sin(10) - std::cos(10)) / 2;
            EXPECT_NEAR(result.end[0], exact, 30 * tolerance) << name << " " << tolerance;
        }
}

// Van der Pol with mu = 1000: an explicit method would need over a million evaluations.
// y' = -K(y - cos t): stiffness holds the ends of steps in place, whatever lies between them.
TEST(Radau, FollowsAStiffRelaxationBetweenItsStepsToo) {
    for (const double stiffness : {1e6, 1e9, 1e12})
        for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
            FunctionSystem system(1, [stiffness](double t, auto y, auto f) {
                f[0] = -stiffness * (y[0] - std::cos(t));
            });
            const Exact exact = [stiffness](double t) {
                return std::vector{std::cos(t) + std::sin(t) / stiffness};
            };
            const auto result = run("radau5", system, {1}, 10, tolerance, 0, exact);
            EXPECT_LT(result.worstDense, 20 * tolerance) << stiffness << " " << tolerance;
        }
}

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
