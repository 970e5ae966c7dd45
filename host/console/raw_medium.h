// A medium seen without any help: messages as they are sent, in the order in which they come.
#pragma once

#include "ipc/wire.h"
#include "processes/frame_memory.h"
#include "processes/pipe_thread.h"

#include <QStringList>
#include <functional>
#include <stdexcept>

namespace console {

// A fault that a check found, as a sentence.
struct Wrong : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class RawMedium {
public:
    RawMedium(media::PipeThread& pipes, const QString& program, const QStringList& arguments);
    ~RawMedium();

    // Sends a request and waits for its answer; reports that come meanwhile are kept in reports().
    template <ipc::IsRequest R>
    std::variant<typename R::Result, ipc::Error> ask(const R& call, int ms = answerMs) {
        const ipc::Integer id = send(ipc::ToMedium(call));
        auto outcome = waitForAnswer(id, ms, call.method);
        if (auto* error = std::get_if<ipc::Error>(&outcome))
            return *error;
        return std::get<typename R::Result>(std::get<ipc::AnyResult>(outcome));
    }
    template <ipc::IsRequest R> typename R::Result mustAnswer(const R& call, int ms = answerMs) {
        auto outcome = ask(call, ms);
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            throw Wrong(std::string(call.method) + " was refused: " + error->message);
        return std::get<typename R::Result>(outcome);
    }
    ipc::Integer send(const ipc::ToMedium& request);
    void tell(const ipc::ToMedium& notification);
    // A body of any content, expected to be answered as if it were the request `like`.
    std::variant<ipc::AnyResult, ipc::Error> askRaw(const std::string& body, ipc::Integer id,
                                                    const ipc::ToMedium& like);
    void sendBytes(const std::string& bytes);
    void closeInput();

    ipc::Initialized introduce(ipc::Integer oldest = 1, ipc::Integer newest = 1,
                               bool withFrames = true);

    // Waits until a report that `wanted` accepts has come, and takes it out of the others.
    [[nodiscard]] bool waitFor(const std::function<bool(const ipc::ToHost&)>& wanted, int ms);
    void listen(int ms); // keeps what comes in that time
    [[nodiscard]] std::vector<ipc::ToHost>& reports() { return reports_; }
    // How it ended; empty while it runs.
    [[nodiscard]] const std::string& ending() const { return ending_; }
    [[nodiscard]] std::string waitForEnd(int ms); // empty: it did not
    [[nodiscard]] media::FrameMemory& frames() { return frames_; }
    ipc::Integer nextId() { return ++lastId_; }

    static constexpr int answerMs = 10'000;

private:
    std::variant<ipc::AnyResult, ipc::Error> waitForAnswer(ipc::Integer id, int ms,
                                                           const std::string& what);
    bool readOne();

    media::PipeThread& pipes_;
    media::FrameMemory frames_;
    std::shared_ptr<media::Mailbox> mailbox_;
    media::PipeThread::Link link_;
    ipc::Integer lastId_ = 0;
    std::vector<ipc::ToHost> reports_;
    std::map<ipc::Integer, std::variant<ipc::AnyResult, ipc::Error>> answers_;
    std::string ending_;
};

} // namespace console
