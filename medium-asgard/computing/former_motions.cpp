#include "computing/former_motions.h"

#include <algorithm>

namespace computing {

std::optional<simulation::Result> FormerMotions::of(const std::string& text,
                                                    const ParameterValues& parameters) {
    const auto found = std::ranges::find_if(
        all_, [&](const Former& one) { return one.text == text && one.parameters == parameters; });
    if (found == all_.end())
        return std::nullopt;
    all_.splice(all_.begin(), all_, found);
    simulation::Result result = found->result;
    static_cast<simulation::WorkCounts&>(result.statistics) = {};
    static_cast<simulation::Seconds&>(result.statistics) = {};
    return result;
}

void FormerMotions::add(const std::string& text, const ParameterValues& parameters,
                        const simulation::Result& result) {
    if (result.cancelled || !result.motion || of(text, parameters))
        return;
    all_.push_front({text, parameters, result});
    bytes_ += result.statistics.historyBytes;
    while (!all_.empty() && (bytes_ > mostBytes || all_.size() > mostTexts)) {
        bytes_ -= all_.back().result.statistics.historyBytes;
        all_.pop_back();
    }
}

} // namespace computing
