// Reads texts on one thread and computes motion on another, always for the newest start.
//
// Each start has a serial, so that receivers know which start a result belongs to. A start cancels
// the work of an older one. During a gesture, texts come faster than motion can follow: the older
// work then gets some time to end first, so that pictures and paths follow the hand with that
// delay, instead of standing still until the hand rests. A text that comes back has the motion that
// it had (former_motions.h).
//
// Results wait for their owner, who is woken and collects them.
#pragma once

#include "computing/former_motions.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

namespace computing {

using Clock = std::chrono::steady_clock;

enum class Haste {
    now,     // running work is of no use any more
    gesture, // running work may end, within longestReading and the order's `overlap`
};

struct Order {
    ParameterValues parameters;
    bool moves = true; // its motion is wanted, also where it is not known
    bool anew = false; // computed again, also where this text has had one
    Haste haste = Haste::now;
    Clock::duration overlap{};                       // for the motion after a newer start
    std::size_t mostBytes = std::size_t{1500} << 20; // that a motion may add to the process
};

struct Reading {
    unsigned serial = 0;
    std::string text;
    ScenePointer scene; // none: the text has faults
    std::vector<scene::Diagnostic> diagnostics;
    bool moves = false; // its motion is computed next
};

struct Progress { // of a motion that is being computed: the newest only
    unsigned serial = 0;
    ScenePointer scene;
    simulation::MotionPointer motion;
    Clock::duration lasted{}; // since it was begun
};

// A motion that ended or was cancelled (result.cancelled), perhaps before it was begun. One that
// takes more memory than its order allows ends there, with a refusal.
struct Moved {
    unsigned serial = 0;
    ScenePointer scene; // none: the reading was cancelled
    simulation::Result result;
    Clock::duration lasted{};
};

using News = std::variant<Reading, Progress, Moved>;

class Worker {
public:
    static constexpr std::chrono::milliseconds longestReading{2000};

    // `wake` is called on any thread when there are news; then collect() has them.
    Worker(Tools tools, std::function<void()> wake);
    ~Worker(); // cancels and waits
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // The first start begins the threads: a process may confine itself before.
    void start(const std::string& text, Order order);
    void cancel(); // the work of the last start ends soon, with the motion that it has
    [[nodiscard]] unsigned serial() const { return serial_; } // of the last start
    [[nodiscard]] std::vector<News> collect();

private:
    struct Job { // of the thread that computes motion
        unsigned serial = 0;
        std::string text;
        ScenePointer scene;
        Order order;
        std::optional<simulation::Result> known;
    };
    void readOn();
    void moveOn();
    void read(const std::string& text, unsigned serial, Order order);
    [[nodiscard]] script::ReadResult readWith(ParameterValues& parameters,
                                              const std::string& text) const;
    void move(const Job& job);
    [[nodiscard]] bool isCancelled(unsigned serial) const { return serial <= cancelled_; }
    // Something newer is there, and what began then is to be ended for it.
    [[nodiscard]] bool overtaken(unsigned serial, Clock::time_point began,
                                 Clock::duration most) const;
    void tell(News news);

    Tools tools_;
    std::function<void()> wake_;
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
    std::atomic<unsigned> cancelled_{0};  // the last start that was cancelled
    std::atomic<bool> stop_{false};
    std::mutex newsMutex_;
    std::vector<News> news_;
    FormerMotions former_;
    std::thread reading_, moving_;
};

} // namespace computing
