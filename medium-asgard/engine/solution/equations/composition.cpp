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

// Writes the values of one block as a model whose held values they are.
class Composer::Writer {
public:
    Writer(const expression::EquationSet& set, const UnknownIndex& index, const ZeroStates& zero)
        : writer_(set.graph, zero, [&](Node n) { return symbol(set, index, zero, n); }) {}

    // False: it is 0, and none of the values.
    [[nodiscard]] bool write(Node node) {
        const Operand value = writer_.operandOf(node);
        if (!value.is(0))
            outputs_.push_back(writer_.entryOf(value));
        return !value.is(0);
    }
    void writeEven0(Node node) { outputs_.push_back(writer_.entryOf(writer_.operandOf(node))); }
    [[nodiscard]] std::size_t size() const { return outputs_.size(); }
    [[nodiscard]] const std::vector<Node>& symbols() const { return symbols_; }
    [[nodiscard]] Composition::Values values(ComponentModels& models) const {
        ComponentModel::Key key{0, static_cast<std::uint32_t>(outputs_.size()), 0};
        key.insert(key.end(), writer_.key().begin(), writer_.key().end());
        key.push_back(key::outputs);
        key.insert(key.end(), outputs_.begin(), outputs_.end());
        return {.model = models.of(key), .constants = writer_.constants(), .in = {}};
    }

private:
    Operand symbol(const expression::EquationSet& set, const UnknownIndex& index,
                   const ZeroStates& zero, Node n) {
        if (n == set.time) {
            symbols_.push_back(n);
            return writer_.leaf(key::time);
        }
        if (zero.contains(index.of(n).value()))
            return KeyWriter::number(0);
        symbols_.push_back(n);
        return writer_.leaf(key::input);
    }
    std::vector<Node> symbols_; // in the order of the model's inputs; the time among them
    std::vector<std::uint32_t> outputs_;
    KeyWriter writer_;
};

void Composer::writePlaces(Writer& writer, std::span<const Row> rows, std::size_t row) {
    const std::size_t count = rows.size();
    const auto write = [&](Node node, std::size_t place) {
        writer.writeEven0(node);
        made_.ofPlaces.push_back(static_cast<std::uint32_t>(place));
    };
    const expression::Condition& of = *rows[row].condition;
    if (of.gap)
        write(*of.gap, row);
    write(*of.rate, count + row);
    for (std::size_t k = 0; k < of.valid.size(); ++k)
        write(of.valid[k], 2 * count + made_.conditions.firstValid[row] + k);
    for (std::size_t k = 0; k < rows[row].levers.size(); ++k)
        write(rows[row].levers[k], 2 * count + made_.conditions.firstLever[row] + k);
}

bool Composer::writeMotion(Writer& writer, const expression::ConditionParts& parts, std::size_t row,
                           const StateOf& stateOf) {
    const auto number = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    const auto next = [&] { return number(made_.motionValues + writer.size() - 1); };
    if (writer.write(parts.steady))
        made_.steady.push_back({number(row), next()});
    for (auto [terms, factors] : {std::pair(&made_.by, &parts.by), {&made_.pushes, &parts.pushes}})
        for (const auto& [symbol, factor] : *factors) {
            const auto state = stateOf(symbol);
            if (writer.write(factor)) {
                if (!state) // what stays 0 is pushed by nothing
                    return false;
                terms->push_back({number(row), *state, next()});
            }
        }
    return true;
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
        Writer motion(set, index, zero), places(set, index, zero);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const expression::ConditionParts& parts = *rows[r].condition->parts;
            if (parts.owner != owner)
                continue;
            if (!writeMotion(motion, parts, r, stateOf))
                return false;
            writePlaces(places, rows, r);
        }
        made_.motionValues += motion.size();
        for (const auto& [writer, list] :
             {std::pair(&motion, &made_.motion), {&places, &made_.places}}) {
            list->push_back(writer->values(models));
            if (!list->back().model->surfaces().empty())
                return false;
            read_.push_back(writer->symbols());
            symbols_.insert(symbols_.end(), read_.back().begin(), read_.back().end());
        }
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
    std::size_t block = 0;
    for (std::size_t i = 0; i < made_.motion.size(); ++i)
        for (Composition::Values* const values : {&made_.motion[i], &made_.places[i]})
            for (const Node symbol : read_[block++])
                if (const std::uint32_t place = placeOf(symbol); place != 0) // the time is first
                    values->in.push_back(place);
    const auto count = static_cast<int>(model.states());
    for (int column = 0; column <= count; ++column)
        made_.jacobian.columnStarts.push_back(column * count);
    for (int column = 0; column < count; ++column)
        for (int row = 0; row < count; ++row)
            made_.jacobian.rows.push_back(row);
    return std::move(made_);
}

} // namespace solution
