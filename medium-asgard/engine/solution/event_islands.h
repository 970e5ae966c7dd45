// Which unknowns met in events, and how many events each such island had at one instant?
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace solution {

// Unknowns that met, directly or through others, are an island and share its events: what happens
// elsewhere has no part in them.
class EventIslands {
public:
    // Of one motion: they share their island from now on.
    void join(std::span<const std::size_t> unknowns) { (void)unite(unknowns); }
    // How many were noted at that time, the last one, of what these take part in: the most of their
    // islands. Those that no unknown takes part in count together.
    [[nodiscard]] std::size_t atOnce(double time, std::span<const std::size_t> unknowns) const;
    void note(double time, std::span<const std::size_t> unknowns);
    // The unknown that stands for its island.
    [[nodiscard]] std::size_t islandNumber(std::size_t unknown) const;

private:
    struct Island {
        double last = -std::numeric_limits<double>::infinity(); // of its events
        std::size_t atLast = 0;                                 // events at that time

        [[nodiscard]] std::size_t eventsAt(double time) const { return time == last ? atLast : 0; }
        void note(double time) {
            atLast = eventsAt(time) + 1;
            last = time;
        }
    };
    std::size_t unite(std::span<const std::size_t> unknowns);

    mutable std::vector<std::size_t> parents_; // by unknown; itself: the island's root
    std::vector<Island> islands_;              // by root
    Island nobody_;                            // events that no unknown takes part in
};

} // namespace solution
