#include "simulation/computed_motion.h"

#include <algorithm>

namespace simulation {

ComputedMotion::ComputedMotion(Contents contents) : c_(std::move(contents)) {
    computed_ = std::clamp(c_.histories->known(), c_.start, c_.finish);
}

BodyState ComputedMotion::at(std::size_t body, double time) const {
    const auto stopped = c_.stops.find(body);
    const double end = stopped == c_.stops.end() ? computed_ : stopped->second.time;
    return stateOf((*c_.bodies)[body], *c_.histories, std::clamp(time, c_.start, end));
}

std::optional<Stop> ComputedMotion::stop(std::size_t body) const {
    const auto stopped = c_.stops.find(body);
    return stopped == c_.stops.end() ? std::nullopt : std::optional(stopped->second);
}

Vector ComputedMotion::centroid(std::size_t body) const { return (*c_.bodies)[body].centroid; }

double ComputedMotion::mass(std::size_t body) const { return (*c_.bodies)[body].mass; }

std::vector<double> ComputedMotion::jumps(std::size_t body) const {
    const BodyRecord& record = (*c_.bodies)[body];
    std::vector<double> times;
    if (record.isFixed)
        return times;
    // Solved positions meet at joints to rounding; a displacement is more than that.
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t unknown = record.firstUnknown + physics::x + i;
        for (const double t : c_.histories->restarts(unknown)) {
            const double before = c_.histories->pieceBefore(unknown, t).value(t);
            const double after = c_.histories->value(unknown, t);
            if (t > c_.start && std::abs(after - before) > 1e-6 * record.radius)
                times.push_back(t);
        }
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

} // namespace simulation
