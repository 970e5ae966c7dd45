#include "solution/component.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace solution {

Component::Component(const Surroundings& surroundings, std::vector<std::size_t> unknowns)
    : around_(surroundings), set_(surroundings.set), histories_(surroundings.histories),
      options_(surroundings.options), unknowns_(std::move(unknowns)), writer_(unknowns_.size()),
      history_(*writer_.history()), tolerance_(options_.tolerance), values_(unknowns_.size()),
      watched_(options_.start), switches_(options_.start) {
    if (!options_.tolerances.empty()) {
        tolerance_ = infinity;
        for (const std::size_t u : unknowns_)
            tolerance_ = std::min(tolerance_, options_.tolerances[u]);
    }
    // At fixed steps no error is controlled, and Newton's iteration must not add one.
    if (options_.fixedStep)
        tolerance_ = std::min(tolerance_, 1e-13);
    longestPart_ = std::pow(std::min(tolerance_, 1.0), 1.0 / 8);
    findQuaternions();
    counts_.unknowns = unknowns_;
}

// All four of one are in one component, except for those that stay 0.
void Component::findQuaternions() {
    std::set<std::size_t> found;
    for (const std::size_t u : unknowns_)
        if (const auto quaternion = around_.index.quaternionOf(u); quaternion)
            found.insert(*quaternion);
    for (const std::size_t quaternion : found) {
        std::vector<std::size_t> places;
        bool whole = true;
        for (const std::size_t entry : set_->quaternions[quaternion]) {
            if (around_.zero.contains(entry))
                continue;
            const auto at = std::ranges::lower_bound(unknowns_, entry);
            whole = whole && at != unknowns_.end() && *at == entry;
            places.push_back(static_cast<std::size_t>(at - unknowns_.begin()));
        }
        if (whole && !places.empty())
            quaternions_.push_back(places);
    }
}

void Component::use(const PreparedEquations::Component& prepared) {
    phases_ = prepared.phases;
    equations_ = std::make_unique<ComponentEquations>(prepared.bound, histories_);
    takeLayout();
}

std::string Component::names(const std::vector<std::size_t>& places) const {
    std::string text;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k == 4 && places.size() > 5)
            return text + " and " + std::to_string(places.size() - k) + " others";
        text += (k == 0 ? "" : ", ") + set_->unknowns[unknowns_[places[k]]].name;
    }
    return text;
}

void Component::end(Stop::Reason reason, const std::vector<std::size_t>& culprits,
                    const std::string& sentence) {
    Stop stop;
    stop.time = time_;
    stop.reason = reason;
    stop.unknowns = unknowns_;
    for (const std::size_t place : culprits)
        stop.culprits.push_back(unknowns_[place]);
    stop.sentence = sentence;
    stop_ = stop;
    keepCounts();
}

// ---------------------------------------------------------------------------------------------
// Phases

void Component::startAt(double t, std::span<const double> values) {
    time_ = t;
    values_.assign(values.begin(), values.end());
    openRegime(true);
    if (!stop_)
        begin();
}

void Component::openRegime(bool withJumps) {
    std::vector<std::size_t> phases(unknowns_.size());
    nextPhase_ = infinity;
    phasesFrom_ = options_.start;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const expression::Unknown& unknown = set_->unknowns[unknowns_[i]];
        phases[i] = phaseAt(unknown, time_);
        phasesFrom_ = std::max(phasesFrom_, unknown.phases[phases[i]].from);
        if (phases[i] + 1 < unknown.phases.size())
            nextPhase_ = std::min(nextPhase_, unknown.phases[phases[i] + 1].from);
    }
    takeEquations(std::move(phases));
    if (withJumps)
        applyJumps();
    if (!equations_->loop().empty())
        end(Stop::Reason::algebraicLoop, equations_->loop(),
            names(equations_->loop()) +
                " are held by values that depend on each other in a circle");
    makeControl();
}

// The equations of the same phases stay as they are.
void Component::takeEquations(std::vector<std::size_t> phases) {
    if (equations_ && phases == phases_)
        return;
    phases_ = std::move(phases);
    equations_ = std::make_unique<ComponentEquations>(
        std::make_shared<const BoundModel>(
            boundModel(*set_, around_.index, around_.zero, unknowns_, phases_, around_.models)),
        histories_);
    takeLayout();
}

// Jumps of phases that begin now; they read the values before.
void Component::applyJumps() {
    std::vector<expression::Node> nodes;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const expression::Phase& phase = set_->unknowns[unknowns_[i]].phases[phases_[i]];
        if (phase.jump && !phase.given && phase.from == time_) {
            nodes.push_back(*phase.jump);
            places.push_back(i);
        }
    }
    if (nodes.empty())
        return;
    std::vector<expression::Node> symbols = expression::symbolsOf(set_->graph, nodes);
    std::vector<double> in(symbols.size()), out(nodes.size());
    for (std::size_t k = 0; k < symbols.size(); ++k) {
        if (symbols[k] == set_->time)
            in[k] = time_;
        const auto unknown = around_.index.of(symbols[k]);
        if (!unknown)
            continue;
        const auto own = std::lower_bound(unknowns_.begin(), unknowns_.end(), *unknown);
        const bool isOwn = own != unknowns_.end() && *own == *unknown;
        in[k] = isOwn ? values_[static_cast<std::size_t>(own - unknowns_.begin())]
                      : histories_.value(*unknown, time_);
    }
    expression::Tape::Scratch scratch;
    expression::Tape(set_->graph, symbols, nodes).evaluate(in, out, scratch);
    for (std::size_t k = 0; k < places.size(); ++k)
        values_[places[k]] = out[k];
}

void Component::makeControl() {
    std::vector<UnknownScale> scales;
    double extent = 0;
    if (!options_.extents.empty())
        for (const std::size_t u : unknowns_)
            extent = std::max(extent, options_.extents[u]);
    for (const std::size_t place : equations_->states()) {
        const expression::Unknown& unknown = set_->unknowns[unknowns_[place]];
        UnknownScale scale;
        scale.extent = extent;
        if (unknown.lengthPerUnit > 0) {
            scale.kind = UnknownScale::Kind::position;
            scale.lengthPerUnit = unknown.lengthPerUnit;
        } else if (unknown.integralOf && set_->unknowns[*unknown.integralOf].lengthPerUnit > 0) {
            scale.kind = UnknownScale::Kind::velocity;
            scale.lengthPerUnit = set_->unknowns[*unknown.integralOf].lengthPerUnit;
        } else if (!options_.extents.empty()) {
            scale.lengthPerUnit = options_.extents[unknowns_[place]];
        }
        scales.push_back(scale);
    }
    control_ = ErrorControl(std::move(scales), tolerance_);
}

std::vector<double> Component::stateValues() const {
    std::vector<double> y;
    takeStates(y);
    return y;
}

void Component::takeStates(std::vector<double>& y) const {
    const std::vector<std::size_t>& states = equations_->states();
    y.resize(states.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = values_[states[i]];
}

void Component::setStates(std::span<const double> y) {
    for (std::size_t i = 0; i < y.size(); ++i)
        values_[equations_->states()[i]] = y[i];
}

void Component::takeHeldValues() {
    const auto& held = equations_->held();
    if (held.empty())
        return;
    std::vector<double> out(held.size());
    if (!equations_->heldValues(time_, stateValues(), out)) {
        const auto culprits = equations_->notFinite(time_, stateValues());
        end(Stop::Reason::notFinite, culprits,
            "the value that holds " + names(culprits) + " is not finite");
        return;
    }
    for (std::size_t i = 0; i < held.size(); ++i)
        values_[held[i]] = out[i];
}

void Component::normalize() {
    for (const auto& four : quaternions_) {
        double square = 0;
        for (const std::size_t place : four)
            square += values_[place] * values_[place];
        if (square == 1 || !(square > 0) || !std::isfinite(square))
            continue;
        const double length = std::sqrt(square);
        for (const std::size_t place : four)
            values_[place] /= length;
    }
}

// From time_ and values_, as if nothing had been before, except for what checkpoints keep.
void Component::begin() {
    keepCounts();
    model_ = Model::undecided;
    proposed_ = 0;
    writer_.beginAnew();
    suspect_ = -infinity;
    falling_.clear();
    switches_.goOn();
    choice_ = choice_.restarted();
    equations_->inputs().window(infinity);
    std::vector<double> y = stateValues();
    equations_->decide(time_, y);
    if (equations_->hasDirections())
        decideRest(y);
    setStates(y);
    takeHeldValues();
    if (stop_)
        return;
    control_.observe(stateValues());
    remember();
    placeAnchor();
    takeStates(y_);
    (void)overflows();
}

void Component::takeLayout() {
    writer_.takeLayout(equations_->states(), equations_->held(), equations_->integrals());
}

// Held values of the component, for its pieces.
struct Component::Held final : HeldValues {
    explicit Held(Component& component) : of(component) {}
    bool valuesAt(double t, std::span<const double> y, std::span<double> out) override {
        return of.equations_->heldValues(t, y, out);
    }
    std::vector<double> peaksOn(const StateCurves& curves) override {
        return of.centresIn(curves.columns, curves.origin, curves.scale, curves.until);
    }
    Component& of;
};

void Component::append(std::span<const Coefficients> states, double scale, double until) {
    Held held(*this);
    writer_.append({states, time_, scale, until}, held, heldPart * tolerance_);
}

bool Component::fitHeld(double until, double part, std::span<Coefficients> columns) {
    Held held(*this);
    return PieceWriter::fit({{}, time_, 1, until}, held, part * tolerance_, columns);
}

void Component::placeAnchor() {
    const std::vector<double> y = stateValues();
    std::vector<double> slopes(y.size(), 0.0);
    ++counts_.evaluations;
    if (!equations_->rates(time_, y, slopes))
        std::fill(slopes.begin(), slopes.end(), 0.0);
    std::vector<double> rows(2 * unknowns_.size(), 0.0);
    for (std::size_t place = 0; place < unknowns_.size(); ++place)
        rows[2 * place] = values_[place];
    for (std::size_t i = 0; i < y.size(); ++i)
        rows[2 * equations_->states()[i] + 1] = slopes[i];
    writer_.standAt(time_, rows);
}

// ---------------------------------------------------------------------------------------------
// Going back

void Component::remember() { checkpoints_.push_back({time_, phases_, control_, choice_}); }

void Component::backTo(double t) {
    if (time_ <= t)
        return;
    stop_.reset();
    // Values at t: those after an event of its own at t, if there was one.
    const std::size_t index = history_.find(t);
    for (std::size_t place = 0; place < unknowns_.size(); ++place)
        values_[place] = history_.piece(index, place).value(t);
    counts_.discardedSteps += history_.cut(t);
    while (checkpoints_.size() > 1 && checkpoints_.back().time > t)
        checkpoints_.pop_back();
    switches_.backTo(t);
    time_ = t;
    openRegime(false);
    if (stop_)
        return;
    const Checkpoint& last = checkpoints_.back();
    choice_ = last.choice;
    if (last.phases != phases_)
        return;
    control_ = last.control;
    for (std::size_t k = history_.find(last.time); k < history_.size(); ++k) {
        std::vector<double> seen;
        for (const std::size_t place : equations_->states())
            seen.push_back(history_.piece(k, place).coefficients[0]);
        control_.observe(seen);
    }
}

void Component::restart(std::span<const Jump> jumps) {
    if (!equations_ || stop_)
        return;
    for (const Jump& jump : jumps)
        values_[jump.place] = jump.value;
    normalize();
    begin();
}

// ---------------------------------------------------------------------------------------------
// Counts

void Component::keepCounts() {
    if (!method_)
        return;
    counts_.evaluations += method_->counts().evaluations;
    counts_.factorisations += method_->counts().factorisations;
    method_.reset();
}

// A method holds some thirty rows of its states.
std::size_t Component::bytes() const {
    constexpr std::size_t rows = 30;
    return sizeof *this + (linear_ ? linear_->bytes() : 0) +
           (method_ ? rows * columns_.size() * sizeof(double) : 0);
}

std::size_t Component::checkpointBytesBefore(double t) const {
    constexpr std::size_t ofUnknown = 12; // numbers of its control
    const auto after = std::ranges::lower_bound(checkpoints_, t, {}, &Checkpoint::time);
    const auto count = static_cast<std::size_t>(after - checkpoints_.begin());
    return count * (sizeof(Checkpoint) + ofUnknown * unknowns_.size() * sizeof(double));
}

std::size_t Component::evaluations() const {
    return counts_.evaluations + (method_ ? method_->counts().evaluations : 0);
}

ComponentStatistics Component::statistics() const {
    ComponentStatistics result = counts_;
    if (equations_)
        result.bound = equations_->bound();
    result.evaluations = evaluations();
    if (method_)
        result.factorisations += method_->counts().factorisations;
    return result;
}

} // namespace solution
