#include "equations/bound_model.h"

#include "equations/key_writer.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace solution {

using expression::Node;
using Operand = KeyWriter::Operand;

namespace {

// Writes the key of a component's expressions.
class Reader {
public:
    Reader(const expression::EquationSet& set, const UnknownIndex& index, const ZeroStates& zero,
           std::span<const std::size_t> unknowns, std::span<const std::size_t> phases)
        : set_(set), index_(index), zero_(zero), unknowns_(unknowns), phases_(phases),
          writer_(set.graph, zero, [this](Node n) { return symbol(n); }) {}

    BoundModel read(ComponentModels& models, bool mayCompose = true) {
        orderUnknowns();
        if (!bound_.loop.empty())
            return std::move(bound_);
        readLaws();
        Composer composer;
        isComposed_ = mayCompose && compose(composer, models);
        writer_.add({static_cast<std::uint32_t>(bound_.states.size()),
                     static_cast<std::uint32_t>(bound_.held.size()),
                     isComposed_ ? 0 : static_cast<std::uint32_t>(bound_.multipliers.size())});
        for (const std::size_t place : bound_.states)
            writer_.add({set_.unknowns[unknowns_[place]].lengthPerUnit > 0});
        std::vector<std::uint32_t> outputs;
        for (const std::size_t place : bound_.held) {
            const Operand value = writer_.operandOf(*phaseOf(place).given);
            writer_.put(set_.unknowns[unknowns_[place]].symbol, value);
            outputs.push_back(writer_.entryOf(value));
        }
        std::vector<std::uint32_t> rates;
        for (const std::size_t place : bound_.states)
            rates.push_back(entryOf(phaseOf(place).derivative));
        const std::vector<std::uint32_t> conditions =
            isComposed_ ? std::vector<std::uint32_t>() : readConditions();
        for (const Node symbol : composer.symbols())
            (void)writer_.operandOf(symbol); // a place for each
        writer_.add({key::outputs});
        for (const auto& words : {rates, outputs, conditions})
            writer_.add(words);
        bound_.model = models.of(writer_.key());
        bound_.constants = writer_.constants();
        bound_.canPeak = bound_.model->canPeak(bound_.constants);
        if (isComposed_ && bound_.model->isSwitching())
            return Reader(set_, index_, zero_, unknowns_, phases_).read(models, false);
        if (isComposed_)
            bound_.composed = std::make_shared<const Composition>(
                std::move(composer).finish(*bound_.model, [this](Node n) { return inOf(n); }));
        return std::move(bound_);
    }

private:
    // Values that are held may read multipliers in any way.
    [[nodiscard]] bool compose(Composer& composer, ComponentModels& models) const {
        if (bound_.multipliers.size() < leastComposed || !bound_.held.empty())
            return false;
        std::vector<Composer::Row> rows;
        for (std::size_t row = 0; row < bound_.multipliers.size(); ++row)
            rows.push_back({&*phaseOf(bound_.multipliers[row]).condition, levers_[row]});
        const auto stateOf = [this](Node symbol) -> std::optional<std::uint32_t> {
            const auto unknown = index_.of(symbol);
            const auto place = unknown ? placeOf(*unknown) : std::nullopt;
            if (!place || zero_.contains(*unknown))
                return std::nullopt;
            assert(!phaseOf(*place).condition && "parts read no multipliers");
            return stateOf_[*place];
        };
        return composer.compose(set_, index_, zero_, rows, stateOf, models);
    }

    // The place among the symbols of the model.
    [[nodiscard]] std::uint32_t inOf(Node symbol) const {
        if (symbol == set_.time)
            return 0;
        const std::size_t unknown = index_.of(symbol).value();
        if (const auto place = placeOf(unknown))
            return 1 + stateOf_[*place];
        const auto input = std::ranges::find(bound_.inputs, unknown) - bound_.inputs.begin();
        return static_cast<std::uint32_t>(1 + bound_.states.size()) +
               static_cast<std::uint32_t>(input);
    }

    std::uint32_t entryOf(const Node node) { return writer_.entryOf(writer_.operandOf(node)); }

    void readLaws() {
        levers_.assign(bound_.multipliers.size(), {});
        for (const std::size_t place : bound_.multipliers) {
            const expression::Condition& of = *phaseOf(place).condition;
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
        }
    }

    // Of each multiplier its gap, the gap's rate, and the rate's.
    std::vector<std::uint32_t> readConditions() {
        std::vector<std::uint32_t> entries;
        for (const std::size_t place : bound_.multipliers) {
            const expression::Phase& phase = phaseOf(place);
            for (const auto& node : {phase.condition->gap, phase.condition->rate})
                entries.push_back(node ? entryOf(*node) : writer_.entryOf(KeyWriter::number(0)));
            entries.push_back(entryOf(phase.derivative));
        }
        const auto add = [&](const std::vector<Node>& nodes) {
            entries.push_back(static_cast<std::uint32_t>(nodes.size()));
            for (const Node node : nodes)
                entries.push_back(entryOf(node));
        };
        for (const std::size_t place : bound_.multipliers)
            add(phaseOf(place).condition->valid);
        for (const std::vector<Node>& levers : levers_)
            add(levers);
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

    Operand symbol(Node n) {
        if (n == set_.time)
            return writer_.leaf(key::time);
        const auto unknown = index_.of(n);
        assert(unknown && "equations read unknowns and time only");
        if (zero_.contains(*unknown))
            return KeyWriter::number(0);
        if (const auto place = placeOf(*unknown)) { // held ones are done
            const bool isMultiplier = phaseOf(*place).condition.has_value();
            if (isMultiplier && isComposed_) // blocks push rates
                return KeyWriter::number(0);
            return writer_.leaf(isMultiplier ? key::multiplier : key::state, stateOf_[*place]);
        }
        bound_.inputs.push_back(*unknown);
        return writer_.leaf(key::input);
    }

    const expression::EquationSet& set_;
    const UnknownIndex& index_;
    const ZeroStates& zero_;
    std::span<const std::size_t> unknowns_, phases_;
    BoundModel bound_;
    KeyWriter writer_;
    bool isComposed_ = false;
    std::vector<std::uint32_t> stateOf_;    // by place: which state or multiplier it is
    std::vector<std::vector<Node>> levers_; // by multiplier: of its disc
};

} // namespace

BoundModel boundModel(const expression::EquationSet& set, const UnknownIndex& index,
                      const ZeroStates& zero, std::span<const std::size_t> unknowns,
                      std::span<const std::size_t> phases, ComponentModels& models) {
    return Reader(set, index, zero, unknowns, phases).read(models);
}

} // namespace solution
