// Limits of methods that a scene has no switch for: quaternions that nobody renormalises, Newton
// with a Jacobian that is never renewed, orders of fixed steps (docs/numerics/measurements.md,
// Stability, 12 to 17 and 20 to 24). What theory says is computed here, what happens is measured on
// the engine's methods.
#include "marks.h"

#include "integrators/testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using solution::testing::FunctionSystem;
using Values = std::vector<double>;

namespace {

// Fixed steps; visit(y) before the first and after each. False: a step was refused.
template <typename Visit>
bool walk(const std::string& name, solution::System& system, Values y, double h, int steps,
          const Visit& visit, double tolerance = 1e-9,
          std::vector<solution::UnknownScale> scales = {}) {
    scales.resize(y.size());
    solution::ErrorControl control(std::move(scales), tolerance);
    const auto method = solution::makeMethod(name, system, control, true);
    control.observe(y);
    visit(y);
    if (!method->begin(0, y))
        return false;
    for (int n = 0; n < steps; ++n) {
        if (method->attempt(h).outcome != solution::Attempt::Outcome::accepted)
            return false;
        y.assign(method->state().begin(), method->state().end());
        visit(y);
        if (!method->proceed(y))
            return false;
    }
    return true;
}

// --- a free top with the inertias 1, 2, 3: quaternion, then spin in its own axes ---------------

constexpr std::array<double, 3> inertia = {1, 2, 3};
const Values spinning = {1, 0, 0, 0, std::sqrt(3.0), std::sqrt(3.0), std::sqrt(3.0)};

std::array<double, 3> spinRate(std::span<const double> w) {
    return {(inertia[1] - inertia[2]) / inertia[0] * w[1] * w[2],
            (inertia[2] - inertia[0]) / inertia[1] * w[2] * w[0],
            (inertia[0] - inertia[1]) / inertia[2] * w[0] * w[1]};
}

FunctionSystem top() {
    return {7, [](double, auto y, auto f) {
                const auto w = y.subspan(4);
                f[0] = (-y[1] * w[0] - y[2] * w[1] - y[3] * w[2]) / 2;
                f[1] = (y[0] * w[0] + y[2] * w[2] - y[3] * w[1]) / 2;
                f[2] = (y[0] * w[1] + y[3] * w[0] - y[1] * w[2]) / 2;
                f[3] = (y[0] * w[2] + y[1] * w[1] - y[2] * w[0]) / 2;
                const auto rate = spinRate(w);
                std::ranges::copy(rate, f.begin() + 4);
            }};
}

// Attitudes follow velocities in symplectic Euler.
class TopOfPlaces final : public solution::System {
public:
    [[nodiscard]] std::size_t size() const override { return 7; }
    bool rates(double t, std::span<const double> y, std::span<double> f) override {
        return top_.rates(t, y, f);
    }
    const solution::Pattern& jacobianPattern() override { return top_.jacobianPattern(); }
    bool jacobian(double t, std::span<const double> y, std::span<double> entries) override {
        return top_.jacobian(t, y, entries);
    }
    [[nodiscard]] std::span<const std::size_t> configuration() const override { return attitude_; }

private:
    FunctionSystem top_ = top();
    std::array<std::size_t, 4> attitude_ = {0, 1, 2, 3};
};

double square(std::span<const double> v) {
    double sum = 0;
    for (const double x : v)
        sum += x * x;
    return sum;
}
double length(const Values& y) { return std::sqrt(square(std::span(y).first(4))); }
double speed(const Values& y) { return std::sqrt(square(std::span(y).subspan(4))); }
double energy(const Values& y) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += inertia[i] * y[4 + i] * y[4 + i] / 2;
    return sum;
}
double momentum(const Values& y) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += inertia[i] * inertia[i] * y[4 + i] * y[4 + i];
    return std::sqrt(sum);
}

std::vector<Values> spun(const std::string& method, double h, double finish) {
    TopOfPlaces system;
    std::vector<Values> states;
    EXPECT_TRUE(walk(method, system, spinning, h, static_cast<int>(std::lround(finish / h)),
                     [&](const Values& y) { states.push_back(y); }));
    return states;
}

// --- planar rods on critical links: x y angle, then their rates, of each ------------------------

struct Rods {
    int count;
    double stiffness;

    // Of the end that a rod hangs by, and of the other.
    struct End {
        double x, y, dx, dy, armX, armY;
    };
    [[nodiscard]] End end(std::span<const double> s, int rod, double side) const {
        const auto at = static_cast<std::size_t>(6 * rod);
        const double armX = -side * 0.5 * std::sin(s[at + 2]),
                     armY = side * 0.5 * std::cos(s[at + 2]);
        return {s[at] + armX,
                s[at + 1] + armY,
                s[at + 3] - s[at + 5] * armY,
                s[at + 4] + s[at + 5] * armX,
                armX,
                armY};
    }
    [[nodiscard]] static double rodInertia() { return (1 + 0.01) / 12; }

    void rates(std::span<const double> s, std::span<double> f) const {
        for (std::size_t b = 0; b < s.size(); b += 6) {
            for (std::size_t i = 0; i < 3; ++i) {
                f[b + i] = s[b + 3 + i];
                f[b + 3 + i] = 0;
            }
            f[b + 4] = -10;
        }
        for (int rod = 0; rod < count; ++rod) {
            const End a = end(s, rod, 1);
            const End b = rod == 0 ? End{} : end(s, rod - 1, -1);
            const double damping = 2 * std::sqrt(stiffness * (rod == 0 ? 1 : 0.5));
            const double fx = -stiffness * (a.x - b.x) - damping * (a.dx - b.dx);
            const double fy = -stiffness * (a.y - b.y) - damping * (a.dy - b.dy);
            push(f, rod, a, fx, fy);
            if (rod > 0)
                push(f, rod - 1, b, -fx, -fy);
        }
    }
    static void push(std::span<double> f, int rod, const End& at, double fx, double fy) {
        const auto b = static_cast<std::size_t>(6 * rod);
        f[b + 3] += fx;
        f[b + 4] += fy;
        f[b + 5] += (at.armX * fy - at.armY * fx) / rodInertia();
    }
    [[nodiscard]] FunctionSystem system() const {
        FunctionSystem made(static_cast<std::size_t>(6 * count),
                            [*this](double, auto y, auto f) { rates(y, f); });
        for (std::size_t b = 0; b < made.size(); b += 6)
            for (std::size_t i = 0; i < 3; ++i)
                made.positions.emplace_back(b + i, b + 3 + i);
        return made;
    }
};

constexpr double swing = 5.7; // radians a second

std::vector<solution::UnknownScale> scalesOf(std::size_t size) {
    using Kind = solution::UnknownScale::Kind;
    std::vector<solution::UnknownScale> scales(size);
    for (std::size_t i = 0; i < size; ++i)
        scales[i] = {i % 6 < 3 ? Kind::position : Kind::velocity, 1, 1};
    return scales;
}

Values movedBy(const Rods& rods, const Values& from, double finish, double tolerance) {
    FunctionSystem system = rods.system();
    return solution::testing::run("radau5", system, from, finish, tolerance, 0, {},
                                  scalesOf(from.size()))
        .end;
}

// The double pendulum at its lowest, turning as one, once the links have taken the load.
Values inSwing(const Rods& rods) {
    Values y;
    for (int rod = 0; rod < rods.count; ++rod) {
        const double below = 0.5 + rod;
        y.insert(y.end(), {0, -below, 0, swing * below, 0, swing});
    }
    return movedBy(rods, y, 0.1, 1e-8);
}

double placeError(const Values& a, const Values& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (i % 6 < 3)
            largest = std::isfinite(a[i]) ? std::max(largest, std::abs(a[i] - b[i])) : HUGE_VAL;
    return largest;
}

// After `finish` with fixed steps; infinity when a step was refused.
double errorAfter(const std::string& method, const Rods& rods, const Values& from, double finish,
                  double h, const Values& truth) {
    FunctionSystem system = rods.system();
    Values last;
    const bool arrived = walk(method, system, from, h, static_cast<int>(std::lround(finish / h)),
                              [&](const Values& y) { last = y; });
    return arrived ? placeError(last, truth) : HUGE_VAL;
}

// Answers with the Jacobian of the step's start wherever it is asked.
class FrozenJacobian final : public solution::System {
public:
    FrozenJacobian(FunctionSystem& system, const Values& start) : system_(system), start_(start) {}
    [[nodiscard]] std::size_t size() const override { return system_.size(); }
    bool rates(double t, std::span<const double> y, std::span<double> f) override {
        return system_.rates(t, y, f);
    }
    const solution::Pattern& jacobianPattern() override { return system_.jacobianPattern(); }
    bool jacobian(double t, std::span<const double>, std::span<double> entries) override {
        return system_.jacobian(t, start_, entries);
    }

private:
    FunctionSystem& system_;
    Values start_;
};

// The longest single step that Newton solves.
double longestStep(const std::string& method, const Rods& rods, const Values& from, bool frozen) {
    FunctionSystem system = rods.system();
    FrozenJacobian frozenSystem(system, from);
    const auto solves = [&](double h) {
        return walk(method, frozen ? static_cast<solution::System&>(frozenSystem) : system, from, h,
                    1, [](const Values&) {});
    };
    double low = 1e-6, high = 1;
    while (high / low > 1.02) {
        const double middle = std::sqrt(low * high);
        (solves(middle) ? low : high) = middle;
    }
    return low;
}

// --- Kepler: eccentricity 0.9, one turn takes 2 pi ----------------------------------------------

FunctionSystem kepler() {
    FunctionSystem system(4, [](double, auto y, auto f) {
        const double r = std::hypot(y[0], y[1]), cube = r * r * r;
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[0] / cube;
        f[3] = -y[1] / cube;
    });
    system.positions = {{0, 2}, {1, 3}};
    return system;
}
const Values apocentre = {-1.9, 0, 0, -std::sqrt(0.1 / 1.9)};
double orbitEnergy(const Values& y) {
    return (y[2] * y[2] + y[3] * y[3]) / 2 - 1 / std::hypot(y[0], y[1]);
}
double energyChange(const Values& y) { return orbitEnergy(y) / orbitEnergy(apocentre) - 1; }

// At the apocentre after 10 and after 100 turns of 1000 steps each.
std::pair<double, double> driftOf(const std::string& method) {
    FunctionSystem system = kepler();
    int n = 0;
    std::pair<double, double> drift = {NAN, NAN};
    EXPECT_TRUE(
        walk(method, system, apocentre, 2 * std::numbers::pi / 1000, 100'000, [&](const Values& y) {
            if (n == 10'000)
                drift.first = energyChange(y);
            if (n++ == 100'000)
                drift.second = energyChange(y);
        }));
    return drift;
}

} // namespace

// 12. |R(iy)| = 1 - y^6/144 with y = h w/2; that the axis turns too costs as much again.
TEST(Limits, ARungeKuttaQuaternionShrinksByTheSixthPower) {
    const auto change = [](double h) {
        const auto states = spun("rk4", h, 60);
        double predicted = 0;
        for (const Values& y : states)
            predicted -= std::pow(h * speed(y) / 2, 6) / 144;
        return std::pair(length(states.back()) - 1, predicted);
    };
    const auto [measured, predicted] = change(0.05);
    mark("length", "rk4: predicted", 0.05, predicted);
    mark("length", "rk4", 0.05, measured);
    EXPECT_NEAR(predicted, -1.5e-6, 0.3e-6);
    EXPECT_GT(measured / predicted, 0.8);
    EXPECT_LT(measured / predicted, 2.5);
    EXPECT_NEAR(measured / change(0.025).first, 32, 4); // steps times the sixth power
}

// 13. Exactly sqrt(1 + (h w/2)^2) a step, or its inverse.
TEST(Limits, AnEulerQuaternionGrowsOrShrinksByEachStepsSpeed) {
    const double h = 0.01;
    const auto check = [h](const std::string& method, int offset, double sign) {
        const auto states = spun(method, h, 60);
        double logarithm = 0;
        for (std::size_t n = 0; n + 1 < states.size(); ++n)
            logarithm += sign * std::log1p(std::pow(h * speed(states[n + offset]) / 2, 2)) / 2;
        EXPECT_NEAR(length(states.back()) / std::exp(logarithm), 1, 1e-10) << method;
        mark("length", method, h, length(states.back()) - 1);
        return length(states.back());
    };
    EXPECT_GT(check("forward-euler", 0, 1), 1.9);
    EXPECT_GT(check("symplectic-euler", 1, 1), 1.9);
    EXPECT_LT(check("backward-euler", 1, -1), 0.7);
}

// 14. |q|^2 (1 + h^2 w^2/16) stays, so that |q| goes to and fro with w and no further.
TEST(Limits, ATrapezoidalQuaternionKeepsASquare) {
    const double h = 0.05;
    const auto states = spun("trapezoidal", h, 60);
    const auto kept = [h](const Values& y) {
        return length(y) * length(y) * (1 + h * h * speed(y) * speed(y) / 16);
    };
    double wandered = 0;
    for (const Values& y : states) {
        ASSERT_NEAR(kept(y) / kept(states[0]), 1, 5e-12);
        wandered = std::max(wandered, std::abs(length(y) - 1));
    }
    mark("length", "trapezoidal", h, wandered);
    EXPECT_GT(wandered, 1e-5);
    EXPECT_LT(wandered, 2e-3);
}

// 15. Every quadratic invariant stays.
TEST(Limits, TheMidpointRuleKeepsLengthEnergyAndMomentum) {
    for (const Values& y : spun("midpoint", 0.05, 60)) {
        ASSERT_NEAR(length(y), 1, 1e-11);
        ASSERT_NEAR(energy(y) / energy(spinning), 1, 1e-11);
        ASSERT_NEAR(momentum(y) / momentum(spinning), 1, 1e-11);
    }
}

// 16. Adaptive: about the tolerance for each step.
TEST(Limits, AnAdaptiveQuaternionDriftsByItsTolerance) {
    for (const char* method : {"tsit5", "dop853", "radau5", "rodas4", "sdirk4"})
        for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
            FunctionSystem system = top();
            const auto ran = solution::testing::run(method, system, spinning, 60, tolerance);
            const double drift = std::abs(length(ran.end) - 1);
            mark("quaternion", method, tolerance, drift);
            EXPECT_LT(drift, tolerance * static_cast<double>(ran.steps)) << method << tolerance;
            EXPECT_GT(drift, 1e-5 * tolerance) << method << tolerance;
        }
}

// 17. f is across the energy's gradient: each explicit step adds h^2/2 f.If, and a top at h = 0.05
// is torn apart.
TEST(Limits, EulersMethodFeedsATop) {
    const double h = 0.05;
    for (const char* method : {"forward-euler", "symplectic-euler"}) {
        const auto states = spun(method, h, 15);
        for (std::size_t n = 0; n + 1 < states.size(); ++n) {
            const auto rate = spinRate(std::span(states[n]).subspan(4));
            double added = 0;
            for (std::size_t i = 0; i < 3; ++i)
                added += h * h / 2 * inertia[i] * rate[i] * rate[i];
            ASSERT_NEAR(energy(states[n + 1]), energy(states[n]) + added,
                        1e-12 * energy(states[n + 1]))
                << method;
        }
        mark("energy", method, h, energy(states.back()) / energy(spinning));
        EXPECT_GT(energy(states.back()), 2 * energy(spinning)) << method;
    }
}

// 20. The stiff direction turns by w h within a step; a Jacobian that does not turn with it
// contracts by g^2 h^4 k W w^2/m in two iterations. The prediction's constant is of a Newton that
// gives up when corrections grow; ours does not, and solves twice that. With its Jacobian renewed
// it solves much longer steps.
TEST(Limits, NewtonWithAFrozenJacobianNeedsShortSteps) {
    const double w = 8.75; // twice the inverse effective mass of the middle link, measured
    for (const double k : {5e3, 1e5, 1e6, 1e7, 1e8, 1e9}) {
        const Rods rods{2, k};
        const Values from = inSwing(rods);
        const double predicted = 0.27 * std::pow(1 / (k * w * swing * swing), 0.25);
        const double frozen = longestStep("backward-euler", rods, from, true);
        const double renewed = longestStep("backward-euler", rods, from, false);
        mark("newton", "frozen: predicted*", k, predicted);
        mark("newton", "frozen: measured", k, frozen);
        mark("newton", "renewed (ours)", k, renewed);
        EXPECT_GT(frozen / predicted, 1) << k << ": " << frozen;
        EXPECT_LT(frozen / predicted, 2.5) << k << ": " << frozen;
        EXPECT_GT(renewed / frozen, 20) << k << ": " << renewed;
        if (k > 5e3) { // one constant for all, so that the power is right
            EXPECT_NEAR(frozen / predicted, 1.88, 0.15) << k;
        }
    }
}

// Not in the table: rounding in the velocities of stiff links is larger than in their places, and
// Newton, asked for all digits, ends there instead of failing.
TEST(Limits, FixedStepsOfImplicitMethodsArriveOnStiffLinks) {
    for (const double k : {1e6, 1e8, 1e10, 1e12}) {
        const Rods rods{2, k};
        FunctionSystem system = rods.system();
        const Values from = inSwing(rods);
        for (const char* method : {"radau5", "sdirk4", "tr-bdf2", "trapezoidal", "backward-euler"})
            EXPECT_TRUE(walk(
                method, system, from, 2e-4, 2000, [](const Values&) {}, 1e-14,
                scalesOf(from.size())))
                << method << " " << k;
    }
}

// Not in the table: with a Jacobian for each stage stiffness does not shorten Radau's steps,
// however far stiff directions turn in one; and rounding, as it is seen through such a link, is no
// error.
TEST(Limits, StiffnessDoesNotShortenTheStepsOfRadau) {
    constexpr double finish = 0.5, tolerance = 1e-6;
    for (const double k : {1e6, 1e8, 1e10, 1e12}) {
        const Rods rods{2, k};
        const Values from = inSwing(rods), truth = movedBy(rods, from, finish, 1e-9);
        FunctionSystem system = rods.system();
        const auto moved = solution::testing::run("radau5", system, from, finish, tolerance, 0, {},
                                                  scalesOf(from.size()));
        EXPECT_LT(moved.steps + moved.rejected, 150U) << k;
        EXPECT_LT(placeError(moved.end, truth), 20 * tolerance) << k;
    }
}

// 21. On a stiff link the order falls to the stages' own.
TEST(Limits, StiffLinksReduceTheOrder) {
    const auto orderOf = [](const std::string& method, double k, double h) {
        const Rods rods{2, k};
        const Values from = inSwing(rods), truth = movedBy(rods, from, 0.2, 1e-11);
        const double coarse = errorAfter(method, rods, from, 0.2, h, truth);
        const double fine = errorAfter(method, rods, from, 0.2, h / 4, truth);
        return std::log2(coarse / fine) / 2;
    };
    EXPECT_NEAR(orderOf("sdirk4", 1e8, 0.0125), 1, 0.5); // stage order 1
    EXPECT_GT(orderOf("sdirk4", 5e3, 0.0125), 3);        // and 4 where nothing is stiff
    EXPECT_NEAR(orderOf("trapezoidal", 1e8, 0.0125), 2, 0.3);
    EXPECT_NEAR(orderOf("tr-bdf2", 1e8, 0.0125), 2, 0.3);
}

// 22. Rosenbrock methods linearise at the start of a step: no use where stiff directions turn by
// more than about 0.05 in one.
TEST(Limits, RosenbrockMethodsFailWhereStiffDirectionsTurn) {
    for (const double k : {1e6, 1e8}) {
        const Rods rods{2, k};
        const Values from = inSwing(rods), truth = movedBy(rods, from, 0.2, 1e-11);
        const auto error = [&](const char* method, double h) {
            return errorAfter(method, rods, from, 0.2, h, truth);
        };
        for (const char* method : {"rodas4", "tr-bdf2", "sdirk4", "trapezoidal", "radau5"})
            for (const int steps : {8, 16, 32, 64, 128, 256})
                if (const double e = error(method, 0.2 / steps); k == 1e8 && e < 1)
                    mark("order", method, 0.2 / steps, e);
        EXPECT_GT(error("rodas4", 0.025), 0.05) << k;     // 0.14 rad
        EXPECT_LT(error("rodas4", 0.2 / 256), 1e-3) << k; // 0.004 rad
        EXPECT_LT(error("tr-bdf2", 0.025), 0.05) << k;
        EXPECT_LT(error("radau5", 0.2 / 256), 1e-7) << k;
    }
}

// 23. Symmetric methods come back to their energy turn by turn; others leave it steadily.
TEST(Limits, SymmetricMethodsKeepTheEnergyOfAnOrbit) {
    const auto [rk4Soon, rk4Late] = driftOf("rk4");
    mark("drift", "rk4", 10, rk4Soon);
    mark("drift", "rk4", 100, rk4Late);
    EXPECT_NEAR(std::abs(rk4Soon), 3.9e-3, 1e-3);
    EXPECT_NEAR(rk4Late / rk4Soon, 10, 1.5);
    for (const char* method : {"midpoint", "trapezoidal"}) {
        const auto [soon, late] = driftOf(method);
        mark("drift", method, 10, soon);
        mark("drift", method, 100, late);
        EXPECT_LT(std::abs(soon), 0.5) << method;
        EXPECT_LT(std::abs(late), 1.3 * std::abs(soon) + 0.02) << method;
    }
}

// 24. Adaptive orbits drift by their tolerance, times what a hundred pericentres make of it.
TEST(Limits, AdaptiveOrbitsDriftByTheirTolerance) {
    constexpr double amplified = 1e4;
    for (const char* method : {"tsit5", "dop853", "radau5"}) {
        double before = HUGE_VAL;
        for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
            FunctionSystem system = kepler();
            const double drift = std::abs(energyChange(
                solution::testing::run(method, system, apocentre, 200 * std::numbers::pi, tolerance)
                    .end));
            mark("orbit", method, tolerance, drift);
            EXPECT_LT(drift, amplified * tolerance) << method << tolerance;
            EXPECT_LT(drift, before / 10) << method << tolerance;
            before = drift;
        }
    }
}
