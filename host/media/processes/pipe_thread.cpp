#include "processes/pipe_thread.h"

#include "processes/allowance.h"
#include "processes/memory.h"

#include "ipc/framing.h"
#include "ipc/wire.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace media {

namespace {

using Clock = std::chrono::steady_clock;

// The bytes that a medium may leave unread: its longest text and a thousand messages besides.
constexpr std::size_t mostUnsentBytes = std::size_t{80} << 20;
constexpr std::size_t mostUnsentMessages = 1000;
constexpr std::size_t mostLog = 4096;
// A process that closed its output is about to end: its exit code is worth this wait.
constexpr std::chrono::milliseconds graceAfterEof{300};
// The longest time that a keeper has to kill all processes of a medium; others are served
// meanwhile.
constexpr std::chrono::milliseconds mostToEnd{5000};
// How often memory is measured: a process fills some 200 MiB in a second. Seldom while they hold
// little.
constexpr std::chrono::milliseconds measureOften{200}, measureSeldom{1000};

std::string inMiB(std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

struct Request {
    enum class Kind { start, send, closeInput, end } kind = Kind::send;
    PipeThread::Link link = 0;
    Launch launch;
    std::shared_ptr<Mailbox> mailbox;
    std::string text;
};

void closeOnce(int& descriptor) {
    if (descriptor >= 0)
        close(descriptor);
    descriptor = -1;
}

} // namespace

struct PipeThread::Shared {
    mutable std::mutex mutex;
    std::vector<Request> requests;
    struct Unsent {
        std::size_t bytes = 0, messages = 0;
    };
    std::map<Link, Unsent> unsent; // of the links that are open
    Link last = 0;
    int alive = 0;
    std::size_t mostMemory = usualMemory();
    std::function<std::size_t(pid_t)> measure = memoryOf;
    std::map<Link, std::size_t> held; // as measured last
    bool stop = false;
    int wake = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);

    ~Shared() { close(wake); }
    void ring() const {
        const std::uint64_t one = 1;
        static_cast<void>(!write(wake, &one, sizeof one));
    }
};

// One medium, as the pipe thread sees it.
struct Pipe {
    Launched ends;
    std::shared_ptr<Mailbox> mailbox;
    ipc::FrameDecoder decoder;
    Allowance allowance;
    std::deque<std::string> toSend;
    std::size_t sent = 0; // of the first of them
    bool closesInput = false;
    std::string log;
    std::optional<Clock::time_point> deadline;
    std::string closing; // why it is being ended by us; empty: it ended itself
    bool forGood = false;
    std::optional<Clock::time_point> endsUntil; // it was asked to end
    bool hasEnded = false;                      // it can be reaped
};

class PipeThread::Loop {
public:
    explicit Loop(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

    void run() {
        while (takeRequests()) {
            endAndFinish();
            wait();
            watchMemory();
        }
        for (auto& [link, pipe] : pipes_)
            pipe.closing = "the program ends";
        measureAt_ = Clock::now() + mostToEnd; // what they hold matters no more
        for (endAndFinish(); !pipes_.empty(); endAndFinish())
            wait();
    }

private:
    using Pipes = std::map<Link, Pipe>;

    bool takeRequests() {
        std::vector<Request> requests;
        {
            const std::lock_guard lock(shared_->mutex);
            requests.swap(shared_->requests);
            if (shared_->stop)
                return false;
        }
        for (Request& request : requests)
            obey(request);
        return true;
    }

    void endAndFinish() {
        for (auto next = pipes_.begin(); next != pipes_.end();) {
            const auto here = next++;
            Pipe& pipe = here->second;
            if (isOver(pipe) && !pipe.endsUntil) {
                askToEnd(pipe.ends);
                forget(here->first);
                pipe.endsUntil = Clock::now() + mostToEnd;
            }
            if (pipe.endsUntil && Clock::now() >= *pipe.endsUntil) {
                endWithKeeper(pipe.ends);
                pipe.hasEnded = true;
            }
            if (pipe.hasEnded)
                finish(here);
        }
    }

    void obey(Request& request) {
        if (request.kind == Request::Kind::start) {
            startPipe(request);
            return;
        }
        const auto found = pipes_.find(request.link);
        if (found == pipes_.end() || isOver(found->second))
            return;
        if (request.kind == Request::Kind::end) {
            found->second.closing = request.text;
            return;
        }
        if (request.kind == Request::Kind::closeInput)
            found->second.closesInput = true;
        else
            found->second.toSend.push_back(std::move(request.text));
        writeTo(found->first, found->second);
    }

    void startPipe(Request& request) {
        Pipe pipe;
        pipe.mailbox = request.mailbox;
        pipe.ends = launch(request.launch);
        if (pipe.ends.process < 0) {
            forget(request.link);
            pipe.mailbox->pushAlways(
                {Letter::Kind::ended, ipc::Ignored{}, pipe.ends.error, 0, true});
            return;
        }
        {
            const std::lock_guard lock(shared_->mutex);
            ++shared_->alive;
        }
        pipe.mailbox->pushAlways({Letter::Kind::started, ipc::Ignored{}, {}, 0, false});
        pipes_.emplace(request.link, std::move(pipe));
    }

    void wait() {
        std::vector<pollfd> polled{{shared_->wake, POLLIN, 0}};
        std::vector<std::pair<Link, int Launched::*>> whose{{0, nullptr}};
        Clock::time_point until = measureAt_;
        for (auto& [link, pipe] : pipes_) {
            const auto add = [&, id = link, &ends = pipe.ends](int Launched::*end, short events) {
                if (ends.*end >= 0) {
                    polled.push_back({ends.*end, events, 0});
                    whose.emplace_back(id, end);
                }
            };
            if (pipe.endsUntil) { // whatever it says
                add(&Launched::processDescriptor, POLLIN);
                until = std::min(until, *pipe.endsUntil);
                continue;
            }
            add(&Launched::fromMedium, POLLIN);
            add(&Launched::log, POLLIN);
            add(&Launched::processDescriptor, POLLIN);
            if (!pipe.toSend.empty())
                add(&Launched::toMedium, POLLOUT);
            if (pipe.deadline)
                until = std::min(until, *pipe.deadline);
        }
        const int timeout = pipes_.empty() ? -1 : msUntil(until);
        if (poll(polled.data(), polled.size(), timeout) <= 0)
            return;
        if (polled[0].revents) {
            std::uint64_t count = 0;
            static_cast<void>(!read(shared_->wake, &count, sizeof count));
        }
        for (std::size_t i = 1; i < polled.size(); ++i)
            if (polled[i].revents)
                serve(whose[i].first, whose[i].second);
    }

    void serve(Link link, int Launched::*end) {
        Pipe& pipe = pipes_.at(link);
        if (end == &Launched::fromMedium)
            readFrom(pipe);
        else if (end == &Launched::log)
            readLog(pipe);
        else if (end == &Launched::toMedium)
            writeTo(link, pipe);
        else {
            if (!pipe.endsUntil) { // it ended by itself: what it still said comes first
                readAll(pipe);
                readLog(pipe);
            }
            pipe.hasEnded = true;
        }
    }

    void readAll(Pipe& pipe) {
        for (int turn = 0; turn < 32 && pipe.ends.fromMedium >= 0; ++turn)
            readFrom(pipe);
    }

    void readFrom(Pipe& pipe) {
        std::array<char, 65536> buffer;
        const ssize_t count = read(pipe.ends.fromMedium, buffer.data(), buffer.size());
        if (count > 0) {
            std::deque<std::string> bodies;
            pipe.decoder.feed({buffer.data(), static_cast<std::size_t>(count)}, bodies);
            for (std::string& body : bodies)
                if (pipe.closing.empty())
                    deliver(pipe, body);
            if (pipe.closing.empty() && !pipe.decoder.fault().empty())
                pipe.closing = "broke the protocol: " + pipe.decoder.fault();
        } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
            closeOnce(pipe.ends.fromMedium);
            if (!pipe.deadline)
                pipe.deadline = Clock::now() + graceAfterEof;
        }
    }

    void deliver(Pipe& pipe, std::string& body) {
        Letter letter;
        letter.bytes = body.size();
        letter.message =
            ipc::decodeForHost(body, [&](ipc::Integer id) { return pipe.mailbox->awaited(id); });
        if (const auto* violation = std::get_if<ipc::Violation>(&letter.message))
            pipe.closing = "broke the protocol: " + violation->sentence;
        else if (!pipe.allowance.spend(letter.message, letter.bytes, Clock::now()))
            pipe.closing = "sent more than it may in a second (a flood)";
        else if (!pipe.mailbox->push(std::move(letter)))
            pipe.closing = "sent more than can be read (a flood)";
    }

    void readLog(Pipe& pipe) {
        std::array<char, 4096> buffer;
        const ssize_t count = read(pipe.ends.log, buffer.data(), buffer.size());
        if (count > 0) {
            pipe.log.append(buffer.data(), static_cast<std::size_t>(count));
            if (pipe.log.size() > mostLog)
                pipe.log.erase(0, pipe.log.size() - mostLog);
        } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
            closeOnce(pipe.ends.log);
        }
    }

    void writeTo(Link link, Pipe& pipe) {
        std::size_t bytes = 0, messages = 0;
        while (!pipe.toSend.empty() && pipe.ends.toMedium >= 0) {
            const std::string& first = pipe.toSend.front();
            const ssize_t count =
                write(pipe.ends.toMedium, first.data() + pipe.sent, first.size() - pipe.sent);
            if (count < 0 && errno != EINTR) {
                if (errno != EAGAIN) // EPIPE: it ends, and says so by its other descriptors
                    closeOnce(pipe.ends.toMedium);
                break;
            }
            pipe.sent += count > 0 ? static_cast<std::size_t>(count) : 0;
            if (pipe.sent == first.size()) {
                bytes += first.size();
                ++messages;
                pipe.toSend.pop_front();
                pipe.sent = 0;
            }
        }
        if (pipe.toSend.empty() && pipe.closesInput)
            closeOnce(pipe.ends.toMedium);
        const std::lock_guard lock(shared_->mutex);
        auto& unsent = shared_->unsent[link];
        unsent.bytes -= bytes;
        unsent.messages -= messages;
    }

    static int msUntil(Clock::time_point time) {
        const auto rest = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now());
        return static_cast<int>(std::max(rest, std::chrono::milliseconds(0)).count());
    }

    // Ends the largest while all together hold too much; it is not started again by itself.
    void watchMemory() {
        if (pipes_.empty() || msUntil(measureAt_) > 0)
            return;
        std::vector<Pipe*> measured;
        std::vector<std::size_t> held;
        std::map<Link, std::size_t> known;
        std::size_t sum = 0;
        const auto measure = [&] {
            const std::lock_guard lock(shared_->mutex);
            return shared_->measure;
        }();
        for (auto& [link, pipe] : pipes_) {
            measured.push_back(&pipe);
            held.push_back(measure(pipe.ends.process));
            known[link] = held.back();
            sum += held.back();
        }
        const std::size_t most = [&] {
            const std::lock_guard lock(shared_->mutex);
            shared_->held = std::move(known);
            return shared_->mostMemory;
        }();
        while (const auto largest = tooLarge(held, most)) {
            Pipe& pipe = *measured[*largest];
            const std::size_t its = std::exchange(held[*largest], 0);
            if (isOver(pipe)) // it is about to give back what it holds
                continue;
            pipe.closing = "was ended, since all media together held more than " + inMiB(most) +
                           " of memory, and it held the most, " + inMiB(its);
            pipe.forGood = true;
        }
        measureAt_ = Clock::now() + (sum > most / 4 ? measureOften : measureSeldom);
    }

    static bool isOver(const Pipe& pipe) {
        return pipe.hasEnded || !pipe.closing.empty() ||
               (pipe.deadline && Clock::now() >= *pipe.deadline);
    }

    void forget(Link link) {
        const std::lock_guard lock(shared_->mutex);
        shared_->unsent.erase(link);
    }

    void finish(Pipes::iterator at) {
        Pipe& pipe = at->second;
        const int status = reap(pipe.ends);
        readLog(pipe);
        for (int Launched::*end : {&Launched::toMedium, &Launched::fromMedium, &Launched::log,
                                   &Launched::processDescriptor})
            closeOnce(pipe.ends.*end);
        {
            const std::lock_guard lock(shared_->mutex);
            --shared_->alive;
            shared_->held.erase(at->first);
        }
        if (!pipe.log.empty())
            pipe.mailbox->pushAlways({Letter::Kind::log, ipc::Ignored{}, pipe.log, 0, false});
        pipe.mailbox->pushAlways({Letter::Kind::ended, ipc::Ignored{},
                                  pipe.closing.empty() ? describeEnd(status) : pipe.closing, 0,
                                  pipe.forGood || couldNotStart(status)});
        pipes_.erase(at);
    }

    std::shared_ptr<Shared> shared_;
    Pipes pipes_;
    Clock::time_point measureAt_{};
};

PipeThread::PipeThread() : shared_(std::make_shared<Shared>()) {
    std::signal(SIGPIPE, SIG_IGN); // a medium that died is an error of write(), not our end
    thread_ = std::thread([shared = shared_] { Loop(shared).run(); });
}

PipeThread::~PipeThread() {
    departing_.reset();
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stop = true;
    }
    shared_->ring();
    thread_.join();
}

PipeThread::Link PipeThread::start(Launch launch, std::shared_ptr<Mailbox> mailbox) {
    const std::lock_guard lock(shared_->mutex);
    const Link link = ++shared_->last;
    shared_->unsent[link] = {};
    shared_->requests.push_back(
        {Request::Kind::start, link, std::move(launch), std::move(mailbox), {}});
    shared_->ring();
    return link;
}

bool PipeThread::send(Link link, std::string framed) {
    const std::lock_guard lock(shared_->mutex);
    const auto found = shared_->unsent.find(link);
    if (found == shared_->unsent.end())
        return true; // its mailbox says that it has ended
    Shared::Unsent& unsent = found->second;
    if (unsent.messages >= mostUnsentMessages || unsent.bytes + framed.size() > mostUnsentBytes)
        return false;
    unsent.bytes += framed.size();
    ++unsent.messages;
    shared_->requests.push_back({Request::Kind::send, link, {}, {}, std::move(framed)});
    shared_->ring();
    return true;
}

std::size_t PipeThread::unsent(Link link) const {
    const std::lock_guard lock(shared_->mutex);
    const auto found = shared_->unsent.find(link);
    return found == shared_->unsent.end() ? 0 : found->second.messages;
}

void PipeThread::closeInput(Link link) {
    const std::lock_guard lock(shared_->mutex);
    shared_->requests.push_back({Request::Kind::closeInput, link, {}, {}, {}});
    shared_->ring();
}

void PipeThread::end(Link link, std::string why) {
    const std::lock_guard lock(shared_->mutex);
    shared_->requests.push_back({Request::Kind::end, link, {}, {}, std::move(why)});
    shared_->ring();
}

void PipeThread::setMostMemory(std::size_t bytes) {
    const std::lock_guard lock(shared_->mutex);
    shared_->mostMemory = bytes;
}

std::size_t PipeThread::mostMemory() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->mostMemory;
}

bool PipeThread::hasRoom() const {
    const std::lock_guard lock(shared_->mutex);
    std::vector<std::size_t> held;
    for (const auto& [link, bytes] : shared_->held)
        held.push_back(bytes);
    const auto unmeasured = std::ranges::count_if(
        shared_->unsent, [&](const auto& open) { return !shared_->held.contains(open.first); });
    return media::hasRoom(held, static_cast<std::size_t>(unmeasured), shared_->mostMemory);
}

void PipeThread::setMeasure(std::function<std::size_t(pid_t)> measure) {
    const std::lock_guard lock(shared_->mutex);
    shared_->measure = std::move(measure);
}

int PipeThread::alive() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->alive;
}

} // namespace media
