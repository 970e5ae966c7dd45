#include "workbench/worker.h"

#include <utility>

namespace views {

WorkThread::WorkThread(Workshop workshop)
    : workshop_(std::move(workshop)), reading_([this] { readOn(); }),
      moving_([this] { moveOn(); }) {}

WorkThread::~WorkThread() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wakeReading_.notify_one();
    wakeMoving_.notify_one();
    if (workshop_.cancelReading)
        workshop_.cancelReading();
    reading_.join();
    moving_.join();
}

void WorkThread::start(const std::string& text, const Order& order) {
    {
        const std::lock_guard lock(mutex_);
        text_ = text;
        order_ = order;
        waiting_ = true;
        ++serial_;
        if (order.haste == Haste::now)
            lastUrgent_ = serial_.load();
        const bool isLong = Clock::now() - began_ > longestReading;
        // Within the lock, so that it is not the new text whose reading ends.
        if (reads_ && (isLong || order.haste == Haste::now) && workshop_.cancelReading)
            workshop_.cancelReading();
    }
    wakeReading_.notify_one();
}

bool WorkThread::overtaken(unsigned serial, Clock::time_point began, Clock::duration most) const {
    return stop_ || serial < lastUrgent_ || (serial != serial_ && Clock::now() - began > most);
}

void WorkThread::readOn() {
    std::unique_lock lock(mutex_);
    while (true) {
        wakeReading_.wait(lock, [this] { return stop_ || waiting_; });
        if (stop_)
            return;
        waiting_ = false;
        const std::string text = text_;
        const unsigned serial = serial_;
        const Order order = order_;
        began_ = Clock::now();
        reads_ = true;
        lock.unlock();
        read(text, serial, order);
        lock.lock();
        reads_ = false;
    }
}

void WorkThread::read(const std::string& text, unsigned serial, const Order& order) {
    const Clock::time_point began = Clock::now();
    script::ReadResult result = workshop_.read(text);
    if (overtaken(serial, began, longestReading))
        return;
    auto reading = std::make_shared<Reading>();
    reading->serial = serial;
    reading->text = text;
    reading->diagnostics = std::move(result.diagnostics);
    if (result.usable)
        reading->scene = std::make_shared<const scene::Scene>(std::move(result.scene));
    reading->moves = reading->scene && order.moves;
    onRead(reading);
    if (!reading->moves)
        return;
    {
        const std::lock_guard lock(mutex_);
        job_ = Job{serial, reading->scene, order};
    }
    wakeMoving_.notify_one();
}

void WorkThread::moveOn() {
    std::unique_lock lock(mutex_);
    while (true) {
        wakeMoving_.wait(lock, [this] { return stop_ || job_; });
        if (stop_)
            return;
        const Job job = *std::exchange(job_, std::nullopt);
        lock.unlock();
        if (job.serial >= lastUrgent_)
            move(job);
        lock.lock();
    }
}

void WorkThread::move(const Job& job) {
    // Short computations are shown whole: what was shown before stays until then.
    const Clock::time_point began = Clock::now();
    Clock::time_point last = began + std::chrono::milliseconds(300);
    std::atomic<bool> givenUp = false; // asked on any thread
    simulation::Observer observer;
    observer.cancelled = [&] {
        if (job.order.budget && Clock::now() - began > *job.order.budget)
            givenUp = true;
        return givenUp || overtaken(job.serial, began, job.order.overlap);
    };
    observer.progress = [&](const simulation::MotionPointer& motion) {
        if (Clock::now() - last < std::chrono::milliseconds(50) ||
            overtaken(job.serial, began, job.order.overlap))
            return;
        last = Clock::now();
        onProgress(job.serial, job.scene, motion);
    };
    auto moved = std::make_shared<Moved>();
    moved->serial = job.serial;
    moved->scene = job.scene;
    moved->result = workshop_.simulate(job.scene, {}, observer);
    moved->lasted = Clock::now() - began;
    moved->givenUp = givenUp;
    moved->result.cancelled = moved->result.cancelled || givenUp;
    if (!stop_)
        onMoved(moved);
}

} // namespace views
