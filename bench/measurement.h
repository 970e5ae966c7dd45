// What every program of this folder does alike: arguments, processor time, rows of a table.
//
//     bench_PROGRAM [--smoke] [--scenes S1,S2a,...] [--budget SECONDS]
//
// Rows go to standard output as CSV:  program,scene,setting,parameter,error,seconds,least,note
// where seconds is the median and least the least processor time of the stepping alone, of as many
// runs as the budget (processor seconds for one row) allows, at least one. --smoke takes the
// coarsest parameter of each setting and one run.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bench {

[[nodiscard]] double cpuSeconds(); // of this thread

struct Time {
    double median = 0, least = 0;
};

struct Row {
    std::string scene, setting;
    double parameter = 0; // step or tolerance
    double error = 0;     // NaN: none
    Time time;
    std::string note;
};

class Measurement {
public:
    Measurement(std::string program, int argc, char** argv);

    [[nodiscard]] bool smoke() const { return smoke_; }
    [[nodiscard]] bool wants(const std::string& scene) const;
    // A sweep; its first point only when it is a smoke test.
    [[nodiscard]] std::vector<double> sweep(std::vector<double> parameters) const;
    // `once` makes one run and returns the seconds that count.
    [[nodiscard]] Time timeOf(const std::function<double()>& once) const;
    // The same for a run that is shorter than the clock is good for: it is repeated within.
    [[nodiscard]] Time timeOfShort(const std::function<void()>& run) const;
    void add(const Row& row) const;

private:
    std::string program_;
    bool smoke_ = false;
    double budget_ = 0.1;
    std::vector<std::string> scenes_; // empty: all
};

// Time of one call, from calls that alternate with nothing.
template <class Work> double seconds(Work&& work) {
    const double begin = cpuSeconds();
    work();
    return cpuSeconds() - begin;
}

// What a fixed loop of arithmetic takes now: rows of two machines, or of two loads, compare by it.
[[nodiscard]] Time calibration(const Measurement& measurement);

} // namespace bench
