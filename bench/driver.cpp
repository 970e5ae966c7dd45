#include "driver.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace bench {
namespace {

bool arrived(const simulation::Result& result) {
    if (!result.motion || result.motion->computed() < result.motion->finish())
        return false;
    for (std::size_t b = 0; b < result.motion->bodies(); ++b)
        if (result.motion->stop(b))
            return false;
    return true;
}

std::string noteOf(const simulation::Statistics& s) {
    std::size_t delivered = 0;
    for (const auto& component : s.componentList)
        delivered += component.steps;
    char note[200];
    std::snprintf(note, sizeof note,
                  "%zu evaluations %zu steps %zu delivered %zu collisions %zu bytes "
                  "estimate %.2g %s",
                  s.evaluations, s.steps, delivered, s.collisions, s.historyBytes,
                  s.errorEstimate.value_or(std::numeric_limits<double>::quiet_NaN()),
                  s.componentList.empty() ? "" : s.componentList.front().method.c_str());
    return note;
}

} // namespace

scene::Scene Driver::read(const std::string& text) {
    script::ReadResult reading = reader_.read(text);
    if (!reading.usable) {
        std::fprintf(stderr, "%s\n", reading.diagnostics.at(0).message.c_str());
        std::exit(1);
    }
    return std::move(reading.scene);
}

void Driver::run(const std::string& name, const scene::Scene& scene,
                 const std::vector<double>& accuracies,
                 const std::function<double(const simulation::Motion&)>& errorOf,
                 double longest) const {
    for (const double accuracy : m_.sweep(accuracies)) {
        simulation::Options options;
        options.accuracy = accuracy;
        simulation::Result result;
        std::vector<double> moving, estimated;
        const Time all = m_.timeOf([&] {
            const double begin = cpuSeconds();
            simulation::Observer observer;
            // The processor's time takes a call of the system to read, a part of a short run's
            // time; the clock's, which is never behind it, does not.
            const auto start = std::chrono::steady_clock::now();
            observer.cancelled = [&] {
                const std::chrono::duration<double> since =
                    std::chrono::steady_clock::now() - start;
                return since.count() > longest && cpuSeconds() - begin > longest;
            };
            result = simulate(scene, options, observer);
            const simulation::Statistics& s = result.statistics;
            moving.push_back(s.secondsMoving);
            estimated.push_back(s.seconds - s.secondsSettingUp);
            return s.seconds;
        });
        const auto timeOf = [](std::vector<double>& seconds) {
            std::ranges::sort(seconds);
            return Time{.median = seconds[seconds.size() / 2], .least = seconds.front()};
        };
        const double error =
            arrived(result) ? errorOf(*result.motion) : std::numeric_limits<double>::quiet_NaN();
        const std::string note = noteOf(result.statistics) + (result.cancelled ? "; cut off" : "");
        m_.add({name, "motion", accuracy, error, timeOf(moving), note});
        m_.add({name, "with estimate", accuracy, error, timeOf(estimated), note});
        m_.add({name, "all", accuracy, error, all, note});
        if (result.cancelled)
            return;
    }
}

} // namespace bench
