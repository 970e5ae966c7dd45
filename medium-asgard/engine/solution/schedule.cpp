#include "solution/schedule.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace solution {

namespace {

// The first component of each one's group.
std::vector<std::size_t> firstsOf(const Partition& partition) {
    std::vector<std::size_t> first(partition.components.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&](std::size_t c) {
        while (first[c] != c)
            c = first[c] = first[first[c]];
        return c;
    };
    for (std::size_t c = 0; c < first.size(); ++c)
        for (const std::size_t input : partition.reads[c]) {
            const std::size_t a = root(c), b = root(input);
            first[std::max(a, b)] = std::min(a, b);
        }
    for (std::size_t c = 0; c < first.size(); ++c)
        first[c] = root(c);
    return first;
}

} // namespace

void Schedule::arrange(const Partition& partition, std::span<const std::size_t> places) {
    const std::vector<std::size_t> first = firstsOf(partition);
    groupOf_.resize(components_.size());
    rank_.resize(components_.size());
    std::vector<std::size_t> made;
    for (std::size_t c = 0; c < first.size(); ++c) {
        if (first[c] == c) {
            if (free_.empty())
                free_.push_back(groups_.size());
            made.push_back(free_.back());
            free_.pop_back();
            groups_.resize(std::max(groups_.size(), made.back() + 1));
            groupOf_[places[c]] = made.back();
        } else {
            groupOf_[places[c]] = groupOf_[places[first[c]]];
        }
        rank_[places[c]] = c;
        groups_[groupOf_[places[c]]].components.push_back(places[c]);
        enter(places[c]);
    }
    for (const std::size_t group : made)
        settle(group);
}

void Schedule::enter(std::size_t component) {
    if (!components_[component] || components_[component]->ended())
        return;
    auto& heap = groups_[groupOf_[component]].behind;
    heap.emplace_back(components_[component]->time(), component);
    std::ranges::push_heap(heap, std::greater<>());
}

void Schedule::changed(std::size_t component) {
    enter(component);
    settle(groupOf_[component]);
}

const Schedule::Entry* Schedule::furthestBehind(Group& group) {
    while (!group.behind.empty() && isOld(group.behind.front())) {
        std::ranges::pop_heap(group.behind, std::greater<>());
        group.behind.pop_back();
    }
    return group.behind.empty() ? nullptr : &group.behind.front();
}

void Schedule::settle(std::size_t g) {
    Group& group = groups_[g];
    const Entry* entry = furthestBehind(group);
    const double time = entry ? entry->first : infinity;
    if (time == group.time)
        return;
    times_.erase({group.time, g});
    group.time = time;
    if (entry && time < infinity)
        times_.emplace(time, g);
}

Schedule::Round Schedule::nextRound(double finish, bool unbroken) const {
    Round round{.groups = {}, .until = finish};
    for (const auto& [time, g] : times_) {
        const bool isFirst = round.groups.empty();
        if (time >= finish || !(isFirst || time < round.until || time == times_.begin()->first))
            break;
        const Component& component = *components_[groups_[g].behind.front().second];
        round.groups.push_back(g);
        round.work += component.unknowns().size();
        if (!unbroken)
            round.until = std::min(round.until, component.nextEnd());
    }
    return round;
}

std::optional<std::size_t> Schedule::next(std::size_t g, double until, bool any, bool inOrder) {
    Group& group = groups_[g];
    if (inOrder) {
        const auto found = std::ranges::find_if(group.components, [&](std::size_t c) {
            return !components_[c]->ended() && components_[c]->time() < until;
        });
        return found == group.components.end() ? std::nullopt : std::optional(*found);
    }
    const Entry* entry = furthestBehind(group);
    return entry && (any || entry->first < until) ? std::optional(entry->second) : std::nullopt;
}

void Schedule::stepped(std::size_t component) { enter(component); }

} // namespace solution
