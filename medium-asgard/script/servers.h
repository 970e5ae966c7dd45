// The evaluator servers of a process: one that works, and a spare that takes its place.
//
// The first two are forked before the process has seen a document. If one ends (the system is out
// of memory, somebody kills it), the other starts the next: this process may have threads by then,
// or be confined. Only the end of both at once is final.
#pragma once

#include "script/evaluator.h"
#include "script/processes.h"

#include <chrono>
#include <optional>
#include <vector>

namespace script {

class Servers {
public:
    explicit Servers(const Limits& limits);
    ~Servers(); // ends them; they end their evaluators
    Servers(const Servers&) = delete;
    Servers& operator=(const Servers&) = delete;

    // Sees to it that one works and one is spare, as far as can be. Says why none works.
    [[nodiscard]] std::optional<End> prepare();
    // Of the one that works.
    [[nodiscard]] int requests() const { return working_.descriptors[0]; }
    [[nodiscard]] int replies() const { return working_.descriptors[1]; }
    // The one that works has ended, or makes no sense any more.
    void dismiss();
    // How many took the place of another.
    [[nodiscard]] int replaced() const { return replaced_; }

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] Sent start(bool spare);
    [[nodiscard]] bool tooOften() const;
    void countEnd();
    void noticeEnds();
    void askForSpare();

    Limits limits_;
    int arrivals_ = -1;    // here the descriptors of the next server arrive
    int arrivalsFar_ = -1; // the end for servers, until the first two have it
    Sent working_, spare_; // process, requests, replies
    std::vector<pid_t> leaving_;
    std::vector<Clock::time_point> ends_;
    int replaced_ = 0;
};

} // namespace script
