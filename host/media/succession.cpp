#include "media/succession.h"

namespace media {

namespace {

constexpr int restartDelayMs = 100;

} // namespace

Succession::Succession(MediumProgram program, QObject* parent)
    : QObject(parent), program_(std::move(program)),
      restarts_(program_.limits.restartsPerMinute, program_.limits.restartsPerHour) {
    clock_.start();
    restartTimer_.setSingleShot(true);
    connect(&restartTimer_, &QTimer::timeout, this, &Succession::begin);
}

bool Succession::isReady() const {
    return process_ && process_->state() == MediumProcess::State::ready;
}

bool Succession::mayHaveWindows() const {
    return next_ || (process_ && process_->mode() == Mode::edit);
}

std::function<bool()> Succession::sameAsNow() const {
    return [self = QPointer<const Succession>(this),
            process = QPointer<const MediumProcess>(process_.get())] {
        return self && process && process == self->process_.get();
    };
}

std::unique_ptr<MediumProcess> Succession::create() {
    auto process = std::make_unique<MediumProcess>(program_.manifest, program_.path, mode_,
                                                   program_.pipes, program_.limits);
    MediumProcess* made = process.get();
    connect(made, &MediumProcess::told, this, [this, made](const ipc::ToHost& report) {
        if (made == process_.get())
            Q_EMIT told(report);
    });
    connect(made, &MediumProcess::asked, this,
            [this, made](const ipc::Id& id, const ipc::ToHost& request) {
                Q_EMIT asked(made, id, request);
            });
    connect(made, &MediumProcess::respondingChanged, this, [this, made] {
        if (made == process_.get())
            Q_EMIT respondingChanged();
    });
    return process;
}

void Succession::start() {
    restartTimer_.stop();
    if (!process_)
        begin();
}

void Succession::begin() {
    process_ = create();
    MediumProcess* made = process_.get();
    connect(made, &MediumProcess::ready, this, &Succession::ready);
    connect(made, &MediumProcess::ended, this, &Succession::currentEnded);
    Q_EMIT begun();
    made->start();
}

void Succession::changeTo(Mode mode, std::function<void()> then) {
    afterChange_.push_back(std::move(then));
    if (next_)
        return;
    mode_ = mode;
    next_ = create();
    connect(next_.get(), &MediumProcess::ended, this, &Succession::nextEnded);
    connect(next_.get(), &MediumProcess::ready, this, &Succession::takeOver);
    next_->start();
}

void Succession::takeOver() {
    disconnect(next_.get(), &MediumProcess::ended, this, nullptr);
    connect(next_.get(), &MediumProcess::ended, this, &Succession::currentEnded);
    discard(process_);
    process_ = std::move(next_);
    Q_EMIT ready();
    for (const auto& then : std::exchange(afterChange_, {}))
        then();
}

void Succession::discard(std::unique_ptr<MediumProcess>& process) {
    if (!process)
        return;
    process->disconnect(this);
    Q_EMIT left(process.get());
    // It may be in a call of its own, and may take its time to end.
    MediumProcess* leaving = process.release();
    if (leaving->state() == MediumProcess::State::ended) {
        leaving->deleteLater();
        return;
    }
    leaving->setParent(&program_.pipes.departing());
    connect(leaving, &MediumProcess::ended, leaving, &QObject::deleteLater);
    leaving->shutdown();
}

void Succession::end() {
    restartTimer_.stop();
    discard(next_);
    discard(process_);
    afterChange_.clear();
}

bool Succession::tryAgain() {
    const bool again = restarts_.mayTry(clock_.elapsed());
    if (again)
        restartTimer_.start(restartDelayMs);
    return again;
}

void Succession::currentEnded(const QString& reason, bool mayStartAgain) {
    discard(process_);
    Q_EMIT failed(reason, mayStartAgain);
}

void Succession::nextEnded(const QString& reason) {
    discard(next_);
    afterChange_.clear();
    mode_ = Mode::play;
    Q_EMIT changeFailed(reason);
}

} // namespace media
