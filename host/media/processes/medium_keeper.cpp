// medium-keeper PROGRAM ARGUMENTS...: runs a program, and leaves nothing of it behind.
//
// A process that the program starts becomes a child of this one when its own parent ends, also
// after it has left the session (PR_SET_CHILD_SUBREAPER). When the program ends, when this process
// is sent SIGTERM, or when its own parent ends, all of them are killed, and this process ends as
// the program did: the same exit code, the same signal. docs/decisions/0055-medium-keeper.md.
//
// It is started for every medium, so it uses the C library alone, which loads at once.
//
// LIMIT: processes that start others faster than they are killed, each ending at once, outrun it.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr int couldNotStart = 127; // as shells say it; launcher.cpp reads it

[[noreturn]] void become(char** command, pid_t keeper, const sigset_t& signalsBefore) {
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != keeper) // it died before the line above
        _exit(couldNotStart);
    sigprocmask(SIG_SETMASK, &signalsBefore, nullptr);
    execv(command[0], command);
    _exit(couldNotStart);
}

// Waits for a child that has ended, or for none if `flags` say so; notes the program's status.
// 0: none has ended; -1: there is no child.
pid_t reapOne(int flags, pid_t program, int& programStatus) {
    int status = 0;
    pid_t child = 0;
    while ((child = waitpid(-1, &status, flags)) < 0 && errno == EINTR) {
    }
    if (child == program)
        programStatus = status;
    return child;
}

// True when the program is among those that have ended by now.
bool reapEnded(pid_t program, int& programStatus) {
    bool ended = false;
    for (pid_t child = 0; (child = reapOne(WNOHANG, program, programStatus)) > 0;)
        ended |= child == program;
    return ended;
}

// A number stays its child's until that is reaped, so nobody else is hit. False: nothing is known
// of children.
bool killChildren() {
    char name[64];
    std::snprintf(name, sizeof name, "/proc/self/task/%d/children", getpid());
    FILE* children = std::fopen(name, "re");
    if (!children)
        return false;
    for (int child = 0; std::fscanf(children, "%d", &child) == 1;)
        kill(child, SIGKILL);
    std::fclose(children);
    return true;
}

// The children of what is killed become children of this process, so it goes on until it has none.
void endAll(pid_t program, int& programStatus) {
    while (killChildren() && reapOne(0, program, programStatus) >= 0)
        reapEnded(program, programStatus);
}

[[noreturn]] void endAs(int status) {
    if (!WIFSIGNALED(status))
        _exit(WEXITSTATUS(status));
    const rlimit noCore{0, 0}; // the program has written its own
    setrlimit(RLIMIT_CORE, &noCore);
    std::signal(WTERMSIG(status), SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    kill(getpid(), WTERMSIG(status));
    _exit(128 + WTERMSIG(status));
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2 || prctl(PR_SET_CHILD_SUBREAPER, 1) != 0)
        return couldNotStart;
    std::signal(SIGCHLD, SIG_DFL); // ignored, it would take the program's status away
    sigset_t waited, before;
    sigemptyset(&waited);
    sigaddset(&waited, SIGCHLD);
    sigaddset(&waited, SIGTERM);
    sigprocmask(SIG_BLOCK, &waited, &before);
    const pid_t keeper = getpid();
    const pid_t program = fork();
    if (program < 0)
        return couldNotStart;
    if (program == 0)
        become(argv + 1, keeper, before);
    // Pipes and frames are the program's alone: the host reads of its end from them.
    syscall(SYS_close_range, 0U, ~0U, 0U);
    prctl(PR_SET_PDEATHSIG, SIGTERM); // it was SIGKILL until here, which the program gets, too
    int status = SIGKILL;             // as waitpid() says it
    for (bool ended = false; !ended;) {
        const int signal = sigwaitinfo(&waited, nullptr);
        ended = signal == SIGTERM || (signal == SIGCHLD && reapEnded(program, status));
    }
    endAll(program, status);
    endAs(status);
}
