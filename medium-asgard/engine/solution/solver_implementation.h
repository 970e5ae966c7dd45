// The solver's components, schedule and events; solver.cpp steps, solver_equations.cpp changes
// equations.
#pragma once

#include "solution/component.h"
#include "solution/partition.h"
#include "solution/solver.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace solution {

class Solver::Implementation {
public:
    Implementation(expression::EquationSet equations, Options options, EventSource* source)
        : set_(std::move(equations)), options_(std::move(options)), source_(source), index_(set_) {
        assert(options_.method == "auto" || std::find(methodNames().begin(), methodNames().end(),
                                                      options_.method) != methodNames().end());
        histories_.start_ = histories_.known_ = options_.start;
        histories_.tracks_.resize(set_.unknowns.size());
        std::vector<double> initial;
        for (std::size_t u = 0; u < set_.unknowns.size(); ++u) {
            initial.push_back(set_.unknowns[u].initial);
            histories_.tracks_[u].initial = initial.back();
        }
        // A method that was asked for is given every state.
        if (options_.method == "auto" && !options_.fixedStep && !options_.whole)
            zero_ = ZeroStates(set_, options_.start, initial);
        place(options_.start, initial);
        noteStops();
    }

    Advance advanceTo(double finish);
    [[nodiscard]] std::shared_ptr<const Histories> snapshot() const;
    [[nodiscard]] Statistics statistics() const;

    expression::EquationSet set_;
    Histories histories_;

private:
    using Identity = std::size_t; // of a component, in order of making: inputs before readers

    [[nodiscard]] Partition partition(double t) const;
    void place(double t, const std::vector<double>& values);
    void addZeroTracks();
    [[nodiscard]] double magnitude(std::size_t unknown, double value) const;
    [[nodiscard]] std::vector<std::size_t> woken(const Event& event, const Changes& changes);
    void change(const Event& event, const Changes& changes);
    void addTracks(const Component& component, double t);
    void connect(const Partition& partition);
    void run(double finish, Advance& advance);
    [[nodiscard]] Component* nextOf(double finish);
    [[nodiscard]] Component& readyFor(Component& component);
    void stepOne(Component& component);
    [[nodiscard]] double known() const;

    [[nodiscard]] bool handleEvents(double finish);
    void apply(const Event& event);
    [[nodiscard]] std::vector<std::size_t> touchedBy(const Event& event,
                                                     const Changes& changes) const;
    void goBack(const std::vector<std::size_t>& components, double t);
    void restart(const std::vector<std::size_t>& components, const Changes& changes);
    void endThose(const Changes& changes);
    [[nodiscard]] std::vector<std::size_t> replace(const Event& event, const Changes& changes,
                                                   const std::vector<std::size_t>& woken);
    void retire(Component& component);
    void stopFor(const Event& event, Stop::Reason reason, const std::string& sentence);
    void noteStops();

    Options options_;
    EventSource* source_;
    UnknownIndex index_;
    ZeroStates zero_;
    std::vector<std::unique_ptr<Component>> components_; // inputs before readers
    std::vector<std::vector<std::size_t>> readers_;
    std::vector<std::size_t> componentOf_;
    std::set<std::pair<double, std::size_t>> live_; // by time; not those that ended

    Statistics past_; // of components that replaced equations ended, and of events
    double lastEvent_ = -infinity;
    std::size_t eventsAtOnce_ = 0;
    double asked_ = -infinity; // the source has answered up to here
};

} // namespace solution
