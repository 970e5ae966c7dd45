#include "computing/memory.h"

#include <malloc.h>
#include <unistd.h>

#include <cstdio>

namespace computing {

std::size_t residentBytes() {
    std::FILE* file = std::fopen("/proc/self/statm", "re");
    if (!file)
        return 0;
    unsigned long all = 0, resident = 0;
    const bool isRead = std::fscanf(file, "%lu %lu", &all, &resident) == 2;
    std::fclose(file);
    return isRead ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void returnFreeMemory() { malloc_trim(0); }

} // namespace computing
