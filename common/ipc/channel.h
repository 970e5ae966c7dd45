// One end of the pipe between a host and a medium, for any event loop.
//
// The owner moves bytes: what it read goes into feed(), what outgoing() shows is written and then
// sent(). next() yields calls of the other side one by one; answers to our own requests go to the
// function given with the request, in the order in which they arrived among the calls. Bytes are
// decoded when they are taken, not when they come, so feed() is cheap and what is unread is
// counted.
//
// Everything the other side sends is hostile until checked. A fault() ends the channel for good;
// its owner closes the pipe and ends the process. Not thread-safe.
//
//     channel.request(ipc::SubdocumentLoad{text, 1}, [](ipc::Outcome<ipc::Done> outcome) { ... });
//     channel.feed(bytes);
//     while (auto call = channel.next()) std::visit(overloaded, *call);
#pragma once

#include "ipc/framing.h"
#include "ipc/wire.h"

#include <deque>
#include <map>

namespace ipc {

inline constexpr std::size_t floodBytes = std::size_t{8} << 20;
inline constexpr std::size_t floodMessages = 1000;

// The result of a request.
template <class Result> using Outcome = std::variant<Result, Error>;

template <class Received, class Sent> class Channel {
public:
    using Call = std::variant<Asked<Received>, Told<Received>>;

    // --- what we say. Nothing is said after a fault: requests then fail at once.
    template <IsRequest R>
    Integer request(R call, std::function<void(Outcome<typename R::Result>)> done) {
        using Result = typename R::Result;
        return start(Sent(std::move(call)), [done = std::move(done)](auto outcome) {
            if (auto* error = std::get_if<Error>(&outcome))
                done(std::move(*error));
            else
                done(std::get<Result>(std::get<AnyResult>(std::move(outcome))));
        });
    }
    template <class N>
    requires(!IsRequest<N>) void notify(N call) { put(encodeNotification(Sent(std::move(call)))); }
    void answer(const Id& id, const AnyResult& result) { put(encodeAnswer(id, result)); }
    void refuse(const Id& id, const Error& error) { put(encodeError(id, error)); }

    // --- bytes
    void feed(std::string_view bytes);
    // Valid until the next call of anything but outgoing().
    [[nodiscard]] std::string_view outgoing() const;
    void sent(std::size_t bytes);
    // True while the other side lags behind: leave out what can be left out, such as frames.
    [[nodiscard]] bool congested() const { return outgoing().size() > floodBytes / 8; }

    // --- what they say. Requests that cannot be served are answered here.
    [[nodiscard]] std::optional<Call> next();
    [[nodiscard]] bool unread() const { return !bodies_.empty(); }

    // The sentence that says what was wrong with what came; empty while all is well.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    // Ends the channel: requests without answer get Error{closed, sentence}, in order.
    void close(const std::string& sentence);

    [[nodiscard]] std::size_t unanswered() const { return awaited_.size(); }

private:
    using AnyOutcome = std::variant<AnyResult, Error>;
    struct Awaited {
        std::size_t call; // place in Sent
        std::function<void(AnyOutcome)> done;
    };

    Integer start(Sent call, std::function<void(AnyOutcome)> done);
    void put(const std::string& body);
    void deliver(Answered answered);
    void fail(std::string sentence);
    void checkFlood();

    FrameDecoder decoder_;
    std::deque<std::string> bodies_; // received, not yet taken
    std::size_t unreadBytes_ = 0;
    std::string out_;
    std::size_t outFrom_ = 0;         // bytes of out_ that are written already
    std::deque<std::size_t> outEnds_; // where each unwritten message ends in out_
    std::map<Integer, Awaited> awaited_;
    Integer lastId_ = 0;
    std::string fault_;
};

using HostChannel = Channel<ToHost, ToMedium>;   // the host's end
using MediumChannel = Channel<ToMedium, ToHost>; // the medium's end

extern template class Channel<ToHost, ToMedium>;
extern template class Channel<ToMedium, ToHost>;

} // namespace ipc
