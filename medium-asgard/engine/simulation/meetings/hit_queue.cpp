#include "meetings/hit_queue.h"

#include <algorithm>

namespace simulation {
namespace {

constexpr std::size_t shortQueue = 16;

} // namespace

bool HitQueue::Later::operator()(const Entry& a, const Entry& b) const {
    if (a.found.time != b.found.time)
        return a.found.time > b.found.time;
    return a.found.pair > b.found.pair;
}

void HitQueue::push(const Found& found) {
    if (queue_.size() > limit_) {
        std::erase_if(queue_, [this](const Entry& entry) { return isOutdated(entry); });
        std::ranges::make_heap(queue_, Later{});
        limit_ = 2 * queue_.size() + shortQueue;
    }
    queue_.push_back({found, version_[found.pair.first], version_[found.pair.second]});
    std::ranges::push_heap(queue_, Later{});
}

void HitQueue::drop() {
    std::ranges::pop_heap(queue_, Later{});
    queue_.pop_back();
}

const Found* HitQueue::first() {
    while (!queue_.empty() && isOutdated(queue_.front()))
        drop();
    return queue_.empty() ? nullptr : &queue_.front().found;
}

Found HitQueue::take() {
    const Found found = queue_.front().found;
    drop();
    return found;
}

} // namespace simulation
