// What is kept of a motion has a limit: a motion that would need more ends, and says so.
//
// It ends at the time up to which all that is kept takes the limit. That follows from the motion
// alone: neither threads, rounds, observers nor the finish change it. What needs most of it ends,
// and the rest goes on as long as it needs little more. Components without events between them go
// ahead of each other, by equal shares, so that what lies beyond that time is never more than the
// limit.
#include "solution/solver_implementation.h"

#include <cstdio>
#include <map>
#include <numeric>

namespace solution {

namespace {

constexpr std::size_t ofUnknown = 128; // that a component takes beside its steps, for each

std::string megabytes(std::size_t bytes) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g MB", static_cast<double>(bytes) * 1e-6);
    return text;
}

} // namespace

std::size_t Solver::Implementation::keptBefore(double t) const {
    std::size_t sum = histories_.bytesBefore(t) + (source_ ? source_->bytesBefore(t) : 0);
    std::size_t tracks = 0;
    for (const Histories::Track& track : histories_.tracks_)
        for (const Histories::Span& span : track.spans)
            tracks += span.from < t ? 1 : 0;
    for (const auto& component : components_)
        sum += component ? component->checkpointBytesBefore(t) : 0;
    return sum + tracks * ofUnknown;
}

void Solver::Implementation::noteKept(std::size_t place) {
    if (const Component* component = components_[place].get())
        kept_.note(place, component->history()->bytes() + ofUnknown * component->unknowns().size() +
                              component->checkpointBytesBefore(infinity));
}

// What components that were replaced kept beside their motion may have been counted too often.
bool Solver::Implementation::isFull() {
    const std::size_t ofSource = source_ ? source_->bytesBefore(infinity) : 0;
    if (!kept_.isFullWith(ofSource))
        return false;
    kept_.count(keptBefore(infinity) - ofSource);
    return kept_.isFullWith(ofSource);
}

// Up to which all that is kept takes the limit; `until`: later.
double Solver::Implementation::fullTime(double until) const {
    double within = options_.start, beyond = until;
    if (keptBefore(beyond) <= kept_.most())
        return until;
    for (;;) {
        const double middle = within + (beyond - within) / 2;
        if (!(middle > within && middle < beyond))
            return within;
        (keptBefore(middle) > kept_.most() ? beyond : within) = middle;
    }
}

void Solver::Implementation::endWhereFull() {
    kept_.setFullAt(infinity);
    if (!isFull())
        return;
    const bool isAsked = source_ && options_.eventDriven;
    double latest = known();
    for (const auto& component : components_)
        if (component && !isAsked && !component->ended() && component->time() < infinity)
            latest = std::max(latest, component->time());
    const double until = isAsked ? std::min(asked_, known()) : latest;
    const double time = std::max({options_.start, lastEvent_, fullTime(until)});
    kept_.setFullAt(time);
    if (isAsked || known() >= time)
        stopFull(time);
}

// Components that read each other or met, directly or through others: by component, the least of
// them.
std::vector<std::size_t> Solver::Implementation::clusters() const {
    std::vector<std::size_t> least(components_.size());
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
    for (std::size_t u = 0; u < componentOf_.size(); ++u)
        if (const std::size_t c = componentOf_[u]; c != noComponent)
            join(c, ofIsland.try_emplace(paces_.islandNumber(u), c).first->second);
    for (std::size_t c = 0; c < readers_.size(); ++c)
        for (const std::size_t reader : readers_[c])
            join(c, reader);
    for (std::size_t& c : least)
        c = root(c);
    return least;
}

// By cluster of what moves: what is kept of it up to a time.
std::map<std::size_t, double>
Solver::Implementation::keptBy(const std::vector<std::size_t>& clusters, double time) const {
    std::map<std::size_t, double> kept;
    for (std::size_t u = 0; u < componentOf_.size(); ++u) {
        const std::size_t c = componentOf_[u];
        if (c == noComponent || components_[c]->ended())
            continue;
        double& sum = kept[clusters[c]];
        for (const Histories::Span& span : histories_.tracks_[u].spans)
            sum += static_cast<double>(span.history->bytesBefore(time)) /
                   static_cast<double>(span.history->columns());
    }
    return kept;
}

// Clusters of which no less is kept than of others, in the mean: these need so much.
void Solver::Implementation::stopFull(double time) {
    disturbed_ = options_.taken != nullptr; // what was taken might end there, too
    if (disturbed_)
        return;
    const std::vector<std::size_t> cluster = clusters();
    const auto kept = keptBy(cluster, time);
    double mean = 0;
    for (const auto& [which, bytes] : kept)
        mean += bytes / static_cast<double>(kept.size());
    Event large{.time = time, .touched = {}, .tag = 0};
    for (std::size_t u = 0; u < componentOf_.size(); ++u)
        if (const std::size_t c = componentOf_[u]; c != noComponent)
            if (const auto found = kept.find(cluster[c]);
                found != kept.end() && found->second >= (1 - 1e-9) * mean)
                large.touched.push_back(u);
    const std::vector<std::size_t> ending = touchedBy(large, {});
    land(ending);
    goBack(ending, time);
    stopFor(large, Stop::Reason::tooMuchKept,
            "the motion up to here takes " + megabytes(kept_.most()) + ", which is the limit");
    for (const std::size_t c : ending)
        noteKept(c);
    kept_.allowMore();
    kept_.setFullAt(infinity);
}

} // namespace solution
