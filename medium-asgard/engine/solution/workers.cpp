#include "solution/workers.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace solution {

Workers::Workers(std::size_t threads)
    : threads_(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency())) {}

Workers::~Workers() { rest(); }

void Workers::rest() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    begin_.notify_all();
    for (std::thread& thread : others_)
        thread.join();
    others_.clear();
    ends_ = false;
}

// Where the system gives no more threads, those that there are do the work.
void Workers::start() {
    try {
        while (others_.size() + 1 < threads_)
            others_.emplace_back([this, seen = job_] { serve(seen); });
    } catch (const std::system_error&) {
        threads_ = others_.size() + 1;
    }
}

void Workers::forEach(std::size_t count, const std::function<void(std::size_t)>& work,
                      const std::function<void()>& meanwhile) {
    if (threads_ == 1 || count < 2) {
        for (std::size_t i = 0; i < count; ++i)
            work(i);
        return;
    }
    start();
    {
        const std::scoped_lock lock(mutex_);
        work_ = &work;
        count_ = count;
        next_ = 0;
        busy_ = others_.size();
        ++job_;
    }
    begin_.notify_all();
    takePieces();
    std::unique_lock lock(mutex_);
    while (!done_.wait_for(lock, std::chrono::milliseconds(1), [this] { return busy_ == 0; })) {
        lock.unlock();
        meanwhile();
        lock.lock();
    }
    work_ = nullptr;
    if (thrown_)
        std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Workers::takePieces() {
    try {
        for (std::size_t i = next_++; i < count_; i = next_++)
            (*work_)(i);
    } catch (...) {
        const std::scoped_lock lock(mutex_);
        thrown_ = std::current_exception();
        next_ = count_; // nobody begins another
    }
}

void Workers::serve(std::size_t seen) {
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            begin_.wait(lock, [&] { return ends_ || job_ != seen; });
            if (ends_)
                return;
            seen = job_;
        }
        takePieces();
        const std::scoped_lock lock(mutex_);
        if (--busy_ == 0)
            done_.notify_one();
    }
}

} // namespace solution
