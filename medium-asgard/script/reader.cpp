#include "script/reader.h"

#include "script/evaluator.h"
#include "script/make_scene.h"
#include "script/processes.h"
#include "script/servers.h"
#include "script/verdict.h"
#include "text/characters.h"

#include <cerrno>
#include <csignal>
#include <mutex>

#include <poll.h>
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
    explicit Implementation(const Limits& given) : limits(given), servers(given) {}

    Limits limits;
    Servers servers;          // changed under reading and writing
    std::mutex reading;       // one reading at a time
    std::mutex writing;       // a cancel does not fall into a request
    std::uint64_t serial = 0; // of the reading that runs now; under writing
    bool running = false;     // under writing
    bool cancelled = false;   // under writing

    Answer ask(std::string_view text, const std::map<std::string, double>& parameters);
    Answer askOneOfTwo(const std::string& request);
    std::optional<End> prepare();
    End dismiss();
    bool send(const std::string& request);
    bool receive(Answer& answer);
    bool waitForReply(int milliseconds) const;
};

bool Reader::Implementation::send(const std::string& request) {
    const WithoutBrokenPipe guard;
    const std::lock_guard lock(writing);
    Header header;
    header.kind = static_cast<std::uint32_t>(Kind::evaluate);
    header.serial = ++serial;
    header.bytes = request.size();
    running = true;
    return writeAll(servers.requests(), &header, sizeof header) &&
           writeAll(servers.requests(), request.data(), request.size());
}

bool Reader::Implementation::waitForReply(int milliseconds) const {
    pollfd reply{servers.replies(), POLLIN, 0};
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
        !readAll(servers.replies(), &header, sizeof header) ||
        header.magic != Header::magicNumber || header.serial != serial ||
        header.bytes > 2 * mostRecordedBytes ||
        header.kind > static_cast<std::uint32_t>(End::notStarted))
        return false;
    answer.bytes.resize(header.bytes);
    answer.end = static_cast<End>(header.kind);
    answer.status = header.status;
    answer.progress = header.progress;
    return readAll(servers.replies(), answer.bytes.data(), answer.bytes.size());
}

std::optional<End> Reader::Implementation::prepare() {
    const WithoutBrokenPipe guard;
    const std::lock_guard lock(writing);
    return servers.prepare();
}

// What a reading has come to whose server ended.
End Reader::Implementation::dismiss() {
    const std::lock_guard lock(writing);
    servers.dismiss();
    return cancelled ? End::cancelled : End::serverEnded;
}

// Of the server that works; where it ended, of the one that takes its place.
Answer Reader::Implementation::askOneOfTwo(const std::string& request) {
    Answer answer;
    for (int tries = 0; tries < 2; ++tries) {
        answer = {};
        if (const auto none = prepare()) {
            answer.end = *none;
            break;
        }
        if (send(request) && receive(answer))
            break;
        answer = {};
        answer.end = dismiss();
        if (answer.end == End::cancelled)
            break;
    }
    return answer;
}

Answer Reader::Implementation::ask(std::string_view text,
                                   const std::map<std::string, double>& parameters) {
    const std::lock_guard lock(reading);
    Request request;
    request.commands = limits.commands;
    request.parameters = parameters;
    request.text = text;
    const int before = servers.replaced();
    Answer answer = askOneOfTwo(encode(request));
    answer.serverReplaced = servers.replaced() > before;
    const std::lock_guard state(writing);
    running = cancelled = false;
    return answer;
}

Reader::Reader(Limits limits) : implementation_(std::make_unique<Implementation>(limits)) {}

Reader::~Reader() = default;

void Reader::cancel() {
    const WithoutBrokenPipe guard;
    const std::lock_guard lock(implementation_->writing);
    if (!implementation_->running)
        return;
    implementation_->cancelled = true;
    Header header;
    header.kind = static_cast<std::uint32_t>(Kind::cancel);
    header.serial = implementation_->serial;
    writeAll(implementation_->servers.requests(), &header, sizeof header);
}

ReadResult Reader::read(std::string_view text, const std::map<std::string, double>& parameters) {
    ReadResult result;
    if (const auto refusal = refuse(text, mostTextBytes)) {
        result.diagnostics = {*refusal};
        return result;
    }
    // Editors of other systems write a mark before the text; as blanks it moves nothing.
    std::string plain(text);
    if (text.starts_with(text::byteOrderMark))
        plain.replace(0, text::byteOrderMark.size(), text::byteOrderMark.size(), ' ');
    const Answer answer = implementation_->ask(plain, parameters);
    return judge(plain, answer, implementation_->limits, parameters);
}

} // namespace script
