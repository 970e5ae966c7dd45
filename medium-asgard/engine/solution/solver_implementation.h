// The solver's components, schedule and events; solver.cpp steps, solver_equations.cpp changes
// equations.
#pragma once

#include "solution/component.h"
#include "solution/partition.h"
#include "solution/prepared_equations.h"
#include "solution/solver.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace solution {

class Solver::Implementation {
public:
    Implementation(std::shared_ptr<const PreparedEquations> prepared, Options options,
                   EventSource* source);

    Advance advanceTo(double finish);
    [[nodiscard]] std::shared_ptr<const Histories> snapshot() const;
    [[nodiscard]] Statistics statistics() const;

    EquationsInForce set_;
    Histories histories_;

private:
    using Identity = std::size_t; // of a component, in order of making: inputs before readers

    [[nodiscard]] Partition partition(double t) const;
    [[nodiscard]] std::unique_ptr<Component> madeOf(std::vector<std::size_t> unknowns);
    void place(double t);
    void addZeroTracks();
    [[nodiscard]] double magnitude(std::size_t unknown, double value) const;
    [[nodiscard]] std::vector<std::size_t> roused(const Event& event, const Changes& changes) const;
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
    void resume(const Event& event, const Changes& changes, std::vector<std::size_t>& touched);
    void goBack(const std::vector<std::size_t>& components, double t);
    void restart(const std::vector<std::size_t>& components, const Changes& changes);
    void endThose(const Changes& changes);
    [[nodiscard]] std::vector<std::size_t> replace(const Event& event, const Changes& changes,
                                                   const std::vector<std::size_t>& woken);
    void retire(Component& component);
    void stopFor(const Event& event, Stop::Reason reason, const std::string& sentence);
    void noteStops();

    std::shared_ptr<const PreparedEquations> prepared_;
    Options options_;
    EventSource* source_;
    ZeroStates zero_;
    std::vector<std::unique_ptr<Component>> components_; // inputs before readers
    std::vector<std::vector<std::size_t>> readers_;
    std::vector<std::size_t> componentOf_;
    mutable std::vector<char> isTouched_;           // by component; all 0 but within touchedBy()
    std::set<std::pair<double, std::size_t>> live_; // by time; not those that ended

    Statistics past_; // of components that replaced equations ended, and of events
    double lastEvent_ = -infinity;
    std::size_t eventsAtOnce_ = 0;
    double asked_ = -infinity; // the source has answered up to here
};

} // namespace solution
