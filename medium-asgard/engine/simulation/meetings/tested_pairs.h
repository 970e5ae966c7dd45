// Which pairs were searched for a hit, and how often?
#pragma once

#include "collision/broad_phase.h"

#include <cstdint>
#include <vector>

namespace simulation {

class TestedPairs {
public:
    using Pair = collision::Pair; // the lesser body first

    TestedPairs();
    void test(const Pair& pair);
    [[nodiscard]] std::size_t tests() const { return tests_; }
    [[nodiscard]] std::vector<Pair> all(); // each once, in order

private:
    std::size_t sort();

    std::size_t tests_ = 0;
    std::vector<std::uint64_t> pairs_;  // as numbers; some several times
    std::size_t kept_ = 0;              // that are known to be different
    std::vector<std::uint64_t> recent_; // of pairs_, by a few of their bits
};

} // namespace simulation
