// Alike components side by side move as each would alone, to the last bit and with the same counts,
// whoever is beside them and however many threads there are.
#include "solution/side_by_side.h"
#include "solution/solver_testing.h"
#include "solution/strikes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>

using namespace solution;
using namespace solution::testing;

namespace {

class Generator {
public:
    explicit Generator(unsigned seed) : random_(seed) {}

    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() % 100000) / 1e5;
    }
    std::size_t below(std::size_t count) { return random_() % count; }
    std::string number(double low, double high) {
        return "(" + std::to_string(real(low, high)) + ")";
    }

    static constexpr std::size_t kinds = 9;
    // Several of one kind have one model and other numbers.
    std::vector<Line> component(const std::string& x, std::size_t kind) {
        const std::string v = "d" + x;
        switch (kind) {
        case 0: // a pendulum, some of them fast
            return {{x, v, real(-2, 2), 1},
                    {v, "-" + number(1, below(4) == 0 ? 4000 : 20) + "*sin(" + x + ")", 0}};
        case 1: // driven and damped, at rest at first
            return {{x, v, 0, 1},
                    {v,
                     number(0.1, 3) + "*sin(" + number(0.3, 9) + "*t)-" + number(1, 9) + "*" + x +
                         "*" + x + "*" + x + "-" + number(0.01, 1) + "*" + v,
                     0}};
        case 2: // van der Pol's, some of them stiff
            return {
                {x, v, real(-2, 2)},
                {v,
                 number(0.1, below(2) == 0 ? 3 : 400) + "*(1.5-" + x + "*" + x + ")*" + v + "-" + x,
                 real(-1, 1)}};
        case 3: // three that turn
            return {{x, number(-2, 2) + "*" + v + "*e" + x, real(-2, 2)},
                    {v, number(-2, 2) + "*" + x + "*e" + x, real(-2, 2)},
                    {"e" + x, number(-2, 2) + "*" + x + "*" + v, real(-2, 2)}};
        case 4: // some grow without bound, in a finite time
            return {{x, number(-0.5, 0.5) + "*" + x + "*" + x + "+0.25", real(-1, 2)}};
        case 5: // some have no rate any more from some time on
            return {{x, "sqrt(" + number(1, 15) + "-t)-sin(" + x + ")", real(-1, 1)}};
        case 6: // a quotient that peaks
            return {{x, v, real(-2, 2), 1},
                    {v, "-" + x + "/(0.01+" + number(0, 1) + "*" + x + "^2)", 0}};
        case 7: // a switch
            return {{x, v, real(-2, 2), 1},
                    {v,
                     "-" + number(1, 9) + "*sin(" + x + ")-" + number(0.01, 1) + "*sign(" + v + ")",
                     0}};
        default: // two kinds of sizes
            return {{x, "sin(" + v + ")*" + number(0.2, 3), real(-1, 1), below(2) == 0 ? 1.0 : 0.3},
                    {v, "cos(" + x + "*" + number(0.5, 2) + ")", real(-9, 9)}};
        }
    }

private:
    std::mt19937 random_;
};

unsigned rounds() {
    const char* factor = std::getenv("ASGARD_LONG");
    return 12 * static_cast<unsigned>(std::max(1, factor ? std::atoi(factor) : 1));
}

constexpr double finish = 8;

struct Scene {
    std::vector<std::vector<Line>> components;
    std::vector<double> tolerances; // of each component
    double changesAt = finish;      // the rates of every fifth become others

    [[nodiscard]] expression::EquationSet equations(std::size_t first, std::size_t count) const {
        std::vector<Line> lines;
        for (std::size_t c = first; c < first + count; ++c)
            lines.insert(lines.end(), components[c].begin(), components[c].end());
        expression::EquationSet set = equationsOf(lines);
        for (std::size_t c = first, unknown = 0; c < first + count;
             unknown += components[c++].size())
            if (c % 5 == 0)
                addPhase(set, unknown + components[c].size() - 1, changesAt,
                         components[c].back().derivative + "-0.1");
        return set;
    }
    [[nodiscard]] Options options(std::size_t first, std::size_t count) const {
        Options options;
        options.maximumSteps = 3000;
        for (std::size_t c = first; c < first + count; ++c)
            options.tolerances.insert(options.tolerances.end(), components[c].size(),
                                      tolerances[c]);
        return options;
    }
};

Scene randomScene(unsigned seed) {
    Generator generator(seed);
    Scene scene;
    const std::size_t count = 3 + generator.below(60);
    const std::size_t first = generator.below(Generator::kinds);
    const bool isMixed = seed % 2 == 0; // else threads have many alike beside each other, too
    for (std::size_t c = 0; c < count; ++c) {
        const std::size_t kind = isMixed ? generator.below(Generator::kinds) : first;
        scene.components.push_back(generator.component("x" + std::to_string(c), kind));
        scene.tolerances.push_back(std::pow(10, generator.real(-9, -3)));
    }
    scene.changesAt = generator.real(0.5, finish);
    return scene;
}

// Everything that is kept of a component's motion, and the work that it took.
std::string written(const Solver& solver, std::size_t first, std::size_t count) {
    std::string text;
    const auto add = [&text](double x) {
        char number[40];
        std::snprintf(number, sizeof number, "%a ", x);
        text += number;
    };
    const History& history = *solver.histories().place(first, 0).history;
    for (std::size_t k = 0; k < history.size(); ++k) {
        add(history.step(k).origin);
        add(history.step(k).until);
        add(history.step(k).scale);
        for (const double x : history.row(k))
            add(x);
    }
    for (const ComponentStatistics& s : solver.statistics().componentList)
        if (s.unknowns.front() == first) {
            for (const std::size_t n : {s.steps, s.rejectedSteps, s.unconvergedSteps, s.evaluations,
                                        s.factorisations, s.switches, s.integratedSteps})
                text += std::to_string(n) + " ";
            text += s.method + " " + s.why + " ";
            add(s.integratedFrom);
        }
    for (std::size_t u = first; u < first + count; ++u)
        if (const Stop* const stop = solver.histories().stop(u)) {
            text += stop->sentence + " ";
            add(stop->time);
        }
    return text;
}

} // namespace

TEST(SideBySide, HasTheBitsAndCountsOfEachAlone) {
    std::size_t stopped = 0, implicit = 0;
    for (unsigned seed = 0; seed < rounds(); ++seed) {
        const Scene scene = randomScene(seed);
        const std::size_t count = scene.components.size();
        std::vector<std::string> alone;
        for (std::size_t c = 0; c < count; ++c) {
            const Solver solver = solved(scene.equations(c, 1), finish, scene.options(c, 1));
            alone.push_back(written(solver, 0, scene.components[c].size()));
            stopped += solver.histories().stops().size();
            implicit += solver.statistics().factorisations > 0 ? 1 : 0;
        }
        for (const std::size_t threads : {1, 2, 5}) {
            Options options = scene.options(0, count);
            options.threads = threads;
            const Solver solver = solved(scene.equations(0, count), finish, options);
            for (std::size_t c = 0, u = 0; c < count; u += scene.components[c++].size())
                ASSERT_EQ(written(solver, u, scene.components[c].size()), alone[c])
                    << seed << ", component " << c << ", " << threads
                    << " threads: " << scene.components[c].back().derivative;
        }
    }
    EXPECT_GT(stopped, rounds()); // such ones were there
    EXPECT_GT(implicit, rounds() / 4);
}

// With events rounds are short: lanes are taken and left at every one.
TEST(SideBySide, HasTheBitsOfOneAfterTheOtherWhereEventsStrike) {
    for (unsigned seed = 0; seed < rounds(); ++seed) {
        const Scene scene = randomScene(1000 + seed);
        Generator generator(seed);
        const expression::EquationSet set = scene.equations(0, scene.components.size());
        std::vector<std::pair<double, std::size_t>> times(5);
        for (auto& [time, unknown] : times) {
            time = generator.real(0, finish);
            unknown = generator.below(set.unknowns.size());
        }
        std::vector<std::string> texts;
        for (const std::size_t threads : {0, 1, 2, 5}) {
            Strikes strikes(times);
            Options options = scene.options(0, scene.components.size());
            options.eventDriven = threads != 0; // else each goes to the end before the next
            options.threads = std::max<std::size_t>(1, threads);
            const Solver solver = solved(set, finish, options, &strikes);
            std::string text;
            char number[40];
            for (std::size_t u = 0; u < set.unknowns.size(); ++u)
                for (int k = 0; k <= 80; ++k) {
                    const double t = std::min(0.1 * k, solver.histories().reached(u));
                    std::snprintf(number, sizeof number, "%a ", solver.histories().value(u, t));
                    text += number;
                }
            texts.push_back(text);
        }
        for (const std::string& text : texts)
            ASSERT_EQ(text, texts[0]) << seed;
    }
}

// Cancelled and continued, in pieces.
TEST(SideBySide, GoesOnWhereItWasLeft) {
    const Scene scene = randomScene(7);
    const std::size_t count = scene.components.size();
    const Solver whole = solved(scene.equations(0, count), finish, scene.options(0, count));
    int polls = 0;
    Options options = scene.options(0, count);
    options.cancelled = [&polls] { return ++polls % 97 == 0; };
    Solver solver(scene.equations(0, count), options);
    while (solver.advanceTo(finish).cancelled)
        ASSERT_LT(polls, 1'000'000);
    for (std::size_t c = 0, u = 0; c < count; u += scene.components[c++].size())
        EXPECT_EQ(written(solver, u, scene.components[c].size()),
                  written(whole, u, scene.components[c].size()));
}

// Whoever is cancelled while lanes are left and filled comes to an end.
TEST(SideBySide, EndsWhereverItIsCancelled) {
    std::vector<Line> lines;
    constexpr int pendulums = 12;
    for (int c = 0; c < pendulums; ++c) {
        const std::string x = "x" + std::to_string(c), v = "d" + x;
        lines.push_back({x, v, 0.5 + 0.1 * c, 1});
        lines.push_back({v, "-" + std::to_string(3 + c) + "*sin(" + x + ")", 0});
    }
    expression::EquationSet set = equationsOf(lines);
    for (int c = 0; c < pendulums; ++c)
        addPhase(set, static_cast<std::size_t>(2 * c + 1), 3, "-2*sin(x" + std::to_string(c) + ")");
    bool isCancelled = true;
    for (int poll = 1; isCancelled; ++poll) {
        int polls = 0;
        Options options;
        options.cancelled = [&] { return ++polls == poll; };
        Solver solver(set, options);
        isCancelled = solver.advanceTo(finish).cancelled;
        ASSERT_LT(poll, 10'000);
    }
}
