// Samples the plots of a scene on a thread of its own: an expression of a large scene takes its
// time.
//
// The newest wish wins. While a motion grows each piece is sampled. Another scene is not waited
// for, unless the sampling before was overtaken, too: so scenes that follow one another fast, as
// under a slider that is dragged, are shown now and then. The equations of a scene are built once
// for all its plots and motions.
#pragma once

#include "charts/plots.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace charts {

class PlotSampler {
public:
    struct Wish {
        std::shared_ptr<const scene::Scene> scene;
        simulation::MotionPointer motion; // null: its plots have no values
        unsigned number = 0;              // the wisher's own
    };
    // Called on the thread, with the plots of each wish whose sampling came to its end.
    using Done = std::function<void(const Wish&, std::vector<Plot>)>;

    // Of more plots than `most` the first ones.
    explicit PlotSampler(Done done, std::size_t most = std::numeric_limits<std::size_t>::max());
    ~PlotSampler(); // waits for the thread, which ends soon
    PlotSampler(const PlotSampler&) = delete;
    PlotSampler& operator=(const PlotSampler&) = delete;

    void sample(Wish wish); // the thread starts with the first
    // How often the equations of a scene were built.
    [[nodiscard]] std::size_t built() const { return built_; }

private:
    void run();
    bool serve(const Wish& wish); // false: it was overtaken

    Done done_;
    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable wished_;
    std::optional<Wish> wish_;                     // under mutex_
    bool stop_ = false;                            // under mutex_
    std::shared_ptr<const scene::Scene> workedOn_; // under mutex_
    bool lastWasOvertaken_ = false;                // under mutex_
    std::atomic<bool> overtaken_{false};
    std::optional<simulation::ReadableScene> readable_; // the thread's, of `readFrom_`
    std::shared_ptr<const scene::Scene> readFrom_;
    std::atomic<std::size_t> built_{0};
    std::thread thread_;
};

} // namespace charts
