// The processes of one subdocument, one after another: start, end, restart, change of mode.
//
// There is one process, or none. Another mode takes another process: it starts beside the first,
// which leaves when the next is ready. One that ended by itself may be started again a few times
// (restarts.h). A process that leaves is asked to end, and nobody waits for it.
#pragma once

#include "media/restarts.h"
#include "processes/medium_process.h"

#include <QPointer>
#include <functional>
#include <memory>

namespace media {

// A medium that is installed, with all that its processes need.
struct MediumProgram {
    Manifest manifest;
    QString path;
    PipeThread& pipes;
    TimeLimits limits;
};

class Succession : public QObject {
    Q_OBJECT

public:
    explicit Succession(MediumProgram program, QObject* parent = nullptr);

    [[nodiscard]] const Manifest& manifest() const { return program_.manifest; }
    // The process that serves now, perhaps not yet ready; null: none.
    [[nodiscard]] MediumProcess* current() const { return process_.get(); }
    [[nodiscard]] bool isReady() const;
    [[nodiscard]] bool any() const { return process_ || next_; }
    [[nodiscard]] bool mayHaveWindows() const;
    // True as long as the process of now serves: an answer may come when the subdocument is gone,
    // or has another process.
    [[nodiscard]] std::function<bool()> sameAsNow() const;

    [[nodiscard]] Mode mode() const { return mode_; }
    void setMode(Mode mode) { mode_ = mode; } // of the next process
    void start();                             // if there is none
    void changeTo(Mode mode, std::function<void()> then);
    void end(); // all of them

    // After failed(): whether it is started again soon. Counts.
    [[nodiscard]] bool tryAgain();
    [[nodiscard]] QString tried() const { return restarts_.told(clock_.elapsed()); }
    void forgetFailures() { restarts_.forget(); } // after a click
    void doNotTryAgain() { restartTimer_.stop(); }

Q_SIGNALS:
    void begun();
    void ready();                         // current() is another one
    void left(media::MediumProcess* one); // it is current() if it served; it may have ended
    void told(const ipc::ToHost& report); // of current()
    void asked(media::MediumProcess* by, const ipc::Id& id, const ipc::ToHost& request);
    void respondingChanged(); // of current()
    void failed(const QString& reason, bool mayStartAgain);
    void changeFailed(const QString& reason); // the process of before goes on

private:
    [[nodiscard]] std::unique_ptr<MediumProcess> create();
    void begin();
    void takeOver();
    void discard(std::unique_ptr<MediumProcess>& process);
    void currentEnded(const QString& reason, bool mayStartAgain);
    void nextEnded(const QString& reason);

    MediumProgram program_;
    Mode mode_ = Mode::play;
    std::unique_ptr<MediumProcess> process_;
    std::unique_ptr<MediumProcess> next_; // of another mode, until it is ready
    std::vector<std::function<void()>> afterChange_;
    Restarts restarts_;
    QElapsedTimer clock_;
    QTimer restartTimer_;
};

} // namespace media
