#include "script/evaluator.h"

#include "confinement/confinement.h"
#include "script/interpreter.h"
#include "script/processes.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <tcl.h>
#include <unistd.h>

namespace script {

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
    std::set_terminate(&leaveWithoutMemory);
    Tcl_SetPanicProc(&leaveAtTclPanic);
    const std::string& recording = interpreter.evaluate(*request);
    _exit(writeAll(out, recording.data(), recording.size()) ? 0 : 1);
}

// --- in the server --------------------------------------------------------------------------

struct Evaluator {
    Child child;
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

Evaluator makeReady(const Limits& limits) {
    Evaluator evaluator;
    std::array<int, 2> in{-1, -1};
    std::array<int, 2> out{-1, -1};
    void* page =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED || !openPipe(in) || !openPipe(out)) {
        if (page != MAP_FAILED)
            munmap(page, sizeof(Progress));
        closeAll(in);
        return evaluator;
    }
    evaluator.progress = new (page) Progress;
    const pid_t server = getpid();
    evaluator.child = forkChild();
    if (evaluator.child.process == 0) {
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
    Server(const ServerEnds& ends, int parent, const Limits& limits)
        : ends_(ends), parent_(parent), limits_(limits) {}

    [[noreturn]] void run(bool spare) {
        if (!spare)
            ready_ = makeReady(limits_);
        Header header;
        while (readAll(ends_.requests, &header, sizeof header) && serve(header)) {
        }
        end(ready_.child);
        _exit(0);
    }

private:
    // False when this process has nothing to do any more.
    bool serve(const Header& header) {
        if (header.magic != Header::magicNumber)
            return false;
        if (header.kind == static_cast<std::uint32_t>(Kind::another)) {
            makeAnother();
        } else if (header.kind == static_cast<std::uint32_t>(Kind::evaluate)) {
            request_.resize(header.bytes);
            if (!readAll(ends_.requests, request_.data(), request_.size()) || !answer(header))
                return false;
        } // else it cancels what has ended already
        if (ready_.child.process < 0) {
            forget(ready_);
            ready_ = makeReady(limits_);
        }
        return true;
    }

    // A spare beside this process, within the same fences, which it inherits.
    void makeAnother() {
        std::array<int, 2> requests{-1, -1};
        std::array<int, 2> replies{-1, -1};
        if (openPipe(requests) && openPipe(replies)) {
            const pid_t process = forkSibling();
            if (process == 0) {
                forget(ready_);
                standBy({requests[0], replies[1], ends_.arrivals});
            }
            if (process > 0)
                send(ends_.arrivals, {process, {requests[1], replies[0]}});
        }
        closeAll(requests);
        closeAll(replies);
    }

    [[noreturn]] void standBy(const ServerEnds& ends) {
        confinement::dieWithParent(parent_);
        const std::array<int, 3> keep{ends.requests, ends.replies, ends.arrivals};
        confinement::closeDescriptorsExcept(keep);
        Server(ends, parent_, limits_).run(true);
    }

    bool answer(const Header& request) {
        const Result result = evaluate(request);
        Header reply;
        reply.kind = static_cast<std::uint32_t>(result.end);
        reply.serial = request.serial;
        reply.bytes = result.bytes.size();
        reply.progress = result.progress;
        reply.status = result.status;
        return writeAll(ends_.replies, &reply, sizeof reply) &&
               writeAll(ends_.replies, result.bytes.data(), result.bytes.size());
    }

    Result evaluate(const Header& request) {
        Result result;
        if (ready_.child.process < 0) {
            result.end = End::notStarted;
            return result;
        }
        const auto until = Clock::now() + limits_.wallClock;
        const std::uint64_t size = request_.size();
        request_.insert(0, reinterpret_cast<const char*>(&size), sizeof size);
        result.end = exchange(request.serial, until, result.bytes);
        // Its last descriptor closes when its exit status is set already; one that closed it by
        // itself and lives is ended, too.
        const int status = end(ready_.child);
        result.progress = ready_.progress->offset.load(std::memory_order_relaxed);
        if (result.end == End::exited && WIFSIGNALED(status)) {
            result.end = End::signalled;
            result.status = WTERMSIG(status);
        } else if (WIFEXITED(status)) {
            result.status = WEXITSTATUS(status);
        }
        return result;
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
                pollfd{ready_.out, POLLIN, 0}, pollfd{ends_.requests, POLLIN, 0},
                pollfd{sent < request_.size() ? ready_.in : -1, POLLOUT, 0}};
            if (poll(watched.data(), watched.size(), static_cast<int>(left)) < 0 && errno != EINTR)
                return End::cancelled;
            if (watched[1].revents != 0 && cancels(serial))
                return End::cancelled;
            if ((watched[2].revents & POLLOUT) != 0)
                sendOn(sent);
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
        if (!readAll(ends_.requests, &header, sizeof header))
            return true; // the reader is gone
        return header.kind == static_cast<std::uint32_t>(Kind::cancel) && header.serial == serial;
    }

    void sendOn(std::size_t& sent) {
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

    ServerEnds ends_;
    pid_t parent_;
    Limits limits_;
    Evaluator ready_;
    std::string request_;
};

} // namespace

void serveEvaluations(const ServerEnds& ends, int parent, const Limits& limits, bool spare) {
    confinement::dieWithParent(parent);
    const std::array<int, 3> keep{ends.requests, ends.replies, ends.arrivals};
    confinement::closeDescriptorsExcept(keep);
    confinement::emptyEnvironment();
    std::signal(SIGPIPE, SIG_IGN);
    for (const int inherited : {SIGINT, SIGTERM, SIGHUP, SIGCHLD})
        std::signal(inherited, SIG_DFL);
    (void)confinement::confine(confinement::Role::server,
                               {.memory = {}, .cpuSeconds = {}, .descriptors = 64});
    Server(ends, parent, limits).run(spare);
}

} // namespace script
