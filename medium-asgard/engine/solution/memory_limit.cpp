#include "solution/memory_limit.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>

namespace solution {

namespace {

std::string megabytes(std::size_t bytes) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g MB", static_cast<double>(bytes) * 1e-6);
    return text;
}

} // namespace

// The memory of components that were replaced may have been counted too often.
bool MemoryLimit::isFull() {
    const std::size_t ofSource = source_ ? source_->bytesBefore(infinity) : 0;
    if (!network_.kept.isFullWith(ofSource))
        return false;
    network_.kept.count(keptBefore(infinity) - ofSource);
    return network_.kept.isFullWith(ofSource);
}

// Up to which all that is kept takes the limit; `until`: later.
double MemoryLimit::fullTime(double until) const {
    double within = network_.options.start, beyond = until;
    if (keptBefore(beyond) <= network_.kept.most())
        return until;
    for (;;) {
        const double middle = within + (beyond - within) / 2;
        if (!(middle > within && middle < beyond))
            return within;
        (keptBefore(middle) > network_.kept.most() ? beyond : within) = middle;
    }
}

void MemoryLimit::endWhereFull(double asked, double lastEvent) {
    network_.kept.setFullAt(infinity);
    if (!isFull())
        return;
    const bool isAsked = source_ && network_.options.eventDriven;
    double latest = network_.known();
    for (const auto& component : network_.components)
        if (component && !isAsked && !component->ended() && component->time() < infinity)
            latest = std::max(latest, component->time());
    const double until = isAsked ? std::min(asked, network_.known()) : latest;
    const double time = std::max({network_.options.start, lastEvent, fullTime(until)});
    network_.kept.setFullAt(time);
    if (isAsked || network_.known() >= time)
        stopFull(time);
}

// Components that read each other or met, directly or through others: by component, the least of
// them.
std::vector<std::size_t> MemoryLimit::clusters() const {
    std::vector<std::size_t> least(network_.components.size());
    std::iota(least.begin(), least.end(), std::size_t{0});
    const auto root = [&least](std::size_t c) {
        while (least[c] != c)
            c = least[c] = least[least[c]];
        return c;
    };
    const auto join = [&](std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        least[std::max(a, b)] = std::min(a, b);
    };
    std::map<std::size_t, std::size_t> ofIsland;
    for (std::size_t u = 0; u < network_.componentOf.size(); ++u)
        if (const std::size_t c = network_.componentOf[u]; c != noComponent)
            join(c, ofIsland.try_emplace(islands_.islandNumber(u), c).first->second);
    for (std::size_t c = 0; c < network_.readers.size(); ++c)
        for (const std::size_t reader : network_.readers[c])
            join(c, reader);
    for (std::size_t& c : least)
        c = root(c);
    return least;
}

// By cluster of what moves: what is kept of it up to a time.
std::map<std::size_t, double> MemoryLimit::keptBy(const std::vector<std::size_t>& clusters,
                                                  double time) const {
    std::map<std::size_t, double> kept;
    for (std::size_t u = 0; u < network_.componentOf.size(); ++u) {
        const std::size_t c = network_.componentOf[u];
        if (c == noComponent || network_.components[c]->ended())
            continue;
        kept[clusters[c]] += network_.keptOf(u, time);
    }
    return kept;
}

// Clusters of which no less is kept than of others, in the mean: these need so much.
void MemoryLimit::stopFull(double time) {
    network_.isDisturbed = network_.options.taken != nullptr; // what was taken might end there, too
    if (network_.isDisturbed)
        return;
    const std::vector<std::size_t> cluster = clusters();
    const auto kept = keptBy(cluster, time);
    double mean = 0;
    for (const auto& [which, bytes] : kept)
        mean += bytes / static_cast<double>(kept.size());
    Event large{.time = time, .touched = {}, .tag = 0};
    for (std::size_t u = 0; u < network_.componentOf.size(); ++u)
        if (const std::size_t c = network_.componentOf[u]; c != noComponent)
            if (const auto found = kept.find(cluster[c]);
                found != kept.end() && found->second >= (1 - 1e-9) * mean)
                large.touched.push_back(u);
    const std::vector<std::size_t> ending = network_.touchedBy(large, {});
    flights_.land(ending);
    network_.goBack(ending, time);
    network_.end(large.touched, Stop::Reason::tooMuchKept,
                 "the motion up to here takes " + megabytes(network_.kept.most()) +
                     ", which is the limit");
    network_.noteStops();
    for (const std::size_t c : ending)
        network_.noteKept(c);
    network_.kept.allowMore();
    network_.kept.setFullAt(infinity);
}

} // namespace solution
