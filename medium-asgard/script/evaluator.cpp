#include "script/evaluator.h"

#include "confinement/confinement.h"
#include "script/interpreter.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <tcl.h>
#include <unistd.h>

namespace script {

bool readAll(int fd, void* bytes, std::size_t count) {
    auto* at = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = read(fd, at, count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

bool writeAll(int fd, const void* bytes, std::size_t count) {
    const auto* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t put = write(fd, at, count);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0)
            return false;
        at += put;
        count -= static_cast<std::size_t>(put);
    }
    return true;
}

namespace {

using Clock = std::chrono::steady_clock;

// --- in the evaluator -----------------------------------------------------------------------

// What the handlers of exhausted memory can still send.
const Interpreter* interpreterInUse = nullptr;
int replyInUse = -1;

[[noreturn]] void leaveWithoutMemory() {
    if (interpreterInUse) {
        const std::string& recorded = interpreterInUse->recorded();
        writeAll(replyInUse, recorded.data(), recorded.size());
    }
    _exit(exitOutOfMemory);
}

// Tcl panics when it cannot allocate; tcl.h takes the better name.
[[noreturn]] void leaveAtTclPanic(const char*, ...) { leaveWithoutMemory(); }

[[noreturn]] void evaluateOne(int in, int out, Progress& progress, const Limits& limits) {
    Interpreter interpreter(progress);
    (void)confinement::confine(
        confinement::Role::evaluator,
        {.memory = limits.bytes, .cpuSeconds = limits.cpuSeconds, .descriptors = 0});
    std::uint64_t size = 0;
    if (!readAll(in, &size, sizeof size))
        _exit(0); // never needed
    std::string bytes(size, '\0');
    if (!readAll(in, bytes.data(), size))
        _exit(1);
    const auto request = decodeRequest(bytes);
    if (!request)
        _exit(1);
    interpreterInUse = &interpreter;
    replyInUse = out;
    std::set_new_handler(&leaveWithoutMemory);
    Tcl_SetPanicProc(&leaveAtTclPanic);
    const std::string& recording = interpreter.evaluate(*request);
    _exit(writeAll(out, recording.data(), recording.size()) ? 0 : 1);
}

// --- in the server --------------------------------------------------------------------------

struct Evaluator {
    pid_t process = -1;
    int in = -1;  // to it
    int out = -1; // from it
    Progress* progress = nullptr;
};

void forget(Evaluator& evaluator) {
    if (evaluator.in >= 0)
        close(evaluator.in);
    if (evaluator.out >= 0)
        close(evaluator.out);
    if (evaluator.progress)
        munmap(evaluator.progress, sizeof(Progress));
    evaluator = {};
}

// A pipe whose ends are not among the standard descriptors, which libraries take for their own.
bool openPipe(std::array<int, 2>& ends) {
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        return false;
    for (int& end : ends)
        if (end < 3) {
            const int moved = fcntl(end, F_DUPFD_CLOEXEC, 3);
            close(end);
            end = moved;
        }
    return ends[0] >= 0 && ends[1] >= 0;
}

Evaluator makeReady(const Limits& limits) {
    Evaluator evaluator;
    std::array<int, 2> in{-1, -1};
    std::array<int, 2> out{-1, -1};
    void* page =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED || !openPipe(in) || !openPipe(out))
        return evaluator;
    evaluator.progress = new (page) Progress;
    const pid_t server = getpid();
    evaluator.process = fork();
    if (evaluator.process == 0) {
        confinement::dieWithParent(server);
        const std::array<int, 2> keep{in[0], out[1]};
        confinement::closeDescriptorsExcept(keep);
        evaluateOne(in[0], out[1], *evaluator.progress, limits);
    }
    close(in[0]);
    close(out[1]);
    evaluator.in = in[1];
    evaluator.out = out[0];
    fcntl(evaluator.in, F_SETFL, O_NONBLOCK);
    return evaluator;
}

struct Result {
    End end = End::exited;
    int status = 0;
    std::uint64_t progress = noOffset;
    std::string bytes;
};

class Server {
public:
    Server(int requests, int replies, const Limits& limits)
        : requests_(requests), replies_(replies), limits_(limits) {}

    void run() {
        ready_ = makeReady(limits_);
        Header header;
        while (readAll(requests_, &header, sizeof header)) {
            if (header.magic != Header::magicNumber)
                break;
            if (header.kind != static_cast<std::uint32_t>(Kind::evaluate))
                continue; // cancels what has ended already
            request_.resize(header.bytes);
            if (!readAll(requests_, request_.data(), request_.size()) || !answer(header))
                break;
            forget(ready_);
            ready_ = makeReady(limits_);
        }
        endEvaluator();
    }

private:
    bool answer(const Header& request) {
        const Result result = evaluate(request);
        Header reply;
        reply.kind = static_cast<std::uint32_t>(result.end);
        reply.serial = request.serial;
        reply.bytes = result.bytes.size();
        reply.progress = result.progress;
        reply.status = result.status;
        return writeAll(replies_, &reply, sizeof reply) &&
               writeAll(replies_, result.bytes.data(), result.bytes.size());
    }

    Result evaluate(const Header& request) {
        Result result;
        if (ready_.process < 0) {
            result.end = End::notStarted;
            return result;
        }
        const auto until = Clock::now() + limits_.wallClock;
        const std::uint64_t size = request_.size();
        request_.insert(0, reinterpret_cast<const char*>(&size), sizeof size);
        result.end = exchange(request.serial, until, result.bytes);
        if (result.end != End::exited)
            kill(ready_.process, SIGKILL);
        const int status = endEvaluator();
        result.progress = ready_.progress->offset.load(std::memory_order_relaxed);
        if (result.end == End::exited && WIFSIGNALED(status)) {
            result.end = End::signalled;
            result.status = WTERMSIG(status);
        } else if (WIFEXITED(status)) {
            result.status = WEXITSTATUS(status);
        }
        return result;
    }

    // An evaluator's last descriptor closes when its exit status is set already; one that closed it
    // by itself and lives is ended.
    int endEvaluator() {
        int status = 0;
        if (ready_.process < 0)
            return status;
        kill(ready_.process, SIGKILL);
        while (waitpid(ready_.process, &status, 0) < 0 && errno == EINTR) {
        }
        ready_.process = -1;
        return status;
    }

    // Sends the request, takes the recording, until the pipe closes or something ends it.
    End exchange(std::uint64_t serial, Clock::time_point until, std::string& bytes) {
        std::size_t sent = 0;
        while (true) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
            if (left <= 0)
                return End::outOfTime;
            std::array<pollfd, 3> watched{
                pollfd{ready_.out, POLLIN, 0}, pollfd{requests_, POLLIN, 0},
                pollfd{sent < request_.size() ? ready_.in : -1, POLLOUT, 0}};
            if (poll(watched.data(), watched.size(), static_cast<int>(left)) < 0 && errno != EINTR)
                return End::cancelled;
            if (watched[1].revents != 0 && cancels(serial))
                return End::cancelled;
            if ((watched[2].revents & POLLOUT) != 0)
                send(sent);
            else if (watched[2].revents != 0)
                sent = request_.size(); // it is gone
            if (watched[0].revents != 0 && !take(bytes))
                return End::exited;
            if (bytes.size() > mostRecordedBytes)
                return End::tooMuch;
        }
    }

    bool cancels(std::uint64_t serial) {
        Header header;
        if (!readAll(requests_, &header, sizeof header))
            return true; // the reader is gone
        return header.kind == static_cast<std::uint32_t>(Kind::cancel) && header.serial == serial;
    }

    void send(std::size_t& sent) {
        const ssize_t put = write(ready_.in, request_.data() + sent, request_.size() - sent);
        if (put > 0)
            sent += static_cast<std::size_t>(put);
        else if (errno != EAGAIN && errno != EINTR)
            sent = request_.size();
    }

    bool take(std::string& bytes) {
        std::array<char, 65536> block;
        const ssize_t got = read(ready_.out, block.data(), block.size());
        if (got < 0)
            return errno == EINTR;
        bytes.append(block.data(), static_cast<std::size_t>(got));
        return got > 0;
    }

    int requests_;
    int replies_;
    Limits limits_;
    Evaluator ready_;
    std::string request_;
};

} // namespace

void serveEvaluations(int requests, int replies, int parent, const Limits& limits) {
    confinement::dieWithParent(parent);
    const std::array<int, 2> keep{requests, replies};
    confinement::closeDescriptorsExcept(keep);
    confinement::emptyEnvironment();
    std::signal(SIGPIPE, SIG_IGN);
    for (const int inherited : {SIGINT, SIGTERM, SIGHUP, SIGCHLD})
        std::signal(inherited, SIG_DFL);
    (void)confinement::confine(confinement::Role::server,
                               {.memory = {}, .cpuSeconds = {}, .descriptors = 64});
    Server(requests, replies, limits).run();
    _exit(0);
}

} // namespace script
