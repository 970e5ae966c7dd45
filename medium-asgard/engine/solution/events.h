// Asks the source for its events (event_source.h), in order, and does what they say.
#pragma once

#include "solution/event_islands.h"
#include "solution/event_source.h"
#include "solution/flights.h"
#include "solution/interruption.h"
#include "solution/memory_limit.h"
#include "solution/network.h"
#include "solution/replacement.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace solution {

class Events final : private Turns {
public:
    // The source may be null: then nothing happens.
    Events(Network& network, Interruption& interruption, EventSource* source);

    // All events up to `finish` that lie in what is known. True: there was one, or steps were ended
    // before one: less is known now.
    [[nodiscard]] bool handleAll(double finish);
    void endWhereFull() { memory_.endWhereFull(asked_, lastEvent_); }
    // The bytes that are kept of all motion, of events, too.
    [[nodiscard]] std::size_t kept() const { return memory_.keptBefore(infinity); }
    // The work of components that events replaced, and the number of events.
    [[nodiscard]] Statistics statistics() const;

private:
    [[nodiscard]] bool handleNext(double finish);
    [[nodiscard]] bool goesOnAfter(const Event& event);
    void apply(const Event& event);
    [[nodiscard]] bool turn(double time, std::span<Turn> turns) override;
    [[nodiscard]] std::optional<double> approach(double time, std::span<const std::size_t> unknowns,
                                                 const IsBefore& isBefore) override;
    void resume(const Event& event, const Changes& changes, std::vector<std::size_t>& touched);
    void stopAll(double time, const std::string& sentence);

    Network& network_;
    Interruption& interruption_;
    EventSource* source_;
    EventIslands islands_;
    Flights flights_{network_, islands_};
    Replacement replacement_{network_, flights_};
    MemoryLimit memory_{network_, flights_, islands_, source_};
    std::size_t events_ = 0;
    double lastEvent_ = -infinity;
    double asked_ = -infinity;         // the source has answered up to here
    bool hasGoneBack_ = false;         // by approach()
    std::vector<std::size_t> turning_; // of each motion that turns, one unknown
};

} // namespace solution
