// Reads texts and computes motion on one thread, always the text that was asked for last.
//
// start() cancels what runs and begins anew; each start has a serial, so that who receives results
// can tell what they belong to. The callbacks run on the worker thread.
#pragma once

#include "views/scene_document.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace views {

class WorkThread {
public:
    using ScenePointer = std::shared_ptr<const scene::Scene>;

    explicit WorkThread(Workshop workshop);
    ~WorkThread();
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;

    void start(const std::string& text);
    [[nodiscard]] unsigned serial() const { return serial_; } // of the last start

    // Set before the first start.
    std::function<void(unsigned, const script::ReadResult&)> onRead;
    // Of long computations, at most some twenty times a second.
    std::function<void(unsigned, const ScenePointer&, const simulation::MotionPointer&)> onProgress;
    std::function<void(unsigned, const ScenePointer&, const simulation::Result&)> onFinished;

private:
    void run();
    void process(const std::string& text, unsigned serial);
    [[nodiscard]] bool overtaken(unsigned serial) const { return stop_ || serial != serial_; }

    Workshop workshop_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::string text_;
    bool waiting_ = false; // text_ has not been taken up
    std::atomic<unsigned> serial_{0};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace views
