#include "meetings/tested_pairs.h"

#include <algorithm>

namespace simulation {
namespace {

constexpr std::size_t recentPairs = 4096;

} // namespace

TestedPairs::TestedPairs() : recent_(recentPairs, 0) {}

void TestedPairs::test(const Pair& pair) {
    ++tests_;
    const std::uint64_t key = (static_cast<std::uint64_t>(pair.first) << 32) + pair.second;
    std::uint64_t& recent = recent_[(pair.first * 613 + pair.second) % recentPairs];
    if (recent == key)
        return;
    recent = key;
    pairs_.push_back(key);
    if (pairs_.size() > 2 * kept_ + recentPairs)
        kept_ = sort();
}

std::size_t TestedPairs::sort() {
    std::ranges::sort(pairs_);
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_.size();
}

std::vector<collision::Pair> TestedPairs::all() {
    kept_ = sort();
    std::vector<Pair> pairs;
    pairs.reserve(pairs_.size());
    for (const std::uint64_t key : pairs_)
        pairs.emplace_back(key >> 32, key & 0xffffffff);
    return pairs;
}

} // namespace simulation
