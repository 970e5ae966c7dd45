// Processor time that this process has used, for the statistics: never for a decision about motion.
#pragma once

#include <ctime>

namespace simulation {

inline double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace simulation
