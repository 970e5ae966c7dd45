// Does anybody want a solver to end before its finish? Asked on the thread that asked for the
// motion, and on no other: what is asked there need not know of others.
#pragma once

#include "stepping/options.h"

#include <atomic>
#include <cstddef>
#include <thread>

namespace solution {

class Interruption {
public:
    explicit Interruption(const Options& options) : options_(options) {}

    // By the thread that will be the one that asks.
    void begin() {
        caller_ = std::this_thread::get_id();
        isCancelled_ = false;
    }
    [[nodiscard]] bool isCancelled() const { return isCancelled_; }
    [[nodiscard]] bool isCaller() const { return std::this_thread::get_id() == caller_; }
    // Asks, and says every now and then that work goes on at that time.
    void poll(double time) {
        constexpr std::size_t seldom = 256;
        if (!isCancelled_ && options_.cancelled && options_.cancelled())
            isCancelled_ = true;
        if (options_.working && ++polls_ % seldom == 0)
            options_.working(time);
    }

private:
    const Options& options_;
    std::thread::id caller_;
    std::atomic<bool> isCancelled_ = false;
    std::size_t polls_ = 0;
};

} // namespace solution
