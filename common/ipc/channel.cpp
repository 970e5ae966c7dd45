#include "ipc/channel.h"

namespace ipc {
namespace {

template <class Received> auto decodeFor(std::string_view body, const AwaitedCall& awaited) {
    if constexpr (std::is_same_v<Received, ToHost>)
        return decodeForHost(body, awaited);
    else
        return decodeForMedium(body, awaited);
}

} // namespace

template <class R, class S>
Integer Channel<R, S>::start(S call, std::function<void(AnyOutcome)> done) {
    const Integer id = ++lastId_;
    if (!fault_.empty()) {
        done(Error{ErrorCode::closed, fault_});
        return id;
    }
    const std::size_t index = call.index();
    const std::string body = encodeRequest(id, call);
    awaited_.emplace(id, Awaited{index, std::move(done)});
    put(body);
    return id;
}

template <class R, class S> void Channel<R, S>::put(const std::string& body) {
    if (!fault_.empty())
        return;
    if (outgoing().size() > floodBytes || outEnds_.size() > floodMessages)
        return fail("the other side does not read its messages");
    if (body.size() > longestBody)
        return fail("a message to send is longer than 64 MiB");
    if (outFrom_ > 0 && outFrom_ >= out_.size() / 2) {
        out_.erase(0, outFrom_);
        for (std::size_t& end : outEnds_)
            end -= outFrom_;
        outFrom_ = 0;
    }
    out_ += framed(body);
    outEnds_.push_back(out_.size());
}

template <class R, class S> void Channel<R, S>::feed(std::string_view bytes) {
    if (!fault_.empty())
        return;
    const std::size_t before = bodies_.size();
    decoder_.feed(bytes, bodies_);
    for (std::size_t i = before; i < bodies_.size(); ++i)
        unreadBytes_ += bodies_[i].size();
    if (!decoder_.fault().empty())
        fail(decoder_.fault());
    checkFlood();
}

template <class R, class S> void Channel<R, S>::checkFlood() {
    // One long message is not a flood: it may be 64 MiB.
    if (bodies_.size() > floodMessages || (bodies_.size() > 1 && unreadBytes_ > floodBytes))
        fail("a flood: more than 8 MiB or 1000 messages unread");
}

template <class R, class S> std::string_view Channel<R, S>::outgoing() const {
    return std::string_view(out_).substr(outFrom_);
}

template <class R, class S> void Channel<R, S>::sent(std::size_t bytes) {
    outFrom_ += bytes;
    while (!outEnds_.empty() && outEnds_.front() <= outFrom_)
        outEnds_.pop_front();
    if (outFrom_ == out_.size()) {
        out_.clear();
        outFrom_ = 0;
        if (out_.capacity() > floodBytes)
            out_.shrink_to_fit();
    }
}

template <class R, class S> auto Channel<R, S>::next() -> std::optional<Call> {
    const AwaitedCall awaited = [this](Integer id) -> std::optional<std::size_t> {
        const auto found = awaited_.find(id);
        return found == awaited_.end() ? std::nullopt : std::optional(found->second.call);
    };
    while (!bodies_.empty() && fault_.empty()) {
        const std::string body = std::move(bodies_.front());
        bodies_.pop_front();
        unreadBytes_ -= body.size();
        Decoded<R> decoded = decodeFor<R>(body, awaited);
        if (auto* asked = std::get_if<Asked<R>>(&decoded))
            return std::move(*asked);
        if (auto* told = std::get_if<Told<R>>(&decoded))
            return std::move(*told);
        if (auto* answered = std::get_if<Answered>(&decoded))
            deliver(std::move(*answered));
        else if (auto* unanswerable = std::get_if<Unanswerable>(&decoded))
            refuse(unanswerable->id, unanswerable->error);
        else if (auto* violation = std::get_if<Violation>(&decoded))
            fail(violation->sentence);
    }
    return std::nullopt;
}

template <class R, class S> void Channel<R, S>::deliver(Answered answered) {
    const auto found = awaited_.find(answered.id);
    const auto done = std::move(found->second.done);
    awaited_.erase(found); // first: done() may ask again
    done(std::move(answered.outcome));
}

template <class R, class S> void Channel<R, S>::close(const std::string& sentence) {
    if (fault_.empty())
        fail(sentence);
    while (!awaited_.empty()) {
        const auto done = std::move(awaited_.begin()->second.done);
        awaited_.erase(awaited_.begin());
        done(Error{ErrorCode::closed, sentence});
    }
}

template <class R, class S> void Channel<R, S>::fail(std::string sentence) {
    if (!fault_.empty())
        return;
    fault_ = std::move(sentence);
    bodies_.clear();
    unreadBytes_ = 0;
}

template class Channel<ToHost, ToMedium>;
template class Channel<ToMedium, ToHost>;

} // namespace ipc
