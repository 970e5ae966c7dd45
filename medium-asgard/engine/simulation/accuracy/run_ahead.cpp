#include "accuracy/run_ahead.h"

#include <system_error>
#include <utility>

namespace simulation {

RunAhead::RunAhead(const Problem& problem, std::vector<double> tolerances, OpenRun::Use use)
    : tolerances_(std::move(tolerances)),
      run_(std::make_unique<OpenRun>(problem, tolerances_, Rounding::asItIs, use)) {}

RunAhead::~RunAhead() { end(); }

void RunAhead::end() {
    isCancelled_ = true;
    if (thread_.joinable())
        thread_.join();
}

// A system without another thread to give leaves the run to the caller.
void RunAhead::begin(std::chrono::milliseconds after) {
    if (thread_.joinable() || isCancelled_ || Clock::now() - made_ < after)
        return;
    try {
        thread_ = std::thread([this] { solve(); });
    } catch (const std::system_error&) {
        isCancelled_ = true;
    }
}

void RunAhead::solve() {
    const Observer observer{.cancelled = [this] { return isCancelled_.load(); },
                            .progress = {},
                            .working = [this](double time) { worksAt_ = time; }};
    std::exception_ptr thrown;
    try {
        run_->solve(observer);
    } catch (...) {
        thrown = std::current_exception();
    }
    const std::scoped_lock lock(mutex_);
    thrown_ = thrown;
    isSolved_ = true;
    solved_.notify_all();
}

std::unique_ptr<OpenRun> RunAhead::take(const Observer& observer) {
    constexpr std::chrono::milliseconds often(5);
    if (!thread_.joinable())
        return nullptr;
    std::unique_lock lock(mutex_);
    while (!solved_.wait_for(lock, often, [this] { return isSolved_; })) {
        lock.unlock();
        if (observer.cancelled && observer.cancelled()) {
            end();
            return nullptr;
        }
        if (observer.working)
            observer.working(worksAt_);
        lock.lock();
    }
    lock.unlock();
    end();
    if (thrown_)
        std::rethrow_exception(std::exchange(thrown_, nullptr));
    return std::move(run_);
}

} // namespace simulation
