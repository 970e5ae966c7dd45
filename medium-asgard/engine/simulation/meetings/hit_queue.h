// Hits that were found, in order of time; those from before a cut of one of their bodies count no
// more.
//
// An outdated hit lies in the queue until its time comes, or until such hits are most of it.
#pragma once

#include "collision/broad_phase.h"

#include <cstdint>
#include <vector>

namespace simulation {

struct Found {
    double time = 0;
    collision::Pair pair;
    bool pressing = false, isLost = false; // collision::Hit
};

class HitQueue {
public:
    explicit HitQueue(std::size_t bodies) : version_(bodies, 0) {}

    // The motion of the body was cut: its hits so far are outdated.
    void cut(std::size_t body) { ++version_[body]; }
    void push(const Found& found);
    // The earliest, of equal times that of the least pair; null: none. Valid until the next change.
    [[nodiscard]] const Found* first();
    [[nodiscard]] Found take();                                      // the first
    [[nodiscard]] std::size_t size() const { return queue_.size(); } // with outdated ones

private:
    struct Entry {
        Found found;
        std::uint32_t first = 0, second = 0; // versions of the bodies
    };
    struct Later {
        bool operator()(const Entry& a, const Entry& b) const;
    };
    [[nodiscard]] bool isOutdated(const Entry& entry) const {
        return version_[entry.found.pair.first] != entry.first ||
               version_[entry.found.pair.second] != entry.second;
    }
    void drop();

    std::vector<std::uint32_t> version_; // by body: of its motion
    std::vector<Entry> queue_;           // a heap
    std::size_t limit_ = 0;              // longer, and outdated hits are taken out
};

} // namespace simulation
