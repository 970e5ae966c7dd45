// Steps whose rates are machine code have the bits and the counts of steps stage by stage.
#include "integrators/direct_step.h"

#include "integrators/explicit_runge_kutta.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace solution;

namespace {

// Each unknown is pulled by those after it; without finite rates where one falls below the limit.
class Chain final : public System {
public:
    Chain(std::size_t size, bool isDirect, double limit)
        : isDirect_(isDirect), constants_{static_cast<double>(size), limit}, arguments_(1 + size) {}
    std::size_t size() const override { return arguments_.size() - 1; }
    bool rates(double t, std::span<const double> y, std::span<double> out) override {
        ++calls_;
        std::vector<double> in = {t};
        in.insert(in.end(), y.begin(), y.end());
        evaluate(in.data(), out.data(), constants_.data(), nullptr, nullptr);
        return std::ranges::all_of(out, [](double x) { return std::isfinite(x); });
    }
    Direct direct() override {
        if (!isDirect_)
            return {};
        return {{&evaluate, constants_.data()}, arguments_.data(), nullptr};
    }
    const Pattern& jacobianPattern() override { return none_; }
    bool jacobian(double, std::span<const double>, std::span<double>) override { return false; }
    std::size_t calls() const { return calls_; }

private:
    static void evaluate(const double* in, double* out, const double* constants,
                         const expression::Decision*, double*) {
        const auto size = static_cast<std::size_t>(constants[0]);
        for (std::size_t n = 0; n < size; ++n)
            out[n] =
                std::sin(3 * in[0] + in[1 + (n + 1) % size]) - std::sqrt(in[1 + n] - constants[1]);
    }

    bool isDirect_;
    std::vector<double> constants_, arguments_;
    std::size_t calls_ = 0;
    Pattern none_;
};

struct Trail {
    std::vector<double> numbers; // of all steps
    std::size_t evaluations = 0, calls = 0, failures = 0;
};

Trail trailOf(std::size_t size, bool isDirect, double limit) {
    Chain system(size, isDirect, limit);
    ErrorControl control(std::vector<UnknownScale>(size), 1e-7);
    ExplicitRungeKutta method(*tableauNamed("dop853"), system, control, false);
    std::vector<double> y(size);
    std::mt19937 random(3);
    for (double& x : y)
        x = std::uniform_real_distribution<double>(0.1, 1)(random);
    control.observe(y);
    EXPECT_TRUE(method.begin(0, y));
    Trail run;
    double h = 0.3;
    for (int tries = 0; tries < 60; ++tries) {
        const Attempt attempt = method.attempt(h);
        h = attempt.next;
        run.numbers.push_back(h);
        run.failures += attempt.outcome == Attempt::Outcome::notFinite;
        if (attempt.outcome != Attempt::Outcome::accepted)
            continue;
        std::vector<Coefficients> columns(size);
        method.dense(columns);
        for (const Coefficients& column : columns)
            run.numbers.insert(run.numbers.end(), column.begin(), column.end());
        y.assign(method.state().begin(), method.state().end());
        run.numbers.push_back(method.stabilityUsed());
        EXPECT_TRUE(method.proceed(y));
    }
    run.evaluations = method.counts().evaluations;
    run.calls = system.calls();
    return run;
}

} // namespace

TEST(DirectStep, HasTheBitsAndCountsOfStagesMadeOneByOne) {
    const bool isThere = DirectStep::of(*tableauNamed("dop853"), 1).stages;
    for (std::size_t size = 1; size <= DirectStep::largest + 1; ++size)
        for (const double limit : {-4.0, -0.3}) {
            const Trail direct = trailOf(size, true, limit), other = trailOf(size, false, limit);
            EXPECT_EQ(direct.numbers, other.numbers) << size;
            EXPECT_EQ(direct.evaluations, other.evaluations) << size;
            EXPECT_TRUE(other.failures > 0 || limit < -1) << size;
            EXPECT_EQ(direct.calls < other.calls, isThere && size <= DirectStep::largest) << size;
        }
}

TEST(DirectStep, IsOfOneMethodAndSmallSystems) {
    EXPECT_FALSE(DirectStep::of(*tableauNamed("dopri5"), 2).stages);
    EXPECT_FALSE(DirectStep::of(*tableauNamed("dop853"), 0).stages);
    EXPECT_FALSE(DirectStep::of(*tableauNamed("dop853"), DirectStep::largest + 1).stages);
}
