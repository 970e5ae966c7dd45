#include "confinement/confinement.h"

#include "confinement/fences.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <vector>

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace confinement {

namespace {

void note(Report& report, bool& inForce, const std::string& failure) {
    inForce = failure.empty();
    if (!failure.empty())
        report.missing += (report.missing.empty() ? "" : "; ") + failure;
}

// close_range(2) is younger than the kernels that we run on; /proc may be absent. Both, then.
void closeRange(unsigned from, unsigned to) {
#ifdef SYS_close_range
    if (syscall(SYS_close_range, from, to, 0u) == 0)
        return;
#endif
    const long most = sysconf(_SC_OPEN_MAX);
    const unsigned last = most > 0 ? static_cast<unsigned>(most) : 65536u;
    for (unsigned fd = from; fd <= to && fd < last; ++fd)
        close(static_cast<int>(fd));
}

} // namespace

Report confine(Role role, const Limits& limits, Fences wanted) {
    Report report;
    report.inForce = Fences{false, false, false, false};
    if (wanted.privileges || wanted.paths || wanted.calls)
        note(report, report.inForce.privileges, dropPrivileges(role));
    if (wanted.paths)
        note(report, report.inForce.paths, forbidPaths(role, report.landlockVersion));
    // After the paths, which take a descriptor for a moment; before the calls, which forbid it.
    if (wanted.limits)
        note(report, report.inForce.limits, setLimits(role, limits));
    if (wanted.calls)
        note(report, report.inForce.calls, filterCalls(role));
    return report;
}

Report tryOut(Role role, const Limits& limits) {
    Report report;
    report.inForce = Fences{false, false, false, false};
    report.missing = "no process could be started to try the fences";
    std::array<int, 2> ends{-1, -1};
    if (pipe(ends.data()) != 0)
        return report;
    const pid_t process = fork();
    if (process == 0) {
        const Report own = confine(role, limits);
        std::string answer;
        for (const bool fence :
             {own.inForce.limits, own.inForce.privileges, own.inForce.paths, own.inForce.calls})
            answer += fence ? '1' : '0';
        answer += static_cast<char>(own.landlockVersion);
        answer += own.missing;
        _exit(write(ends[1], answer.data(), answer.size()) > 0 ? 0 : 1);
    }
    close(ends[1]);
    std::array<char, 1000> answer{};
    const ssize_t got = process < 0 ? 0 : read(ends[0], answer.data(), answer.size());
    close(ends[0]);
    if (process > 0)
        waitpid(process, nullptr, 0);
    if (got >= 5) {
        report.inForce = {answer[0] == '1', answer[1] == '1', answer[2] == '1', answer[3] == '1'};
        report.landlockVersion = answer[4];
        report.missing.assign(answer.data() + 5, static_cast<std::size_t>(got) - 5);
    }
    return report;
}

void dieWithParent(int parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (getppid() != parent)
        _exit(0);
}

void closeDescriptorsExcept(std::span<const int> keep) {
    std::vector<int> kept(keep.begin(), keep.end());
    std::sort(kept.begin(), kept.end());
    unsigned from = 0;
    for (const int fd : kept) {
        if (static_cast<unsigned>(fd) > from)
            closeRange(from, static_cast<unsigned>(fd) - 1);
        from = static_cast<unsigned>(fd) + 1;
    }
    closeRange(from, ~0u);
}

void emptyEnvironment() {
    clearenv(); // leaves a null pointer, which libraries do not expect
    static char* none[] = {nullptr};
    environ = none;
}

} // namespace confinement
