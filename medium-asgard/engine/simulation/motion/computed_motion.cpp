#include "motion/computed_motion.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace simulation {

ComputedMotion::ComputedMotion(Contents contents) : c_(std::move(contents)) {
    double known = solution::infinity;
    for (const Place& place : c_.places) // what is fixed is known for ever
        if (const Part& part = c_.parts[place.part]; !(*part.bodies)[place.body].isFixed)
            known = std::min(known, part.histories->known());
    computed_ = std::clamp(known, c_.start, c_.finish);
}

const solution::Histories& ComputedMotion::histories() const {
    assert(c_.parts.size() == 1);
    return *c_.parts[0].histories;
}

ComputedMotion::Solution ComputedMotion::of(std::size_t body) const {
    const Place place = c_.places[body];
    const Part& part = c_.parts[place.part];
    return {(*part.bodies)[place.body], *part.histories};
}

BodyState ComputedMotion::at(std::size_t body, double time) const {
    const auto stopped = c_.stops.find(body);
    const double end = stopped == c_.stops.end() ? computed_ : stopped->second.time;
    const auto [record, histories] = of(body);
    const double at = std::clamp(time, c_.start, end);
    const Part& part = c_.parts[c_.places[body].part];
    std::array<double, physics::bodyUnknowns> values{};
    if (part.conditions && !record.isFixed &&
        part.conditions->values(record.firstUnknown, at, values))
        return stateOf(record, values);
    return stateOf(record, histories, at);
}

double ComputedMotion::valueOf(std::size_t body, std::size_t unknown, double time) const {
    const Part& part = c_.parts[c_.places[body].part];
    double value = 0;
    if (part.conditions && part.conditions->values(unknown, time, std::span(&value, 1)))
        return value;
    return part.histories->value(unknown, time);
}

double ComputedMotion::readingOf(std::size_t body, std::string_view name, double time) const {
    const Part& part = c_.parts[c_.places[body].part];
    return part.conditions ? part.conditions->reading(name, time).value_or(0) : 0;
}

std::optional<Stop> ComputedMotion::stop(std::size_t body) const {
    const auto stopped = c_.stops.find(body);
    return stopped == c_.stops.end() ? std::nullopt : std::optional(stopped->second);
}

Vector ComputedMotion::centroid(std::size_t body) const { return of(body).record.centroid; }

double ComputedMotion::mass(std::size_t body) const { return of(body).record.mass; }

std::vector<double> ComputedMotion::jumps(std::size_t body) const {
    const auto [record, histories] = of(body);
    std::vector<double> times;
    if (record.isFixed)
        return times;
    // Solved positions meet at joints to rounding; a displacement is more than that.
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t unknown = record.firstUnknown + physics::x + i;
        for (const double t : histories.restarts(unknown)) {
            const double before = histories.pieceBefore(unknown, t).value(t);
            const double after = histories.value(unknown, t);
            const bool isWithin = t > c_.start && t <= c_.finish;
            if (isWithin && std::abs(after - before) > 1e-6 * record.radius)
                times.push_back(t);
        }
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

} // namespace simulation
