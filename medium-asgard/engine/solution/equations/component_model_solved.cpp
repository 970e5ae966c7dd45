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

// None: they cannot be solved for so, wherever they are.
std::optional<EliminationOrder> ComponentModel::orderOfConditions() const {
    std::vector<std::uint32_t> rowOf;
    std::uint32_t rows = 0;
    for (const char isTie : conditions_.isTie)
        rowOf.push_back(isTie != 0 ? rows : rows++);
    std::set<std::uint32_t> pushed; // states
    for (const Entry& push : conditions_.pushes)
        if (conditions_.isTie[push.column] == 0)
            pushed.insert(push.row);
    if (rows > pushed.size())
        return std::nullopt; // some are redundant
    std::vector<EliminationOrder::Place> places;
    for (const auto& [row, column] : conditions_.matrix)
        if (conditions_.isTie[row] == 0)
            places.push_back({rowOf[row], rowOf[column]});
    return orderToWrite(rows, places);
}

std::unique_ptr<ComponentModel::Solved> ComponentModel::derivedSolution() const {
    if (function_.decisions() > 0)
        return nullptr;
    const auto order = orderOfConditions();
    if (!order)
        return nullptr;
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
                            .rests = {},
                            .lefts = {}};
    std::vector<Node> given;
    std::unordered_map<std::uint32_t, Node> without;
    for (std::size_t r = 0; r < multipliers.size(); ++r) {
        without.emplace(multipliers[r].index, graph.constant(0));
        if (conditions_.isTie[r] != 0)
            continue;
        linear.lefts.push_back(conditionNodes_[3 * r + 2]);
        given.push_back(symbols[symbols_.all.size() + r]);
        linear.held.push_back(multipliers[r]);
    }
    const auto matrix = expression::gradients(graph, linear.lefts, linear.held);
    std::vector<Node> ofGiven = given;
    for (std::size_t row = 0; row < matrix.size(); ++row)
        for (const auto& [column, derivative] : matrix[row]) {
            linear.places.push_back({static_cast<std::uint32_t>(row), column});
            linear.entries.push_back(derivative);
            ofGiven[row] = graph.add(ofGiven[row], graph.multiply(derivative, linear.held[column]));
        }
    linear.rests = expression::substitute(graph, linear.lefts, without);
    const std::vector<Node> read = expression::symbolsOf(graph, linear.entries);
    if (std::ranges::any_of(read, [&](Node n) { return without.contains(n.index); }))
        return nullptr; // forces that read products of forces
    auto made = std::make_unique<Solved>();
    made->rows = linear.held.size();
    made->multiplications = order->multiplications;
    const auto solve = [&](std::span<const Node> outputs, std::size_t inputs) {
        auto solved = solvedConditions(linear, *order, outputs);
        if (!solved)
            return false;
        std::vector<Node>& all = solved->outputs;
        std::size_t row = 0;
        for (const char isTie : conditions_.isTie)
            all.push_back(isTie != 0 ? solved->graph.constant(0) : solved->multipliers[row++]);
        all.insert(all.end(), solved->checks.begin(), solved->checks.end());
        (outputs.empty() ? made->given : made->all) = expression::Function(
            expression::Tape(solved->graph, std::span(solved->symbols).first(inputs), all));
        return true;
    };
    if (!solve(outputs_, symbols_.all.size()))
        return nullptr;
    linear.rests = given;
    linear.lefts = ofGiven;
    if (!solve({}, symbols.size()))
        return nullptr;
    return made;
}

} // namespace solution
