// The solver's components, schedule and events; solver.cpp steps, solver_events.cpp cuts,
// solver_equations.cpp changes equations.
#pragma once

#include "equations/partition.h"
#include "equations/prepared_equations.h"
#include "solution/kept_bytes.h"
#include "solution/pace.h"
#include "solution/schedule.h"
#include "solution/solver.h"
#include "solution/workers.h"
#include "stepping/component.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <map>
#include <set>
#include <span>
#include <thread>

namespace solution {

class Solver::Implementation final : private Turns {
public:
    Implementation(std::shared_ptr<const PreparedEquations> prepared, Options options,
                   EventSource* source);

    Advance advanceTo(double finish);
    void takeLonger(std::shared_ptr<const TakenMotion> taken);
    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] double hopelessBeyond() const;
    [[nodiscard]] std::shared_ptr<const Histories> snapshot() const;
    [[nodiscard]] Statistics statistics() const;

    EquationsInForce set_;
    Histories histories_;

private:
    [[nodiscard]] std::unique_ptr<Component> madeOf(std::vector<std::size_t> unknowns);
    void place(double t);
    void addConstantTracks();
    [[nodiscard]] bool isTaken(const std::vector<std::size_t>& unknowns) const;
    void take(const std::vector<std::size_t>& unknowns);
    [[nodiscard]] bool isUnread(std::size_t unknown) const {
        return !prepared_->unread.empty() && prepared_->unread[unknown];
    }
    [[nodiscard]] double magnitude(std::size_t unknown, double value) const;
    [[nodiscard]] std::vector<std::size_t> roused(double time,
                                                  std::span<const Changes::Jump> jumps) const;
    [[nodiscard]] std::vector<std::size_t> woken(const Event& event, const Changes& changes);
    void add(const Changes& changes);
    // By an event: it tells of no body.
    [[nodiscard]] bool isAdded(std::size_t unknown) const {
        return unknown >= prepared_->set->unknowns.size();
    }
    [[nodiscard]] bool sleepsOn(const Changes::Equation& change) const;
    void change(const Event& event, const Changes& changes);
    void addTracks(const Component& component, double t);
    void connect(const Partition& partition, std::span<const std::size_t> places);
    void run(double finish, Advance& advance);
    [[nodiscard]] double roundsEnd(double finish) const;
    void doRound(double until);
    // Up to a time, or until each has kept that many bytes more.
    struct Leg {
        double until = 0;
        std::size_t share = 0;
    };
    void advanceGroup(std::size_t group, const Leg& leg);
    void advanceAlone(std::size_t place, const Leg& leg, bool isCaller);
    void advanceGroups(std::span<const std::size_t> groups, const Leg& leg);
    void advanceSideBySide(std::span<const std::size_t> places, const Leg& leg);
    void poll(double time);
    [[nodiscard]] Component& readyFor(Component& component);
    [[nodiscard]] double known() const { return schedule_.known(); }

    [[nodiscard]] bool handleEvents(double finish);
    [[nodiscard]] bool goesOnAfter(const Event& event);
    void apply(const Event& event);
    // Flights, in solver_flights.cpp.
    struct Flight {
        struct Axis {                            // that is not 0 for ever
            std::size_t place = 0, velocity = 0; // components; a velocity may stay 0
            std::size_t coordinate = 0;
            double half = 0; // of the acceleration
        };
        std::vector<Axis> axes;
        std::array<bool, 3> moves{};      // by coordinate: its velocity is not 0 for ever
        std::shared_ptr<History> history; // a column for each axis, then the rates of these
        bool isBent = false;              // else accelerations are 0
        bool isOn = false;                // else the components go on by themselves
        [[nodiscard]] std::size_t terms() const { return isBent ? 3 : 2; }
        [[nodiscard]] std::size_t bytesOfTurn() const {
            return (1 + axes.size() * terms()) * sizeof(double);
        }
    };
    [[nodiscard]] bool turn(double time, std::span<Turn> turns) override;
    [[nodiscard]] Flight* flightOf(std::size_t unknown);
    [[nodiscard]] bool fliesOn(std::span<const Turn> turns);
    [[nodiscard]] bool staysInPlane(double time, std::span<Turn> turns) const;
    [[nodiscard]] bool turn(double time, Turn& turn);
    [[nodiscard]] std::optional<std::vector<Flight::Axis>> axesOf(const Turn& turn) const;
    [[nodiscard]] Flight* takeOff(double time, Turn& turn);
    [[nodiscard]] Flight& openFlight(const Turn& turn);
    void follow(const Flight& flight, const Turn& turn, double time);
    void land(std::span<const std::size_t> components);
    void land(Flight& flight);
    [[nodiscard]] std::vector<std::size_t> touchedBy(const Event& event,
                                                     const Changes& changes) const;
    void resume(const Event& event, const Changes& changes, std::vector<std::size_t>& touched);
    void goBack(const std::vector<std::size_t>& components, double t);
    void restart(const std::vector<std::size_t>& components, const Changes& changes);
    void endThose(const Changes& changes);
    // The changes of components by an event's new equations, in solver_equations.cpp.
    struct Region { // all of the groups that they concern
        std::vector<std::size_t> groups, components, unknowns;
        Partition partition;  // anew, of places in `unknowns`
        bool isTaken = false; // one of them was taken from another run: the rest is not filled in
    };
    [[nodiscard]] std::set<std::size_t> changedBy(const Event& event, const Changes& changes,
                                                  const std::vector<std::size_t>& woken);
    [[nodiscard]] Region regionOf(const Event& event, const std::set<std::size_t>& changed,
                                  const std::vector<std::size_t>& woken) const;
    [[nodiscard]] std::vector<double> valuesAt(const Event& event, const Changes& changes,
                                               std::span<const std::size_t> unknowns);
    [[nodiscard]] std::vector<std::size_t> replace(const Event& event, const Changes& changes,
                                                   const std::vector<std::size_t>& woken);
    void retire(Component& component);
    void stopFor(const Event& event, Stop::Reason reason, const std::string& sentence);
    void stopIsland(const Event& event, const std::string& sentence);
    void stopAll(double time, const std::string& sentence);
    void noteStops();
    // The bytes that are kept, in solver_kept.cpp.
    void noteKept(std::size_t place);
    [[nodiscard]] std::size_t keptBefore(double t) const;
    [[nodiscard]] double fullTime(double until) const;
    [[nodiscard]] bool isFull();
    void endWhereFull();
    [[nodiscard]] std::vector<std::size_t> clusters() const;
    [[nodiscard]] std::map<std::size_t, double> keptBy(const std::vector<std::size_t>& clusters,
                                                       double time) const;
    void stopFull(double time);

    std::vector<Flight> flights_;
    std::vector<std::uint32_t> flightOf_; // by unknown; 0: none, else one more than its place

    std::shared_ptr<const PreparedEquations> prepared_;
    Options options_;
    EventSource* source_;
    ZeroStates zero_;
    std::vector<std::unique_ptr<Component>> components_; // none where one was replaced or taken
    std::vector<std::vector<std::size_t>> readers_;
    std::vector<std::size_t> componentOf_;
    mutable std::vector<char> isTouched_; // by component; all 0 but within touchedBy()
    Schedule schedule_{components_};
    Workers workers_;
    std::thread::id caller_; // of advanceTo()
    std::atomic<bool> cancelled_ = false;
    std::atomic<bool> stopsChanged_ = true; // since noteStops()

    Statistics past_; // of components that replaced equations ended, and of events
    double lastEvent_ = -infinity;
    EventPaces paces_{options_.start};
    std::vector<std::size_t> turning_; // of each motion that turns, one unknown
    double retiredBeyond_ = infinity;  // hopelessBeyond() of components that were replaced
    KeptBytes kept_{options_.mostBytes};
    std::size_t polls_ = 0;
    bool disturbed_ = false;   // an event touched what was taken
    double asked_ = -infinity; // the source has answered up to here
};

} // namespace solution
