// Equation sets of a few lines, for tests.
#pragma once

#include "expression/testing.h"
#include "solution/solver.h"

#include <string>
#include <vector>

namespace solution::testing {

struct Line {
    std::string name, derivative;
    double initial = 0;
    double lengthPerUnit = 0;
};

// A velocity is found by its name: "dx" is that of "x".
inline expression::EquationSet equationsOf(const std::vector<Line>& lines) {
    expression::EquationSet set;
    set.time = set.graph.symbol("t");
    for (const Line& line : lines) {
        expression::Unknown unknown;
        unknown.name = line.name;
        unknown.symbol = set.graph.symbol(line.name);
        unknown.initial = line.initial;
        unknown.lengthPerUnit = line.lengthPerUnit;
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = expression::testing::parsed(set.graph, line.derivative);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (lines[i].derivative == line.name)
                unknown.integralOf = i;
        set.unknowns.push_back(unknown);
    }
    return set;
}

inline void addPhase(expression::EquationSet& set, std::size_t unknown, double from,
                     const std::string& derivative, const std::string& given = "",
                     const std::string& jump = "") {
    expression::Phase phase;
    phase.from = from;
    phase.derivative = expression::testing::parsed(set.graph, derivative);
    if (!given.empty())
        phase.given = expression::testing::parsed(set.graph, given);
    if (!jump.empty())
        phase.jump = expression::testing::parsed(set.graph, jump);
    set.unknowns[unknown].phases.push_back(phase);
}

inline Solver solved(expression::EquationSet set, double finish, Options options = {},
                     EventSource* source = nullptr) {
    Solver solver(std::move(set), std::move(options), source);
    const Advance advance = solver.advanceTo(finish);
    if (advance.cancelled)
        throw std::runtime_error("cancelled");
    return solver;
}

inline Options tolerance(double tolerance) {
    Options options;
    options.tolerance = tolerance;
    return options;
}

// The largest error of an unknown on a grid of times.
inline double worst(const Histories& histories, std::size_t unknown, double from, double to,
                    const std::function<double(double)>& exact) {
    double largest = 0;
    for (int k = 0; k <= 1000; ++k) {
        const double t = from + (to - from) * k / 1000;
        largest = std::max(largest, std::abs(histories.value(unknown, t) - exact(t)));
    }
    return largest;
}

} // namespace solution::testing
