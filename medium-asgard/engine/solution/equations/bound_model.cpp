#include "equations/bound_model.h"

#include "expression/operation.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

// Numbers for a few nodes of a large graph.
template <class Value> class Table {
public:
    Table() : slots_(128, {none, {}}) {}
    [[nodiscard]] const Value* find(std::uint64_t key) const {
        for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
            if (slots_[i].first == key)
                return &slots_[i].second;
            if (slots_[i].first == none)
                return nullptr;
        }
    }
    void insert(std::uint64_t key, Value value) {
        if (2 * ++count_ > slots_.size()) {
            std::vector<std::pair<std::uint64_t, Value>> old(2 * slots_.size(), {none, {}});
            old.swap(slots_);
            for (const auto& slot : old)
                if (slot.first != none)
                    place(slot);
        }
        place({key, value});
    }

private:
    // No bits of a finite number and no index of a node.
    static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    [[nodiscard]] std::size_t start(std::uint64_t key) const {
        return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) & (slots_.size() - 1);
    }
    void place(const std::pair<std::uint64_t, Value>& slot) {
        std::size_t i = start(slot.first);
        while (slots_[i].first != none)
            i = (i + 1) & (slots_.size() - 1);
        slots_[i] = slot;
    }
    std::vector<std::pair<std::uint64_t, Value>> slots_;
    std::size_t count_ = 0;
};

// Writes the key of a component's expressions, arguments before what reads them.
class Reader {
public:
    Reader(const expression::EquationSet& set, const UnknownIndex& index, const ZeroStates& zero,
           std::span<const std::size_t> unknowns, std::span<const std::size_t> phases)
        : set_(set), index_(index), zero_(zero), unknowns_(unknowns), phases_(phases) {}

    BoundModel read(ComponentModels& models) {
        orderUnknowns();
        if (!bound_.loop.empty())
            return std::move(bound_);
        key_ = {static_cast<std::uint32_t>(bound_.states.size()),
                static_cast<std::uint32_t>(bound_.held.size()),
                static_cast<std::uint32_t>(bound_.multipliers.size())};
        for (const std::size_t place : bound_.states)
            key_.push_back(set_.unknowns[unknowns_[place]].lengthPerUnit > 0);
        std::vector<std::uint32_t> outputs;
        for (const std::size_t place : bound_.held) {
            const Operand value = operandOf(*phaseOf(place).given);
            done_.insert(set_.unknowns[unknowns_[place]].symbol.index, value);
            outputs.push_back(entryOf(value));
        }
        std::vector<std::uint32_t> rates;
        for (const std::size_t place : bound_.states)
            rates.push_back(entryOf(operandOf(phaseOf(place).derivative)));
        const std::vector<std::uint32_t> conditions = readConditions();
        key_.push_back(key::outputs);
        key_.insert(key_.end(), rates.begin(), rates.end());
        key_.insert(key_.end(), outputs.begin(), outputs.end());
        key_.insert(key_.end(), conditions.begin(), conditions.end());
        bound_.model = models.of(key_);
        bound_.canPeak = bound_.model->canPeak(bound_.constants);
        return std::move(bound_);
    }

private:
    // A number, or an entry of the key.
    struct Operand {
        bool isNumber = false;
        double number = 0;
        std::uint32_t entry = 0;
        [[nodiscard]] bool is(double value) const { return isNumber && number == value; }
    };
    static Operand number(double value) { return {true, value, 0}; }

    // Of each multiplier its gap, the gap's rate, and the rate's.
    std::vector<std::uint32_t> readConditions() {
        std::vector<std::uint32_t> entries;
        levers_.assign(bound_.multipliers.size(), {});
        for (const std::size_t place : bound_.multipliers) {
            const expression::Phase& phase = phaseOf(place);
            const expression::Condition& of = *phase.condition;
            const bool isBounded = of.low > -infinity || of.high < infinity;
            BoundModel::Law law{of.low,
                                of.high,
                                of.restitution,
                                of.resolution,
                                of.gap && isBounded,
                                of.rate.has_value()};
            if (of.release)
                if (const auto unknown = index_.of(*of.release))
                    law.release = placeOf(*unknown);
            law.leaving = of.leaving;
            law.hop = of.hop;
            if (of.patch)
                law.patch = of.patch->index;
            if (of.friction)
                law.disc = discOf(*of.friction);
            bound_.laws.push_back(law);
            for (const auto& node : {phase.condition->gap, phase.condition->rate})
                entries.push_back(entryOf(node ? operandOf(*node) : number(0)));
            entries.push_back(entryOf(operandOf(phase.derivative)));
        }
        for (const std::size_t place : bound_.multipliers) {
            const std::vector<Node>& valid = phaseOf(place).condition->valid;
            entries.push_back(static_cast<std::uint32_t>(valid.size()));
            for (const Node node : valid)
                entries.push_back(entryOf(operandOf(node)));
        }
        for (std::size_t row = 0; row < bound_.multipliers.size(); ++row) {
            const std::vector<Node>& levers = levers_[row];
            entries.push_back(static_cast<std::uint32_t>(levers.size()));
            for (const Node node : levers)
                entries.push_back(entryOf(operandOf(node)));
        }
        return entries;
    }

    // The same one for all of its rows.
    std::size_t discOf(const expression::Friction& friction) {
        BoundModel::Disc disc{.rows = multipliersOf(friction.rows),
                              .normals = multipliersOf(friction.normals),
                              .sticking = friction.sticking,
                              .sliding = friction.sliding};
        // A disc that does not turn acts at one point.
        disc.hasLevers = !friction.levers.empty() && disc.rows.size() > 1 &&
                         multiplierOf(friction.rows.back()).has_value();
        const auto known = std::ranges::find(bound_.discs, disc);
        const auto place = static_cast<std::size_t>(known - bound_.discs.begin());
        if (known != bound_.discs.end())
            return place;
        for (std::size_t i = 0; disc.hasLevers && i < friction.normals.size(); ++i)
            if (const auto normal = multiplierOf(friction.normals[i]))
                for (std::size_t k = 0; k + 1 < friction.rows.size(); ++k)
                    if (multiplierOf(friction.rows[k]))
                        levers_[*normal].push_back(friction.levers[i][k]);
        bound_.discs.push_back(std::move(disc));
        return place;
    }
    // None of those that stay 0.
    [[nodiscard]] std::optional<std::size_t> multiplierOf(Node symbol) const {
        const auto unknown = index_.of(symbol);
        if (!unknown || zero_.contains(*unknown))
            return std::nullopt;
        const auto place = placeOf(*unknown);
        if (!place || !phaseOf(*place).condition)
            return std::nullopt;
        return stateOf_[*place];
    }
    [[nodiscard]] std::vector<std::size_t> multipliersOf(std::span<const Node> symbols) const {
        std::vector<std::size_t> found;
        for (const Node symbol : symbols)
            if (const auto multiplier = multiplierOf(symbol))
                found.push_back(*multiplier);
        return found;
    }

    [[nodiscard]] const expression::Phase& phaseOf(std::size_t place) const {
        return set_.unknowns[unknowns_[place]].phases[phases_[place]];
    }
    [[nodiscard]] std::optional<std::size_t> placeOf(std::size_t unknown) const {
        const auto at = std::ranges::lower_bound(unknowns_, unknown);
        if (at == unknowns_.end() || *at != unknown)
            return std::nullopt;
        return static_cast<std::size_t>(at - unknowns_.begin());
    }

    // Held unknowns after those that they read.
    void orderUnknowns() {
        std::vector<std::size_t> waiting;
        stateOf_.assign(unknowns_.size(), 0);
        for (std::size_t i = 0; i < unknowns_.size(); ++i)
            if (phaseOf(i).given) {
                waiting.push_back(i);
            } else if (phaseOf(i).condition) {
                stateOf_[i] = static_cast<std::uint32_t>(bound_.multipliers.size());
                bound_.multipliers.push_back(i);
            } else {
                stateOf_[i] = static_cast<std::uint32_t>(bound_.states.size());
                bound_.states.push_back(i);
            }
        std::vector<std::vector<std::size_t>> reads(unknowns_.size()); // places of held ones
        for (const std::size_t i : waiting) {
            const Node given = *phaseOf(i).given;
            for (const Node symbol : zero_.symbolsLeft(set_.graph, {&given, 1}))
                if (const auto unknown = index_.of(symbol))
                    if (const auto place = placeOf(*unknown); place && phaseOf(*place).given)
                        reads[i].push_back(*place);
        }
        std::vector<bool> ordered(unknowns_.size(), false);
        while (!waiting.empty()) {
            const auto ready = std::ranges::find_if(waiting, [&](std::size_t i) {
                return std::ranges::all_of(reads[i], [&](std::size_t j) { return ordered[j]; });
            });
            if (ready == waiting.end()) {
                bound_.loop = waiting;
                return;
            }
            ordered[*ready] = true;
            bound_.held.push_back(*ready);
            waiting.erase(ready);
        }
    }

    // Arguments first, on an own stack: expressions may be deep.
    Operand operandOf(Node root) {
        stack_.assign(1, root);
        while (!stack_.empty()) {
            const Node n = stack_.back();
            if (done_.find(n.index)) {
                stack_.pop_back();
                continue;
            }
            const std::size_t size = stack_.size();
            if (!zero_.isZero(n))
                for (const Node argument : set_.graph.arguments(n))
                    if (!done_.find(argument.index))
                        stack_.push_back(argument);
            if (stack_.size() > size)
                continue;
            stack_.pop_back();
            done_.insert(n.index, zero_.isZero(n) ? number(0) : made(n));
        }
        return *done_.find(root.index);
    }

    Operand made(Node n) {
        const Op op = set_.graph.op(n);
        if (op == Op::constant)
            return number(set_.graph.value(n));
        if (op == Op::symbol)
            return symbol(n);
        if (op == Op::parameter) {
            bound_.constants.push_back(set_.graph.value(n));
            return leaf(key::constant);
        }
        std::array<Operand, 3> a;
        const auto arguments = set_.graph.arguments(n);
        bool allNumbers = true;
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            a[k] = *done_.find(arguments[k].index);
            allNumbers = allNumbers && a[k].isNumber;
        }
        if (allNumbers) {
            const double value = expression::compute(op, a[0].number, a[1].number, a[2].number);
            if (std::isfinite(value))
                return number(value);
        }
        if (const auto shorter = shortened(op, a))
            return *shorter;
        return operation(op, a, arguments.size());
    }

    // What a 0 in the place of an unknown leaves, so that numbers beside it meet and fold.
    static std::optional<Operand> shortened(Op op, const std::array<Operand, 3>& a) {
        if (op == Op::add && (a[0].is(0) || a[1].is(0)))
            return a[a[0].is(0) ? 1 : 0];
        if (op == Op::subtract && a[1].is(0))
            return a[0];
        if (op == Op::multiply && (a[0].is(0) || a[1].is(0)))
            return number(0);
        if (op == Op::multiply && (a[0].is(1) || a[1].is(1)))
            return a[a[0].is(1) ? 1 : 0];
        return std::nullopt;
    }

    Operand operation(Op op, const std::array<Operand, 3>& a, std::size_t count) {
        std::array<std::uint32_t, 3> entries{};
        for (std::size_t k = 0; k < count; ++k)
            entries[k] =
                op == Op::power && k == 1 && a[k].isNumber ? literal(a[k].number) : entryOf(a[k]);
        key_.push_back(static_cast<std::uint32_t>(op));
        key_.insert(key_.end(), entries.begin(), entries.begin() + static_cast<long>(count));
        return {false, 0, entries_++};
    }

    Operand symbol(Node n) {
        if (n == set_.time)
            return leaf(key::time);
        const auto unknown = index_.of(n);
        assert(unknown && "equations read unknowns and time only");
        if (zero_.contains(*unknown))
            return number(0);
        if (const auto place = placeOf(*unknown)) // held ones are done
            return leaf(phaseOf(*place).condition ? key::multiplier : key::state, stateOf_[*place]);
        bound_.inputs.push_back(*unknown);
        return leaf(key::input);
    }

    Operand leaf(std::uint32_t kind, std::optional<std::uint32_t> which = {}) {
        key_.push_back(kind);
        if (which)
            key_.push_back(*which);
        return {false, 0, entries_++};
    }

    std::uint32_t literal(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        key_.insert(key_.end(),
                    {static_cast<std::uint32_t>(Op::constant), static_cast<std::uint32_t>(bits),
                     static_cast<std::uint32_t>(bits >> 32)});
        return entries_++;
    }

    std::uint32_t entryOf(const Operand& operand) {
        if (!operand.isNumber)
            return operand.entry;
        const double value = operand.number;
        const auto bits = std::bit_cast<std::uint64_t>(value);
        if (const auto* known = numbers_.find(bits))
            return *known;
        std::uint32_t entry = 0;
        if (value == 0 || std::abs(value) == 1) {
            entry = literal(value);
        } else {
            bound_.constants.push_back(value);
            entry = leaf(key::constant).entry;
        }
        numbers_.insert(bits, entry);
        return entry;
    }

    const expression::EquationSet& set_;
    const UnknownIndex& index_;
    const ZeroStates& zero_;
    std::span<const std::size_t> unknowns_, phases_;
    BoundModel bound_;
    ComponentModel::Key key_;
    std::uint32_t entries_ = 0;
    std::vector<std::uint32_t> stateOf_;    // by place: which state or multiplier it is
    std::vector<std::vector<Node>> levers_; // by multiplier: of its disc
    std::vector<Node> stack_;
    Table<Operand> done_;          // by node
    Table<std::uint32_t> numbers_; // by bits
};

} // namespace

BoundModel boundModel(const expression::EquationSet& set, const UnknownIndex& index,
                      const ZeroStates& zero, std::span<const std::size_t> unknowns,
                      std::span<const std::size_t> phases, ComponentModels& models) {
    return Reader(set, index, zero, unknowns, phases).read(models);
}

} // namespace solution
