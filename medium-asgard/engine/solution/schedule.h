// Which components step next, and which may do so side by side?
//
// Components that read each other, directly or through others, are a group: what happens in one
// group concerns no other until an event. Time advances in rounds:
//
//     a round takes the groups that are furthest behind, in order of time, as long as the next is
//     behind the end of a step that one of those taken would make; the least such end ends the
//     round. Each group then steps until all of it has reached the end of the round.
//
// So no group is ever further ahead of the others than one step of its own, and little is thrown
// away at an event. Where there are events, a group whose component passes a switch leaves the
// round: the step that was foreseen is none any more, and an event may come first. Rounds follow
// from times and steps alone: the threads that share one, and their number, change neither motion
// nor counts.
#pragma once

#include "equations/partition.h"
#include "stepping/component.h"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace solution {

class Schedule {
public:
    using Components = std::vector<std::unique_ptr<Component>>;
    explicit Schedule(const Components& components) : components_(components) {}

    // New groups of these components: those of the partition, by the places that they have among
    // all. Groups that they were in before must have been disbanded.
    void arrange(const Partition& partition, std::span<const std::size_t> places);
    void disband(std::size_t group) {
        times_.erase({groups_[group].time, group});
        groups_[group] = {};
        free_.push_back(group);
    }
    [[nodiscard]] std::size_t groupOf(std::size_t component) const { return groupOf_[component]; }
    // Inputs before their readers.
    [[nodiscard]] const std::vector<std::size_t>& components(std::size_t group) const {
        return groups_[group].components;
    }
    // Inputs of a group come before their readers.
    [[nodiscard]] bool comesBefore(std::size_t a, std::size_t b) const {
        return std::pair(rank_[a], a) < std::pair(rank_[b], b);
    }
    // The time of this component has changed, or it ended or goes on.
    void changed(std::size_t component);

    // All that did not end are known up to here.
    [[nodiscard]] double known() const { return times_.empty() ? infinity : times_.begin()->first; }
    [[nodiscard]] std::size_t groups() const { return groups_.size() - free_.size(); }

    struct Round {
        std::vector<std::size_t> groups;
        double until = 0;
        std::size_t work = 0; // unknowns that step
    };
    // None behind `finish`: no groups. A round that is `unbroken` goes to the finish.
    [[nodiscard]] Round nextRound(double finish, bool unbroken) const;

    // During a round, by the one thread that has the group. The component furthest behind `until`;
    // `any`: even when all have reached it. Or, `inOrder`, the first that has not reached it.
    [[nodiscard]] std::optional<std::size_t> next(std::size_t group, double until, bool any,
                                                  bool inOrder);
    void stepped(std::size_t component);
    // After the round, for each of its groups.
    void settle(std::size_t group);

private:
    using Entry = std::pair<double, std::size_t>; // time, component
    struct Group {
        std::vector<std::size_t> components;
        std::vector<Entry> behind; // a heap; entries with another than the component's time are old
        double time = infinity;    // its place in times_
    };
    [[nodiscard]] bool isOld(const Entry& entry) const {
        const Component& component = *components_[entry.second];
        return component.ended() || component.time() != entry.first;
    }
    [[nodiscard]] const Entry* furthestBehind(Group& group);
    void enter(std::size_t component);

    const Components& components_;
    std::vector<Group> groups_;
    std::vector<std::size_t> free_;                  // groups that are disbanded
    std::vector<std::size_t> groupOf_, rank_;        // by component
    std::set<std::pair<double, std::size_t>> times_; // of groups that did not end
};

} // namespace solution
