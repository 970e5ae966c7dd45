#include "computing/former_motions.h"

#include <algorithm>

namespace computing {

FormerMotions::Place FormerMotions::find(const std::string& text,
                                         const ParameterValues& parameters) {
    return std::ranges::find_if(
        all_, [&](const Former& one) { return one.text == text && one.parameters == parameters; });
}

void FormerMotions::drop(Place one) {
    bytes_ -= one->bytes;
    all_.erase(one);
}

std::optional<simulation::Result>
FormerMotions::of(const std::string& text, const ParameterValues& parameters, bool isGesture) {
    const std::lock_guard lock(mutex_);
    const auto found = find(text, parameters);
    if (found == all_.end())
        return std::nullopt;
    all_.splice(all_.begin(), all_, found);
    found->isPassing = found->isPassing && isGesture;
    simulation::Result result = found->result;
    static_cast<simulation::WorkCounts&>(result.statistics) = {};
    static_cast<simulation::Seconds&>(result.statistics) = {};
    return result;
}

void FormerMotions::add(const std::string& text, const ParameterValues& parameters,
                        const simulation::Result& result, std::size_t bodies, bool isGesture) {
    constexpr std::size_t equations = 50'000; // bytes of a body, about
    const std::lock_guard lock(mutex_);
    if (result.cancelled || !result.motion || find(text, parameters) != all_.end())
        return;
    if (isGesture)
        if (const auto last = std::ranges::find_if(all_, &Former::isPassing); last != all_.end())
            drop(last);
    const std::size_t bytes =
        text.size() + result.statistics.historyBytes + (1 + bodies) * equations;
    all_.push_front({text, parameters, result, bytes, isGesture});
    bytes_ += bytes;
    while (!all_.empty() && (bytes_ > mostBytes || all_.size() > mostTexts))
        drop(std::prev(all_.end()));
}

} // namespace computing
