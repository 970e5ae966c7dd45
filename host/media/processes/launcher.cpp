#include "processes/launcher.h"

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace media {

namespace {

std::vector<char*> pointers(const std::vector<std::string>& strings) {
    std::vector<char*> result;
    result.reserve(strings.size() + 1);
    for (const std::string& string : strings)
        result.push_back(const_cast<char*>(string.c_str()));
    result.push_back(nullptr);
    return result;
}

std::string keeperProgram() {
    std::array<char, PATH_MAX> self{};
    const ssize_t length = readlink("/proc/self/exe", self.data(), self.size());
    const std::string program(self.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
    return program.substr(0, program.rfind('/') + 1) + "medium-keeper";
}

struct Ends {
    std::array<int, 2> in{-1, -1}, out{-1, -1}, log{-1, -1};

    bool open() {
        return pipe2(in.data(), O_CLOEXEC) == 0 && pipe2(out.data(), O_CLOEXEC) == 0 &&
               pipe2(log.data(), O_CLOEXEC) == 0;
    }
    void closeAll() {
        for (auto* pair : {&in, &out, &log})
            for (int end : *pair)
                if (end >= 0)
                    close(end);
    }
};

// Descriptors are first moved out of the way of 0..3, so that none is overwritten before its turn.
bool placeDescriptors(int in, int out, int log, int frames) {
    const int above = 10;
    std::array<int, 4> from{in, out, log, frames};
    for (int& descriptor : from)
        if (descriptor >= 0 && (descriptor = fcntl(descriptor, F_DUPFD, above)) < 0)
            return false;
    for (int target = 0; target < 4; ++target)
        if (from[target] >= 0 && dup2(from[target], target) < 0)
            return false;
    const unsigned first = frames >= 0 ? framesDescriptor + 1 : framesDescriptor;
    return syscall(SYS_close_range, first, ~0U, 0) == 0;
}

// Runs between vfork and exec: system calls only, and nothing of the parent's memory is changed.
[[noreturn]] void become(const Launch& request, const Ends& ends, pid_t parent, char** arguments,
                         char** environment) {
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) // it died before the line above
        _exit(127);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    signal(SIGPIPE, SIG_DFL);
    if (placeDescriptors(ends.in[0], ends.out[1], ends.log[1], request.frames))
        execve(arguments[0], arguments, environment);
    _exit(127);
}

// By itself, so that no variable of the parent lives in registers across vfork.
[[gnu::noinline]] pid_t forkInto(const Launch& request, const Ends& ends, pid_t parent,
                                 char** arguments, char** environment) {
    // become() makes system calls only and never returns, as vfork wants it.
    const pid_t process = vfork(); // NOLINT(clang-analyzer-security.insecureAPI.vfork)
    if (process == 0)
        become(request, ends, parent, arguments, environment); // NOLINT(clang-analyzer-unix.Vfork)
    return process;
}

} // namespace

Launched launch(const Launch& request) {
    Launched result;
    const std::string keeper = keeperProgram();
    if (access(keeper.c_str(), X_OK) != 0) {
        result.error = "could not be started: the program " + keeper +
                       ", which ends what media leave behind, is missing; install Ensemble again";
        return result;
    }
    Ends ends;
    if (!ends.open()) {
        result.error = std::string("no pipe to it could be made: ") + std::strerror(errno);
        ends.closeAll();
        return result;
    }
    std::vector<char*> arguments = pointers(request.arguments);
    arguments.insert(arguments.begin(), {const_cast<char*>(keeper.c_str()),
                                         const_cast<char*>(request.program.c_str())});
    const std::vector<char*> environment = pointers(request.environment);
    const pid_t parent = getpid();
    const pid_t process =
        forkInto(request, ends, parent, arguments.data(), const_cast<char**>(environment.data()));
    if (process < 0) {
        result.error = std::string("no process could be made: ") + std::strerror(errno);
        ends.closeAll();
        return result;
    }
    close(ends.in[0]);
    close(ends.out[1]);
    close(ends.log[1]);
    for (int end : {ends.in[1], ends.out[0], ends.log[0]})
        fcntl(end, F_SETFL, O_NONBLOCK);
    result.process = process;
    result.processDescriptor = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
    result.toMedium = ends.in[1];
    result.fromMedium = ends.out[0];
    result.log = ends.log[0];
    return result;
}

void askToEnd(const Launched& medium) {
    kill(medium.process, SIGTERM);
    kill(medium.process, SIGCONT); // the medium may have stopped it
}

void endWithKeeper(const Launched& medium) { kill(medium.process, SIGKILL); }

int reap(const Launched& medium) {
    int status = 0;
    while (waitpid(medium.process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

bool couldNotStart(int waitStatus) {
    return !WIFSIGNALED(waitStatus) && WEXITSTATUS(waitStatus) == 127;
}

std::string describeEnd(int waitStatus) {
    if (WIFSIGNALED(waitStatus)) {
        const int signal = WTERMSIG(waitStatus);
        const char* name = sigdescr_np(signal);
        return "was ended by signal " + std::to_string(signal) + " (" + (name ? name : "?") + ")" +
               (signal == SIGKILL ? ", for example since the machine has no memory left" : "");
    }
    if (couldNotStart(waitStatus))
        return "could not be started";
    return "ended with exit code " + std::to_string(WEXITSTATUS(waitStatus));
}

} // namespace media
