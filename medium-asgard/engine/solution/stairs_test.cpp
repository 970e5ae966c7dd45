// Random expressions that switch with the time alone, against their exact integrals.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

using namespace solution;
using namespace solution::testing;

namespace {

struct Stairs {
    std::string text;
    std::function<double(double)> value;
};

// Piecewise constant or piecewise linear in t; what may be compared with what is both.
class RandomStairs {
public:
    explicit RandomStairs(unsigned seed) : random_(seed) {}

    Stairs constants(int depth) { // piecewise constant
        if (depth == 0)
            return number(static_cast<int>(pick(7)) - 3);
        switch (pick(7)) {
        case 0: {
            const Stairs a = linear(depth - 1);
            return {"floor(" + a.text + ")", [a](double t) { return std::floor(a.value(t)); }};
        }
        case 1: {
            const Stairs a = linear(depth - 1);
            return {"sign(" + a.text + ")",
                    [a](double t) { return double((a.value(t) > 0) - (a.value(t) < 0)); }};
        }
        case 2:
            return comparison(depth);
        case 3: {
            const Stairs a = constants(depth - 1), b = constants(depth - 1);
            return {"(" + a.text + ")+(" + b.text + ")",
                    [a, b](double t) { return a.value(t) + b.value(t); }};
        }
        case 4: {
            const Stairs a = constants(depth - 1), b = constants(depth - 1);
            return {"min(" + a.text + "," + b.text + ")",
                    [a, b](double t) { return std::min(a.value(t), b.value(t)); }};
        }
        default: {
            const Stairs c = comparison(depth), a = constants(depth - 1), b = constants(depth - 1);
            return {"(" + c.text + " ? " + a.text + " : " + b.text + ")",
                    [c, a, b](double t) { return c.value(t) != 0 ? a.value(t) : b.value(t); }};
        }
        }
    }

private:
    unsigned pick(unsigned n) { return static_cast<unsigned>(random_() % n); }

    static Stairs number(int n) {
        const std::string text = n < 0 ? "(" + std::to_string(n) + ")" : std::to_string(n);
        return {text, [n](double) { return n; }};
    }

    Stairs linear(int depth) {
        if (depth > 0 && pick(3) == 0) {
            const Stairs a = linear(depth - 1);
            if (pick(2) == 0)
                return {"abs(" + a.text + ")", [a](double t) { return std::abs(a.value(t)); }};
            const Stairs b = constants(depth - 1);
            return {"max(" + a.text + "," + b.text + ")",
                    [a, b](double t) { return std::max(a.value(t), b.value(t)); }};
        }
        // An even multiple of 1/2 for slopes, of 1/4 for offsets: exact in floating point.
        static constexpr double slopes[] = {0.5, 1, 2, -1, -0.5};
        const double slope = slopes[pick(5)], offset = (static_cast<int>(pick(25)) - 12) / 4.0;
        return {"(" + std::to_string(slope) + "*t+" + (offset < 0 ? "(" : "") +
                    std::to_string(offset) + (offset < 0 ? "))" : ")"),
                [slope, offset](double t) { return slope * t + offset; }};
    }

    Stairs comparison(int depth) {
        const bool still = pick(2) == 0;
        const Stairs a = still ? constants(depth - 1) : linear(depth - 1);
        const Stairs b = constants(depth - 1);
        const auto both = [&](const char* op, auto compare) {
            return Stairs{"(" + a.text + op + b.text + ")",
                          [a, b, compare](double t) { return compare(a.value(t), b.value(t)); }};
        };
        switch (pick(still ? 6 : 4)) {
        case 0:
            return both(" < ", [](double x, double y) { return double(x < y); });
        case 1:
            return both(" > ", [](double x, double y) { return double(x > y); });
        case 2:
            return both(" <= ", [](double x, double y) { return double(x <= y); });
        case 3:
            return both(" >= ", [](double x, double y) { return double(x >= y); });
        case 4:
            return both(" == ", [](double x, double y) { return double(x == y); });
        default:
            return both(" != ", [](double x, double y) { return double(x != y); });
        }
    }

    std::mt19937 random_;
};

// Between its jumps, which bisection finds to the last bits, the integrand is constant.
double integral(const std::function<double(double)>& f, double finish) {
    constexpr int pieces = 20'000;
    double sum = 0, from = 0, value = f(1e-9);
    for (int i = 0; i < pieces; ++i) {
        double low = finish * (i + 0.37) / pieces, high = finish * (i + 1.37) / pieces;
        if (f(high) == value)
            continue;
        const double next = f(high);
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            (f(middle) == value ? low : high) = middle;
        }
        sum += value * (high - from);
        from = high;
        value = next;
    }
    return sum + value * (finish - from);
}

} // namespace

TEST(Switches, RandomStairsOfTimeAreIntegratedExactly) {
    const char* asked = std::getenv("ASGARD_LONG");
    const int count = asked ? 300 * std::atoi(asked) : 300;
    int varied = 0;
    for (int i = 0; i < count; ++i) {
        RandomStairs random(static_cast<unsigned>(i));
        const Stairs stairs = random.constants(3);
        constexpr double finish = 7.3;
        const double exact = integral(stairs.value, finish);
        const Solver solver = solved(equationsOf({{"x", stairs.text, 0}}), finish, tolerance(1e-9));
        ASSERT_EQ(solver.histories().stop(0), nullptr)
            << i << ": " << stairs.text << ": " << solver.histories().stop(0)->sentence;
        ASSERT_NEAR(solver.histories().value(0, finish), exact, 1e-8) << i << ": " << stairs.text;
        varied += exact != stairs.value(1e-9) * finish ? 1 : 0;
    }
    EXPECT_GT(varied, count / 4);
}
