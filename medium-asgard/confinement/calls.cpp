// The filter on system calls: an allow-list per role. What is not listed answers EPERM, and clone3
// ENOSYS, so that the C library falls back to clone, whose arguments a filter can read.
#include "confinement/fences.h"

#include <cerrno>
#include <csignal>
#include <memory>
#include <span>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <seccomp.h>

namespace confinement {

namespace {

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

// Memory, the descriptors that are open, the clock, and leaving.
constexpr int forAll[] = {
    SCMP_SYS(read),          SCMP_SYS(write),           SCMP_SYS(close),
    SCMP_SYS(munmap),        SCMP_SYS(mremap),          SCMP_SYS(brk),
    SCMP_SYS(madvise),       SCMP_SYS(futex),           SCMP_SYS(exit),
    SCMP_SYS(exit_group),    SCMP_SYS(rt_sigreturn),    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday),    SCMP_SYS(getpid),
    SCMP_SYS(gettid),        SCMP_SYS(restart_syscall), SCMP_SYS(getrandom),
    SCMP_SYS(sigaltstack),   SCMP_SYS(sched_yield),     SCMP_SYS(getrusage),
    SCMP_SYS(times)};

constexpr int forServer[] = {
    SCMP_SYS(poll), SCMP_SYS(ppoll), SCMP_SYS(wait4), SCMP_SYS(pipe2), SCMP_SYS(set_robust_list),
    SCMP_SYS(rseq), SCMP_SYS(getppid), SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep),
    SCMP_SYS(rt_sigaction), SCMP_SYS(close_range),
    // Its children end by the descriptors that it got when it made them: it has no others. Another
    // server's descriptors go to the reader.
    SCMP_SYS(pidfd_send_signal), SCMP_SYS(sendmsg),
    // What an evaluator needs to confine itself further. None of these loosens anything.
    SCMP_SYS(seccomp), SCMP_SYS(setrlimit), SCMP_SYS(getrlimit), SCMP_SYS(landlock_create_ruleset),
    SCMP_SYS(landlock_restrict_self),
    // What the Tcl library asks when it starts; the answers do not matter.
    SCMP_SYS(fstat), SCMP_SYS(newfstatat), SCMP_SYS(lseek), SCMP_SYS(uname), SCMP_SYS(getuid),
    SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(sysinfo)};

// Threads, timers, waiting, and the graphics device, which is open already. No path, no socket,
// no program, no other process.
constexpr int forPlayer[] = {
    SCMP_SYS(readv), SCMP_SYS(writev), SCMP_SYS(pread64), SCMP_SYS(pwrite64), SCMP_SYS(poll),
    SCMP_SYS(ppoll), SCMP_SYS(select), SCMP_SYS(pselect6), SCMP_SYS(epoll_create1),
    SCMP_SYS(epoll_ctl), SCMP_SYS(epoll_wait), SCMP_SYS(epoll_pwait), SCMP_SYS(eventfd2),
    SCMP_SYS(pipe2), SCMP_SYS(dup), SCMP_SYS(dup3), SCMP_SYS(fstat), SCMP_SYS(lseek),
    SCMP_SYS(ftruncate), SCMP_SYS(timerfd_create), SCMP_SYS(timerfd_settime),
    SCMP_SYS(timerfd_gettime), SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep),
    SCMP_SYS(clock_getres), SCMP_SYS(set_robust_list), SCMP_SYS(rseq), SCMP_SYS(set_tid_address),
    SCMP_SYS(membarrier), SCMP_SYS(sched_get_priority_max), SCMP_SYS(sched_get_priority_min),
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigtimedwait), SCMP_SYS(rt_sigpending), SCMP_SYS(mlock),
    SCMP_SYS(munlock), SCMP_SYS(mincore), SCMP_SYS(msync), SCMP_SYS(getppid), SCMP_SYS(getuid),
    SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(uname), SCMP_SYS(sysinfo),
    SCMP_SYS(getrlimit), SCMP_SYS(wait4), SCMP_SYS(getcpu), SCMP_SYS(arch_prctl),
    // Descriptors of another evaluator server, from the server before.
    SCMP_SYS(recvmsg)};

// Calls whose first argument is a process or a thread. A player asks about itself, and slows none
// but itself.
constexpr int onOneProcess[] = {SCMP_SYS(get_robust_list), SCMP_SYS(sched_getaffinity),
                                SCMP_SYS(sched_setaffinity), SCMP_SYS(sched_getparam),
                                SCMP_SYS(sched_getscheduler)};

// What is done with a descriptor. Left out is what makes signals of it (F_SETOWN, F_SETSIG,
// F_SETLEASE, F_NOTIFY): a thread that is older than the fence of paths could send them to others.
constexpr int onDescriptors[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL};

// A condition on an argument. The library's own macros are C's.
constexpr scmp_arg_cmp where(unsigned argument, scmp_compare comparison, scmp_datum_t a,
                             scmp_datum_t b = 0) {
    return {argument, comparison, a, b};
}

bool allow(void* filter, std::span<const int> calls) {
    for (const int call : calls)
        if (seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) != 0)
            return false;
    return true;
}

template <class... Conditions> bool allowWhere(void* filter, int call, Conditions... conditions) {
    return seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, sizeof...(conditions), conditions...) ==
           0;
}

// Memory may be mapped and its protection changed, but not to something that runs. A player may:
// the software renderer compiles its shaders.
bool allowMemory(void* filter, bool executable) {
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)})
        if (!(executable ? allowWhere(filter, call)
                         : allowWhere(filter, call, where(2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0))))
            return false;
    return true;
}

// A process may signal itself: abort() does. The identity of a later child is not known here.
bool allowOwnSignals(void* filter) {
    const auto self = static_cast<scmp_datum_t>(getpid());
    return allowWhere(filter, SCMP_SYS(tgkill), where(0, SCMP_CMP_EQ, self));
}

bool allowDescriptors(void* filter) {
    for (const int command : onDescriptors)
        if (!allowWhere(filter, SCMP_SYS(fcntl),
                        where(1, SCMP_CMP_EQ, static_cast<scmp_datum_t>(command))))
            return false;
    return allowWhere(filter, SCMP_SYS(fcntl), where(1, SCMP_CMP_EQ, F_SETFL),
                      where(2, SCMP_CMP_MASKED_EQ, O_ASYNC, 0));
}

// What drivers do with their own threads, named as 0 or by the number of the process. Never more
// of the processor than others get: as root a class of real time or a priority below 0 would.
bool allowOnOneself(void* filter) {
    for (const scmp_datum_t self : {scmp_datum_t{0}, static_cast<scmp_datum_t>(getpid())}) {
        for (const int call : onOneProcess)
            if (!allowWhere(filter, call, where(0, SCMP_CMP_EQ, self)))
                return false;
        for (const int schedule : {SCHED_OTHER, SCHED_BATCH, SCHED_IDLE})
            if (!allowWhere(filter, SCMP_SYS(sched_setscheduler), where(0, SCMP_CMP_EQ, self),
                            where(1, SCMP_CMP_EQ, static_cast<scmp_datum_t>(schedule))))
                return false;
        if (!allowWhere(filter, SCMP_SYS(setpriority), where(0, SCMP_CMP_EQ, PRIO_PROCESS),
                        where(1, SCMP_CMP_EQ, self), where(2, SCMP_CMP_LE, 19)) ||
            !allowWhere(filter, SCMP_SYS(getpriority), where(0, SCMP_CMP_EQ, PRIO_PROCESS),
                        where(1, SCMP_CMP_EQ, self)))
            return false;
    }
    const auto self = static_cast<scmp_datum_t>(getpid());
    return allowWhere(filter, SCMP_SYS(kcmp), where(0, SCMP_CMP_EQ, self),
                      where(1, SCMP_CMP_EQ, self));
}

bool fillForPlayer(void* filter) {
    // Threads, not processes.
    return allow(filter, forPlayer) && allowDescriptors(filter) && allowOnOneself(filter) &&
           allowWhere(filter, SCMP_SYS(clone),
                      where(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD)) &&
           // Naming a thread, which drivers do; and asking. Nothing that changes credentials.
           allowWhere(filter, SCMP_SYS(prctl), where(0, SCMP_CMP_EQ, PR_SET_NAME)) &&
           allowWhere(filter, SCMP_SYS(prctl), where(0, SCMP_CMP_EQ, PR_GET_NAME)) &&
           // Asking for a limit of one's own, not setting one.
           allowWhere(filter, SCMP_SYS(prlimit64), where(0, SCMP_CMP_EQ, 0),
                      where(2, SCMP_CMP_EQ, 0)) &&
           // Requests to graphics devices are those whose type is 'd' (DRM) or 'F' (NVIDIA).
           allowWhere(filter, SCMP_SYS(ioctl), where(1, SCMP_CMP_MASKED_EQ, 0xff00, 'd' << 8)) &&
           allowWhere(filter, SCMP_SYS(ioctl), where(1, SCMP_CMP_MASKED_EQ, 0xff00, 'F' << 8));
}

bool fillForServer(void* filter) {
    // New processes, but none in a namespace of its own.
    constexpr scmp_datum_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS |
                                        CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
    return allow(filter, forServer) && allowDescriptors(filter) &&
           allowWhere(filter, SCMP_SYS(clone), where(0, SCMP_CMP_MASKED_EQ, namespaces, 0)) &&
           // What its children tie and drop before they read anything, and their limits.
           allowWhere(filter, SCMP_SYS(prctl), where(0, SCMP_CMP_EQ, PR_SET_PDEATHSIG)) &&
           allowWhere(filter, SCMP_SYS(prctl), where(0, SCMP_CMP_EQ, PR_SET_NO_NEW_PRIVS)) &&
           allowWhere(filter, SCMP_SYS(prctl), where(0, SCMP_CMP_EQ, PR_SET_DUMPABLE),
                      where(1, SCMP_CMP_EQ, 0)) &&
           allowWhere(filter, SCMP_SYS(prlimit64), where(0, SCMP_CMP_EQ, 0));
}

bool fill(void* filter, Role role) {
    if (!allow(filter, forAll) || !allowMemory(filter, role == Role::player) ||
        seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) != 0)
        return false;
    switch (role) {
    case Role::evaluator:
        return allowOwnSignals(filter);
    case Role::player:
        return allowOwnSignals(filter) && fillForPlayer(filter);
    case Role::server:
        return fillForServer(filter);
    }
    return false;
}

} // namespace

std::string filterCalls(Role role) {
    const Filter filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release);
    if (!filter)
        return "no filter on system calls";
    // Threads that exist already are held as well.
    if (role == Role::player)
        seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_TSYNC, 1);
    if (!fill(filter.get(), role) || seccomp_load(filter.get()) != 0)
        return "no filter on system calls";
    return "";
}

} // namespace confinement
