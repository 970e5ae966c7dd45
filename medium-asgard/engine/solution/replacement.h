// An event's new equations make other components.
//
// Groups of components that read what changed are cut anew. Components that keep their unknowns and
// equations stay as they are; others are replaced by new ones, from the values at the event.
#pragma once

#include "solution/flights.h"
#include "solution/network.h"
#include "solution/statistics.h"

#include <cstddef>
#include <set>
#include <span>
#include <vector>

namespace solution {

class Replacement {
public:
    Replacement(Network& network, Flights& flights) : network_(network), flights_(flights) {}

    // The equations of the event are in force from its time on.
    void change(const Event& event, const Changes& changes);
    // Exchanges components; answers with those that must restart. `woken` stayed 0 before. Where an
    // equation reads what was taken from another run, the network is disturbed, and nothing is
    // done.
    [[nodiscard]] std::vector<std::size_t> replace(const Event& event, const Changes& changes,
                                                   const std::vector<std::size_t>& woken);
    // The work of components that were replaced.
    [[nodiscard]] const Statistics& retired() const { return retired_; }

private:
    struct Region { // all of the groups that new equations concern
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
    void retire(Component& component);

    Network& network_;
    Flights& flights_;
    Statistics retired_;
};

} // namespace solution
