#include "solution/solver.h"

#include "solution/events.h"
#include "solution/interruption.h"
#include "solution/network.h"
#include "solution/rounds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace solution {

Preparation preparationFor(const Options& options) {
    // A method that was asked for is given every state.
    const bool ladder = options.method == "auto" && !options.fixedStep && !options.whole;
    return {.start = options.start,
            .whole = options.whole,
            .everyState = !ladder,
            .asked = options.asked,
            .models = {}};
}

class Solver::Implementation {
public:
    Implementation(std::shared_ptr<const PreparedEquations> prepared, Options options,
                   EventSource* source)
        : network(std::move(prepared), std::move(options)), hasEvents_(source != nullptr),
          events_(network, interruption_, source), rounds_(network, interruption_, hasEvents_) {
        [[maybe_unused]] const Options& o = network.options;
        [[maybe_unused]] const Preparation& how = network.prepared->how;
        assert(o.method == "auto" ||
               std::ranges::find(methodNames(), o.method) != methodNames().end());
        assert(how.start == o.start && how.whole == o.whole);
    }

    Advance advanceTo(double finish);
    [[nodiscard]] Statistics statistics() const;

    Network network;

private:
    void run(double finish, Advance& advance);
    [[nodiscard]] double roundsEnd(double finish) const;

    bool hasEvents_;
    Interruption interruption_{network.options};
    Events events_;
    Rounds rounds_;
};

// Without events nothing but progress, and what is left when somebody cancels, asks for more than
// one round.
double Solver::Implementation::roundsEnd(double finish) const {
    const Options& options = network.options;
    const double shown = (finish - options.start) / 64;
    const bool isShown = options.progress || options.cancelled;
    return hasEvents_ || !isShown ? finish : std::min(finish, network.known() + shown);
}

void Solver::Implementation::run(double finish, Advance& advance) {
    double told = network.histories.known();
    interruption_.begin();
    for (;;) {
        interruption_.poll(network.histories.known());
        events_.endWhereFull();
        advance.disturbed = network.isDisturbed;
        if (network.isDisturbed)
            return;
        rounds_.doOne(std::min(roundsEnd(finish), network.kept.fullAt()));
        if (interruption_.isCancelled()) {
            advance.cancelled = true;
            return;
        }
        const bool complete = network.known() >= finish;
        network.setKnown(std::min(network.known(), finish));
        if (network.histories.known() > told || complete) {
            const bool ask = network.options.eventDriven || complete;
            const bool happened = ask && events_.handleAll(finish);
            advance.cancelled = interruption_.isCancelled();
            advance.disturbed = network.isDisturbed;
            if (advance.cancelled || advance.disturbed)
                return;
            told = network.histories.known();
            if (network.options.progress)
                network.options.progress(told);
            if (happened)
                continue;
        }
        if (complete)
            return;
    }
}

Advance Solver::Implementation::advanceTo(double finish) {
    Advance advance;
    if (!std::isfinite(finish)) // nobody can wait for that
        finish = network.histories.known();
    run(finish, advance);
    network.setKnown(std::min(network.known(), finish));
    advance.reached = network.histories.known();
    rounds_.rest();
    return advance;
}

Statistics Solver::Implementation::statistics() const {
    Statistics total = events_.statistics();
    const auto list = [&total](const ComponentStatistics& s) {
        ++total.components;
        total.addIntegrated(s);
        total.largestComponent = std::max(total.largestComponent, s.unknowns.size());
        total.componentList.push_back(s);
    };
    if (network.options.taken)
        for (const ComponentStatistics& s : network.options.taken->components)
            if (network.isTaken(s.unknowns))
                list(s);
    for (const auto& component : network.components) {
        if (!component || network.isAdded(component->unknowns()[0]))
            continue;
        const ComponentStatistics s = component->statistics();
        list(s);
        total.addWork(s);
    }
    total.rounds = rounds_.done();
    total.groups = network.schedule.groups();
    total.historyBytes = network.histories.bytes();
    total.keptBytes = events_.kept();
    total.zeroStates = network.zero.unknowns();
    // Readers know the unknowns that there were at first.
    const auto isAdded = [this](std::size_t u) { return network.isAdded(u); };
    std::erase_if(total.integrated, [&](const auto& of) { return isAdded(of.unknown); });
    std::erase_if(total.zeroStates, isAdded);
    for (ComponentStatistics& s : total.componentList)
        std::erase_if(s.unknowns, isAdded);
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
    implementation_->network.takeLonger(std::move(taken));
}
const Histories& Solver::histories() const { return implementation_->network.histories; }
std::size_t Solver::bytes() const { return implementation_->network.bytes(); }
std::shared_ptr<const Histories> Solver::snapshot() const {
    return implementation_->network.snapshot();
}
std::shared_ptr<const expression::EquationSet> Solver::equations() const {
    return implementation_->network.set.shared();
}
Statistics Solver::statistics() const { return implementation_->statistics(); }

} // namespace solution
