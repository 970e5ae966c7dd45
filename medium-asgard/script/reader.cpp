#include "script/reader.h"

#include "script/evaluator.h"
#include "script/make_scene.h"
#include "script/places.h"
#include "script/verdict.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace script {

namespace {

constexpr std::size_t mostTextBytes = std::size_t{8} << 20;

// A server that died must not end this process by SIGPIPE.
class WithoutBrokenPipe {
public:
    WithoutBrokenPipe() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~WithoutBrokenPipe() {
        constexpr timespec atOnce{0, 0};
        while (sigtimedwait(&pipe_, nullptr, &atOnce) < 0 && errno == EINTR) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    WithoutBrokenPipe(const WithoutBrokenPipe&) = delete;
    WithoutBrokenPipe& operator=(const WithoutBrokenPipe&) = delete;

private:
    sigset_t pipe_;
    sigset_t before_;
};

} // namespace

struct Reader::Implementation {
    Limits limits;
    pid_t server = -1;
    int requests = -1;
    int replies = -1;
    std::mutex reading;       // one reading at a time
    std::mutex writing;       // a cancel does not fall into a request
    std::uint64_t serial = 0; // of the reading that runs now; under writing
    bool running = false;     // under writing

    void start();
    Answer ask(std::string_view text, const std::map<std::string, double>& parameters);
    bool send(const std::string& request);
    bool receive(Answer& answer);
    bool waitForReply(int milliseconds) const;
};

void Reader::Implementation::start() {
    std::array<int, 2> to{-1, -1};
    std::array<int, 2> from{-1, -1};
    if (pipe2(to.data(), O_CLOEXEC) != 0)
        return;
    if (pipe2(from.data(), O_CLOEXEC) != 0) {
        close(to[0]);
        close(to[1]);
        return;
    }
    const pid_t self = getpid();
    server = fork();
    if (server == 0)
        serveEvaluations(to[0], from[1], self, limits);
    close(to[0]);
    close(from[1]);
    requests = to[1];
    replies = from[0];
}

bool Reader::Implementation::send(const std::string& request) {
    const WithoutBrokenPipe guard;
    const std::lock_guard lock(writing);
    Header header;
    header.kind = static_cast<std::uint32_t>(Kind::evaluate);
    header.serial = ++serial;
    header.bytes = request.size();
    running = true;
    return writeAll(requests, &header, sizeof header) &&
           writeAll(requests, request.data(), request.size());
}

bool Reader::Implementation::waitForReply(int milliseconds) const {
    pollfd reply{replies, POLLIN, 0};
    while (true) {
        const int ready = poll(&reply, 1, milliseconds);
        if (ready >= 0 || errno != EINTR)
            return ready > 0;
    }
}

bool Reader::Implementation::receive(Answer& answer) {
    // The server keeps the time; that it keeps it is checked too.
    constexpr int graceMs = 3000;
    Header header;
    if (!waitForReply(static_cast<int>(limits.wallClock.count()) + graceMs) ||
        !readAll(replies, &header, sizeof header) || header.magic != Header::magicNumber ||
        header.serial != serial || header.bytes > 2 * mostRecordedBytes ||
        header.kind > static_cast<std::uint32_t>(End::notStarted))
        return false;
    answer.bytes.resize(header.bytes);
    answer.end = static_cast<End>(header.kind);
    answer.status = header.status;
    answer.progress = header.progress;
    return readAll(replies, answer.bytes.data(), answer.bytes.size());
}

Answer Reader::Implementation::ask(std::string_view text,
                                   const std::map<std::string, double>& parameters) {
    Answer answer;
    answer.end = End::notStarted;
    const std::lock_guard lock(reading);
    if (server < 0)
        return answer;
    Request request;
    request.commands = limits.commands;
    request.parameters = parameters;
    request.text = text;
    if (!send(encode(request)) || !receive(answer)) {
        // Out of step for good.
        kill(server, SIGKILL);
        waitpid(server, nullptr, 0);
        server = -1;
        answer = {};
        answer.end = End::notStarted;
    }
    const std::lock_guard state(writing);
    running = false;
    return answer;
}

Reader::Reader(Limits limits) : implementation_(std::make_unique<Implementation>()) {
    implementation_->limits = limits;
    implementation_->start();
}

Reader::~Reader() {
    if (implementation_->requests >= 0)
        close(implementation_->requests); // the server leaves at the end of its pipe
    if (implementation_->replies >= 0)
        close(implementation_->replies);
    while (implementation_->server > 0 && waitpid(implementation_->server, nullptr, 0) < 0 &&
           errno == EINTR) {
    }
}

void Reader::cancel() {
    const WithoutBrokenPipe guard;
    const std::lock_guard lock(implementation_->writing);
    if (!implementation_->running)
        return;
    Header header;
    header.kind = static_cast<std::uint32_t>(Kind::cancel);
    header.serial = implementation_->serial;
    writeAll(implementation_->requests, &header, sizeof header);
}

ReadResult Reader::read(std::string_view text, const std::map<std::string, double>& parameters) {
    ReadResult result;
    if (const auto refusal = refuse(text, mostTextBytes)) {
        result.diagnostics = {*refusal};
        return result;
    }
    // Editors of other systems write a mark before the text; as blanks it moves nothing.
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
    std::string plain(text);
    if (text.starts_with(byteOrderMark))
        plain.replace(0, byteOrderMark.size(), byteOrderMark.size(), ' ');
    const Answer answer = implementation_->ask(plain, parameters);
    return judge(plain, answer, implementation_->limits, parameters);
}

} // namespace script
