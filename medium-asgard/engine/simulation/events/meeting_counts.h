// Which bodies meet others, or change what bears them, again and again without end?
#pragma once

#include "events/instant.h"
#include "solution/accumulation_monitor.h"

#include <optional>
#include <vector>

namespace simulation {

class MeetingCounts {
public:
    MeetingCounts(std::size_t bodies, double start)
        : start_(start), meetings_(bodies), changes_(bodies) {}

    // One more meeting of a body. `turnsBack`: the other one gives way, so that it ends after
    // however many (Galperin's billiard). True: they have no end.
    [[nodiscard]] bool meets(std::size_t body, std::size_t other, bool turnsBack, double time);
    // Its supports change so often within next to no time that no position of rest is found.
    [[nodiscard]] bool isRestless(std::size_t body, double time);
    // Of the last meetings of a body not all were with the same one.
    [[nodiscard]] bool isWithSeveral(std::size_t body) const {
        return meetings_[body].isWithSeveral;
    }

private:
    struct Meetings {
        solution::AccumulationMonitor monitor;
        std::optional<std::size_t> partner; // the last
        // Since the monitor's last mark:
        bool isGivenWay = false;    // by someone
        bool isWithSeveral = false; // not all of them with the same body
    };

    double start_;
    std::vector<Meetings> meetings_;                     // by body
    std::vector<solution::AccumulationMonitor> changes_; // by body: of what bears it
};

// One more meeting of these two: it has no end for one of them.
[[nodiscard]] bool meetsWithoutEnd(const Instant& instant, const Pair& pair, MeetingCounts& counts);

} // namespace simulation
