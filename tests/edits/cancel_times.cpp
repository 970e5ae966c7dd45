// How long does a simulation go without asking whether it was cancelled? Processor time between two
// questions, at most, for each of the given scenes.
//
//     cancel_times SCENE.al...
#include "script/reader.h"
#include "simulation/cpu_seconds.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

int main(int argc, char** argv) {
    script::Reader reader;
    for (int i = 1; i < argc; ++i) {
        std::stringstream text;
        text << std::ifstream(argv[i]).rdbuf();
        const script::ReadResult read = reader.read(text.str());
        const double begin = simulation::cpuSeconds();
        double last = begin, longest = 0, first = 0;
        std::size_t polls = 0;
        const auto asked = [&] {
            const double now = simulation::cpuSeconds();
            if (polls++ == 0)
                first = now - begin;
            else
                longest = std::max(longest, now - last);
            last = now;
            return false;
        };
        const auto result =
            simulation::simulate(read.scene, {}, {.cancelled = asked, .progress = {}});
        const double end = simulation::cpuSeconds();
        std::printf(
            "%-32s %8.1f ms to the first, %8.1f ms at most between two of %zu, %8.1f ms after "
            "the last; %9.1f ms in all\n",
            argv[i], 1e3 * first, 1e3 * longest, polls, 1e3 * (end - last), 1e3 * (end - begin));
    }
}
