// One medium's process, from its start to its end, as the interface thread sees it.
//
//   starting -> ready -> closing -> over -> ended        starting, ready -> over when it fails
//
// Its end is told later, never inside a call: whoever asks or tells it something may go on, and
// hears of an end from the event loop. Between the two it is `over`: nothing is sent or read.
//
// It is asked by requests and told by notifications; answers and reports come back as calls and
// signals in the interface thread, a few at a time, so that a flood cannot hold the window. It is
// pinged: without an answer for `quiet` it is not responding, for `hung` it is ended. Nothing here
// waits; nothing the medium sends is believed before ipc has checked it.
#pragma once

#include "media/frame_memory.h"
#include "media/manifest.h"
#include "media/pipe_thread.h"

#include "ipc/messages.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <variant>

namespace media {

using ipc::Mode;

// In ms; tests make them shorter.
struct TimeLimits {
    int initialize = 10'000;
    int quiet = 2'000;
    int hung = 10'000;
    int shutdown = 2'000;
    int pingEvery = 1'000;
    int restartsPerMinute = 3; // by itself
    int restartsPerHour = 10;
};

template <class Result> using Outcome = std::variant<Result, ipc::Error>;

class MediumProcess : public QObject {
    Q_OBJECT

public:
    enum class State { starting, ready, closing, over, ended };

    MediumProcess(const Manifest& manifest, QString program, Mode mode, PipeThread& pipes,
                  TimeLimits limits = {}, QObject* parent = nullptr);
    ~MediumProcess() override; // ends it

    void start();
    void shutdown(); // asks it to end; it has TimeLimits::shutdown for that
    // Now; ended() follows. For good: another start would end the same.
    void end(const QString& why, bool forGood = false);

    [[nodiscard]] State state() const { return state_; }
    [[nodiscard]] Mode mode() const { return mode_; }
    [[nodiscard]] bool isResponding() const { return responding_; }
    [[nodiscard]] const ipc::Initialized& introduction() const { return introduction_; }
    [[nodiscard]] FrameMemory& frames() { return *frames_; }
    // True while it has much unread: leave out what can be left out, such as pointer moves.
    [[nodiscard]] bool isCongested() const;
    [[nodiscard]] const QString& log() const { return log_; }

    // Notifications are dropped once it is over; requests are then answered by an error, later.
    template <ipc::IsRequest R>
    void request(R call, std::function<void(Outcome<typename R::Result>)> done = {}) {
        using Result = typename R::Result;
        ask(ipc::ToMedium(std::move(call)), [done = std::move(done)](AnyOutcome outcome) {
            if (!done)
                return;
            if (auto* error = std::get_if<ipc::Error>(&outcome))
                done(std::move(*error));
            else
                done(std::get<Result>(std::get<ipc::AnyResult>(std::move(outcome))));
        });
    }
    void notify(const ipc::ToMedium& notification);
    void answer(const ipc::Id& id, const ipc::AnyResult& result);
    void refuse(const ipc::Id& id, const ipc::Error& error);

Q_SIGNALS:
    void ready();
    void respondingChanged();
    void told(const ipc::ToHost& report);
    void asked(const ipc::Id& id, const ipc::ToHost& request);
    void ended(const QString& reason, bool mayStartAgain); // by itself, that is

private:
    using AnyOutcome = std::variant<ipc::AnyResult, ipc::Error>;
    struct Waiting {
        std::function<void(AnyOutcome)> done;
    };

    Q_INVOKABLE void readMail();
    void read(Letter& letter);
    void readMessage(ipc::Decoded<ipc::ToHost>& message);
    void introduce();
    void ask(const ipc::ToMedium& call, std::function<void(AnyOutcome)> done);
    void send(const std::string& body);
    void ping();
    void tick();
    void tellEnd();
    [[nodiscard]] bool isOver() const { return state_ >= State::over; }
    [[nodiscard]] Launch launchRequest() const;

    Manifest manifest_;
    QString program_;
    Mode mode_;
    PipeThread& pipes_;
    TimeLimits limits_;
    std::shared_ptr<FrameMemory> frames_;
    std::shared_ptr<Mailbox> mailbox_;
    PipeThread::Link link_ = 0;
    State state_ = State::starting;
    bool responding_ = true;
    bool mayStartAgain_ = true;
    QString reason_; // why it is over
    ipc::Initialized introduction_;
    ipc::Integer lastId_ = 0;
    std::map<ipc::Integer, Waiting> waiting_;
    QTimer clock_;
    QElapsedTimer sinceStart_;
    QElapsedTimer sincePing_; // valid while a ping is unanswered
    QElapsedTimer sincePong_;
    QElapsedTimer sinceShutdown_;
    QString log_;
};

} // namespace media
