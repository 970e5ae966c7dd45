#include "equations/composition.h"

#include "equations/key_writer.h"
#include "equations/partition.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace solution {

using expression::Node;
using Operand = KeyWriter::Operand;

// Writes the model of one block.
class Composer::Writer {
public:
    using Places = std::vector<std::uint32_t>;
    using Input = std::pair<std::uint32_t, Node>; // among inputs

    Writer(const expression::EquationSet& set, const UnknownIndex& index, const ZeroStates& zero,
           const StateOf& stateOf)
        : stateOf_(stateOf),
          writer_(set.graph, zero, [&](Node n) { return symbol(set, index, zero, n); }) {}

    [[nodiscard]] Operand operandOf(Node node) { return writer_.operandOf(node); }
    [[nodiscard]] std::optional<std::uint32_t> stateOf(Node node) const { return stateOf_(node); }
    // Its number among the held values.
    std::uint32_t hold(const Operand& value) {
        held_.push_back(writer_.entryOf(value));
        return static_cast<std::uint32_t>(held_.size() - 1);
    }
    // To the second rate of the row that is written: a factor of the rate of a state.
    void addTo(Operand& second, const Operand& factor, std::uint32_t state) {
        auto known = std::ranges::find(rates_, state, &Composition::Block::Symbol::of);
        if (known == rates_.end()) {
            ofRates_.push_back(writer_.leaf(key::input));
            known = rates_.insert(rates_.end(), {inputCount_++, state});
        }
        const auto which = static_cast<std::size_t>(known - rates_.begin());
        second = sum(second, product(factor, ofRates_[which]));
    }
    // To the rate of a state, what the multiplier of this row pushes.
    void push(std::uint32_t state, const Operand& factor) {
        if (!multiplier_)
            multiplier_ = writer_.leaf(key::multiplier, static_cast<std::uint32_t>(rows_.size()));
        Operand& rate = pushed_[placeOf(state)];
        rate = sum(rate, product(factor, *multiplier_));
    }
    void endRow(std::uint32_t row, const Row& of, const Operand& second) {
        const auto write = [&](const Operand& value, Places& entries) {
            entries.push_back(writer_.entryOf(value));
        };
        write(of.condition->gap ? operandOf(*of.condition->gap) : KeyWriter::number(0), ofRows_);
        write(operandOf(*of.condition->rate), ofRows_);
        write(second, ofRows_);
        for (auto [nodes, entries] :
             {std::pair(std::span<const Node>(of.condition->valid), &valid_),
              {of.levers, &levers_}}) {
            entries->push_back(static_cast<std::uint32_t>(nodes.size()));
            for (const Node node : nodes)
                write(operandOf(node), *entries);
        }
        multiplier_.reset();
        rows_.push_back(row);
    }
    // The places of its symbols are those of its states and inputs until they are numbered.
    [[nodiscard]] Composition::Block block(ComponentModels& models) {
        ComponentModel::Key key{static_cast<std::uint32_t>(states_.size()),
                                static_cast<std::uint32_t>(held_.size()),
                                static_cast<std::uint32_t>(rows_.size())};
        key.resize(key.size() + states_.size(), 0);
        std::vector<std::uint32_t> rates;
        for (const Operand& rate : pushed_)
            rates.push_back(writer_.entryOf(rate));
        key.insert(key.end(), writer_.key().begin(), writer_.key().end());
        key.push_back(key::outputs);
        for (const auto* const words : {&rates, &held_, &ofRows_, &valid_, &levers_})
            key.insert(key.end(), words->begin(), words->end());
        return {.model = models.of(key),
                .constants = writer_.constants(),
                .read = {},
                .rates = rates_,
                .states = states_,
                .rows = rows_,
                .gaps = {}};
    }
    [[nodiscard]] const std::vector<Input>& inputs() const { return inputs_; }

private:
    [[nodiscard]] Operand sum(const Operand& a, const Operand& b) {
        return writer_.apply(expression::Op::add, {a, b}, 2);
    }
    [[nodiscard]] Operand product(const Operand& a, const Operand& b) {
        return writer_.apply(expression::Op::multiply, {a, b}, 2);
    }
    // Of a state of the component, among those of the block.
    [[nodiscard]] std::uint32_t placeOf(std::uint32_t state) {
        const auto known = std::ranges::find(states_, state);
        const auto place = static_cast<std::uint32_t>(known - states_.begin());
        if (known == states_.end()) {
            states_.push_back(state);
            pushed_.push_back(KeyWriter::number(0));
        }
        return place;
    }
    Operand symbol(const expression::EquationSet& set, const UnknownIndex& index,
                   const ZeroStates& zero, Node n) {
        if (n == set.time)
            return writer_.leaf(key::time);
        if (zero.contains(index.of(n).value()))
            return KeyWriter::number(0);
        if (const auto state = stateOf_(n))
            return writer_.leaf(key::state, placeOf(*state));
        inputs_.emplace_back(inputCount_++, n);
        return writer_.leaf(key::input);
    }

    const StateOf& stateOf_;
    Places states_, rows_, held_;
    std::vector<Operand> pushed_; // rates of states
    std::vector<Input> inputs_;
    std::vector<Composition::Block::Symbol> rates_; // among inputs
    std::vector<Operand> ofRates_;
    std::uint32_t inputCount_ = 0;
    std::optional<Operand> multiplier_; // of the row that is written
    Places ofRows_, valid_, levers_;    // entries
    KeyWriter writer_;
};

// Values are held ones of the block until it is numbered.
bool Composer::write(Writer& writer, const Row& row, std::size_t place) {
    const auto at = static_cast<std::uint32_t>(place);
    const expression::ConditionParts& parts = *row.condition->parts;
    Operand second = writer.operandOf(parts.steady);
    if (!second.is(0))
        made_.steady.push_back({at, writer.hold(second)});
    for (const auto& [symbol, factor] : parts.by) {
        const Operand value = writer.operandOf(factor);
        if (value.is(0))
            continue;
        const auto state = writer.stateOf(symbol);
        if (!state) // what stays 0 is pushed by nothing
            return false;
        made_.by.push_back({at, *state, writer.hold(value)});
        writer.addTo(second, value, *state);
    }
    for (const auto& [symbol, factor] : parts.pushes) {
        const Operand value = writer.operandOf(factor);
        if (value.is(0))
            continue;
        const auto state = writer.stateOf(symbol);
        if (!state)
            return false;
        made_.pushes.push_back({at, *state, writer.hold(value)});
        writer.push(*state, value);
    }
    writer.endRow(at, row, second);
    return true;
}

// Where its gaps stand among the component's.
void Composer::number(Composition::Block& block) const {
    const ComponentModel::Conditions& all = made_.conditions;
    const auto count = static_cast<std::uint32_t>(all.isTie.size());
    for (const std::uint32_t first : {0u, count})
        for (const std::uint32_t row : block.rows)
            block.gaps.push_back(first + row);
    for (const auto* const firsts : {&all.firstValid, &all.firstLever})
        for (const std::uint32_t row : block.rows)
            for (std::uint32_t k = (*firsts)[row]; k < (*firsts)[row + 1]; ++k)
                block.gaps.push_back(2 * count + k);
}

bool Composer::compose(const expression::EquationSet& set, const UnknownIndex& index,
                       const ZeroStates& zero, std::span<const Row> rows, const StateOf& stateOf,
                       ComponentModels& models) {
    ComponentModel::Conditions& conditions = made_.conditions;
    std::uint32_t beside = 0;
    for (const Row& row : rows) {
        if (!row.condition->parts || !row.condition->rate)
            return false;
        conditions.firstValid.push_back(beside);
        beside += static_cast<std::uint32_t>(row.condition->valid.size());
    }
    conditions.firstValid.push_back(beside);
    for (const Row& row : rows) {
        conditions.firstLever.push_back(beside);
        beside += static_cast<std::uint32_t>(row.levers.size());
    }
    conditions.firstLever.push_back(beside);
    conditions.isTie.assign(rows.size(), 0);

    std::vector<Node> owners;
    for (const Row& row : rows)
        if (std::ranges::find(owners, row.condition->parts->owner) == owners.end())
            owners.push_back(row.condition->parts->owner);
    for (const Node owner : owners) {
        Writer writer(set, index, zero, stateOf);
        const std::array before{made_.steady.size(), made_.by.size(), made_.pushes.size()};
        for (std::size_t r = 0; r < rows.size(); ++r)
            if (rows[r].condition->parts->owner == owner && !write(writer, rows[r], r))
                return false;
        Composition::Block block = writer.block(models);
        if (block.model->isSwitching())
            return false;
        number(block);
        const auto first = static_cast<std::uint32_t>(made_.values + block.states.size());
        for (std::size_t k = before[0]; k < made_.steady.size(); ++k)
            made_.steady[k].value += first;
        for (std::size_t k = before[1]; k < made_.by.size(); ++k)
            made_.by[k].value += first;
        for (std::size_t k = before[2]; k < made_.pushes.size(); ++k)
            made_.pushes[k].value += first;
        made_.values += block.model->outputs().size();
        inputs_.push_back(writer.inputs());
        for (const auto& [place, symbol] : inputs_.back())
            symbols_.push_back(symbol);
        made_.blocks.push_back(std::move(block));
    }
    std::ranges::sort(symbols_);
    symbols_.erase(std::unique(symbols_.begin(), symbols_.end()), symbols_.end());
    return true;
}

// Which entries there are, and of which products.
void Composer::multiply(const ComponentModel& model) {
    using Entries = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;
    using Terms = std::vector<std::vector<std::uint32_t>>; // by state: numbers of terms
    const auto byState = [&](const std::vector<Composition::Term>& terms) {
        Terms of(model.states());
        for (std::uint32_t k = 0; k < terms.size(); ++k)
            of[terms[k].state].push_back(k);
        return of;
    };
    const auto number = [](Entries& entries, std::vector<ComponentModel::Entry>& list) {
        std::uint32_t next = 0;
        for (auto& [place, which] : entries) {
            which = next++;
            list.push_back({place.first, place.second});
        }
    };
    const Terms by = byState(made_.by), pushes = byState(made_.pushes);
    Entries ofMatrix, ofShifts;
    const auto eachOfMatrix = [&](const auto& visit) {
        for (std::size_t state = 0; state < by.size(); ++state)
            for (const std::uint32_t b : by[state])
                for (const std::uint32_t p : pushes[state])
                    visit(std::pair(made_.by[b].row, made_.pushes[p].row), b, p);
    };
    eachOfMatrix([&](const auto& place, std::uint32_t, std::uint32_t) { ofMatrix[place] = 0; });
    number(ofMatrix, made_.conditions.matrix);
    eachOfMatrix([&](const auto& place, std::uint32_t b, std::uint32_t p) {
        made_.matrix.push_back({ofMatrix[place], made_.by[b].value, made_.pushes[p].value});
    });
    std::ranges::stable_sort(made_.matrix, {}, &Composition::Product::into);
    for (const Composition::Term& push : made_.pushes)
        made_.conditions.pushes.push_back({push.state, push.row});
    const std::vector<ComponentModel::Entry>& turning = model.kinematics().entries;
    const auto eachOfShifts = [&](const auto& visit) {
        for (std::uint32_t k = 0; k < turning.size(); ++k)
            for (const std::uint32_t p : pushes[turning[k].column])
                visit(std::pair(turning[k].row, made_.pushes[p].row), k, p);
    };
    eachOfShifts([&](const auto& place, std::uint32_t, std::uint32_t) { ofShifts[place] = 0; });
    number(ofShifts, made_.conditions.shifts);
    eachOfShifts([&](const auto& place, std::uint32_t k, std::uint32_t p) {
        made_.shifts.push_back({ofShifts[place], k, made_.pushes[p].value});
    });
}

Composition Composer::finish(const ComponentModel& model,
                             const std::function<std::uint32_t(Node)>& placeOf) && {
    multiply(model);
    for (std::size_t k = 0; k < made_.blocks.size(); ++k) {
        Composition::Block& block = made_.blocks[k];
        for (const std::uint32_t state : block.states)
            block.read.push_back({static_cast<std::uint32_t>(1 + block.read.size()), 1 + state});
        const auto first = static_cast<std::uint32_t>(1 + block.states.size());
        for (const auto& [place, symbol] : inputs_[k])
            block.read.push_back({first + place, placeOf(symbol)});
        for (auto& [place, state] : block.rates)
            place += first;
    }
    const auto count = static_cast<int>(model.states());
    for (int column = 0; column <= count; ++column)
        made_.jacobian.columnStarts.push_back(column * count);
    for (int column = 0; column < count; ++column)
        for (int row = 0; row < count; ++row)
            made_.jacobian.rows.push_back(row);
    return std::move(made_);
}

} // namespace solution
