#include "service/serve.h"

#include <array>
#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace service {
namespace {

class Loop {
public:
    Loop(Platform platform, int input, int output)
        : input_(input), output_(output), session_(std::move(platform), channel_) {}

    int run() {
        while (open_ && !session_.over() && channel_.fault().empty()) {
            wait();
            while (!session_.over())
                if (const auto call = channel_.next())
                    session_.receive(*call, Clock::now());
                else
                    break;
            session_.attend(Clock::now());
            flush();
        }
        if (channel_.fault().empty())
            return 0;
        std::fprintf(stderr, "asgard: the host sent %s\n", channel_.fault().c_str());
        return 1;
    }

private:
    // Until a byte comes or can go, the worker has news, or something is due.
    void wait() {
        const bool sending = !channel_.outgoing().empty();
        std::array<pollfd, 3> polled{pollfd{input_, POLLIN, 0},
                                     pollfd{session_.descriptor(), POLLIN, 0},
                                     pollfd{output_, static_cast<short>(sending ? POLLOUT : 0), 0}};
        poll(polled.data(), polled.size(), timeout());
        if (polled[0].revents != 0)
            receive();
        if ((polled[2].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0)
            open_ = false; // nobody reads any more
    }

    int timeout() const {
        const auto deadline = session_.deadline();
        if (!deadline)
            return -1;
        const auto rest =
            std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now()).count();
        return static_cast<int>(std::clamp<long>(rest, 0, 60'000));
    }

    void receive() {
        std::array<char, 1 << 16> bytes;
        const ssize_t count = read(input_, bytes.data(), bytes.size());
        if (count > 0)
            channel_.feed({bytes.data(), static_cast<std::size_t>(count)});
        else if (count == 0 || (errno != EAGAIN && errno != EINTR))
            open_ = false;
    }

    void flush() {
        while (!channel_.outgoing().empty()) {
            const std::string_view bytes = channel_.outgoing();
            const ssize_t count = write(output_, bytes.data(), bytes.size());
            if (count > 0)
                channel_.sent(static_cast<std::size_t>(count));
            else if (errno == EAGAIN)
                return;
            else if (errno != EINTR)
                open_ = false;
            if (!open_)
                return;
        }
    }

    int input_, output_;
    bool open_ = true;
    ipc::MediumChannel channel_;
    Session session_;
};

} // namespace

int serve(Platform platform, int input, int output) {
    for (const int descriptor : {input, output})
        fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
    return Loop(std::move(platform), input, output).run();
}

} // namespace service
