#include "equations/component_model.h"

#include "equations/peaks.h"
#include "expression/operation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <map>
#include <numbers>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

// atan2(y, x), which jumps by 2 pi where y passes 0 on the left: with switches there, and on each
// branch an angle that goes on.
Node angleOf(Graph& graph, Node y, Node x) {
    const Node zero = graph.constant(0), quarter = graph.constant(std::numbers::pi / 2);
    const Node left = graph.negate(x), down = graph.negate(y);
    const Node above = graph.add(quarter, graph.apply(Op::atan2, left, y));
    const Node below = graph.negate(graph.add(quarter, graph.apply(Op::atan2, left, down)));
    const Node behind = graph.apply(Op::select, graph.apply(Op::less, y, zero), below, above);
    const Node ahead = graph.apply(Op::atan2, y, x);
    return graph.apply(Op::select, graph.apply(Op::less, x, zero), behind, ahead);
}

} // namespace

ComponentModel::ComponentModel(Key key) : key_(std::move(key)) {
    readKey();
    findStructure();
    function_ = expression::Function(expression::Tape(graph_, symbols_.all, outputs_));
    Graph graph = graph_;
    FoundDirections directions;
    if (dividesByLength(graph_))
        directions = foundDirections(graph);
    if (!directions.all.empty())
        deriveDirections(graph, directions);
    if (symbols_.multipliers > 0)
        deriveConditions(graph, directions);
}

void ComponentModel::readKey() {
    std::size_t at = 0;
    const auto next = [&] { return key_[at++]; };
    symbols_.states = next();
    const std::size_t held = next();
    symbols_.multipliers = next();
    for (std::size_t i = 0; i < symbols_.states; ++i)
        if (next() != 0)
            structure_.configuration.push_back(i);
    symbols_.all.push_back(graph_.symbol("t"));
    for (std::size_t i = 0; i < symbols_.states; ++i)
        symbols_.all.push_back(graph_.symbol("y" + std::to_string(i)));
    std::vector<Node> constants, entries, multipliers;
    for (std::size_t i = 0; i < symbols_.multipliers; ++i)
        multipliers.push_back(graph_.symbol("m" + std::to_string(i)));
    const auto moves = [&](Node a, Node b) {
        return std::ranges::any_of(
            expression::symbolsOf(graph_, std::array{a, b}),
            [&](Node symbol) { return std::ranges::find(constants, symbol) == constants.end(); });
    };
    while (key_[at] != key::outputs) {
        const std::uint32_t word = next();
        if (word == key::time) {
            entries.push_back(symbols_.all[0]);
            structure_.readsTime = true;
        } else if (word == key::state) {
            entries.push_back(symbols_.all[1 + next()]);
        } else if (word == key::multiplier) {
            entries.push_back(multipliers[next()]);
        } else if (word == key::input) {
            symbols_.all.push_back(graph_.symbol("u" + std::to_string(symbols_.inputs++)));
            entries.push_back(symbols_.all.back());
        } else if (word == key::constant) {
            constants.push_back(graph_.symbol("c" + std::to_string(constants.size())));
            entries.push_back(constants.back());
        } else if (static_cast<Op>(word) == Op::constant) {
            const std::uint64_t low = next(), high = next();
            entries.push_back(graph_.constant(std::bit_cast<double>(low | high << 32)));
        } else {
            const Op op = static_cast<Op>(word);
            const int count = expression::argumentCount(op);
            const Node a = entries[next()], b = count > 1 ? entries[next()] : Node{},
                       c = count > 2 ? entries[next()] : Node{};
            entries.push_back(op == Op::atan2 && moves(a, b) ? angleOf(graph_, a, b)
                              : count == 1                   ? graph_.apply(op, a)
                              : count == 2                   ? graph_.apply(op, a, b)
                                                             : graph_.apply(op, a, b, c));
        }
    }
    ++at;
    for (std::size_t i = 0; i < symbols_.states + held; ++i)
        outputs_.push_back(entries[next()]);
    for (std::size_t i = 0; i < 3 * multipliers.size(); ++i)
        conditionNodes_.push_back(entries[next()]);
    for (std::size_t r = 0; r < multipliers.size(); ++r) {
        conditions_.firstValid.push_back(static_cast<std::uint32_t>(besideNodes_.size()));
        for (std::uint32_t left = next(); left > 0; --left)
            besideNodes_.push_back(entries[next()]);
    }
    conditions_.firstValid.push_back(static_cast<std::uint32_t>(besideNodes_.size()));
    conditions_.firstLever.push_back(static_cast<std::uint32_t>(besideNodes_.size()));
    for (std::size_t r = 0; r < multipliers.size(); ++r) {
        for (std::uint32_t left = next(); left > 0; --left)
            besideNodes_.push_back(entries[next()]);
        conditions_.firstLever.push_back(static_cast<std::uint32_t>(besideNodes_.size()));
    }
    symbols_.all.insert(symbols_.all.end(), constants.begin(), constants.end());
    symbols_.all.insert(symbols_.all.end(), multipliers.begin(), multipliers.end());
    for (std::size_t i = 0; i < symbols_.all.size(); ++i)
        symbols_.places.emplace(symbols_.all[i].index, i);
}

void ComponentModel::findStructure() {
    const auto stateOf = [this](Node n) -> std::optional<std::size_t> {
        const auto place = placeOf(n);
        return place && *place >= 1 && *place <= symbols_.states ? std::optional(*place - 1)
                                                                 : std::nullopt;
    };
    for (std::size_t x = 0; x < symbols_.states; ++x)
        if (const auto v = stateOf(outputs_[x]))
            structure_.integrals.emplace_back(x, *v);
    const std::vector<Node> read = expression::symbolsOf(graph_, outputs_);
    structure_.readsStates =
        std::ranges::any_of(read, [&](Node n) { return stateOf(n).has_value(); });
    structure_.canPeak = solution::canPeak(graph_, outputs_, constantSymbols(), attitudes());
    if (structure_.canPeak)
        peaks_ = peaksAmong(outputs_);
    switching_.surfaces = surfacesOf(graph_, outputs_);
    switching_.read = ReadSurfaces(graph_, outputs_, switching_.surfaces);
    if (structure_.canPeak && !switching_.surfaces.empty()) {
        std::vector<Node> guards;
        std::ranges::transform(switching_.surfaces, std::back_inserter(guards), &Surface::guard);
        guardPeaks_ = peaksAmong(guards);
    }
    if (!switching_.surfaces.empty()) // without surfaces there are none
        switching_.switches = switchesOf(graph_, outputs_);
    derivatives_.gradients.resize(switching_.surfaces.size());
    for (const Surface& surface : switching_.surfaces)
        switching_.readMultipliers.push_back(std::ranges::any_of(
            expression::symbolsOf(graph_, std::span(&surface.guard, 1)), [this](Node symbol) {
                const auto place = placeOf(symbol);
                return place && *place >= variables() + constants();
            }));
    for (std::size_t s = 0; s < switching_.surfaces.size(); ++s)
        if (const auto state = stateOf(switching_.surfaces[s].guard);
            state && !switching_.surfaces[s].whole)
            switching_.ownGuards.emplace_back(s, *state);
}

ComponentModel::PeakFunctions ComponentModel::peaksAmong(std::span<const Node> nodes) const {
    PeakFunctions found;
    Graph graph = graph_;
    std::vector<Node> symbols = symbols_.all;
    std::vector<Moving> moving = {{symbols_.all[0], graph.constant(1)}};
    for (std::size_t i = 1; i < variables(); ++i) {
        moving.push_back({symbols_.all[i], graph.symbol("rate of " + graph.name(symbols_.all[i]))});
        symbols.push_back(moving.back().rate);
    }
    const Peaks peaks = peaksOf(graph, nodes, constantSymbols(), attitudes(), moving);
    std::vector<Node> causes, rates;
    for (const Peaks::Cause& cause : peaks.causes) {
        causes.push_back(cause.value);
        rates.push_back(cause.rate);
        found.ratios.push_back(cause.ratio);
    }
    causes.insert(causes.end(), rates.begin(), rates.end());
    found.causes = expression::Function(expression::Tape(graph, symbols, causes));
    found.heights = expression::Function(expression::Tape(graph, symbols_.all, peaks.heights));
    found.arePolynomials = peaks.arePolynomials;
    return found;
}

std::vector<Node> ComponentModel::attitudes() const {
    std::vector<Node> attitudes;
    for (const std::size_t state : structure_.configuration)
        if (std::ranges::find(structure_.integrals, state,
                              &std::pair<std::size_t, std::size_t>::first) ==
            structure_.integrals.end())
            attitudes.push_back(symbols_.all[1 + state]);
    return attitudes;
}

bool ComponentModel::canPeak(std::span<const double> values) const {
    return structure_.canPeak &&
           solution::canPeak(graph_, outputs_, constantSymbols(), attitudes(), values);
}

std::optional<std::size_t> ComponentModel::placeOf(Node symbol) const {
    const auto found = symbols_.places.find(symbol.index);
    return found == symbols_.places.end() ? std::nullopt : std::optional(found->second);
}

// ---------------------------------------------------------------------------------------------
// Derivatives

const ComponentModel::Jacobian& ComponentModel::jacobian() const {
    const std::scoped_lock lock(derivatives_.making);
    if (!derivatives_.jacobian)
        derivatives_.jacobian = derivedJacobian();
    return *derivatives_.jacobian;
}

std::unique_ptr<ComponentModel::Jacobian> ComponentModel::derivedJacobian() const {
    auto jacobian = std::make_unique<Jacobian>();
    Graph graph = graph_;
    std::vector<std::map<int, Node>> columns(symbols_.states);
    const std::span<const Node> states = std::span(symbols_.all).subspan(1, symbols_.states);
    const auto rows =
        expression::gradients(graph, std::span(outputs_).first(symbols_.states), states);
    for (std::size_t row = 0; row < symbols_.states; ++row)
        for (const auto& [state, derivative] : rows[row])
            columns[state].emplace(static_cast<int>(row), derivative);
    const auto addPushes = [&](std::uint32_t state) {
        for (const Entry& push : conditions_.pushes)
            columns[state].emplace(static_cast<int>(push.row), graph.constant(0));
    };
    std::vector<Node> seconds, ofConditions;
    for (std::size_t r = 0; r < symbols_.multipliers; ++r)
        seconds.push_back(conditionNodes_[3 * r + 2]);
    const auto ofSeconds = expression::gradients(graph, seconds, states);
    for (std::size_t r = 0; r < seconds.size(); ++r)
        for (const auto& [state, derivative] : ofSeconds[r]) {
            jacobian->ofConditions.push_back({static_cast<std::uint32_t>(r), state});
            ofConditions.push_back(derivative);
            addPushes(state);
        }
    std::vector<Node> read;
    std::vector<std::uint32_t> places;
    for (std::size_t r = 0; r < symbols_.multipliers; ++r)
        if (graph.isConstant(conditionNodes_[3 * r], 0)) {
            read.push_back(conditionNodes_[3 * r + 1]);
            places.push_back(static_cast<std::uint32_t>(symbols_.multipliers + r));
        }
    for (std::uint32_t k = conditions_.firstLever.front(); k < conditions_.firstLever.back(); ++k) {
        read.push_back(besideNodes_[k]);
        places.push_back(static_cast<std::uint32_t>(2 * symbols_.multipliers + k));
    }
    std::vector<Node> ofGaps;
    const auto ofRead = expression::gradients(graph, read, states);
    for (std::size_t i = 0; i < read.size(); ++i)
        for (const auto& [state, derivative] : ofRead[i]) {
            jacobian->ofGaps.push_back({places[i], state});
            ofGaps.push_back(derivative);
            addPushes(state);
        }
    Pattern& pattern = jacobian->pattern;
    std::vector<Node> entries;
    pattern.columnStarts.push_back(0);
    for (const auto& column : columns) {
        for (const auto& [row, node] : column) {
            pattern.rows.push_back(row);
            entries.push_back(node);
        }
        pattern.columnStarts.push_back(static_cast<int>(pattern.rows.size()));
    }
    entries.insert(entries.end(), ofConditions.begin(), ofConditions.end());
    entries.insert(entries.end(), ofGaps.begin(), ofGaps.end());
    jacobian->entries = derive(graph, entries);
    return jacobian;
}

bool ComponentModel::isSwitching() const {
    return !switching_.surfaces.empty() || !directions_.ranges.empty() ||
           !conditions_.second.sources.empty() || !conditions_.gaps.sources.empty();
}

const ComponentModel::Kinematics& ComponentModel::kinematics() const {
    const std::scoped_lock lock(derivatives_.making);
    if (!derivatives_.kinematics)
        derivatives_.kinematics = derivedKinematics();
    return *derivatives_.kinematics;
}

std::unique_ptr<ComponentModel::Kinematics> ComponentModel::derivedKinematics() const {
    auto kinematics = std::make_unique<Kinematics>();
    Graph graph = graph_;
    std::vector<Node> rates, slopes;
    for (const std::size_t i : structure_.configuration)
        rates.push_back(outputs_[i]);
    const auto rows =
        expression::gradients(graph, rates, std::span(symbols_.all).subspan(1, symbols_.states));
    for (std::size_t place = 0; place < rows.size(); ++place)
        for (const auto& [state, derivative] : rows[place]) {
            kinematics->entries.push_back(
                {static_cast<std::uint32_t>(structure_.configuration[place]), state});
            slopes.push_back(derivative);
        }
    kinematics->slopes = derive(graph, slopes);
    return kinematics;
}

const ComponentModel::Gradient& ComponentModel::gradient(std::size_t surface) const {
    const std::scoped_lock lock(derivatives_.making);
    std::unique_ptr<const Gradient>& place = derivatives_.gradients[surface];
    if (!place)
        place = std::make_unique<Gradient>(gradientOf(switching_.surfaces[surface].guard));
    return *place;
}

ComponentModel::Gradient ComponentModel::gradientOf(Node node) const {
    Gradient gradient;
    Graph graph = graph_;
    std::vector<Node> derivatives;
    for (const Node symbol : std::span(symbols_.all).first(variables()))
        derivatives.push_back(expression::differentiate(graph, node, symbol));
    derivatives.push_back(node);
    gradient.derivatives = derive(graph, derivatives);
    const auto place = placeOf(node);
    if (place && *place >= 1 && *place <= symbols_.states)
        gradient.state = *place - 1;
    return gradient;
}

// Its own switches are ours, or stand on the same surfaces as ours.
// Nodes read the symbols and `more`.
ComponentModel::Derived ComponentModel::derive(Graph& graph, std::span<const Node> nodes,
                                               std::span<const Node> more) const {
    Derived derived;
    std::vector<Node> symbols = symbols_.all;
    symbols.insert(symbols.end(), more.begin(), more.end());
    derived.function = expression::Function(expression::Tape(graph, symbols, nodes));
    for (const Node switching : switchesOf(graph, nodes)) {
        Derived::Source source;
        const auto same = std::ranges::lower_bound(switching_.switches, switching);
        const Op op = graph.op(switching);
        if (same != switching_.switches.end() && *same == switching) {
            source.decision = static_cast<std::size_t>(same - switching_.switches.begin());
        } else if (op != Op::floor && op != Op::ceil) {
            const Guard guard = guardOf(graph, switching);
            source.orientation = guard.orientation;
            for (std::size_t s = 0; s < switching_.surfaces.size(); ++s)
                if (!switching_.surfaces[s].whole && switching_.surfaces[s].guard == guard.node)
                    source.surface = s;
        }
        derived.sources.push_back(source);
    }
    return derived;
}

// ---------------------------------------------------------------------------------------------
// Conditions

void ComponentModel::deriveConditions(Graph graph, const FoundDirections& directions) {
    const std::size_t count = symbols_.multipliers;
    const std::span<const Node> multipliers = std::span(symbols_.all).last(count);
    const std::span<const Node> states = std::span(symbols_.all).subspan(1, symbols_.states);
    std::vector<Node> gaps, rates, seconds, system, moves;
    std::unordered_map<std::uint32_t, Node> without;
    for (std::size_t r = 0; r < count; ++r) {
        gaps.push_back(conditionNodes_[3 * r]);
        rates.push_back(conditionNodes_[3 * r + 1]);
        seconds.push_back(conditionNodes_[3 * r + 2]);
        without.emplace(multipliers[r].index, graph.constant(0));
    }
    const auto add = [](std::vector<Entry>& entries, std::size_t row, std::size_t column) {
        entries.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)});
    };
    for (std::size_t r = 0; r < count; ++r)
        conditions_.isTie.push_back(graph.isConstant(rates[r], 0) && !graph.isConstant(gaps[r], 0));
    const auto matrix = expression::gradients(graph, seconds, multipliers);
    std::vector<Node> ties;
    for (std::size_t r = 0; r < count; ++r)
        for (const auto& [column, derivative] : matrix[r]) {
            const bool isOfTie = conditions_.isTie[column] != 0;
            add(isOfTie ? conditions_.ofTies : conditions_.matrix, r, column);
            (isOfTie ? ties : system).push_back(derivative);
        }
    const std::vector<Node> rests = expression::substitute(graph, seconds, without);
    for (std::size_t r = 0; r < count; ++r)
        system.push_back(conditions_.isTie[r] != 0 ? graph.constant(0) : rests[r]);

    const std::span<const Node> slopes = std::span(outputs_).first(symbols_.states);
    const auto pushes = expression::gradients(graph, slopes, multipliers);
    std::vector<Node> configuration; // rates of places and attitudes: velocities' are long
    for (const std::size_t i : structure_.configuration)
        configuration.push_back(slopes[i]);
    const auto ofStates = expression::gradients(graph, configuration, states);
    for (std::size_t i = 0; i < symbols_.states; ++i)
        for (const auto& [column, derivative] : pushes[i]) {
            add(conditions_.pushes, i, column);
            moves.push_back(derivative);
        }
    for (std::size_t place = 0; place < configuration.size(); ++place) {
        const std::size_t i = structure_.configuration[place];
        std::vector<std::optional<Node>> shift(count);
        for (const auto& [column, push] : pushes[i]) // a condition of first order
            shift[column] = push;
        for (const auto& [k, derivative] : ofStates[place])
            for (const auto& [column, push] : pushes[k]) {
                const Node part = graph.multiply(derivative, push);
                shift[column] = shift[column] ? graph.add(*shift[column], part) : part;
            }
        for (std::size_t column = 0; column < count; ++column)
            if (shift[column]) {
                add(conditions_.shifts, i, column);
                moves.push_back(*shift[column]);
            }
    }
    conditions_.second = derive(graph, system);
    if (!directions.all.empty()) {
        const auto [nodes, symbols] = withSymbols(graph, directions, system);
        directions_.second = derive(graph, nodes, symbols);
    }
    conditions_.ties = derive(graph, ties);
    gaps.insert(gaps.end(), rates.begin(), rates.end());
    gaps.insert(gaps.end(), besideNodes_.begin(), besideNodes_.end());
    conditions_.gaps = derive(graph, gaps);
    conditions_.moves = derive(graph, moves);
}

// ---------------------------------------------------------------------------------------------
// Directions

// Some state that its parts read has a rate that reads it: it can hold itself at 0.
bool ComponentModel::actsOnItself(const Direction& direction) const {
    std::vector<Node> parts;
    for (const Direction::Part& part : direction.parts)
        parts.push_back(part.node);
    return std::ranges::any_of(expression::symbolsOf(graph_, parts), [&](Node symbol) {
        const auto place = placeOf(symbol);
        if (!place || *place < 1 || *place > symbols_.states)
            return false;
        const auto nodes = expression::reachable(graph_, std::span(&outputs_[*place - 1], 1));
        return std::ranges::find(nodes, direction.length) != nodes.end();
    });
}

// Two lengths of the same parts are one; parts that others have too are in none but the first.
ComponentModel::FoundDirections ComponentModel::foundDirections(Graph& graph) const {
    const auto isNumber = [&](Node n) {
        const auto place = placeOf(n);
        return graph.op(n) == Op::constant ||
               (place && *place >= variables() && *place < variables() + constants());
    };
    FoundDirections found;
    for (const Node length : lengthsDividedBy(graph, outputs_)) {
        const auto direction = directionOf(graph, length, isNumber);
        if (!direction || !actsOnItself(*direction))
            continue;
        const auto has = [&](const Direction& other, bool all) {
            const auto isIn = [&](const Direction::Part& part) {
                return std::ranges::find(other.parts, part.node, &Direction::Part::node) !=
                       other.parts.end();
            };
            return all ? std::ranges::all_of(direction->parts, isIn)
                       : std::ranges::any_of(direction->parts, isIn);
        };
        const auto shares = std::ranges::find_if(
            found.all, [&](const Direction& other) { return has(other, false); });
        if (shares == found.all.end()) {
            found.lengths.emplace_back(length, found.all.size());
            found.all.push_back(*direction);
        } else if (has(*shares, true) && shares->parts.size() == direction->parts.size()) {
            found.lengths.emplace_back(length,
                                       static_cast<std::size_t>(shares - found.all.begin()));
        }
    }
    return found;
}

std::pair<std::vector<Node>, std::vector<Node>>
ComponentModel::withSymbols(Graph& graph, const FoundDirections& found,
                            std::span<const Node> nodes) const {
    std::vector<Node> symbols;
    std::unordered_map<std::uint32_t, Node> replacements;
    for (const Direction& direction : found.all)
        for (const Direction::Part& part : direction.parts) {
            symbols.push_back(graph.symbol("a" + std::to_string(symbols.size())));
            replacements.emplace(part.node.index, symbols.back());
            if (graph.op(part.node) == Op::subtract) {
                const std::vector<Node> terms(graph.arguments(part.node).begin(),
                                              graph.arguments(part.node).end());
                replacements.emplace(graph.subtract(terms[1], terms[0]).index,
                                     graph.negate(symbols.back()));
            }
        }
    const std::size_t parts = symbols.size();
    for (std::size_t d = 0; d < found.all.size(); ++d)
        symbols.push_back(graph.symbol("l" + std::to_string(d)));
    std::vector<Node> divided;
    for (const auto& [length, direction] : found.lengths) {
        divided.push_back(length);
        replacements.emplace(length.index, symbols[parts + direction]);
    }
    return {withDirections(graph, nodes, divided, replacements), symbols};
}

void ComponentModel::deriveDirections(Graph graph, const FoundDirections& found) {
    std::vector<Node> parts, weights;
    for (const Direction& direction : found.all) {
        directions_.ranges.push_back({parts.size(), direction.parts.size()});
        directions_.lengths.push_back(direction.length);
        for (const Direction::Part& part : direction.parts) {
            parts.push_back(part.node);
            weights.push_back(part.weight ? *part.weight : graph.constant(1));
            directions_.gradients.push_back(gradientOf(part.node));
        }
    }
    directions_.parts = parts.size();
    const auto [outputs, symbols] = withSymbols(graph, found, outputs_);
    directions_.outputs = derive(graph, outputs, symbols);
    std::vector<Node> measures = parts;
    measures.insert(measures.end(), weights.begin(), weights.end());
    measures.insert(measures.end(), directions_.lengths.begin(), directions_.lengths.end());
    directions_.measures = derive(graph, measures);
}

std::string ComponentModel::print() const {
    std::string text;
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        text += (i < symbols_.states ? "y" + std::to_string(i) + "' = "
                                     : "h" + std::to_string(i - symbols_.states) + " = ") +
                expression::print(graph_, outputs_[i]) + "\n";
    return text;
}

std::string ComponentModel::printJacobian() const {
    Graph graph = graph_;
    const auto rows = expression::gradients(graph, std::span(outputs_).first(symbols_.states),
                                            std::span(symbols_.all).subspan(1, symbols_.states));
    std::string text;
    for (std::size_t row = 0; row < symbols_.states; ++row)
        for (const auto& [state, derivative] : rows[row])
            text += "dy" + std::to_string(row) + "'/dy" + std::to_string(state) + " = " +
                    expression::print(graph, derivative) + "\n";
    return text;
}

// ---------------------------------------------------------------------------------------------
// Models by content

std::size_t ComponentModels::Hash::operator()(const ComponentModel::Key& key) const {
    std::uint64_t hash = key.size();
    for (const std::uint32_t word : key)
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u + (hash >> 29);
    return hash;
}

std::shared_ptr<const ComponentModel> ComponentModels::of(const ComponentModel::Key& key) {
    const std::scoped_lock lock(mutex_);
    Known& known = models_[key];
    known.asked = ++asked_;
    if (known.model)
        return known.model;
    auto model = known.model = std::make_shared<const ComponentModel>(key);
    ++made_;
    words_ += key.size();
    if (words_ > room_)
        forgetUnused();
    return model;
}

std::size_t ComponentModels::size() const {
    const std::scoped_lock lock(mutex_);
    return models_.size();
}

std::size_t ComponentModels::made() const {
    const std::scoped_lock lock(mutex_);
    return made_;
}

void ComponentModels::forgetUnused() {
    std::vector<std::pair<std::size_t, const ComponentModel::Key*>> unused; // by when
    for (const auto& [key, known] : models_)
        if (known.model.use_count() == 1)
            unused.emplace_back(known.asked, &key);
    std::ranges::sort(unused, {}, &std::pair<std::size_t, const ComponentModel::Key*>::first);
    for (const auto& [asked, key] : unused) {
        if (2 * words_ <= room_)
            return;
        words_ -= key->size();
        models_.erase(models_.find(*key));
    }
}

} // namespace solution
