#include "media/medium_process.h"

#include "media/environment.h"

#include "ipc/framing.h"
#include "ipc/wire.h"

#include <QLocale>
#include <QPointer>

namespace media {

namespace {

// What one turn of the event loop may spend on one medium's mail.
constexpr int mostLettersPerTurn = 100;
constexpr int mostMsPerTurn = 8;

} // namespace

MediumProcess::MediumProcess(const Manifest& manifest, QString program, Mode mode,
                             PipeThread& pipes, TimeLimits limits, QObject* parent)
    : QObject(parent), manifest_(manifest), program_(std::move(program)), mode_(mode),
      pipes_(pipes), limits_(limits), frames_(std::make_shared<FrameMemory>()),
      mailbox_(std::make_shared<Mailbox>(this, "readMail")) {
    connect(&clock_, &QTimer::timeout, this, &MediumProcess::tick);
}

MediumProcess::~MediumProcess() {
    mailbox_->detach();
    if (link_ && !isOver())
        pipes_.end(link_, "is no longer needed");
}

Launch MediumProcess::launchRequest() const {
    Launch launch;
    launch.program = program_.toStdString();
    for (int i = 1; i < manifest_.command.size(); ++i)
        launch.arguments.push_back(manifest_.command[i].toStdString());
    launch.environment = environmentFor(mode_);
    launch.frames = frames_->descriptor();
    return launch;
}

void MediumProcess::start() {
    sinceStart_.start();
    if (program_.isEmpty()) {
        end(QStringLiteral("could not be started: there is no program \"%1\"")
                .arg(manifest_.command.first()),
            true);
        return;
    }
    link_ = pipes_.start(launchRequest(), mailbox_);
    clock_.start(std::min({limits_.pingEvery, limits_.quiet, limits_.shutdown}) / 2 + 1);
    introduce();
}

void MediumProcess::introduce() {
    ipc::Initialize call;
    call.oldest = manifest_.protocolMin;
    call.newest = std::min(manifest_.protocolMax, 1);
    call.documentClass = manifest_.documentClass.toStdString();
    call.mode = mode_;
    if (frames_->isValid())
        call.frames = ipc::SharedMemory{framesDescriptor, FrameMemory::capacity};
    call.locale = QLocale().name().toStdString();
    request(call, [this](Outcome<ipc::Initialized> outcome) {
        if (state_ != State::starting)
            return;
        if (const auto* error = std::get_if<ipc::Error>(&outcome)) {
            end(QStringLiteral("refused to begin: ") + QString::fromStdString(error->message),
                true);
            return;
        }
        introduction_ = std::get<ipc::Initialized>(std::move(outcome));
        state_ = State::ready;
        sincePong_.start();
        Q_EMIT ready();
    });
}

void MediumProcess::ask(const ipc::ToMedium& call, std::function<void(AnyOutcome)> done) {
    const ipc::Integer id = ++lastId_;
    waiting_[id] = {std::move(done)};
    if (isOver()) {
        QMetaObject::invokeMethod(this, &MediumProcess::tellEnd, Qt::QueuedConnection);
        return;
    }
    mailbox_->await(id, call.index());
    send(ipc::encodeRequest(id, call));
}

void MediumProcess::notify(const ipc::ToMedium& notification) {
    if (!isOver())
        send(ipc::encodeNotification(notification));
}

void MediumProcess::answer(const ipc::Id& id, const ipc::AnyResult& result) {
    send(ipc::encodeAnswer(id, result));
}

void MediumProcess::refuse(const ipc::Id& id, const ipc::Error& error) {
    send(ipc::encodeError(id, error));
}

void MediumProcess::send(const std::string& body) {
    if (!link_ || isOver())
        return;
    if (body.size() > ipc::longestBody)
        end(QStringLiteral("would have to read a message of more than 64 MiB"));
    else if (!pipes_.send(link_, ipc::framed(body)))
        end(QStringLiteral("does not read its messages"));
}

bool MediumProcess::isCongested() const {
    constexpr std::size_t many = 16;
    return link_ && pipes_.unsent(link_) > many;
}

void MediumProcess::readMail() {
    QElapsedTimer turn;
    turn.start();
    Letter letter;
    for (int count = 0; mailbox_->take(letter); ++count) {
        read(letter);
        if (count >= mostLettersPerTurn || turn.elapsed() >= mostMsPerTurn) {
            mailbox_->ring();
            return;
        }
    }
}

void MediumProcess::read(Letter& letter) {
    switch (letter.kind) {
    case Letter::Kind::started:
        break;
    case Letter::Kind::log:
        log_ = QString::fromUtf8(letter.text.c_str());
        break;
    case Letter::Kind::ended:
        end(QString::fromStdString(letter.text), letter.forGood);
        break;
    case Letter::Kind::message:
        if (!isOver())
            readMessage(letter.message);
        break;
    }
}

void MediumProcess::readMessage(ipc::Decoded<ipc::ToHost>& message) {
    if (const auto* report = std::get_if<ipc::Told<ipc::ToHost>>(&message)) {
        Q_EMIT told(report->call);
    } else if (const auto* request = std::get_if<ipc::Asked<ipc::ToHost>>(&message)) {
        Q_EMIT asked(request->id, request->call);
    } else if (const auto* wrong = std::get_if<ipc::Unanswerable>(&message)) {
        refuse(wrong->id, wrong->error);
    } else if (auto* answered = std::get_if<ipc::Answered>(&message)) {
        const auto found = waiting_.find(answered->id);
        if (found == waiting_.end())
            return;
        const auto done = std::move(found->second.done);
        waiting_.erase(found);
        done(std::move(answered->outcome));
    }
}

void MediumProcess::ping() {
    sincePing_.start();
    request(ipc::Ping{}, [this](const Outcome<ipc::Done>& outcome) {
        if (!std::holds_alternative<ipc::Done>(outcome))
            return;
        sincePing_.invalidate();
        sincePong_.start();
        if (!responding_) {
            responding_ = true;
            Q_EMIT respondingChanged();
        }
    });
}

// LIMIT: a process that is being debugged by its author is ended like one that hangs.
void MediumProcess::tick() {
    if (state_ == State::starting && sinceStart_.hasExpired(limits_.initialize)) {
        end(QStringLiteral("did not answer within %1 s of its start")
                .arg(limits_.initialize / 1e3));
    } else if (state_ == State::closing && sinceShutdown_.hasExpired(limits_.shutdown)) {
        end(QStringLiteral("did not end when asked to"));
    } else if (state_ == State::ready && !sincePing_.isValid()) {
        if (sincePong_.hasExpired(limits_.pingEvery))
            ping();
    } else if (state_ == State::ready && sincePing_.hasExpired(limits_.hung)) {
        end(QStringLiteral("did not respond for %1 s").arg(limits_.hung / 1e3));
    } else if (state_ == State::ready && responding_ && sincePing_.hasExpired(limits_.quiet)) {
        responding_ = false;
        Q_EMIT respondingChanged();
    }
}

void MediumProcess::shutdown() {
    if (isOver() || state_ == State::closing)
        return;
    mayStartAgain_ = false;
    if (state_ == State::starting) {
        end(QStringLiteral("is no longer needed"));
        return;
    }
    state_ = State::closing;
    sinceShutdown_.start();
    request(ipc::Shutdown{}, [this](const Outcome<ipc::Done>&) { notify(ipc::Exit{}); });
}

void MediumProcess::end(const QString& why, bool forGood) {
    if (isOver())
        return;
    mayStartAgain_ = mayStartAgain_ && !forGood;
    state_ = State::over;
    reason_ = why;
    clock_.stop();
    if (link_)
        pipes_.end(link_, why.toStdString());
    QMetaObject::invokeMethod(this, &MediumProcess::tellEnd, Qt::QueuedConnection);
}

void MediumProcess::tellEnd() {
    const QPointer<MediumProcess> self = this;
    const bool first = std::exchange(state_, State::ended) != State::ended;
    const ipc::Error closed(ipc::ErrorCode::closed, "the medium " + reason_.toStdString());
    for (auto& [id, request] : std::exchange(waiting_, {}))
        request.done(closed);
    if (first && self)
        Q_EMIT ended(reason_, mayStartAgain_);
}

} // namespace media
