// Makes the steps of one round (schedule.h): groups on any thread, alike components side by side.
//
// Threads do not concern each other, so that motion and counts are the same for any number.
#pragma once

#include "solution/interruption.h"
#include "solution/network.h"
#include "solution/workers.h"

#include <cstddef>
#include <span>

namespace solution {

class Rounds {
public:
    // Without events a group need not wait for the others.
    Rounds(Network& network, Interruption& interruption, bool haveEvents)
        : network_(network), interruption_(interruption), workers_(network.options.threads),
          haveEvents_(haveEvents) {}

    // Of the groups that are furthest behind, at most up to that time.
    void doOne(double until);
    void rest() { workers_.rest(); }
    [[nodiscard]] std::size_t done() const { return done_; }

private:
    // Up to a time, or until each has kept that many bytes more.
    struct Leg {
        double until = 0;
        std::size_t share = 0;
    };
    void advanceGroup(std::size_t group, const Leg& leg);
    void advanceAlone(std::size_t place, const Leg& leg);
    void advanceGroups(std::span<const std::size_t> groups, const Leg& leg);
    void advanceSideBySide(std::span<const std::size_t> places, const Leg& leg);

    Network& network_;
    Interruption& interruption_;
    Workers workers_;
    bool haveEvents_;
    std::size_t done_ = 0;
};

} // namespace solution
