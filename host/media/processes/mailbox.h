// The messages of a medium that the interface thread has not read yet. Filled by the pipe thread,
// emptied by the interface thread a little at a time. It is bounded: a medium that sends faster
// than it is read is a flood, and push() says so. Newest first is never needed: frames are bounded
// by their acknowledgements.
#pragma once

#include "ipc/wire.h"

#include <QObject>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <string>

namespace media {

struct Letter {
    enum class Kind { started, message, log, ended };
    Kind kind = Kind::message;
    ipc::Decoded<ipc::ToHost> message = ipc::Ignored{};
    std::string text; // of log; of ended: why
    std::size_t bytes = 0;
    bool forGood = false; // ended so that another start would end the same
};

class Mailbox {
public:
    static constexpr std::size_t mostMessages = 1000;
    static constexpr std::size_t mostBytes = 8 << 20; // beyond the one message that is being read

    // `slot` is invoked in the thread of `receiver` when there is something to read.
    Mailbox(QObject* receiver, const char* slot) : receiver_(receiver), slot_(slot) {}

    [[nodiscard]] bool push(Letter letter); // false: it was too much, nothing was kept
    void pushAlways(Letter letter);         // what the pipe thread itself has to say
    [[nodiscard]] bool take(Letter& letter);
    void ring();   // asks for another turn of the receiver
    void detach(); // the receiver is gone

    // Which of our requests an answer belongs to; asked for by the pipe thread, which decodes.
    void await(ipc::Integer id, std::size_t call);
    [[nodiscard]] std::optional<std::size_t> awaited(ipc::Integer id);

private:
    std::mutex mutex_;
    QObject* receiver_;
    const char* slot_;
    std::deque<Letter> letters_;
    std::map<ipc::Integer, std::size_t> awaited_;
    std::size_t bytes_ = 0;
    bool rung_ = false;

    void append(Letter&& letter);
};

} // namespace media
