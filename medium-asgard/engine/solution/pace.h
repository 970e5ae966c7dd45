// Would a motion need more events than anybody waits for (stepping/work_estimate.h)?
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace solution {

// Events that unknowns take part in. Those that met, directly or through others, are an island, and
// share its events: what happens elsewhere has no part in them.
class EventPaces {
    static constexpr double never = -std::numeric_limits<double>::infinity();

public:
    struct Island {
        std::size_t events = 0;
        // When as many events had been, at the last powers of 2 and at 3/4 of the last one.
        double quarter = never, half = never, third = never;
        double last = never; // of its events, and how many there were at that time
        std::size_t atLast = 0;

        [[nodiscard]] std::size_t eventsAt(double time) const { return time == last ? atLast : 0; }
        void note(double time);
        // So many next events are but one more each: they make nothing hopeless.
        [[nodiscard]] std::size_t plainAhead() const;
    };

    explicit EventPaces(double start) : start_(start) {}
    // Of one motion: they share their island from now on.
    void join(std::span<const std::size_t> unknowns);
    // The earliest finish that this event, which joins them, would make hopeless.
    [[nodiscard]] double hopelessFrom(double time, std::span<const std::size_t> unknowns) const;
    // How many were noted at that time, the last one, of what these take part in: the most of their
    // islands. Those that no unknown takes part in count together.
    [[nodiscard]] std::size_t atOnce(double time, std::span<const std::size_t> unknowns) const;
    void note(double time, std::span<const std::size_t> unknowns);
    // Of unknowns of one island whose next event is but one more: that island. Null: else, and
    // those above tell.
    [[nodiscard]] Island* plainIsland(std::span<const std::size_t> unknowns);
    // The island of an unknown that took part in an event.
    [[nodiscard]] Island& island(std::size_t unknown) { return islands_[rootOf(unknown)]; }
    // The unknown that stands for its island.
    [[nodiscard]] std::size_t islandNumber(std::size_t unknown) const { return rootOf(unknown); }
    // All in the island of an unknown.
    [[nodiscard]] std::vector<std::size_t> islandOf(std::size_t unknown) const;
    [[nodiscard]] double beyond() const { return beyond_; }

private:
    [[nodiscard]] std::size_t rootOf(std::size_t unknown) const;
    std::size_t unite(std::span<const std::size_t> unknowns);

    double start_;
    mutable std::vector<std::size_t> parents_; // by unknown; itself: the island's root
    std::vector<Island> islands_;              // by root
    Island nobody_;                            // events that no unknown takes part in
    double beyond_ = std::numeric_limits<double>::infinity();
};

} // namespace solution
