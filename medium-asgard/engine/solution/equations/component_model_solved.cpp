// Multipliers, with the outputs that read them, as expressions; see component_model.h.
#include "equations/component_model.h"

#include "equations/solved_conditions.h"

#include <algorithm>
#include <set>

namespace solution {

using expression::Graph;
using expression::Node;

const ComponentModel::Solved* ComponentModel::solved() const {
    const std::scoped_lock lock(derivatives_.making);
    if (!derivatives_.isSolvedKnown)
        derivatives_.solved = derivedSolution();
    derivatives_.isSolvedKnown = true;
    return derivatives_.solved.get();
}

std::unique_ptr<ComponentModel::Solved> ComponentModel::derivedSolution() const {
    if (function_.decisions() > 0)
        return nullptr;
    std::set<std::uint32_t> pushed; // states
    for (const Entry& push : conditions_.pushes)
        if (conditions_.isTie[push.column] == 0)
            pushed.insert(push.row);
    if (static_cast<std::size_t>(std::ranges::count(conditions_.isTie, 0)) > pushed.size())
        return nullptr; // redundant ones, wherever they are
    Graph graph = graph_;
    const std::span<const Node> multipliers = std::span(symbols_.all).last(symbols_.multipliers);
    std::vector<Node> symbols = symbols_.all;
    for (std::size_t r = 0; r < multipliers.size(); ++r)
        symbols.push_back(graph.symbol("r" + std::to_string(r)));
    LinearConditions linear{.graph = graph,
                            .symbols = symbols,
                            .constants = constantSymbols(),
                            .multipliers = multipliers,
                            .held = {},
                            .places = {},
                            .entries = {},
                            .rests = {}};
    std::vector<Node> seconds, given;
    std::unordered_map<std::uint32_t, Node> without;
    for (std::size_t r = 0; r < multipliers.size(); ++r) {
        without.emplace(multipliers[r].index, graph.constant(0));
        if (conditions_.isTie[r] != 0)
            continue;
        seconds.push_back(conditionNodes_[3 * r + 2]);
        given.push_back(symbols[symbols_.all.size() + r]);
        linear.held.push_back(multipliers[r]);
    }
    const auto matrix = expression::gradients(graph, seconds, linear.held);
    for (std::size_t row = 0; row < matrix.size(); ++row)
        for (const auto& [column, derivative] : matrix[row]) {
            linear.places.push_back({static_cast<std::uint32_t>(row), column});
            linear.entries.push_back(derivative);
        }
    linear.rests = expression::substitute(graph, seconds, without);
    const std::vector<Node> read = expression::symbolsOf(graph, linear.entries);
    if (std::ranges::any_of(read, [&](Node n) { return without.contains(n.index); }))
        return nullptr; // forces that read products of forces
    auto made = std::make_unique<Solved>();
    made->rows = linear.held.size();
    const auto solve = [&](std::span<const Node> outputs, std::size_t inputs) {
        auto solved = solvedConditions(linear, outputs);
        if (!solved)
            return false;
        std::vector<Node>& all = solved->outputs;
        std::size_t row = 0;
        for (const char isTie : conditions_.isTie)
            all.push_back(isTie != 0 ? solved->graph.constant(0) : solved->multipliers[row++]);
        all.insert(all.end(), solved->checks.begin(), solved->checks.end());
        (outputs.empty() ? made->given : made->all) = expression::Function(
            expression::Tape(solved->graph, std::span(solved->symbols).first(inputs), all));
        made->multiplications = solved->multiplications;
        return true;
    };
    if (!solve(outputs_, symbols_.all.size()))
        return nullptr;
    linear.rests = given;
    if (!solve({}, symbols.size()))
        return nullptr;
    return made;
}

} // namespace solution
