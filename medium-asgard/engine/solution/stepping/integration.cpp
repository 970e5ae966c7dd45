#include "stepping/integration.h"

#include "batches/alike_steps.h"
#include "integrators/methods.h"

#include <algorithm>
#include <cmath>

namespace solution {

void Integration::begin() {
    dropMethod();
    rest_.begin();
    calm_ = stable;
    context_.memory.now.choice = context_.memory.now.choice.restarted();
}

void Integration::dropMethod() {
    if (!method_)
        return;
    context_.counts.evaluations += method_->counts().evaluations;
    context_.counts.factorisations += method_->counts().factorisations;
    method_.reset();
}

// A method holds some thirty rows of its states.
std::size_t Integration::bytes() const {
    constexpr std::size_t rows = 30;
    return method_ ? rows * columns_.size() * sizeof(double) : 0;
}

// ---------------------------------------------------------------------------------------------
// Methods

std::unique_ptr<Method> Integration::chosenMethod() const {
    const Options& options = context_.options;
    const bool choose = options.method == "auto";
    const bool implicit = context_.memory.now.choice.implicit();
    const std::string name = !choose ? options.method : implicit ? "radau5" : "dop853";
    return makeMethod(name, context_.equations(), context_.control(),
                      options.fixedStep.has_value());
}

// Rates that are next to 0 by chance, as those of a rectified drive, say nothing of how long a
// step may be: the steps before do.
double Integration::longestFirst() const {
    constexpr std::size_t asked = 8;
    constexpr double times = 16;
    const History& history = context_.history;
    double longest = 0;
    for (std::size_t k = history.size(); k-- > 0 && k + asked >= history.size();)
        if (const auto step = history.step(k); step.until > step.origin) // no anchor
            longest = std::max(longest, step.scale);
    return longest > 0 ? times * longest : infinity;
}

std::optional<Ending> Integration::beginMethod() {
    const Options& options = context_.options;
    ComponentEquations& equations = context_.equations();
    ComponentStatistics& counts = context_.counts;
    method_ = chosenMethod();
    context_.memory.now.choice.begin();
    const bool quadrature = equations.states().size() == 1 && !equations.readsStates();
    counts.method = method_->name();
    counts.order = method_->order();
    counts.model = method_->implicit() ? "implicit" : quadrature ? "quadrature" : "explicit";
    mayChange_ = options.method == "auto" && counts.model != "quadrature";
    counts.why = options.method != "auto" ? "asked for"
                 : method_->implicit()    ? "stiffness bounds explicit steps"
                 : quadrature             ? "a function of time and of what is solved upstream"
                                          : "explicit steps cost less than implicit ones";
    const std::vector<double> y = context_.states();
    if (!method_->begin(context_.time(), y))
        return context_.endingWithoutRate(context_.time(), y);
    if (const std::string how = equations.howMultipliersAreFound(); !how.empty())
        counts.why += "; " + how;
    double& proposed = context_.progress.proposed;
    const double first =
        options.fixedStep ? *options.fixedStep
        : options.firstStep
            ? *options.firstStep
            : method_->firstStep(std::min(context_.limit() - context_.time(), longestFirst()));
    proposed = proposed > 0 && !options.fixedStep ? std::min(proposed, first) : first;
    findTurn();
    strides_ = mayStride();
    return std::nullopt;
}

std::optional<Ending> Integration::changeMethod() {
    dropMethod();
    context_.memory.keep(context_.time());
    context_.equations().inputs().window(infinity);
    const double h = context_.progress.proposed;
    if (auto ending = beginMethod())
        return ending;
    context_.progress.proposed = h;
    return std::nullopt;
}

StepModel::Afterwards Integration::goOn(std::span<const double> y) {
    if (!method_) // it came to the last time at which it has a rate
        return {};
    context_.equations().followCentres(context_.time(), y);
    if (!method_->proceed(y)) {
        if (auto violation = switchesHere())
            return *violation;
        return context_.endingWithoutRate(context_.time(), y);
    }
    if (auto ending = reconsider())
        return *ending;
    findTurn();
    return {};
}

void Integration::findTurn() {
    ComponentEquations& equations = context_.equations();
    constexpr double stiff = 0.5; // of the stability of an explicit method
    turns_ = {};
    const bool mayTurn =
        equations.slips() && (method_->implicit() || calm_ < stable || equations.slipsSlowly() ||
                              method_->stabilityUsed() > stiff);
    if (!context_.options.fixedStep && mayTurn)
        turns_ = equations.turns(context_.time(), context_.states());
    if (method_->implicit())
        turns_.fastest = 0; // it bounds no step
}

std::optional<Ending> Integration::reconsider() {
    if (!mayChange_)
        return std::nullopt;
    MethodChoice& choice = context_.memory.now.choice;
    const bool wasTrial = choice.isTrial();
    if (choice.changesAfter(*method_, lastLength_, context_.control().crossing(), turns_.fastest) ||
        (choice.wantsSpectralRadius() && choice.changesFor(spectralRadius(), lastLength_)))
        return changeMethod();
    if (wasTrial && !choice.isTrial()) // it was won
        context_.memory.keep(context_.time());
    return std::nullopt;
}

// Power iteration on the Jacobian, from a fixed vector; the mean growth of the last rounds, since
// complex pairs turn.
double Integration::spectralRadius() {
    constexpr int rounds = 24, counted = 8;
    ComponentEquations& equations = context_.equations();
    const Pattern& pattern = equations.jacobianPattern();
    std::vector<double> entries(pattern.entries());
    if (!equations.jacobian(context_.time(), context_.states(), entries))
        return 0;
    std::vector<double> x(pattern.size()), image(pattern.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = 1 + 0.1 * static_cast<double>(i % 7);
    double growth = 0;
    for (int round = 0; round < rounds; ++round) {
        std::fill(image.begin(), image.end(), 0.0);
        for (std::size_t column = 0; column < x.size(); ++column)
            for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k) {
                const auto entry = static_cast<std::size_t>(k);
                image[static_cast<std::size_t>(pattern.rows[entry])] += entries[entry] * x[column];
            }
        double before = 0, after = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            before += x[i] * x[i];
            after += image[i] * image[i];
        }
        if (!(after > 0) || !std::isfinite(after))
            return 0;
        if (round >= rounds - counted)
            growth += 0.5 * std::log(after / before) / counted;
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] = image[i] / std::sqrt(after);
    }
    return std::exp(growth);
}

// ---------------------------------------------------------------------------------------------
// Steps

// The stages of an explicit step beyond what is stable do not see how friction turns a slow slip
// about: it is no larger there, and no error shows.
double Integration::longest() const {
    const double watched =
        context_.oversight.longest(context_.time(), context_.equations(), method_->implicit());
    return turns_.fastest > 0
               ? std::min(watched, calm_ * method_->stabilityLimit() / turns_.fastest)
               : watched;
}

Proposal Integration::propose() {
    const Options& options = context_.options;
    double& proposed = context_.progress.proposed;
    const double time = context_.time(), limit = context_.limit();
    if (context_.equations().hasDirections())
        if (auto piece = rest_.arrive(method_ ? proposed : longestFirst()))
            return *piece;
    if (!method_)
        if (auto ending = beginMethod()) {
            dropMethod();
            if (auto piece = switchHere())
                return *piece;
            return std::move(*ending);
        }
    if (turns_.stop)
        if (auto piece = toStop(*turns_.stop))
            return *piece;
    context_.oversight.prepare(time, context_.equations(), method_->implicit(), context_.control());
    for (;;) { // every refusal shortens the step, until it cannot be
        const double wanted =
            std::max(std::min({proposed, longest(), rest_.longest()}), shortestStep(time));
        const bool lands = time + landingOf(options) * wanted >= limit;
        const double to = lands ? limit : time + wanted;
        const double h = to - time;
        const Attempt attempt = method_->attempt(h);
        if (attempt.outcome != Attempt::Outcome::accepted) {
            if (auto instead = refuse(attempt, h))
                return std::move(*instead);
            continue;
        }
        proposed = attempt.next;
        if (options.fixedStep && rest_.longest() < infinity)
            proposed = *options.fixedStep;
        if (lands && h < wanted)
            proposed = std::max(proposed, options.fixedStep ? *options.fixedStep : wanted);
        return review(to);
    }
}

// A slip goes to rest along the rates that it has where these hardly change up to there.
// LIMIT: a force that comes and goes within this way is not seen, since both ends alone are asked.
std::optional<StepPiece> Integration::toStop(const ComponentEquations::Turns::Stop& stop) {
    constexpr double certain = 0.1; // of the error that a step may have
    ComponentEquations& equations = context_.equations();
    const double from = context_.time(), to = from + stop.duration, h = to - from;
    if (!(h > shortestStep(from)) || to >= context_.limit())
        return std::nullopt;
    y_ = context_.states();
    std::vector<double> first(y_.size()), last(y_.size());
    context_.counts.evaluations += 2;
    if (!equations.rates(from, y_, first))
        return std::nullopt;
    goAlong(equations, first, h, y_, columns_);
    if (!equations.rates(to, y_, last))
        return std::nullopt;
    std::vector<double> error(y_.size());
    for (std::size_t i = 0; i < y_.size(); ++i)
        error[i] = 0.5 * h * (last[i] - first[i]);
    for (const auto& [x, v] : equations.integrals())
        error[x] = h / 3 * error[v];
    context_.control().prepare(y_, h);
    if (!(context_.control().norm(error) <= certain))
        return std::nullopt;
    StateCurves curves{columns_, from, h, to};
    found_ = violationOn(curves);
    if (found_ && context_.passesAtOnce(*found_, curves))
        return std::nullopt;
    if (!found_)
        found_ = Violation{to, {equations.guards().turnOf(stop.disc)}};
    curves.until = found_->time;
    curves.at(curves.until, y_);
    return StepPiece{
        .curves = curves, .end = y_, .kind = StepPiece::Kind::integrated, .crossing = &*found_};
}

// Nothing: a shorter step is to be tried.
std::optional<Proposal> Integration::refuse(const Attempt& attempt, double h) {
    ComponentEquations& equations = context_.equations();
    ++context_.counts.rejectedSteps;
    if (attempt.outcome == Attempt::Outcome::notConverged)
        ++context_.counts.unconvergedSteps;
    const bool isFixed = context_.options.fixedStep.has_value();
    const bool isWithout = attempt.outcome == Attempt::Outcome::notFinite;
    // Steps of fixed length too come to the end of a branch that has no value beyond it.
    const bool comesToEnd = isWithout && equations.watches() > 0;
    double& proposed = context_.progress.proposed;
    if (comesToEnd && equations.lookBeyond(context_.time(), context_.states())) {
        proposed = h;
        return std::nullopt;
    }
    const double next = isFixed ? (comesToEnd ? h / 4 : h) : attempt.next;
    if (next > shortestStep(context_.time()) && next < h) {
        proposed = next;
        return std::nullopt;
    }
    proposed = 0; // what was refused says nothing of what comes behind
    if (comesToEnd) {
        if (auto piece = switchHere())
            return *piece;
        if (auto across = acrossSwitch(h))
            return across;
    }
    if (isWithout && !isFixed)
        if (auto last = toLastRate(h))
            return last;
    return underflow(attempt.outcome, h);
}

Ending Integration::underflow(Attempt::Outcome outcome, double h) const {
    const ErrorControl& control = context_.control();
    std::vector<double> y = context_.states(), slopes(y.size());
    const bool here = context_.equations().rates(context_.time(), y, slopes);
    if (outcome == Attempt::Outcome::notFinite) {
        for (std::size_t i = 0; here && i < y.size(); ++i)
            y[i] += h * slopes[i];
        return context_.endingWithoutRate(context_.time() + h, y);
    }
    std::size_t fastest = 0;
    for (std::size_t i = 1; i < y.size(); ++i)
        if (std::abs(slopes[i]) / control.scale(i) >
            std::abs(slopes[fastest]) / control.scale(fastest))
            fastest = i;
    const std::vector<std::size_t> culprit = {context_.equations().states()[fastest]};
    const std::string name = context_.names(culprit);
    if (outcome == Attempt::Outcome::notConverged)
        return {Stop::Reason::notConverged, culprit,
                "the implicit equations of a step cannot be solved for " + name};
    return {Stop::Reason::stepUnderflow, culprit,
            "error control needs steps too short to resolve for " + name};
}

// The step that the method has made, to `to`.
Proposal Integration::review(double to) {
    const double from = context_.time(), h = to - from;
    columns_.resize(context_.equations().states().size());
    method_->dense(columns_);
    StateCurves curves{columns_, from, h, to};
    found_ = violationOn(curves);
    const bool atOnce = found_ && context_.passesAtOnce(*found_, curves);
    if (swings(curves)) {
        calm_ /= 2;
        return lookCloser(to, h);
    }
    if (found_)
        curves.until = found_->time;
    const ReviewedStep step{curves, found_, atOnce, method_->implicit(), shortestStep(from)};
    if (const auto at = context_.oversight.verdict(step, context_.equations(), context_.control(),
                                                   context_.counts.evaluations))
        return lookCloser(*at, h);
    if (atOnce)
        return SwitchAtOnce{*found_};
    lastLength_ = h;
    y_.assign(method_->state().begin(), method_->state().end());
    constexpr double beyond = 1.5; // of the way that is left: good where the contact changes
    if (const auto before = endBeforeContact(curves)) {
        curves.until = *before;
        curves.at(*before, y_);
        return StepPiece{.curves = curves,
                         .end = y_,
                         .kind = StepPiece::Kind::integrated,
                         .endsAnew = true,
                         .next = beyond * (found_->time - *before)};
    }
    if (found_)
        curves.at(curves.until, y_);
    return StepPiece{.curves = curves,
                     .end = y_,
                     .kind = StepPiece::Kind::integrated,
                     .crossing = found_ ? &*found_ : nullptr};
}

// A slow slip swings about its way within a step at the edge of stability, by less than the
// tolerance. A force on the step's polynomials then falls below its bound, and that of the states
// which conditions hold does not. Such a step is refused, and the next ones are half as long.
bool Integration::swings(const StateCurves& curves) {
    constexpr double part = 0.1;              // of what the watch had where the step began
    constexpr double calmest = stable / 16.0; // then it is taken as it is
    ComponentEquations& equations = context_.equations();
    Guards& guards = equations.guards();
    if (!found_ || method_->implicit() || context_.options.fixedStep || !(calm_ > calmest) ||
        !guards.readForces(*found_) || !equations.slips())
        return false;
    std::vector<double> y(columns_.size()), from(equations.watches()), to(from.size());
    curves.at(curves.origin, y);
    guards.watch(curves.origin, y, from);
    curves.at(found_->time, y);
    equations.project(found_->time, y);
    guards.watch(found_->time, y, to);
    const auto hasFallen = [&](std::size_t k) { return !(to[k] > part * std::abs(from[k])); };
    return guards.knowForces() && std::ranges::none_of(found_->watches, hasFallen) &&
           equations.turns(curves.origin, context_.states()).fastest > 0;
}

// The source of events asks who touches whom at the instant at which a contact begins or loses its
// place, of states that conditions hold: these may do so elsewhere than a long step's polynomials.
// The step ends shortly before these or the polynomials do so, whichever come first.
std::optional<double> Integration::endBeforeContact(const StateCurves& curves) {
    ComponentEquations& equations = context_.equations();
    if (!found_)
        return std::nullopt;
    std::vector<double> y(columns_.size());
    curves.at(found_->time, y);
    if (!equations.movesContacts(*found_, y))
        return std::nullopt;
    const auto isThere = [&](double t) {
        curves.at(t, y);
        return equations.hasMovedContacts(*found_, t, y);
    };
    constexpr int halvings = 10;
    double before = curves.origin, then = found_->time;
    const bool isEarlier = isThere(then) && !isThere(before);
    for (int i = 0; i < halvings && isEarlier; ++i)
        if (const double middle = 0.5 * (before + then); isThere(middle))
            then = middle;
        else
            before = middle;
    return shortlyBefore(then, curves.origin);
}

Proposal Integration::lookCloser(double at, double h) {
    ++context_.counts.rejectedSteps;
    context_.progress.proposed = 0.5 * h;
    dropMethod();
    if (context_.progress.proposed > shortestStep(context_.time()))
        return TryAgain{};
    std::vector<double> rates(columns_.size());
    return underflow(context_.equations().rates(at, context_.states(), rates)
                         ? Attempt::Outcome::errorTooLarge
                         : Attempt::Outcome::notFinite,
                     h);
}

// A motion that leaves a surface slowly, as two bodies that touch and are pressed together ever
// harder, is carried across it and back by rounding alone, which shorter steps do not change.
std::optional<Violation> Integration::violationOn(const StateCurves& curves) {
    ComponentEquations& equations = context_.equations();
    auto found = context_.violationOn(curves);
    if (!found)
        return found;
    std::vector<double> y(columns_.size());
    for (std::size_t k = 0; found && k < equations.watches(); ++k) {
        curves.at(found->time, y);
        if (!equations.guards().grazesByRounding(*found, found->time, y))
            break;
        found = context_.violationOn(curves);
    }
    return found;
}

// ---------------------------------------------------------------------------------------------
// A right-hand side without a value

// A branch that has no value beyond its end, as that of a root whose argument max() bounds, lets no
// step look across. Within some of the shortest steps of its end the motion goes on along its rates
// to beyond it. Forces of slips that are next to none may be found there at some places and not at
// others.
std::optional<Proposal> Integration::acrossSwitch(double h) {
    for (const double steps : {8.0, 4.0, 2.0, 1.0})
        if (auto across = acrossWay(std::min(steps * h, context_.limit() - context_.time())))
            return across;
    return std::nullopt;
}

std::optional<Proposal> Integration::acrossWay(double across) {
    ComponentEquations& equations = context_.equations();
    const double from = context_.time();
    std::vector<double> slopes, here(equations.watches()), beyond(here.size());
    y_ = context_.states();
    slopes.resize(y_.size());
    if (here.empty() || !equations.rates(from, y_, slopes))
        return std::nullopt;
    equations.guards().watch(from, y_, here);
    columns_.assign(y_.size(), Coefficients{});
    for (std::size_t i = 0; i < y_.size(); ++i) {
        columns_[i][0] = y_[i];
        columns_[i][1] = across * slopes[i];
        y_[i] += columns_[i][1];
    }
    const double to = from + across;
    if (equations.rates(to, y_, slopes))
        return std::nullopt;
    equations.guards().watch(to, y_, beyond);
    Violation violation{.time = to, .watches = {}};
    for (std::size_t k = 0; k < here.size(); ++k)
        if (here[k] >= 0 && beyond[k] < 0)
            violation.watches.push_back(k);
    if (violation.watches.empty())
        return std::nullopt;
    found_ = std::move(violation);
    return StepPiece{.curves = {columns_, from, across, to}, .end = y_, .crossing = &*found_};
}

// A step may end beyond a switch by so little that it counts as before it. Where the old branch has
// no value there, the switch is passed.
std::optional<Violation> Integration::switchesHere() const {
    ComponentEquations& equations = context_.equations();
    const std::vector<double> y = context_.states();
    std::vector<double> values(equations.watches()), slopes(y.size());
    if (values.empty() || equations.rates(context_.time(), y, slopes))
        return std::nullopt;
    equations.guards().watch(context_.time(), y, values);
    Violation violation{.time = context_.time(), .watches = {}};
    for (std::size_t k = 0; k < values.size(); ++k)
        if (values[k] < 0)
            violation.watches.push_back(k);
    if (violation.watches.empty())
        return std::nullopt;
    return violation;
}

std::optional<StepPiece> Integration::switchHere() {
    found_ = switchesHere();
    if (!found_)
        return std::nullopt;
    return StepPiece{.curves = {{}, context_.time(), 1, context_.time()},
                     .kind = StepPiece::Kind::nothing,
                     .crossing = &*found_};
}

// A motion without a rate from some time on, as sqrt(1-t), goes along its rates to the last time at
// which it has one: up to there it needs no value beyond.
std::optional<Proposal> Integration::toLastRate(double h) {
    ComponentEquations& equations = context_.equations();
    const double from = context_.time();
    const std::vector<double> y = context_.states();
    std::vector<double> slopes(y.size()), rates(y.size());
    if (!equations.rates(from, y, slopes))
        return std::nullopt;
    y_.resize(y.size());
    const auto hasRates = [&](double t) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y_[i] = y[i] + (t - from) * slopes[i];
        return equations.rates(t, y_, rates);
    };
    double last = from, beyond = std::min(from + h, context_.limit());
    if (hasRates(beyond) || equations.slidingFailed())
        return std::nullopt;
    for (double t = last + 0.5 * (beyond - last); last < t && t < beyond;
         t = last + 0.5 * (beyond - last))
        (hasRates(t) ? last : beyond) = t;
    if (last <= from || !hasRates(last))
        return std::nullopt;
    const double way = last - from;
    ErrorControl& control = context_.control();
    control.prepare(y, h);
    columns_.assign(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i) {
        columns_[i][0] = y[i];
        columns_[i][1] = way * slopes[i];
        if (!(std::abs(columns_[i][1]) <= control.scale(i)))
            return std::nullopt;
    }
    dropMethod();
    return StepPiece{.curves = {columns_, from, way, last}, .end = y_};
}

// ---------------------------------------------------------------------------------------------
// Beside others

bool Integration::mayGoSideBySide() const {
    if (!AlikeSteps::areThere() || !context_.inForce)
        return false;
    const ComponentEquations& equations = context_.equations();
    return equations.isPlain() && equations.size() > 0 && !equations.readsInputs() &&
           !equations.bound()->canPeak && context_.progress.quaternions.empty() &&
           !context_.options.fixedStep;
}

bool Integration::mayStride() const {
    const auto* const method = dynamic_cast<const ExplicitRungeKutta*>(method_.get());
    return mayGoSideBySide() && method && AlikeSteps::areOf(method->tableau());
}

ExplicitRungeKutta& Integration::stride() const {
    return static_cast<ExplicitRungeKutta&>(*method_);
}

std::optional<double> Integration::strideEnd() const {
    const std::size_t steps = context_.history.size();
    if (steps > context_.options.maximumSteps)
        return std::nullopt;
    const double time = context_.time();
    const double wanted =
        std::max(std::min(context_.progress.proposed, longest()), shortestStep(time));
    if (time + landingOf(context_.options) * wanted >= context_.boundary.phasesUntil())
        return std::nullopt;
    return time + wanted;
}

bool Integration::refuseStride(const Attempt& attempt, double h) {
    if (!(attempt.next > shortestStep(context_.time()) && attempt.next < h))
        return false;
    ++context_.counts.rejectedSteps;
    context_.progress.proposed = attempt.next;
    return true;
}

StepPiece Integration::takenStride(double h, double to, double next) {
    context_.oversight.believe();
    context_.switches.goOn();
    context_.progress.proposed = next;
    return {.curves = {columns_, context_.time(), h, to}, .kind = StepPiece::Kind::integrated};
}

bool Integration::changesAfterStride(double h, double crossing) {
    return mayChange_ && context_.memory.now.choice.changesAfter(*method_, h, crossing);
}

} // namespace solution
