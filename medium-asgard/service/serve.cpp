#include "service/serve.h"

#include "terminal/terminal.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace service {

Connection::Connection(Platform platform, int input, int output)
    : input_(input), output_(output), session_(std::move(platform), channel_) {
    for (const int descriptor : {input, output})
        fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

bool Connection::closed() const { return !open_ || session_.over() || !channel_.fault().empty(); }

int Connection::exitCode() const {
    if (channel_.fault().empty())
        return 0;
    terminal::complain("asgard: the host sent " + channel_.fault());
    return 1;
}

void Connection::receive() {
    std::array<char, 1 << 16> bytes;
    const ssize_t count = read(input_, bytes.data(), bytes.size());
    if (count > 0)
        channel_.feed({bytes.data(), static_cast<std::size_t>(count)});
    else if (count == 0 || (errno != EAGAIN && errno != EINTR))
        open_ = false;
    while (!session_.over())
        if (const auto call = channel_.next())
            session_.receive(*call, Clock::now());
        else
            break;
    attend();
}

void Connection::attend() {
    session_.attend(Clock::now());
    flush();
}

void Connection::flush() {
    while (open_ && sending()) {
        const std::string_view bytes = channel_.outgoing();
        const ssize_t count = write(output_, bytes.data(), bytes.size());
        if (count > 0)
            channel_.sent(static_cast<std::size_t>(count));
        else if (errno == EAGAIN)
            return;
        else if (errno != EINTR)
            open_ = false; // nobody reads any more
    }
}

namespace {

int timeout(const Session& session) {
    const auto deadline = session.deadline();
    if (!deadline)
        return -1;
    const auto rest =
        std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now()).count();
    return static_cast<int>(std::clamp<long>(rest, 0, 60'000));
}

} // namespace

void serve(Connection& connection, const std::function<bool()>& until) {
    Session& session = connection.session();
    while (!connection.closed() && !until()) {
        const auto output = static_cast<short>(connection.sending() ? POLLOUT : 0);
        std::array<pollfd, 3> polled{pollfd{connection.input(), POLLIN, 0},
                                     pollfd{session.descriptor(), POLLIN, 0},
                                     pollfd{connection.output(), output, 0}};
        poll(polled.data(), polled.size(), timeout(session));
        if ((polled[2].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0)
            return; // nobody reads any more
        if (polled[0].revents != 0)
            connection.receive();
        else
            connection.attend();
    }
}

} // namespace service
