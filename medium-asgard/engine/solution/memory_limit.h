// A motion has a limit of memory: one that would need more ends, and says so.
//
// It ends at the time up to which all that is kept takes the limit. That follows from the motion
// alone: neither threads, rounds, observers nor the finish change it. What needs most of it ends,
// and the rest goes on as long as it needs little more. Components without events between them go
// ahead of each other, by equal shares, so that what lies beyond that time is never more than the
// limit.
//
// So does a motion end whose finish is farther away than anybody waits for.
#pragma once

#include "solution/event_islands.h"
#include "solution/event_source.h"
#include "solution/flights.h"
#include "solution/network.h"

#include <cstddef>
#include <map>
#include <vector>

namespace solution {

class MemoryLimit {
public:
    // The source may be null. Those that met in events end together.
    MemoryLimit(Network& network, Flights& flights, const EventIslands& islands,
                const EventSource* source)
        : network_(network), flights_(flights), islands_(islands), source_(source) {}

    [[nodiscard]] bool isFull();
    // The source has answered up to `asked`, and its last event was at that time. Where what was
    // taken from another run might end, too, the network is disturbed, and nothing ends.
    void endWhereFull(double asked, double lastEvent);
    // Bytes of the motion up to t.
    [[nodiscard]] std::size_t keptBefore(double t) const {
        return network_.keptBefore(t) + (source_ ? source_->bytesBefore(t) : 0);
    }

private:
    [[nodiscard]] double fullTime(double until) const;
    [[nodiscard]] std::vector<std::size_t> clusters() const;
    [[nodiscard]] std::map<std::size_t, double> keptBy(const std::vector<std::size_t>& clusters,
                                                       double time) const;
    void stopFull(double time);

    Network& network_;
    Flights& flights_;
    const EventIslands& islands_;
    const EventSource* source_;
};

} // namespace solution
