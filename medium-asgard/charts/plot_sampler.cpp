#include "charts/plot_sampler.h"

#include <algorithm>
#include <new>
#include <utility>

namespace charts {

PlotSampler::PlotSampler(Done done, std::size_t most) : done_(std::move(done)), most_(most) {}

PlotSampler::~PlotSampler() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = overtaken_ = true;
    }
    wished_.notify_one();
    if (thread_.joinable())
        thread_.join();
}

void PlotSampler::sample(Wish wish) {
    {
        const std::lock_guard lock(mutex_);
        if (workedOn_ && workedOn_ != wish.scene && !lastWasOvertaken_)
            overtaken_ = true;
        wish_ = std::move(wish);
    }
    if (!thread_.joinable())
        thread_ = std::thread([this] { run(); });
    wished_.notify_one();
}

void PlotSampler::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wished_.wait(lock, [this] { return stop_ || wish_; });
        if (stop_)
            return;
        const Wish wish = *std::exchange(wish_, std::nullopt);
        workedOn_ = wish.scene;
        overtaken_ = false;
        lock.unlock();
        bool delivered = true;
        try {
            delivered = serve(wish);
        } catch (const std::bad_alloc&) {
            readable_.reset();
            Plot none;
            none.fault = "the values need more memory than their process may have";
            done_(wish, std::vector<Plot>(std::min(most_, wish.scene->plots.size()), none));
        }
        lock.lock();
        workedOn_.reset();
        lastWasOvertaken_ = !delivered;
    }
}

bool PlotSampler::serve(const Wish& wish) {
    const bool isKnown = readable_ && readFrom_ == wish.scene;
    if (!isKnown && !wish.scene->plots.empty()) {
        readable_.emplace(*wish.scene);
        readFrom_ = wish.scene;
        ++built_;
    }
    const std::size_t count = std::min(most_, wish.scene->plots.size());
    std::vector<Plot> plots;
    for (std::size_t i = 0; i < count; ++i) {
        auto one = sampled(*readable_, *wish.scene, wish.scene->plots[i], wish.motion,
                           [this] { return overtaken_.load(); });
        if (!one)
            return false;
        plots.push_back(std::move(*one));
    }
    done_(wish, std::move(plots));
    return true;
}

} // namespace charts
