#include "batch/waiting.h"

#include <algorithm>
#include <cstdio>

namespace batch {
namespace {

constexpr std::chrono::seconds patience{2}, longPatience{10};
constexpr std::chrono::milliseconds interval{500};

} // namespace

Waiting::Waiting() : begin_(Clock::now()), next_(begin_) {
    next_ += terminal::errorsAreATerminal() ? patience : longPatience;
}

void Waiting::say(const std::string& sentence) {
    const auto now = Clock::now();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - begin_).count();
    const std::string line = "asgard: " + sentence + " (" + std::to_string(seconds) + " s so far)";
    if (!terminal::errorsAreATerminal()) {
        terminal::complain(line);
        next_ = now + (now - begin_);
        return;
    }
    line_.show(line);
    next_ = now + interval;
}

simulation::Result simulated(const scene::Scene& scene, const simulation::Options& options) {
    Waiting waiting;
    simulation::Observer observer;
    const double finish = options.finish.value_or(scene.simulator.finish);
    double furthest = scene.simulator.start;
    bool isAgain = false;
    observer.working = [&](double time) {
        isAgain = isAgain || time < furthest;
        furthest = std::max(furthest, time);
        if (!waiting.isTime())
            return;
        char text[100];
        std::snprintf(text, sizeof text, "%s, at t = %.6g of %.6g",
                      isAgain ? "computing again, to know the error" : "computing",
                      std::min(time, finish), finish);
        waiting.say(text);
    };
    return simulation::simulate(scene, options, observer);
}

} // namespace batch
