#include "confinement/fences.h"

#include <cerrno>
#include <cstring>

#include <sys/prctl.h>
#include <sys/resource.h>

namespace confinement {

namespace {

std::string limit(int resource, rlim_t soft, rlim_t hard, const char* name) {
    rlimit present{};
    if (getrlimit(static_cast<__rlimit_resource_t>(resource), &present) != 0)
        return std::string("no limit on ") + name;
    if (present.rlim_max != RLIM_INFINITY) { // never ask for more than is allowed
        soft = soft < present.rlim_max ? soft : present.rlim_max;
        hard = hard < present.rlim_max ? hard : present.rlim_max;
    }
    const rlimit wanted{soft, hard};
    if (setrlimit(static_cast<__rlimit_resource_t>(resource), &wanted) == 0)
        return "";
    return std::string("no limit on ") + name + " (" + std::strerror(errno) + ")";
}

// Sanitizers reserve terabytes of address space that they never touch.
constexpr bool addressSpaceIsOurs() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return false;
#else
    return true;
#endif
}

} // namespace

std::string setLimits(Role role, const Limits& limits) {
    std::string failure = limit(RLIMIT_CORE, 0, 0, "core files");
    if (failure.empty())
        failure = limit(RLIMIT_FSIZE, 0, 0, "file size");
    // Threads count as processes, so that only a process without them can be forbidden more.
    if (failure.empty() && role == Role::evaluator)
        failure = limit(RLIMIT_NPROC, 0, 0, "processes");
    if (failure.empty() && limits.memory && addressSpaceIsOurs())
        failure = limit(RLIMIT_AS, *limits.memory, *limits.memory, "memory");
    if (failure.empty() && limits.cpuSeconds) {
        const auto seconds = static_cast<rlim_t>(*limits.cpuSeconds);
        failure = limit(RLIMIT_CPU, seconds, seconds + 1, "processor time");
    }
    if (failure.empty() && limits.descriptors)
        failure = limit(RLIMIT_NOFILE, *limits.descriptors, *limits.descriptors, "descriptors");
    return failure;
}

std::string dropPrivileges(Role) {
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return "privileges can still be gained";
    if (prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0)
        return "other processes may trace this one";
    return "";
}

} // namespace confinement
