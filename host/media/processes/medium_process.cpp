#include "processes/medium_process.h"

#include "processes/environment.h"

#include "ipc/framing.h"
#include "ipc/wire.h"

#include <QLocale>
#include <QPointer>

namespace media {

namespace {

// The time that one turn of the event loop may spend on one medium's mail.
constexpr int mostLettersPerTurn = 100;
constexpr int mostMsPerTurn = 8;

} // namespace

MediumProcess::MediumProcess(const Manifest& manifest, QString program, Mode mode,
                             PipeThread& pipes, TimeLimits limits, QObject* parent)
    : QObject(parent), manifest_(manifest), program_(std::move(program)), mode_(mode),
      pipes_(pipes), frames_(std::make_shared<FrameMemory>()),
      mailbox_(std::make_shared<Mailbox>(this, "readMail")), pulse_(limits) {
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
    pulse_.begin();
    if (program_.isEmpty()) {
        end(QStringLiteral("could not be started: there is no program \"%1\"")
                .arg(manifest_.command.first()),
            true);
        return;
    }
    link_ = pipes_.start(launchRequest(), mailbox_);
    clock_.start(pulse_.interval());
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
        pulse_.introduced();
        Q_EMIT ready();
    });
}

void MediumProcess::ask(const ipc::ToMedium& call, Calls::Done done) {
    const ipc::Integer id = calls_.await(std::move(done));
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
        calls_.take(std::move(*answered));
    }
}

void MediumProcess::ping() {
    pulse_.pinged();
    request(ipc::Ping{}, [this](const Outcome<ipc::Done>& outcome) {
        if (std::holds_alternative<ipc::Done>(outcome) && pulse_.answered())
            Q_EMIT respondingChanged();
    });
}

void MediumProcess::tick() {
    const Pulse::Due due = pulse_.due();
    if (due.what == Pulse::Due::What::end)
        end(due.why);
    else if (due.what == Pulse::Due::What::ping)
        ping();
    else if (due.what == Pulse::Due::What::sayThatItIsQuiet)
        Q_EMIT respondingChanged();
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
    pulse_.askedToEnd();
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
    calls_.refuse(closed);
    if (first && self)
        Q_EMIT ended(reason_, mayStartAgain_);
}

} // namespace media
