// The progress on standard error of a command that takes long.
//
// Nothing for two seconds. Then, on a terminal, one line that is written anew twice a second and
// goes when the work is done; elsewhere a line after 10, 20, 40, ... seconds.
#pragma once

#include "simulation/simulation.h"
#include "terminal/terminal.h"

#include <chrono>
#include <string>

namespace batch {

class Waiting {
public:
    Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    // Is it time to say something? Cheap, to be asked often.
    [[nodiscard]] bool isTime() const { return Clock::now() >= next_; }
    // "asgard: SENTENCE (12 s so far)"
    void say(const std::string& sentence);

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_, next_;
    terminal::Progress line_; // on a terminal
};

// simulate(), which says how far it is.
[[nodiscard]] simulation::Result simulated(const scene::Scene& scene,
                                           const simulation::Options& options = {});

} // namespace batch
