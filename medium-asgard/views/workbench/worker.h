// Reads texts on one thread and computes motion on another, always for the newest start.
//
// Each start has a serial, so that receivers know which start a result belongs to. A start cancels
// the work of an older one. During a gesture, texts come faster than motion can follow: the older
// work then gets some time to end first, so that pictures and paths follow the hand with that
// delay, instead of standing still until the hand rests. The callbacks run on these threads.
#pragma once

#include "workbench/scene_document.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace views {

enum class Haste {
    now,     // running work is of no use any more
    gesture, // running work may end, within longestReading and the order's `overlap`
};

struct Reading {
    unsigned serial = 0;
    std::string text;
    std::shared_ptr<const scene::Scene> scene; // none: the text has faults
    std::vector<scene::Diagnostic> diagnostics;
    bool moves = false; // its motion is computed next
};

struct Moved {
    unsigned serial = 0;
    std::shared_ptr<const scene::Scene> scene;
    simulation::Result result;
    std::chrono::duration<double> lasted{};
    bool givenUp = false; // the order's budget was spent
};

class WorkThread {
public:
    using Clock = std::chrono::steady_clock;
    using ScenePointer = std::shared_ptr<const scene::Scene>;
    static constexpr std::chrono::milliseconds longestReading{2000};

    explicit WorkThread(Workshop workshop);
    ~WorkThread();
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;

    struct Order {
        bool moves = true; // its motion is wanted
        Haste haste = Haste::now;
        std::optional<Clock::duration> budget; // for the motion; then it is given up
        Clock::duration overlap{};             // for the motion after a newer start
    };
    void start(const std::string& text, const Order& order);
    [[nodiscard]] unsigned serial() const { return serial_; } // of the last start

    // Set before the first start.
    std::function<void(std::shared_ptr<const Reading>)> onRead;
    // Of long computations, at most some twenty times a second.
    std::function<void(unsigned, const ScenePointer&, const simulation::MotionPointer&)> onProgress;
    // A motion that ended, or (result.cancelled) was given up.
    std::function<void(std::shared_ptr<const Moved>)> onMoved;

private:
    struct Job { // of the thread that computes motion
        unsigned serial = 0;
        ScenePointer scene;
        Order order;
    };
    void readOn();
    void moveOn();
    void read(const std::string& text, unsigned serial, const Order& order);
    void move(const Job& job);
    // Something newer is there, and what began then is to be ended for it.
    [[nodiscard]] bool overtaken(unsigned serial, Clock::time_point began,
                                 Clock::duration most) const;

    Workshop workshop_;
    std::mutex mutex_;
    std::condition_variable wakeReading_, wakeMoving_;
    std::string text_;
    Order order_;
    bool waiting_ = false;      // text_ has not been taken up
    std::optional<Job> job_;    // has not been taken up
    Clock::time_point began_{}; // the reading that runs
    bool reads_ = false;
    std::atomic<unsigned> serial_{0};
    std::atomic<unsigned> lastUrgent_{0}; // what is older than that ends now
    std::atomic<bool> stop_{false};
    std::thread reading_, moving_;
};

} // namespace views
