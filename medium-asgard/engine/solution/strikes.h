// An event source for tests: reverses given unknowns at given times.
#pragma once

#include "dense/histories.h"
#include "solution/event_source.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace solution::testing {

class Strikes final : public EventSource {
public:
    using Strike = std::pair<double, std::size_t>; // time, unknown
    explicit Strikes(std::vector<Strike> strikes) : strikes_(std::move(strikes)) {
        std::ranges::sort(strikes_);
    }
    std::optional<Event> next(const Histories& h, double known) override {
        for (; next_ < strikes_.size(); ++next_) {
            const auto& [time, unknown] = strikes_[next_];
            if (h.stop(unknown) && h.stop(unknown)->time <= time)
                continue;
            if (time > known)
                return std::nullopt;
            ++next_;
            return Event{time, {unknown}, 0};
        }
        return std::nullopt;
    }
    void apply(const Histories& h, const Event& event, EquationsInForce& /*equations*/,
               Changes& changes) override {
        const std::size_t u = event.touched[0];
        changes.jumps.push_back({u, -h.pieceBefore(u, event.time).value(event.time)});
    }

private:
    std::vector<Strike> strikes_;
    std::size_t next_ = 0;
};

} // namespace solution::testing
