#include "solution/condition_reader.h"

#include "equations/prepared_equations.h"
#include "modes/component_equations.h"

#include <algorithm>

namespace solution {

namespace {

constexpr std::size_t mostIntervals = 16; // that are kept

bool isMultiplier(const expression::Unknown& unknown) {
    return std::ranges::any_of(
        unknown.phases, [](const expression::Phase& phase) { return phase.condition.has_value(); });
}

const expression::Phase& inForce(const expression::Unknown& unknown, double time) {
    return unknown.phases[phaseAt(unknown, time)];
}

} // namespace

bool ConditionReader::isWanted(const expression::EquationSet& set) {
    return !set.readings.empty() || std::ranges::any_of(set.unknowns, isMultiplier);
}

ConditionReader::ConditionReader(std::shared_ptr<const expression::EquationSet> set, double start,
                                 std::shared_ptr<ComponentModels> models,
                                 std::shared_ptr<const Histories> histories)
    : set_(std::move(set)), models_(std::move(models)), histories_(std::move(histories)),
      index_(std::make_unique<const UnknownIndex>(*set_)), times_{start} {
    for (const expression::Unknown& unknown : set_->unknowns)
        for (const expression::Phase& phase : unknown.phases)
            if (phase.from > start)
                times_.push_back(phase.from);
    std::ranges::sort(times_);
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

ConditionReader::~ConditionReader() = default;

// ----------------------------------------------------------------------------------- the groups

ConditionReader::Interval& ConditionReader::intervalAt(double time) const {
    const auto after = std::ranges::upper_bound(times_, time);
    const double from = after == times_.begin() ? times_.front() : *(after - 1);
    ++uses_;
    const auto known = std::ranges::find(intervals_, from, &Interval::from);
    if (known != intervals_.end()) {
        known->lastUse = uses_;
        return *known;
    }
    if (intervals_.size() == mostIntervals)
        intervals_.erase(std::ranges::min_element(intervals_, {}, &Interval::lastUse));
    Interval& made = intervals_.emplace_back();
    made.from = from;
    made.lastUse = uses_;
    for (std::size_t m = 0; m < set_->unknowns.size(); ++m)
        if (const auto& condition = inForce(set_->unknowns[m], from).condition) {
            std::vector<expression::Node> nodes;
            for (const auto& node : {condition->gap, condition->rate})
                if (node)
                    nodes.push_back(*node);
            for (const expression::Node symbol : expression::symbolsOf(set_->graph, nodes))
                if (const auto moved = index_->of(symbol))
                    made.multipliersOf[*moved].push_back(m);
        }
    return made;
}

// In the equations that are in force there, and by the conditions that move it.
std::vector<std::size_t> ConditionReader::readsOf(const Interval& interval,
                                                  std::size_t unknown) const {
    const expression::Phase& phase = inForce(set_->unknowns[unknown], interval.from);
    std::vector<expression::Node> nodes{phase.given ? *phase.given : phase.derivative};
    if (phase.condition)
        for (const auto& node : {phase.condition->gap, phase.condition->rate})
            if (node)
                nodes.push_back(*node);
    std::vector<std::size_t> reads;
    for (const expression::Node symbol : expression::symbolsOf(set_->graph, nodes))
        if (const auto read = index_->of(symbol))
            reads.push_back(*read);
    if (const auto moving = interval.multipliersOf.find(unknown);
        moving != interval.multipliersOf.end())
        reads.insert(reads.end(), moving->second.begin(), moving->second.end());
    if (const auto four = index_->quaternionOf(unknown))
        reads.insert(reads.end(), set_->quaternions[*four].begin(), set_->quaternions[*four].end());
    std::ranges::sort(reads);
    reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
    return reads;
}

// Of that unknown, and of all that it reads, directly or through others.
void ConditionReader::findGroups(Interval& interval, std::size_t unknown) const {
    std::unordered_map<std::size_t, std::vector<std::size_t>> reads;
    std::vector<std::size_t> open{unknown}, all;
    while (!open.empty()) {
        const std::size_t u = open.back();
        open.pop_back();
        if (reads.contains(u))
            continue;
        all.push_back(u);
        const auto& own = reads[u] = readsOf(interval, u);
        open.insert(open.end(), own.begin(), own.end());
    }
    std::ranges::sort(all);
    Reads places;
    for (const std::size_t u : all)
        for (std::size_t& read : places.emplace_back(reads[u]))
            read = static_cast<std::size_t>(std::ranges::lower_bound(all, read) - all.begin());
    addSharedSwitches(*set_, *index_, all, interval.from, {}, places);
    for (std::vector<std::size_t>& unknowns : partitionOf(places).components) {
        for (std::size_t& u : unknowns)
            u = all[u];
        std::vector<std::size_t> phases;
        bool isMoved = false;
        for (const std::size_t u : unknowns) {
            phases.push_back(phaseAt(set_->unknowns[u], interval.from));
            isMoved = isMoved || set_->unknowns[u].phases[phases.back()].condition.has_value();
        }
        std::shared_ptr<Group> group;
        if (isMoved) {
            group = std::make_shared<Group>();
            group->equations = std::make_unique<ComponentEquations>(
                std::make_shared<const BoundModel>(
                    boundModel(*set_, *index_, {}, unknowns, phases, *models_)),
                *histories_);
            group->equations->solveMultipliersInSteps();
            group->values.resize(unknowns.size());
            group->unknowns = unknowns;
        }
        for (const std::size_t u : unknowns)
            interval.groupOf[u] = group;
    }
}

ConditionReader::Group* ConditionReader::groupOf(Interval& interval, std::size_t unknown) const {
    const auto known = interval.groupOf.find(unknown);
    if (known != interval.groupOf.end())
        return known->second.get();
    findGroups(interval, unknown);
    return interval.groupOf.at(unknown).get();
}

// ----------------------------------------------------------------------------------- the values

// The equations in the mode of that time; answers with the states.
std::vector<double> ConditionReader::prepared(const Group& group, double time) const {
    ComponentEquations& equations = *group.equations;
    equations.inputs().window(infinity);
    std::vector<double> y, kept;
    for (const std::size_t i : equations.states())
        y.push_back(group.values[i]);
    if (!equations.model().surfaces().empty()) {
        std::vector<double> decided = y;
        equations.solver().decide(time, decided);
    }
    equations.stickSlip().forget();
    for (const std::size_t i : equations.multipliers()) // whose histories keep modes
        kept.push_back(histories_->value(group.unknowns[i], time));
    equations.takeKept(kept);
    if (equations.hasDirections()) {
        std::vector<double> rested = y;
        if (const auto at = equations.directionsAtRest(time, y); !at.empty())
            (void)equations.rest(at, time, rested);
    }
    return y;
}

void ConditionReader::readStates(Group& group, double time) const {
    if (group.hasStates && group.time == time)
        return;
    group.time = time;
    group.hasStates = true;
    group.hasForces = false;
    for (std::size_t i = 0; i < group.unknowns.size(); ++i)
        group.values[i] = histories_->value(group.unknowns[i], time);
    const std::vector<std::size_t>& states = group.equations->states();
    if (std::ranges::all_of(states, [&](std::size_t i) {
            return histories_->derivative(group.unknowns[i], time) == 0;
        }))
        return;
    std::vector<double> y = prepared(group, time);
    group.equations->project(time, y);
    for (std::size_t k = 0; k < y.size(); ++k)
        group.values[states[k]] = y[k];
}

// Multipliers, and values that are held.
void ConditionReader::readForces(Group& group, double time) const {
    readStates(group, time);
    if (group.hasForces)
        return;
    group.hasForces = true;
    ComponentEquations& equations = *group.equations;
    const std::vector<double> y = prepared(group, time);
    equations.takeSlips(time, y);
    std::vector<double> rates(y.size()), held(equations.held().size());
    (void)equations.rates(time, y, rates);
    for (std::size_t k = 0; k < equations.multipliers().size(); ++k)
        group.values[equations.multipliers()[k]] = equations.multiplierValues()[k];
    if (equations.heldValues(time, y, held))
        for (std::size_t k = 0; k < held.size(); ++k)
            group.values[equations.held()[k]] = held[k];
}

double ConditionReader::inGroup(Group& group, std::size_t place, double time) const {
    readStates(group, time);
    if (std::ranges::find(group.equations->states(), place) == group.equations->states().end())
        readForces(group, time);
    return group.values[place];
}

double ConditionReader::valueOf(Interval& interval, std::size_t unknown, double time) const {
    Group* group = groupOf(interval, unknown);
    if (!group)
        return histories_->value(unknown, time);
    const auto place = std::ranges::lower_bound(group->unknowns, unknown);
    return inGroup(*group, static_cast<std::size_t>(place - group->unknowns.begin()), time);
}

bool ConditionReader::values(std::size_t unknown, double time, std::span<double> out) const {
    const std::scoped_lock lock(mutex_);
    Interval& interval = intervalAt(time);
    if (!groupOf(interval, unknown))
        return false;
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = valueOf(interval, unknown + i, time);
    return true;
}

std::optional<double> ConditionReader::reading(std::string_view name, double time) const {
    const auto of = std::ranges::find(set_->readings, name, [&](const auto& reading) {
        return std::string_view(set_->graph.name(reading.symbol));
    });
    if (of == set_->readings.end())
        return std::nullopt;
    const expression::Reading::Value& value = of->valueAt(time);
    const std::scoped_lock lock(mutex_);
    auto known = readings_.find(value.node.index);
    if (known == readings_.end()) {
        Reading made;
        std::vector<expression::Node> inputs{set_->time};
        for (const expression::Node symbol :
             expression::symbolsOf(set_->graph, std::span(&value.node, 1)))
            if (const auto unknown = index_->of(symbol)) {
                inputs.push_back(symbol);
                made.unknowns.push_back(*unknown);
            }
        made.tape = expression::Tape(set_->graph, inputs, std::span(&value.node, 1));
        known = readings_.emplace(value.node.index, std::move(made)).first;
    }
    Interval& interval = intervalAt(time);
    std::vector<double> inputs{time};
    for (const std::size_t unknown : known->second.unknowns)
        inputs.push_back(valueOf(interval, unknown, time));
    double out = 0;
    expression::Tape::Scratch scratch;
    known->second.tape.evaluate(inputs, std::span(&out, 1), scratch);
    return out;
}

} // namespace solution
