#include "stepping/component.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace solution {

namespace {

double toleranceOf(const Options& options, std::span<const std::size_t> unknowns) {
    double tolerance = options.tolerance;
    if (!options.tolerances.empty()) {
        tolerance = infinity;
        for (const std::size_t u : unknowns)
            tolerance = std::min(tolerance, options.tolerances[u]);
    }
    // At fixed steps no error is controlled, and Newton's iteration must not add one.
    return options.fixedStep ? std::min(tolerance, 1e-13) : tolerance;
}

} // namespace

Component::Component(const Surroundings& surroundings, std::vector<std::size_t> unknowns)
    : around_(surroundings), unknowns_(std::move(unknowns)), writer_(unknowns_.size()),
      switches_(around_.options.start),
      oversight_({around_.options.start, toleranceOf(around_.options, unknowns_),
                  around_.options.isWatched, around_.options.fixedStep.has_value()}),
      context_{
          around_.options, around_.set, unknowns_,          toleranceOf(around_.options, unknowns_),
          equations_,      boundary_,   *writer_.history(), progress_,
          memory_,         switches_,   oversight_,         counts_},
      models_(context_) {
    progress_.values.resize(unknowns_.size());
    findQuaternions();
    counts_.unknowns = unknowns_;
}

// All four of one are in one component, except for those that stay 0.
void Component::findQuaternions() {
    std::set<std::size_t> found;
    for (const std::size_t u : unknowns_)
        if (const auto quaternion = around_.set.index().quaternionOf(u); quaternion)
            found.insert(*quaternion);
    for (const std::size_t quaternion : found) {
        std::vector<std::size_t> places;
        bool whole = true;
        for (const std::size_t entry : around_.set->quaternions[quaternion]) {
            if (around_.zero.contains(entry))
                continue;
            const auto at = std::ranges::lower_bound(unknowns_, entry);
            whole = whole && at != unknowns_.end() && *at == entry;
            places.push_back(static_cast<std::size_t>(at - unknowns_.begin()));
        }
        if (whole && !places.empty())
            progress_.quaternions.push_back(places);
    }
}

void Component::use(const PreparedEquations::Component& prepared) {
    memory_.now.phases = prepared.phases;
    equations_ = std::make_unique<ComponentEquations>(prepared.bound, around_.histories);
    takeLayout();
}

void Component::end(Stop::Reason reason, const std::vector<std::size_t>& culprits,
                    const std::string& sentence) {
    Stop stop;
    stop.time = progress_.time;
    stop.reason = reason;
    stop.unknowns = unknowns_;
    for (const std::size_t place : culprits)
        stop.culprits.push_back(unknowns_[place]);
    stop.sentence = sentence;
    stop_ = stop;
    models_.integration().dropMethod();
}

// ---------------------------------------------------------------------------------------------
// Phases

void Component::startAt(double t, std::span<const double> values) {
    progress_.time = t;
    progress_.values.assign(values.begin(), values.end());
    openRegime(true);
    if (!stop_)
        begin();
}

void Component::openRegime(bool withJumps) {
    std::vector<std::size_t> phases(unknowns_.size());
    double from = around_.options.start, until = infinity;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const expression::Unknown& unknown = around_.set->unknowns[unknowns_[i]];
        phases[i] = phaseAt(unknown, progress_.time);
        from = std::max(from, unknown.phases[phases[i]].from);
        if (phases[i] + 1 < unknown.phases.size())
            until = std::min(until, unknown.phases[phases[i] + 1].from);
    }
    boundary_.setPhases(from, until);
    takeEquations(std::move(phases));
    if (withJumps)
        applyJumps();
    if (!equations_->loop().empty())
        end(Stop::Reason::algebraicLoop, equations_->loop(),
            context_.names(equations_->loop()) +
                " are held by values that depend on each other in a circle");
    makeControl();
}

// The equations of the same phases stay as they are.
void Component::takeEquations(std::vector<std::size_t> phases) {
    if (equations_ && phases == memory_.now.phases)
        return;
    memory_.now.phases = std::move(phases);
    equations_ =
        std::make_unique<ComponentEquations>(std::make_shared<const BoundModel>(boundModel(
                                                 *around_.set, around_.set.index(), around_.zero,
                                                 unknowns_, memory_.now.phases, around_.models)),
                                             around_.histories);
    takeLayout();
}

// Jumps of phases that begin now; they read the values before.
void Component::applyJumps() {
    std::vector<expression::Node> nodes;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const expression::Phase& phase =
            around_.set->unknowns[unknowns_[i]].phases[memory_.now.phases[i]];
        if (phase.jump && !phase.given && phase.from == progress_.time) {
            nodes.push_back(*phase.jump);
            places.push_back(i);
        }
    }
    if (nodes.empty())
        return;
    std::vector<expression::Node> symbols = expression::symbolsOf(around_.set->graph, nodes);
    std::vector<double> in(symbols.size()), out(nodes.size());
    for (std::size_t k = 0; k < symbols.size(); ++k) {
        if (symbols[k] == around_.set->time)
            in[k] = progress_.time;
        const auto unknown = around_.set.index().of(symbols[k]);
        if (!unknown)
            continue;
        const auto own = std::lower_bound(unknowns_.begin(), unknowns_.end(), *unknown);
        const bool isOwn = own != unknowns_.end() && *own == *unknown;
        in[k] = isOwn ? progress_.values[static_cast<std::size_t>(own - unknowns_.begin())]
                      : around_.histories.value(*unknown, progress_.time);
    }
    expression::Tape::Scratch scratch;
    expression::Tape(around_.set->graph, symbols, nodes).evaluate(in, out, scratch);
    for (std::size_t k = 0; k < places.size(); ++k)
        progress_.values[places[k]] = out[k];
}

void Component::makeControl() {
    std::vector<UnknownScale> scales;
    double extent = 0;
    if (!around_.options.extents.empty())
        for (const std::size_t u : unknowns_)
            extent = std::max(extent, around_.options.extents[u]);
    for (const std::size_t place : equations_->states()) {
        const expression::Unknown& unknown = around_.set->unknowns[unknowns_[place]];
        UnknownScale scale;
        scale.extent = extent;
        if (unknown.lengthPerUnit > 0) {
            scale.kind = UnknownScale::Kind::position;
            scale.lengthPerUnit = unknown.lengthPerUnit;
        } else if (unknown.integralOf &&
                   around_.set->unknowns[*unknown.integralOf].lengthPerUnit > 0) {
            scale.kind = UnknownScale::Kind::velocity;
            scale.lengthPerUnit = around_.set->unknowns[*unknown.integralOf].lengthPerUnit;
        } else if (!around_.options.extents.empty()) {
            scale.lengthPerUnit = around_.options.extents[unknowns_[place]];
        }
        scales.push_back(scale);
    }
    memory_.now.control = ErrorControl(std::move(scales), context_.tolerance);
    constexpr double ofTolerance = 0.1; // of what a step may err in velocities
    constexpr double least = 1e-9;      // below, a slip would turn as fast as rounding does
    const double part = ofTolerance * context_.tolerance;
    equations_->setSlow({.part = std::max(part, least), .extent = extent, .way = part * extent});
}

// Of multipliers the histories keep the mode.
void Component::takeModes() {
    const std::vector<std::size_t>& multipliers = equations_->multipliers();
    const std::vector<double> modes = equations_->kept();
    for (std::size_t k = 0; k < multipliers.size(); ++k) {
        double& value = progress_.values[multipliers[k]];
        if (isJammed(modes[k]) && !isJammed(value))
            ++counts_.jams;
        value = modes[k];
    }
    writer_.hold(multipliers, modes);
}

// One release may change the forces that another asks about: it is asked again.
void Component::releaseConditions() {
    while (!stop_ && equations_->release(progress_.values))
        takeHeldValues();
}

void Component::takeHeldValues() {
    if (!equations_->multipliers().empty())
        takeModes();
    const auto& held = equations_->held();
    if (held.empty())
        return;
    std::vector<double> out(held.size());
    if (!equations_->heldValues(progress_.time, states(), out)) {
        const auto culprits = equations_->notFinite(progress_.time, states());
        end(Stop::Reason::notFinite, culprits,
            "the value that holds " + context_.names(culprits) + " is not finite");
        return;
    }
    for (std::size_t i = 0; i < held.size(); ++i)
        progress_.values[held[i]] = out[i];
}

// From here, as if nothing had been before, except for what checkpoints keep.
void Component::begin() {
    models_.begin();
    progress_.proposed = 0;
    writer_.beginAnew();
    oversight_.begin();
    switches_.goOn();
    equations_->inputs().window(infinity);
    std::vector<double> y = states();
    equations_->takeGone(progress_.values);
    equations_->forgetApart();
    equations_->solver().decide(progress_.time, y);
    if (equations_->hasDirections())
        decideRest(y);
    equations_->project(progress_.time, y);
    endWhereContradictory();
    progress_.put(equations_->states(), y);
    takeHeldValues();
    releaseConditions();
    if (stop_)
        return;
    memory_.now.control.observe(states());
    memory_.keep(progress_.time);
    placeAnchor();
    (void)overflows(states());
}

void Component::endWhereContradictory() {
    if (!equations_->contradictory().empty())
        end(context_.endingOf(equations_->contradictory()));
}

// What takes hold now puts bodies where their joints do not close.
void Component::endWhereApart(const std::vector<std::size_t>& apart) {
    if (!stop_ && !apart.empty())
        end(Stop::Reason::contradiction, apart,
            "what begins here wants the bodies of " + context_.names(apart) +
                " elsewhere at once: a place cannot jump");
}

void Component::decideRest(std::vector<double>& y) {
    takeReach(context_, y);
    const auto directions = equations_->directionsAtRest(progress_.time, y);
    std::vector<double> rested = y;
    if (!directions.empty() && equations_->rest(directions, progress_.time, rested))
        y = rested;
}

void Component::takeLayout() {
    writer_.takeLayout(equations_->states(), equations_->held(), equations_->integrals());
}

void Component::placeAnchor() {
    const std::vector<double> y = states();
    std::vector<double> slopes(y.size(), 0.0);
    ++counts_.evaluations;
    const bool hasRates = equations_->rates(progress_.time, y, slopes);
    if (!hasRates)
        std::fill(slopes.begin(), slopes.end(), 0.0);
    progress_.isStill = hasRates && std::ranges::all_of(slopes, [](double s) { return s == 0; });
    std::vector<double> rows(2 * unknowns_.size(), 0.0);
    for (std::size_t place = 0; place < unknowns_.size(); ++place)
        rows[2 * place] = progress_.values[place];
    for (std::size_t i = 0; i < y.size(); ++i)
        rows[2 * equations_->states()[i] + 1] = slopes[i];
    writer_.standAt(progress_.time, rows);
}

// ---------------------------------------------------------------------------------------------
// Going back

void Component::backTo(double t) {
    if (progress_.time <= t)
        return;
    stop_.reset();
    // Values at t: those after an event of its own at t, if there was one.
    History& history = *writer_.history();
    const std::size_t index = history.find(t);
    for (std::size_t place = 0; place < unknowns_.size(); ++place)
        progress_.values[place] = history.piece(index, place).value(t);
    counts_.discardedSteps += history.cut(t);
    const Memory::Checkpoint& last = memory_.backTo(t);
    switches_.backTo(t);
    progress_.time = t;
    openRegime(false);
    if (stop_)
        return;
    landOnConditions();
    memory_.now.choice = last.state.choice;
    if (last.state.phases != memory_.now.phases)
        return;
    memory_.now.control = last.state.control;
    for (std::size_t k = history.find(last.time); k < history.size(); ++k) {
        std::vector<double> seen;
        for (const std::size_t place : equations_->states())
            seen.push_back(history.piece(k, place).coefficients[0]);
        memory_.now.control.observe(seen);
    }
}

// A whole step is on them already.
void Component::landOnConditions() {
    if (equations_->multipliers().empty() || writer_.history()->empty())
        return;
    std::vector<double> kept, y = states();
    for (const std::size_t place : equations_->multipliers())
        kept.push_back(progress_.values[place]);
    if (!equations_->isOff(progress_.time, y, kept))
        return;
    equations_->takeKept(kept);
    equations_->project(progress_.time, y);
    progress_.put(equations_->states(), y);
}

double Component::valueOf(std::size_t unknown) const {
    const auto column = std::ranges::lower_bound(unknowns_, unknown) - unknowns_.begin();
    return progress_.values[static_cast<std::size_t>(column)];
}

std::optional<double> Component::endBefore(double t) {
    const History& history = *writer_.history();
    if (!equations_ || stop_ || equations_->multipliers().empty() || history.empty())
        return std::nullopt;
    const std::size_t index = history.find(t);
    const History::Step step = history.step(index);
    const std::optional<double> end = shortlyBefore(t, step.origin);
    if (!(t < step.until && boundary_.phasesFrom() <= t && end))
        return std::nullopt;
    const auto valuesOf = [&](std::span<const std::size_t> places) {
        std::vector<double> values;
        for (const std::size_t place : places)
            values.push_back(history.piece(index, place).value(t));
        return values;
    };
    const bool isOff =
        equations_->isOff(t, valuesOf(equations_->states()), valuesOf(equations_->multipliers()),
                          ComponentEquations::Conditions::all);
    return isOff ? end : std::nullopt;
}

void Component::restart(std::span<const Jump> jumps) {
    if (!equations_ || stop_)
        return;
    for (const Jump& jump : jumps)
        progress_.values[jump.place] = jump.value;
    progress_.normalize();
    begin();
}

const PlainRate* Component::plainRate() const {
    const bool goesOn =
        models_.isClosedForm() && plainRate_ && !stop_ && progress_.time == infinity;
    return goesOn ? &*plainRate_ : nullptr;
}

void Component::leave(double t) { counts_.discardedSteps += writer_.history()->cut(t); }

void Component::goOn(double origin, std::span<const double> coefficients) {
    while (coefficients.size() > 1 && coefficients.back() == 0)
        coefficients = coefficients.first(coefficients.size() - 1);
    writer_.append({origin, infinity, 1, true, static_cast<std::uint8_t>(coefficients.size())},
                   coefficients);
}

// Bit for bit what backTo(), restart() and a step in closed form do, without their anchor.
bool Component::resume(double t, std::optional<double> jump) {
    const History& history = *writer_.history();
    if (!plainRate() || history.empty())
        return false;
    const Piece last = history.piece(history.size() - 1, 0);
    if (last.origin > t)
        return false;
    const auto piece = plainPiece(*plainRate_, around_.histories, t, jump.value_or(last.value(t)));
    if (!piece)
        return false;
    leave(t);
    ++counts_.evaluations;
    writer_.append(piece->stepFrom(t), piece->numbers());
    return true;
}

// ---------------------------------------------------------------------------------------------
// Counts

std::size_t Component::bytes() const { return sizeof *this + models_.bytes(); }

std::size_t Component::checkpointBytesBefore(double t) const {
    constexpr std::size_t ofUnknown = 12; // numbers of its control
    return memory_.keptBefore(t) *
           (sizeof(Memory::Checkpoint) + ofUnknown * unknowns_.size() * sizeof(double));
}

std::size_t Component::evaluations() const {
    const Method* const method = models_.integration().method();
    return counts_.evaluations + (method ? method->counts().evaluations : 0);
}

ComponentStatistics Component::statistics() const {
    ComponentStatistics result = counts_;
    if (equations_)
        result.bound = equations_->bound();
    result.evaluations = evaluations();
    if (const Method* const method = models_.integration().method())
        result.factorisations += method->counts().factorisations;
    return result;
}

} // namespace solution
