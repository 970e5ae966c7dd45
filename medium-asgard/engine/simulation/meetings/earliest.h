// Which of many comes first? A tournament: each time stands in a leaf, each joint has the winner of
// its two sides; of equal times the least index wins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace simulation {

class Earliest {
public:
    explicit Earliest(std::size_t count) {
        while (leaves_ < count)
            leaves_ *= 2;
        times_.assign(leaves_, std::numeric_limits<double>::infinity());
        winners_.resize(2 * leaves_);
        for (std::size_t node = 2 * leaves_; --node > 0;)
            winners_[node] =
                node < leaves_ ? winners_[2 * node] : static_cast<std::uint32_t>(node - leaves_);
    }
    void set(std::size_t index, double time) {
        times_[index] = time;
        for (std::size_t joint = (index + leaves_) / 2; joint > 0; joint /= 2) {
            const std::uint32_t a = winners_[2 * joint], b = winners_[2 * joint + 1];
            const std::uint32_t winner = times_[a] <= times_[b] ? a : b;
            if (winner == winners_[joint] && winner != index)
                return;
            winners_[joint] = winner;
        }
    }
    [[nodiscard]] std::size_t first() const { return winners_[1]; }
    [[nodiscard]] double time() const { return times_[first()]; }

private:
    std::size_t leaves_ = 1;
    std::vector<double> times_;
    std::vector<std::uint32_t> winners_; // by node: 1 is the root, leaves are the last half
};

} // namespace simulation
