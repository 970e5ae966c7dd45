// The components in force: which unknowns each has, who reads whom, and where readers of the motion
// find each unknown.
//
// A network steps nothing: rounds.h does. An event goes through it in four moves:
//
//     touchedBy(event, changes)      the components that it concerns, and all that read these
//     goBack(components, time)       they forget what they solved beyond it
//     restart(components, changes)   they go on from the values that jump
//     endThose(changes)              or end
//
// New equations exchange components (replacement.h), and flights take their motion over
// (flights.h): both work on the parts of the network, which are open to them.
#pragma once

#include "equations/partition.h"
#include "equations/prepared_equations.h"
#include "solution/event_source.h"
#include "solution/kept_bytes.h"
#include "solution/schedule.h"
#include "stepping/component.h"

#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace solution {

class Network {
public:
    Network(std::shared_ptr<const PreparedEquations> prepared, Options options);
    Network(const Network&) = delete;
    Network& operator=(const Network&) = delete;

    // Nobody will read it.
    [[nodiscard]] bool isUnread(std::size_t unknown) const {
        return !prepared->unread.empty() && prepared->unread[unknown];
    }
    // By an event: it tells of no body.
    [[nodiscard]] bool isAdded(std::size_t unknown) const {
        return unknown >= prepared->set->unknowns.size();
    }
    // From an earlier run; so are all unknowns of its component.
    [[nodiscard]] bool isTaken(const std::vector<std::size_t>& unknowns) const {
        return options.taken && options.taken->unknowns[unknowns[0]];
    }
    // The motion that was taken, known for longer.
    void takeLonger(std::shared_ptr<const TakenMotion> taken);

    [[nodiscard]] std::unique_ptr<Component> madeOf(std::vector<std::size_t> unknowns);
    // Of these components, by their places among all: who reads whom.
    void connect(const Partition& partition, std::span<const std::size_t> places);
    // An unknown that stays 0 from the start on, until it gets a component.
    void addUnknown(const Changes::Addition& added);
    // From t on, readers find an unknown in that column, and those of a component in its history.
    void readFrom(double t, std::size_t unknown, std::shared_ptr<const History> history,
                  std::size_t column);
    void addTracks(const Component& component, double t);
    // The component, or the one of its inputs that must step before it.
    [[nodiscard]] Component& readyFor(Component& component);

    // Components of what the event touches, and transitively those that read them, in order.
    [[nodiscard]] std::vector<std::size_t> touchedBy(const Event& event,
                                                     const Changes& changes) const;
    void goBack(const std::vector<std::size_t>& touched, double t);
    void restart(const std::vector<std::size_t>& touched, const Changes& changes);
    void endThose(const Changes& changes);
    void end(std::span<const std::size_t> unknowns, Stop::Reason reason,
             const std::string& sentence);
    // Stops of components, for readers; after each change that could bring or lift one.
    void noteStops();
    // The memory that the component keeps, after it stepped or was cut.
    void noteKept(std::size_t place);

    [[nodiscard]] double known() const { return schedule.known(); }
    // All unknowns that did not stop are known up to here, for readers.
    void setKnown(double time) { histories.known_ = time; }
    // Bytes that histories and components hold.
    [[nodiscard]] std::size_t bytes() const;
    // Those of what is kept of the motion up to t.
    [[nodiscard]] std::size_t keptBefore(double t) const;
    // Those of an unknown's share in the histories that it was in.
    [[nodiscard]] double keptOf(std::size_t unknown, double t) const;
    [[nodiscard]] std::shared_ptr<const Histories> snapshot() const;

    std::shared_ptr<const PreparedEquations> prepared;
    Options options;
    EquationsInForce set;
    Histories histories;
    ZeroStates zero;
    std::vector<std::unique_ptr<Component>> components; // none where one was replaced or taken
    std::vector<std::vector<std::size_t>> readers;      // by component
    std::vector<std::size_t> componentOf;               // by unknown
    Schedule schedule{components};
    KeptBytes kept{options.mostBytes};
    std::atomic<bool> areStopsNew = true; // since noteStops()
    bool isDisturbed = false;             // an event touched what was taken

private:
    void place();
    void take(const std::vector<std::size_t>& unknowns);
    void addConstantTracks();
    [[nodiscard]] std::shared_ptr<const History> constant(double value) const;

    mutable std::vector<char> isTouched_; // by component; all 0 but within touchedBy()
};

} // namespace solution
