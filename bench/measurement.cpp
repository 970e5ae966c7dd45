#include "measurement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <sstream>

namespace bench {

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Measurement::Measurement(std::string program, int argc, char** argv)
    : program_(std::move(program)) {
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--smoke") == 0) {
            smoke_ = true;
        } else if (std::strcmp(argv[i], "--budget") == 0 && i + 1 < argc) {
            budget_ = std::atof(argv[++i]);
        } else if (std::strcmp(argv[i], "--scenes") == 0 && i + 1 < argc) {
            std::istringstream list(argv[++i]);
            for (std::string scene; std::getline(list, scene, ',');)
                scenes_.push_back(scene);
        } else {
            std::fprintf(stderr, "usage: %s [--smoke] [--scenes S,...] [--budget SECONDS]\n",
                         argv[0]);
            std::exit(2);
        }
    }
}

bool Measurement::wants(const std::string& scene) const {
    return scenes_.empty() || std::ranges::find(scenes_, scene) != scenes_.end();
}

std::vector<double> Measurement::sweep(std::vector<double> parameters) const {
    if (smoke_)
        parameters.resize(1);
    return parameters;
}

Time Measurement::timeOf(const std::function<double()>& once) const {
    std::vector<double> all;
    double sum = 0;
    do {
        const double begin = cpuSeconds();
        all.push_back(once());
        sum += cpuSeconds() - begin;
    } while (!smoke_ && sum < budget_ && all.size() < 1001);
    std::ranges::sort(all);
    return {.median = all[all.size() / 2], .least = all.front()};
}

Time Measurement::timeOfShort(const std::function<void()>& run) const {
    int repeats = 1;
    const auto once = [&] {
        return seconds([&] {
            for (int i = 0; i < repeats; ++i)
                run();
        });
    };
    constexpr double enough = 2e-4; // a thousand times what reading the clock takes
    while (!smoke_ && once() < enough)
        repeats *= 2;
    Time time = timeOf(once);
    time.median /= repeats;
    time.least /= repeats;
    return time;
}

void Measurement::add(const Row& row) const {
    std::printf("%s,%s,%s,%.6g,%.3e,%.6e,%.6e,%s\n", program_.c_str(), row.scene.c_str(),
                row.setting.c_str(), row.parameter, row.error, row.time.median, row.time.least,
                row.note.c_str());
    std::fflush(stdout);
}

Time calibration(const Measurement& measurement) {
    volatile double kept = 0;
    return measurement.timeOfShort([&] {
        double x = 0.5;
        for (int i = 0; i < 2000; ++i)
            x = std::sin(x) * 0.7 + x / (1 + x * x);
        kept = x;
    });
}

} // namespace bench
