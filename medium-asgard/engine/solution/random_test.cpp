// Random equation sets that switch, nest switches, read each other and are struck by events: work
// is bounded, bits do not depend on how far things were solved, and the tolerance is met.
#include "solution/solver_testing.h"
#include "solution/strikes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

using namespace solution;
using namespace solution::testing;

namespace {

class Generator {
public:
    explicit Generator(unsigned seed, std::string prefix = "u")
        : random_(seed), prefix_(std::move(prefix)) {}

    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() % 100000) / 1e5;
    }
    std::size_t below(std::size_t count) { return random_() % count; }

    std::string expression(std::size_t unknowns, int depth) {
        const auto part = [&] { return expression(unknowns, depth - 1); };
        switch (below(depth > 0 ? 13 : 4)) {
        case 0:
            return number(real(-3, 3));
        case 1:
            return variable(unknowns);
        case 2:
            return "sin(" + number(real(0.3, 9)) + "*t+" + number(real(0, 6)) + ")";
        case 3:
            return "(" + number(real(-2, 2)) + "*" + variable(unknowns) + ")";
        case 4:
            return "(" + part() + "+" + part() + ")";
        case 5:
            return "(" + part() + "-" + part() + ")";
        case 6:
            return "sign(" + part() + ")";
        case 7:
            return "abs(" + part() + ")";
        case 8:
            return "(" + part() + "<" + part() + "?" + part() + ":" + part() + ")";
        case 9:
            return "min(" + part() + "," + part() + ")";
        case 10:
            return "floor(" + part() + ")";
        case 11:
            return "sin(" + part() + ")";
        default:
            return "(-sign(" + variable(unknowns) + "))";
        }
    }

    std::vector<Line> lines() {
        const std::size_t count = 2 + below(5);
        std::vector<Line> result;
        for (std::size_t i = 0; i < count; ++i) {
            const std::string name = prefix_ + std::to_string(i);
            const std::string damping = "-" + number(real(0.1, 1)) + "*" + name;
            result.push_back({name, expression(count, 3) + damping, real(-2, 2)});
        }
        return result;
    }

private:
    static std::string number(double value) { return "(" + std::to_string(value) + ")"; }
    std::string variable(std::size_t unknowns) { return prefix_ + std::to_string(below(unknowns)); }
    std::mt19937 random_;
    std::string prefix_;
};

unsigned rounds() {
    const char* factor = std::getenv("ASGARD_LONG");
    return 60 * static_cast<unsigned>(std::max(1, factor ? std::atoi(factor) : 1));
}

} // namespace

namespace {

void expectTheSameBits(unsigned seed) {
    Generator generator(seed);
    const std::vector<Line> lines = generator.lines();
    std::vector<Strikes::Strike> strikes(3);
    for (Strikes::Strike& strike : strikes)
        strike = {generator.real(0, 8), generator.below(lines.size())};
    Options options = tolerance(1e-7);
    options.maximumSteps = 100'000;
    Options toTheEnd = options;
    toTheEnd.eventDriven = false;
    Strikes first(strikes), second(strikes), third(strikes);
    Solver a(equationsOf(lines), options, &first);
    Solver b(equationsOf(lines), toTheEnd, &second);
    Solver c(equationsOf(lines), options, &third);
    ASSERT_EQ(a.advanceTo(8).reached, 8);
    ASSERT_EQ(b.advanceTo(8).reached, 8);
    for (int k = 1; k <= 13; ++k)
        ASSERT_FALSE(c.advanceTo(8.0 * k / 13).cancelled);
    EXPECT_LT(a.statistics().evaluations, 5'000'000u) << seed;
    for (std::size_t u = 0; u < lines.size(); ++u) {
        ASSERT_EQ(a.histories().stop(u) == nullptr, b.histories().stop(u) == nullptr) << seed;
        const double end = std::min(8.0, a.histories().reached(u));
        for (int k = 0; 0.1 * k <= end; ++k) {
            const double t = 0.1 * k;
            ASSERT_EQ(a.histories().value(u, t), b.histories().value(u, t)) << seed << " " << t;
            ASSERT_EQ(a.histories().value(u, t), c.histories().value(u, t)) << seed << " " << t;
        }
    }
}

} // namespace

TEST(RandomSystems, AreBoundedReproducibleAndIndependentOfTheSchedule) {
    for (unsigned seed = 0; seed < rounds(); ++seed)
        expectTheSameBits(seed);
}

// A stage that rounding puts beyond the end of its step reads what was known there; floor of what
// is whole switches where that does; floors within comparisons; a sign that is compared, which
// creeps along its surface by 1e-12 at a time, and ends.
TEST(RandomSystems, ThatWereNotOnce) {
    for (const unsigned seed : {655, 459, 498, 1025})
        expectTheSameBits(seed);
}

namespace {

// All numbers of a motion and of the work for it, to the last bit.
std::string written(const Solver& solver, double finish) {
    std::string text;
    const Statistics s = solver.statistics();
    for (const std::size_t count :
         {s.steps, s.rejectedSteps, s.discardedSteps, s.evaluations, s.factorisations, s.events,
          s.switches, s.integratedSteps, s.components, s.historyBytes, s.groups})
        text += std::to_string(count) + " ";
    char number[40];
    for (std::size_t u = 0; u < solver.histories().unknowns(); ++u)
        for (int k = 0; k <= 20; ++k) {
            std::snprintf(number, sizeof number, "%a ",
                          solver.histories().value(u, finish * k / 20));
            text += number;
        }
    for (const Stop& stop : solver.histories().stops())
        text += stop.sentence + " ";
    return text;
}

} // namespace

TEST(RandomSystems, MoveAndCountTheSameOnAnyNumberOfThreads) {
    for (unsigned seed = 0; seed < rounds() / 20; ++seed) {
        std::vector<Line> lines;
        for (unsigned k = 0; k < 30; ++k)
            for (const Line& line :
                 Generator(1000 * seed + k, "g" + std::to_string(k) + "u").lines())
                lines.push_back(line);
        Generator generator(seed);
        std::vector<Strikes::Strike> strikes(6);
        for (Strikes::Strike& strike : strikes)
            strike = {generator.real(0, 3), generator.below(lines.size())};
        Options options = tolerance(1e-6);
        options.maximumSteps = 20'000;
        std::string first;
        for (const std::size_t threads : {1, 2, 4, 8, 16}) {
            options.threads = threads;
            for (const bool isStruck : {true, false}) {
                Strikes source(strikes);
                Solver solver(equationsOf(lines), options, isStruck ? &source : nullptr);
                ASSERT_EQ(solver.advanceTo(3).reached, 3);
                const std::string text = written(solver, 3);
                if (threads == 1 && isStruck)
                    first = text;
                if (isStruck) {
                    ASSERT_EQ(text, first) << seed << ", " << threads << " threads";
                }
            }
        }
    }
}
