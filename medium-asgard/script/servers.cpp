#include "script/servers.h"

#include <algorithm>
#include <cerrno>

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace script {

namespace {

// A server that lives answers at once.
constexpr int mostMillisecondsForSpare = 3000;

bool hasEnded(pid_t process) { return waitpid(process, nullptr, WNOHANG) != 0; }

void waitFor(pid_t process) {
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

} // namespace

Servers::Servers(const Limits& limits) : limits_(limits) {
    std::array<int, 2> ends{-1, -1};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return;
    arrivals_ = ends[0];
    arrivalsFar_ = ends[1];
    working_ = start(false);
    spare_ = start(true);
    close(arrivalsFar_);
    arrivalsFar_ = -1;
}

Servers::~Servers() {
    // A server leaves at the end of its pipe.
    for (Sent* server : {&working_, &spare_})
        closeAll(server->descriptors);
    if (arrivals_ >= 0)
        close(arrivals_);
    for (const Sent* server : {&working_, &spare_})
        if (server->process > 0)
            waitFor(server->process);
    noticeEnds();
}

Sent Servers::start(bool spare) {
    std::array<int, 2> to{-1, -1};
    std::array<int, 2> from{-1, -1};
    Sent server;
    if (openPipe(to) && openPipe(from)) {
        const pid_t self = getpid();
        server.process = fork();
        if (server.process == 0)
            serveEvaluations({to[0], from[1], arrivalsFar_}, self, limits_, spare);
    }
    if (server.process > 0) {
        std::swap(server.descriptors[0], to[1]);
        std::swap(server.descriptors[1], from[0]);
    }
    closeAll(to);
    closeAll(from);
    return server;
}

bool Servers::tooOften() const {
    const auto since = Clock::now() - limits_.restartsWithin;
    return std::count_if(ends_.begin(), ends_.end(), [&](auto at) { return at > since; }) >
           limits_.restarts;
}

void Servers::countEnd() {
    const auto since = Clock::now() - limits_.restartsWithin;
    std::erase_if(ends_, [&](auto at) { return at <= since; });
    ends_.push_back(Clock::now());
}

void Servers::noticeEnds() {
    std::erase_if(leaving_, hasEnded);
    if (spare_.process > 0 && hasEnded(spare_.process)) {
        closeAll(spare_.descriptors);
        spare_ = {};
        countEnd();
    }
}

void Servers::dismiss() {
    closeAll(working_.descriptors);
    if (working_.process > 0) {
        leaving_.push_back(working_.process);
        countEnd();
    }
    working_ = {};
    noticeEnds();
}

void Servers::askForSpare() {
    Header header;
    header.kind = static_cast<std::uint32_t>(Kind::another);
    if (writeAll(requests(), &header, sizeof header))
        spare_ = receive(arrivals_, mostMillisecondsForSpare).value_or(Sent{});
}

std::optional<End> Servers::prepare() {
    noticeEnds();
    if (working_.process < 0) {
        if (spare_.process < 0)
            return End::noServer;
        if (tooOften())
            return End::endedTooOften;
        working_ = std::exchange(spare_, Sent{});
        ++replaced_;
    }
    if (spare_.process < 0 && !tooOften())
        askForSpare();
    return std::nullopt;
}

} // namespace script
