#include "service/closing_search.h"

#include <utility>

namespace service {

void ClosingSearch::start(const std::string& text, const std::shared_ptr<const scene::Scene>& scene,
                          std::function<void()> wake) {
    stop();
    thread_ = std::thread([this, text, scene, wake = std::move(wake)] {
        commands::Closed found = commands::closed(text, scene, [this] { return stopped_.load(); });
        {
            const std::lock_guard lock(mutex_);
            found_ = std::move(found);
        }
        wake();
    });
}

void ClosingSearch::stop() {
    stopped_ = true;
    if (thread_.joinable())
        thread_.join();
    stopped_ = false;
    found_.reset();
}

std::optional<commands::Closed> ClosingSearch::take() {
    {
        const std::lock_guard lock(mutex_);
        if (!found_)
            return std::nullopt;
    }
    thread_.join();
    return std::exchange(found_, std::nullopt);
}

} // namespace service
