// Equations of one component from lines of text, for tests.
#pragma once

#include "equations/prepared_equations.h"
#include "expression/testing.h"
#include "modes/component_equations.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace solution::testing {

using Rates = std::vector<std::pair<std::string, std::string>>; // names and rates

inline std::shared_ptr<expression::EquationSet> setOf(const Rates& rates) {
    auto set = std::make_shared<expression::EquationSet>();
    set->time = set->graph.symbol("t");
    for (const auto& [name, rate] : rates) {
        expression::Unknown unknown;
        unknown.name = name;
        unknown.symbol = set->graph.symbol(name);
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = expression::testing::parsed(set->graph, rate);
        set->unknowns.push_back(unknown);
    }
    return set;
}

inline PreparedEquations prepared(std::shared_ptr<expression::EquationSet> set) {
    Preparation how;
    how.whole = how.everyState = true;
    return PreparedEquations(std::move(set), how);
}

// One component, without inputs.
class Equations {
public:
    explicit Equations(Rates rates)
        : prepared_(prepared(setOf(rates))),
          equations_(prepared_.components.at(0).bound, histories_) {}

    ComponentEquations* operator->() { return &equations_; }
    ComponentEquations& operator*() { return equations_; }
    std::string modeAt(std::vector<double> y, double t = 0) {
        equations_.solver().decide(t, y);
        return print(equations_.mode());
    }
    std::vector<double> ratesAt(std::vector<double> y, double t = 0) {
        equations_.solver().decide(t, y);
        std::vector<double> out(y.size());
        if (!equations_.rates(t, y, out))
            throw std::runtime_error("not finite");
        return out;
    }

private:
    PreparedEquations prepared_;
    Histories histories_;
    ComponentEquations equations_;
};

} // namespace solution::testing
