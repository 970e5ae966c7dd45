// Which of many belong together, when some pairs do? A union-find: each group is known by its least
// member.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace simulation {

class Groups {
public:
    // Each alone.
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    // By member: another one of its group that is no greater, in the end the least.
    explicit Groups(std::vector<std::size_t> parents) : parent_(std::move(parents)) {}

    [[nodiscard]] std::size_t root(std::size_t member) {
        while (parent_[member] != member)
            member = parent_[member] = parent_[parent_[member]];
        return member;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    // By member.
    [[nodiscard]] std::vector<std::size_t> roots() {
        std::vector<std::size_t> all(parent_.size());
        for (std::size_t member = 0; member < all.size(); ++member)
            all[member] = root(member);
        return all;
    }

private:
    std::vector<std::size_t> parent_;
};

} // namespace simulation
