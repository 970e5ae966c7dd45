// A run that is solved on a thread of its own, beside another one that is wanted first.
//
//     RunAhead ahead(problem, tolerances, use)
//     the first run:    ahead.begin(50 ms), every now and then: it begins once these have passed
//     its run is next:  ahead.take(observer), which waits for it
//
// Runs do not depend on each other, so its numbers are those that it would have later. Its
// destructor ends it.
#pragma once

#include "run/open_run.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace simulation {

class RunAhead {
public:
    // The problem must outlive it.
    RunAhead(const Problem& problem, std::vector<double> tolerances, OpenRun::Use use);
    ~RunAhead();
    RunAhead(const RunAhead&) = delete;
    RunAhead& operator=(const RunAhead&) = delete;

    [[nodiscard]] const std::vector<double>& tolerances() const { return tolerances_; }
    // From this long after its construction on.
    void begin(std::chrono::milliseconds after);
    // The run, solved to the problem's finish. None where it has not begun or the observer, which
    // is asked and told on this thread meanwhile, cancels. What it threw is thrown here.
    [[nodiscard]] std::unique_ptr<OpenRun> take(const Observer& observer);

private:
    using Clock = std::chrono::steady_clock;
    void solve();
    void end();

    std::vector<double> tolerances_;
    std::unique_ptr<OpenRun> run_;
    const Clock::time_point made_ = Clock::now();
    std::thread thread_;
    std::atomic<bool> isCancelled_ = false;
    std::atomic<double> worksAt_ = 0; // a time of the motion
    std::mutex mutex_;
    std::condition_variable solved_;
    bool isSolved_ = false;
    std::exception_ptr thrown_;
};

} // namespace simulation
