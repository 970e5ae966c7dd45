#include "modes/switch_log.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace solution {

namespace {

// So many switches in such a part of the time since the start have no end.
struct Endless {
    std::size_t times;
    double part;
};
constexpr Endless endless[] = {{100, 1e-10}, {1'000, 1e-7}};
constexpr double resolved = 16;     // units in the last place of the time, from switch to switch
constexpr double least = 1e-16;     // of time
constexpr std::size_t kept = 4'000; // an event may take some back

void dropAfter(std::vector<double>& times, double t) {
    while (!times.empty() && times.back() > t)
        times.pop_back();
}

} // namespace

void SwitchLog::add(double t, std::vector<std::size_t> surfaces) {
    goOn();
    switches_.push_back({t, std::move(surfaces)});
    if (switches_.size() > kept)
        switches_.pop_front();
}

void SwitchLog::backTo(double t) {
    while (!switches_.empty() && switches_.back().time > t)
        switches_.pop_back();
    dropAfter(rests_, t);
    dropAfter(stays_, t);
}

bool SwitchLog::isEndless(double now) const {
    return std::ranges::any_of(endless,
                               [&](const Endless& e) { return isEndless(now, e.times, e.part); });
}

bool SwitchLog::isEndless(double now, std::size_t times, double part) const {
    const double units = resolved * std::numeric_limits<double>::epsilon() * std::abs(now);
    return switches_.size() >= times &&
           now - timeBack(times) <=
               std::max(part * (now - start_), static_cast<double>(times) * units) + least;
}

bool SwitchLog::hasSwitched(double now, std::size_t times, double part) const {
    const double shortest = part * std::max(std::abs(now), now - start_) + least;
    return switches_.size() >= times && now - timeBack(times) <= shortest;
}

// Three groups of switches: their lengths fall by a factor, and the two factors are alike.
bool SwitchLog::swingsShrink(double now, double since) const {
    constexpr std::size_t group = 8;
    constexpr double shorter = 0.9, alike = 4;
    if (!hasSwitched(now) || switches_.size() <= 3 * group ||
        !isAfterRest(timeBack(1 + 3 * group), since))
        return false;
    const auto end = [this](std::size_t groups) { return timeBack(1 + groups * group); };
    const double last = end(0) - end(1), before = end(1) - end(2), first = end(2) - end(3);
    return last > 0 && last < shorter * before && before < shorter * first &&
           last * first < alike * before * before && before * before < alike * last * first;
}

bool SwitchLog::goesToAndFro(double now, double since) const {
    constexpr double shortWhile = 1e-4, hardlyLess = 0.9;
    if (!hasSwitched(now, 2 * often, shortWhile))
        return false;
    const double first = timeBack(2 * often), middle = timeBack(often);
    return isAfterRest(first, since) && now - middle > hardlyLess * (middle - first);
}

bool SwitchLog::hasStayedNear(double now) const {
    const double near = 1e-5 * std::max(std::abs(now), now - start_);
    return !stays_.empty() && now - stays_.back() <= near;
}

std::vector<std::size_t> SwitchLog::surfacesOfLast() const {
    std::set<std::size_t> found;
    for (std::size_t n = 1; n <= often; ++n)
        found.insert(switches_[switches_.size() - n].surfaces.begin(),
                     switches_[switches_.size() - n].surfaces.end());
    return {found.begin(), found.end()};
}

} // namespace solution
