#include "solution/solver.h"

#include "batches/alike_steps.h"
#include "solution/side_by_side.h"
#include "solution/solver_implementation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace solution {

// ---------------------------------------------------------------------------------------------
// Making components

Preparation preparationFor(const Options& options) {
    // A method that was asked for is given every state.
    const bool ladder = options.method == "auto" && !options.fixedStep && !options.whole;
    return {.start = options.start,
            .whole = options.whole,
            .everyState = !ladder,
            .asked = options.asked,
            .models = {}};
}

Solver::Implementation::Implementation(std::shared_ptr<const PreparedEquations> prepared,
                                       Options options, EventSource* source)
    : set_(prepared->set, std::shared_ptr<const UnknownIndex>(prepared, &prepared->index)),
      prepared_(std::move(prepared)), options_(std::move(options)), source_(source),
      zero_(prepared_->zero), workers_(options_.threads) {
    assert(options_.method == "auto" ||
           std::ranges::find(methodNames(), options_.method) != methodNames().end());
    assert(prepared_->how.start == options_.start && prepared_->how.whole == options_.whole);
    histories_.start_ = histories_.known_ = options_.start;
    histories_.tracks_.resize(set_->unknowns.size());
    for (std::size_t u = 0; u < set_->unknowns.size(); ++u)
        histories_.tracks_[u].initial =
            options_.initial.empty() ? set_->unknowns[u].initial : options_.initial[u];
    place(options_.start);
    noteStops();
    if (source_)
        source_->use(*this);
}

std::unique_ptr<Component> Solver::Implementation::madeOf(std::vector<std::size_t> unknowns) {
    return std::make_unique<Component>(
        Component::Surroundings{set_, histories_, options_, zero_, *prepared_->how.models},
        std::move(unknowns));
}

void Solver::Implementation::place(double t) {
    const Partition& parts = prepared_->partition;
    for (std::size_t c = 0; c < parts.components.size(); ++c) {
        if (isTaken(parts.components[c])) {
            components_.emplace_back();
            take(parts.components[c]);
            continue;
        }
        components_.push_back(madeOf(parts.components[c]));
        components_.back()->use(prepared_->components[c]);
        addTracks(*components_.back(), t);
    }
    addConstantTracks();
    componentOf_ = parts.componentOf;
    std::vector<std::size_t> places(components_.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    connect(parts, places);
    for (std::size_t c = 0; c < components_.size(); ++c) {
        if (!components_[c])
            continue;
        std::vector<double> own;
        for (const std::size_t u : components_[c]->unknowns())
            own.push_back(histories_.tracks_[u].initial);
        components_[c]->startAt(t, own);
    }
    schedule_.arrange(parts, places);
}

void Solver::Implementation::addTracks(const Component& component, double t) {
    for (std::size_t column = 0; column < component.unknowns().size(); ++column) {
        auto& spans = histories_.tracks_[component.unknowns()[column]].spans;
        while (!spans.empty() && spans.back().from >= t)
            spans.pop_back();
        spans.push_back({t, component.history(), column});
    }
}

bool Solver::Implementation::isTaken(const std::vector<std::size_t>& unknowns) const {
    return options_.taken && options_.taken->unknowns[unknowns[0]];
}

void Solver::Implementation::take(const std::vector<std::size_t>& unknowns) {
    for (const std::size_t u : unknowns)
        histories_.tracks_[u] = options_.taken->histories->tracks_[u];
}

void Solver::Implementation::takeLonger(std::shared_ptr<const TakenMotion> taken) {
    options_.taken = std::move(taken);
    for (const std::vector<std::size_t>& unknowns : prepared_->partition.components)
        if (isTaken(unknowns))
            take(unknowns);
}

// What is not solved: one piece for all that stay 0, and one for all that nobody reads, from the
// start to the end of time.
void Solver::Implementation::addConstantTracks() {
    const auto constant = [this](double value) {
        auto history = std::make_shared<History>(1);
        history->append({options_.start, infinity, 1, true, 1}, std::span(&value, 1));
        return history;
    };
    const auto zero = constant(0), unread = constant(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t u = 0; u < histories_.tracks_.size(); ++u)
        if (zero_.contains(u) || isUnread(u))
            histories_.tracks_[u].spans.push_back(
                {options_.start, zero_.contains(u) ? zero : unread, 0});
}

void Solver::Implementation::connect(const Partition& partition,
                                     std::span<const std::size_t> places) {
    readers_.resize(components_.size());
    for (const std::size_t place : places)
        readers_[place].clear();
    for (std::size_t c = 0; c < places.size(); ++c)
        for (const std::size_t input : partition.reads[c])
            readers_[places[input]].push_back(places[c]);
    for (const std::size_t place : places)
        if (components_[place])
            components_[place]->setRead(!readers_[place].empty());
}

// ---------------------------------------------------------------------------------------------
// The schedule

Component& Solver::Implementation::readyFor(Component& component) {
    Component* candidate = &component;
    while (const auto input = candidate->waitsFor())
        candidate = components_[componentOf_[*input]].get();
    return *candidate;
}

// On the calling thread only: what is asked there need not know of others.
void Solver::Implementation::poll(double time) {
    constexpr std::size_t seldom = 256;
    if (!cancelled_ && options_.cancelled && options_.cancelled())
        cancelled_ = true;
    if (options_.working && ++polls_ % seldom == 0)
        options_.working(time);
}

void Solver::Implementation::advanceGroup(std::size_t group, const Leg& leg) {
    const bool isCaller = std::this_thread::get_id() == caller_;
    if (schedule_.components(group).size() == 1)
        return advanceAlone(schedule_.components(group)[0], leg, isCaller);
    std::size_t added = 0;
    for (bool any = true; !cancelled_ && added <= leg.share; any = false) {
        if (isCaller)
            poll(components_[schedule_.components(group)[0]]->time());
        const auto behind = schedule_.next(group, leg.until, any, !options_.eventDriven);
        if (!behind || cancelled_)
            return;
        Component& component = readyFor(*components_[*behind]);
        const std::size_t before = component.history()->bytes();
        component.step();
        added += component.history()->bytes() - std::min(before, component.history()->bytes());
        schedule_.stepped(componentOf_[component.unknowns()[0]]);
        if (component.ended()) { // its readers must be told first
            stopsChanged_ = true;
            return;
        }
    }
}

// It reads no other: nobody need be asked whose turn it is.
void Solver::Implementation::advanceAlone(std::size_t place, const Leg& leg, bool isCaller) {
    Component& component = *components_[place];
    const History& history = *component.history();
    const std::size_t most = history.bytes() + leg.share;
    for (bool any = options_.eventDriven; !cancelled_; any = false) {
        if (isCaller)
            poll(component.time());
        if (cancelled_ || component.ended() || !(any || component.time() < leg.until) ||
            history.bytes() > most)
            break;
        (void)readyFor(component);
        component.step();
        if (component.ended())
            stopsChanged_ = true;
    }
    schedule_.stepped(place);
}

// Those that are by themselves go side by side.
void Solver::Implementation::advanceGroups(std::span<const std::size_t> groups, const Leg& leg) {
    std::vector<std::size_t> single;
    for (const std::size_t group : groups) {
        const std::vector<std::size_t>& places = schedule_.components(group);
        const bool maySo = groups.size() > 1 && places.size() == 1 && options_.eventDriven &&
                           components_[places[0]]->integration().mayGoSideBySide();
        if (maySo)
            single.push_back(places[0]);
        else
            advanceGroup(group, leg);
    }
    if (!single.empty())
        advanceSideBySide(single, leg);
}

void Solver::Implementation::advanceSideBySide(std::span<const std::size_t> places,
                                               const Leg& leg) {
    constexpr std::size_t seldom = 64; // steps, each time that all are counted
    const bool isCaller = std::this_thread::get_id() == caller_;
    std::vector<Component*> components;
    for (const std::size_t place : places)
        components.push_back(components_[place].get());
    const auto bytes = [&components] {
        std::size_t sum = 0;
        for (const Component* component : components)
            sum += component->history()->bytes();
        return sum;
    };
    const std::size_t before = bytes(), share = leg.share * places.size();
    std::size_t asked = 0;
    solution::advanceSideBySide(components, leg.until, [&, this](double time) {
        if (isCaller)
            poll(time);
        const bool isFull = ++asked % (seldom * places.size()) == 0 && bytes() > before + share;
        return !cancelled_ && !isFull;
    });
    for (const std::size_t place : places) {
        if (components_[place]->ended())
            stopsChanged_ = true;
        schedule_.stepped(place);
    }
}

// That a thread takes: few, so that none waits long for the last, but enough to go side by side.
static std::size_t groupsAtOnce(std::size_t groups, std::size_t threads) {
    constexpr std::size_t parts = 16, side = AlikeSteps::lanes;
    if (threads == 1)
        return std::max<std::size_t>(1, groups);
    return std::max(1 + groups / (parts * threads), std::min(side, groups / (2 * threads)));
}

// Starting threads costs more than a few small steps do.
void Solver::Implementation::doRound(double until) {
    constexpr std::size_t enough = 64; // unknowns
    const bool unbroken = !source_ || !options_.eventDriven;
    const Schedule::Round round = schedule_.nextRound(until, unbroken);
    const std::size_t count = round.groups.size();
    const std::size_t atOnce = groupsAtOnce(count, workers_.threads());
    const Leg leg{.until = round.until, .share = kept_.share(count)};
    const auto advance = [&](std::size_t piece) {
        const std::size_t first = atOnce * piece;
        advanceGroups(std::span(round.groups).subspan(first, std::min(atOnce, count - first)), leg);
    };
    const std::size_t pieces = (count + atOnce - 1) / atOnce;
    caller_ = std::this_thread::get_id();
    ++past_.rounds;
    if (round.work < enough)
        for (std::size_t piece = 0; piece < pieces; ++piece)
            advance(piece);
    else
        workers_.forEach(pieces, advance, [this] { poll(histories_.known_); });
    for (const std::size_t group : round.groups) {
        schedule_.settle(group);
        for (const std::size_t component : schedule_.components(group))
            noteKept(component);
    }
    if (stopsChanged_)
        noteStops();
}

// Without events nothing but progress, and what is left when somebody cancels, asks for more than
// one round.
double Solver::Implementation::roundsEnd(double finish) const {
    const double shown = (finish - options_.start) / 64;
    const bool isShown = options_.progress || options_.cancelled;
    return source_ || !isShown ? finish : std::min(finish, known() + shown);
}

void Solver::Implementation::run(double finish, Advance& advance) {
    double told = histories_.known_;
    cancelled_ = false;
    for (;;) {
        poll(histories_.known_);
        endWhereFull();
        advance.disturbed = disturbed_;
        if (disturbed_)
            return;
        doRound(std::min(roundsEnd(finish), kept_.fullAt()));
        if (cancelled_) {
            advance.cancelled = true;
            return;
        }
        const bool complete = known() >= finish;
        histories_.known_ = std::min(known(), finish);
        if (histories_.known_ > told || complete) {
            const bool ask = source_ && (options_.eventDriven || complete);
            bool event = false;
            while (ask && !cancelled_ && !disturbed_ && !isFull() && handleEvents(finish)) {
                event = true;
                poll(lastEvent_);
            }
            if (ask) // a source that was interrupted has not said that nothing happens
                poll(histories_.known_);
            advance.cancelled = cancelled_;
            advance.disturbed = disturbed_;
            if (advance.cancelled || disturbed_)
                return;
            told = histories_.known_;
            if (options_.progress)
                options_.progress(told);
            if (event)
                continue;
        }
        if (complete)
            return;
    }
}

Advance Solver::Implementation::advanceTo(double finish) {
    Advance advance;
    if (!std::isfinite(finish)) // nobody can wait for that
        finish = histories_.known_;
    options_.finish = finish;
    run(finish, advance);
    histories_.known_ = std::min(known(), finish);
    advance.reached = histories_.known_;
    workers_.rest();
    return advance;
}

// ---------------------------------------------------------------------------------------------
// Reading

void Statistics::addIntegrated(const ComponentStatistics& component) {
    if (component.integratedSteps > 0)
        for (const std::size_t unknown : component.unknowns)
            integrated.push_back({unknown, component.integratedFrom});
}

std::size_t Solver::Implementation::bytes() const {
    std::size_t sum = histories_.bytes();
    for (const auto& component : components_)
        sum += component ? component->bytes() : 0;
    return sum;
}

double Solver::Implementation::hopelessBeyond() const {
    double beyond = std::min(paces_.beyond(), retiredBeyond_);
    for (const auto& component : components_)
        beyond = component ? std::min(beyond, component->hopelessBeyond()) : beyond;
    return beyond;
}

std::shared_ptr<const Histories> Solver::Implementation::snapshot() const {
    auto copy = std::make_shared<Histories>(histories_);
    for (auto& track : copy->tracks_)
        for (auto& span : track.spans)
            span.history = span.history->freeze(); // the same one for all that share it
    return copy;
}

Statistics Solver::Implementation::statistics() const {
    Statistics total = past_;
    const auto list = [&total](const ComponentStatistics& s) {
        ++total.components;
        total.integratedSteps += s.integratedSteps;
        total.addIntegrated(s);
        total.largestComponent = std::max(total.largestComponent, s.unknowns.size());
        total.componentList.push_back(s);
    };
    if (options_.taken)
        for (const ComponentStatistics& s : options_.taken->components)
            if (isTaken(s.unknowns))
                list(s);
    for (const auto& component : components_) {
        if (!component || isAdded(component->unknowns()[0]))
            continue;
        const ComponentStatistics s = component->statistics();
        list(s);
        total.steps += s.steps;
        total.rejectedSteps += s.rejectedSteps;
        total.unconvergedSteps += s.unconvergedSteps;
        total.discardedSteps += s.discardedSteps;
        total.evaluations += s.evaluations;
        total.equationEvaluations += s.evaluations * s.unknowns.size();
        total.factorisations += s.factorisations;
        total.switches += s.switches;
    }
    total.groups = schedule_.groups();
    total.historyBytes = histories_.bytes();
    total.keptBytes = keptBefore(infinity);
    total.zeroStates = zero_.unknowns();
    // Readers know the unknowns that there were at first.
    std::erase_if(total.integrated, [this](const auto& of) { return isAdded(of.unknown); });
    std::erase_if(total.zeroStates, [this](std::size_t u) { return isAdded(u); });
    for (ComponentStatistics& s : total.componentList)
        std::erase_if(s.unknowns, [this](std::size_t u) { return isAdded(u); });
    return total;
}

Solver::Solver(std::shared_ptr<const PreparedEquations> prepared, Options options,
               EventSource* source)
    : implementation_(
          std::make_unique<Implementation>(std::move(prepared), std::move(options), source)) {}
Solver::Solver(expression::EquationSet equations, Options options, EventSource* source)
    : Solver(std::make_shared<const PreparedEquations>(
                 std::make_shared<const expression::EquationSet>(std::move(equations)),
                 preparationFor(options)),
             options, source) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Advance Solver::advanceTo(double finish) { return implementation_->advanceTo(finish); }
void Solver::takeLonger(std::shared_ptr<const TakenMotion> taken) {
    implementation_->takeLonger(std::move(taken));
}
const Histories& Solver::histories() const { return implementation_->histories_; }
double Solver::hopelessBeyond() const { return implementation_->hopelessBeyond(); }
std::size_t Solver::bytes() const { return implementation_->bytes(); }
std::shared_ptr<const Histories> Solver::snapshot() const { return implementation_->snapshot(); }
std::shared_ptr<const expression::EquationSet> Solver::equations() const {
    return implementation_->set_.shared();
}
Statistics Solver::statistics() const { return implementation_->statistics(); }

} // namespace solution
