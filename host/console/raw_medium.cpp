#include "console/raw_medium.h"

#include "ipc/framing.h"

#include <QElapsedTimer>
#include <QThread>

namespace console {

namespace {

constexpr int pollMs = 2;

} // namespace

RawMedium::RawMedium(media::PipeThread& pipes, const QString& program, const QStringList& arguments)
    : pipes_(pipes), mailbox_(std::make_shared<media::Mailbox>(nullptr, "")) {
    media::Launch launch;
    launch.program = program.toStdString();
    for (const QString& argument : arguments)
        launch.arguments.push_back(argument.toStdString());
    launch.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8", "LC_ALL=C.UTF-8"};
    launch.frames = frames_.descriptor();
    link_ = pipes_.start(launch, mailbox_);
}

RawMedium::~RawMedium() {
    pipes_.end(link_, "the check is over");
    // The frame memory must stay until the process has surely been started.
    static_cast<void>(waitForEnd(answerMs));
}

ipc::Integer RawMedium::send(const ipc::ToMedium& request) {
    const ipc::Integer id = nextId();
    mailbox_->await(id, request.index());
    sendBytes(ipc::framed(ipc::encodeRequest(id, request)));
    return id;
}

void RawMedium::tell(const ipc::ToMedium& notification) {
    sendBytes(ipc::framed(ipc::encodeNotification(notification)));
}

std::variant<ipc::AnyResult, ipc::Error> RawMedium::askRaw(const std::string& body, ipc::Integer id,
                                                           const ipc::ToMedium& like) {
    mailbox_->await(id, like.index());
    sendBytes(ipc::framed(body));
    return waitForAnswer(id, answerMs, "a request");
}

void RawMedium::sendBytes(const std::string& bytes) {
    static_cast<void>(pipes_.send(link_, bytes));
}

void RawMedium::closeInput() { pipes_.closeInput(link_); }

ipc::Initialized RawMedium::introduce(ipc::Integer oldest, ipc::Integer newest, bool withFrames) {
    ipc::Initialize call;
    call.oldest = oldest;
    call.newest = newest;
    call.documentClass = "CHECK";
    call.mode = ipc::Mode::play;
    if (withFrames)
        call.frames = ipc::SharedMemory{media::framesDescriptor, media::FrameMemory::capacity};
    return mustAnswer(call);
}

bool RawMedium::readOne() {
    media::Letter letter;
    if (!mailbox_->take(letter))
        return false;
    if (letter.kind == media::Letter::Kind::ended)
        ending_ = letter.text;
    if (letter.kind != media::Letter::Kind::message)
        return true;
    if (const auto* told = std::get_if<ipc::Told<ipc::ToHost>>(&letter.message)) {
        reports_.push_back(told->call);
    } else if (auto* answered = std::get_if<ipc::Answered>(&letter.message)) {
        answers_[answered->id] = std::move(answered->outcome);
    } else if (const auto* asked = std::get_if<ipc::Asked<ipc::ToHost>>(&letter.message)) {
        sendBytes(ipc::framed(ipc::encodeError(
            asked->id, {ipc::ErrorCode::notPossible, "the conformance test changes nothing"})));
    }
    return true;
}

std::variant<ipc::AnyResult, ipc::Error> RawMedium::waitForAnswer(ipc::Integer id, int ms,
                                                                  const std::string& what) {
    QElapsedTimer elapsed;
    elapsed.start();
    while (!answers_.contains(id)) {
        if (readOne())
            continue;
        if (!ending_.empty())
            throw Wrong("instead of an answer to " + what + " the medium " + ending_);
        if (elapsed.hasExpired(ms))
            throw Wrong("no answer to " + what + " within " + std::to_string(ms / 1000) + " s");
        QThread::msleep(pollMs);
    }
    auto outcome = std::move(answers_.at(id));
    answers_.erase(id);
    return outcome;
}

bool RawMedium::waitFor(const std::function<bool(const ipc::ToHost&)>& wanted, int ms) {
    QElapsedTimer elapsed;
    elapsed.start();
    for (;;) {
        const auto found = std::find_if(reports_.begin(), reports_.end(), wanted);
        if (found != reports_.end()) {
            reports_.erase(found);
            return true;
        }
        if (!readOne()) {
            if (elapsed.hasExpired(ms) || !ending_.empty())
                return false;
            QThread::msleep(pollMs);
        }
    }
}

void RawMedium::listen(int ms) {
    QElapsedTimer elapsed;
    elapsed.start();
    while (!elapsed.hasExpired(ms))
        if (!readOne())
            QThread::msleep(pollMs);
}

std::string RawMedium::waitForEnd(int ms) {
    QElapsedTimer elapsed;
    elapsed.start();
    while (ending_.empty() && !elapsed.hasExpired(ms))
        if (!readOne())
            QThread::msleep(pollMs);
    return ending_;
}

} // namespace console
