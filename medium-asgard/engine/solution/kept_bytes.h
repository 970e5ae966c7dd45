// The bytes kept of a motion, and their limit: components, flights and the source of events have
// written them so far.
//
// The count tells when to look; where a motion ends for it follows from what is kept up to each
// time (memory_limit.h), so that nobody's schedule decides it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace solution {

class KeptBytes {
public:
    explicit KeptBytes(std::size_t most) : most_(most) {}

    // A component, by its place, keeps so many now.
    void note(std::size_t place, std::size_t bytes) {
        if (place >= ofPlace_.size())
            ofPlace_.resize(place + 1);
        sum_ += bytes - ofPlace_[place]; // modulo 2^n: it may be less
        ofPlace_[place] = bytes;
    }
    void add(std::size_t bytes) { sum_ += bytes; }
    void count(std::size_t all) { sum_ = all; } // anew
    [[nodiscard]] bool isFullWith(std::size_t others) const { return sum_ + others > most_; }
    // The bytes that each of so many groups may add before the others' are counted again.
    [[nodiscard]] std::size_t share(std::size_t groups) const {
        constexpr std::size_t parts = 4;
        return most_ / (parts * std::max<std::size_t>(groups, 1));
    }

    // For what goes on where others ended: a quarter of the limit, then an eighth, and so on.
    void allowMore() {
        more_ = more_ == 0 ? most_ / 4 : more_ / 2;
        most_ += more_;
    }
    [[nodiscard]] std::size_t most() const { return most_; }
    [[nodiscard]] double fullAt() const { return fullAt_; }
    void setFullAt(double time) { fullAt_ = time; }

private:
    std::size_t most_, more_ = 0, sum_ = 0;
    std::vector<std::size_t> ofPlace_;
    double fullAt_ = std::numeric_limits<double>::infinity();
};

} // namespace solution
