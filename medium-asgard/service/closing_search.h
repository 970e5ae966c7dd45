// How open joints close and bodies that overlap part, found out on a thread of its own.
#pragma once

#include "commands/closing.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace service {

class ClosingSearch {
public:
    ClosingSearch() = default;
    ~ClosingSearch() { stop(); }
    ClosingSearch(const ClosingSearch&) = delete;
    ClosingSearch& operator=(const ClosingSearch&) = delete;

    // `wake` is called on the thread, when it has ended.
    void start(const std::string& text, const std::shared_ptr<const scene::Scene>& scene,
               std::function<void()> wake);
    void stop(); // nothing comes of it
    [[nodiscard]] bool runs() const { return thread_.joinable(); }
    // What it has come to, once; none: nothing runs, or it goes on.
    [[nodiscard]] std::optional<commands::Closed> take();

private:
    std::atomic<bool> stopped_{false};
    std::mutex mutex_;
    std::optional<commands::Closed> found_; // under mutex_
    std::thread thread_;
};

} // namespace service
