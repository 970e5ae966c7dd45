#include "views/worker.h"

#include <chrono>

namespace views {

WorkThread::WorkThread(Workshop workshop)
    : workshop_(std::move(workshop)), thread_([this] { run(); }) {}

WorkThread::~WorkThread() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    if (workshop_.cancelReading)
        workshop_.cancelReading();
    thread_.join();
}

void WorkThread::start(const std::string& text) {
    {
        const std::lock_guard lock(mutex_);
        text_ = text;
        waiting_ = true;
        ++serial_;
    }
    if (workshop_.cancelReading)
        workshop_.cancelReading();
    wake_.notify_one();
}

void WorkThread::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return stop_ || waiting_; });
        if (stop_)
            return;
        waiting_ = false;
        const std::string text = text_;
        const unsigned serial = serial_;
        lock.unlock();
        process(text, serial);
        lock.lock();
    }
}

void WorkThread::process(const std::string& text, unsigned serial) {
    const script::ReadResult read = workshop_.read(text);
    if (overtaken(serial))
        return;
    onRead(serial, read);
    if (!read.usable)
        return;
    const auto scene = std::make_shared<const scene::Scene>(read.scene);
    using Clock = std::chrono::steady_clock;
    // Short computations are shown whole: what was shown before stays until then.
    const Clock::time_point began = Clock::now();
    Clock::time_point last = began + std::chrono::milliseconds(350);
    simulation::Observer observer;
    observer.cancelled = [&] { return overtaken(serial); };
    observer.progress = [&](const simulation::MotionPointer& motion) {
        if (Clock::now() - last < std::chrono::milliseconds(50) || overtaken(serial))
            return;
        last = Clock::now();
        onProgress(serial, scene, motion);
    };
    const simulation::Result result = workshop_.simulate(scene, {}, observer);
    if (!overtaken(serial))
        onFinished(serial, scene, result);
}

} // namespace views
