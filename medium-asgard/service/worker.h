// Reads and computes beside the thread that answers the host.
//
// One job at a time, the newest wins: starting another cancels the one that runs. A job reads a
// text, and computes the motion of what it read. News are collected by their owner, who learns of
// them by a descriptor that becomes readable: any event loop will do.
#pragma once

#include "script/reader.h"
#include "simulation/simulation.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace service {

using ScenePointer = std::shared_ptr<const scene::Scene>;
using ParameterValues = std::map<std::string, double>;

// The services that a job needs. `read` and `simulate` run on the worker's thread.
struct Tools {
    std::function<script::ReadResult(const std::string& text, const ParameterValues&)> read;
    std::function<void()> cancelReading; // any thread
    std::function<simulation::Result(const ScenePointer&, const simulation::Options&,
                                     const simulation::Observer&)>
        simulate;
};

// The news of one job since the last time.
struct News {
    std::optional<std::vector<scene::Diagnostic>> diagnostics; // the text was read
    ScenePointer scene;                                        // and makes this scene
    simulation::MotionPointer motion;                          // its newest motion
    std::optional<std::vector<std::string>> refusal; // the job ended; why there is no motion, if so
    bool cancelled = false;
    std::optional<simulation::Statistics> statistics; // of a motion that ended
};

class Worker {
public:
    explicit Worker(Tools tools);
    ~Worker(); // cancels and waits
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void start(std::string text, ParameterValues parameters);
    // The job ends soon, with the motion that it has.
    void cancel();
    [[nodiscard]] bool busy() const; // until the end of the job has been collected

    // Readable while there are news, and after wake().
    [[nodiscard]] int descriptor() const { return descriptor_; }
    void wake() const; // any thread
    [[nodiscard]] News collect();

private:
    struct Job {
        std::string text;
        ParameterValues parameters;
    };
    void run();
    script::ReadResult readWith(ParameterValues& parameters, const std::string& text) const;
    void perform(const Job& job, unsigned number);
    bool superseded(unsigned number) const;
    // Adds to the news of a job, unless a newer one has been started.
    void publish(unsigned number, const std::function<void(News&)>& add);

    Tools tools_;
    int descriptor_;
    std::thread thread_; // started by the first job: after the process has been confined
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Job> next_;
    News news_;
    unsigned newest_ = 0; // number of the newest job
    bool busy_ = false, cancelled_ = false, ending_ = false;
};

} // namespace service
