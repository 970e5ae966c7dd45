// One medium's process, from its start to its end, as the interface thread sees it.
//
//   starting -> ready -> closing -> over -> ended        starting, ready -> over when it fails
//
// Its end is told later, never inside a call: whoever asks or tells it something may go on, and
// hears of an end from the event loop. Between the two it is `over`: nothing is sent or read.
//
// It is asked by requests and told by notifications; answers and reports come back as calls and
// signals in the interface thread, a few at a time, so that a flood cannot hold the window
// (calls.h). It is pinged, and ended when it hangs (pulse.h). Nothing here waits; nothing the
// medium sends is believed before ipc has checked it.
#pragma once

#include "processes/calls.h"
#include "processes/frame_memory.h"
#include "processes/manifest.h"
#include "processes/pipe_thread.h"
#include "processes/pulse.h"

#include "ipc/messages.h"

#include <QObject>
#include <QTimer>
#include <functional>
#include <variant>

namespace media {

using ipc::Mode;

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
    [[nodiscard]] bool isResponding() const { return pulse_.isResponding(); }
    [[nodiscard]] const ipc::Initialized& introduction() const { return introduction_; }
    [[nodiscard]] FrameMemory& frames() { return *frames_; }
    // True while it has much unread: leave out what can be left out, such as pointer moves.
    [[nodiscard]] bool isCongested() const;
    [[nodiscard]] const QString& log() const { return log_; }

    // Notifications are dropped once it is over; requests are then answered by an error, later.
    template <ipc::IsRequest R>
    void request(R call, std::function<void(Outcome<typename R::Result>)> done = {}) {
        using Result = typename R::Result;
        ask(ipc::ToMedium(std::move(call)), [done = std::move(done)](Calls::Outcome outcome) {
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
    Q_INVOKABLE void readMail();
    void read(Letter& letter);
    void readMessage(ipc::Decoded<ipc::ToHost>& message);
    void introduce();
    void ask(const ipc::ToMedium& call, Calls::Done done);
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
    std::shared_ptr<FrameMemory> frames_;
    std::shared_ptr<Mailbox> mailbox_;
    PipeThread::Link link_ = 0;
    State state_ = State::starting;
    bool mayStartAgain_ = true;
    QString reason_; // why it is over
    ipc::Initialized introduction_;
    Calls calls_;
    Pulse pulse_;
    QTimer clock_; // of the pulse
    QString log_;
};

} // namespace media
