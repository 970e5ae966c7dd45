#include "media/live_subdocument.h"

#include <algorithm>

namespace media {

namespace {

constexpr int restartDelayMs = 100;
constexpr const char* updateDrafts = "update-drafts";

// What a user asks for in windows of the medium, which a process in mode edit has alone.
bool asksAsEditor(const ipc::ToHost& request) {
    return std::holds_alternative<ipc::EditUndo>(request) ||
           std::holds_alternative<ipc::EditRedo>(request);
}

} // namespace

LiveSubdocument::LiveSubdocument(const Manifest& manifest, QString program, PipeThread& pipes,
                                 TimeLimits limits, QObject* parent)
    : QObject(parent), manifest_(manifest), program_(std::move(program)), pipes_(pipes),
      limits_(limits), restarts_(limits.restartsPerMinute, limits.restartsPerHour) {
    clock_.start();
    restartTimer_.setSingleShot(true);
    connect(&restartTimer_, &QTimer::timeout, this, [this] { begin(mode_); });
}

LiveSubdocument::~LiveSubdocument() {
    for (Rendition* rendition : renditions_)
        rendition->subdocument_ = nullptr;
    discard(next_);
    discard(process_);
}

QString LiveSubdocument::name() const { return ownName_.isEmpty() ? manifest_.name : ownName_; }

void LiveSubdocument::setCondition(Condition condition) {
    condition_ = condition;
    Q_EMIT conditionChanged();
}

bool LiveSubdocument::hasPicture() const {
    return std::any_of(renditions_.begin(), renditions_.end(),
                       [](const Rendition* one) { return !one->picture().isNull(); });
}

// --- text --------------------------------------------------------------------------------------

bool LiveSubdocument::isReady() const {
    return process_ && process_->state() == MediumProcess::State::ready;
}

bool LiveSubdocument::isTooLong() const {
    return static_cast<std::size_t>(text_.size()) > ipc::longestText.most;
}

// After a change of the text: false when no medium can be sent it.
bool LiveSubdocument::judgeText(bool wasTooLong) {
    if (isTooLong()) {
        makeStill();
        reason_ = QStringLiteral("%1 is not started: this text has %2 MiB, and it may have %3 MiB "
                                 "at most. Make it shorter.")
                      .arg(manifest_.name)
                      .arg(static_cast<double>(text_.size()) / (1 << 20), 0, 'f', 1)
                      .arg(ipc::longestText.most >> 20);
        setCondition(Condition::failed);
        return false;
    }
    if (wasTooLong) {
        reason_.clear();
        setCondition(Condition::still);
        Q_EMIT processGone(); // it may be started now
    }
    return true;
}

void LiveSubdocument::setText(const QByteArray& text) {
    const bool wasTooLong = isTooLong();
    text_ = text;
    ++revision_;
    if (judgeText(wasTooLong) && isReady())
        load();
}

void LiveSubdocument::edit(const text::Edits& edits, const QString& label) {
    const bool wasTooLong = isTooLong();
    std::size_t typed = 0;
    for (const text::Edit& edit : edits)
        typed += edit.text.size();
    const std::string_view before(text_.constData(), static_cast<std::size_t>(text_.size()));
    text_ = QByteArray::fromStdString(text::applied(before, edits));
    ++revision_;
    if (!judgeText(wasTooLong) || applyingOwnChange_ || !isReady())
        return; // it knows already, or is told by load()
    if (edits.size() > ipc::mostEdits.most || typed > ipc::longestText.most)
        return load(); // more than one message tells
    const auto isCurrent = currentProcess();
    process_->request(ipc::SubdocumentEdit{revision_, edits, label.toStdString()},
                      [this, isCurrent](const Outcome<ipc::Done>& outcome) {
                          if (isCurrent() && isReady() &&
                              std::holds_alternative<ipc::Error>(outcome))
                              load();
                      });
}

// An answer may come when the subdocument is gone, or has another process.
std::function<bool()> LiveSubdocument::currentProcess() const {
    return [self = QPointer<const LiveSubdocument>(this),
            process = QPointer<const MediumProcess>(process_.get())] {
        return self && process && process == self->process_.get();
    };
}

void LiveSubdocument::load() {
    const auto isCurrent = currentProcess();
    process_->request(ipc::SubdocumentLoad{text_.toStdString(), revision_, title_.toStdString()},
                      [this, isCurrent](const Outcome<ipc::Done>& outcome) {
                          if (!isCurrent() || !std::holds_alternative<ipc::Done>(outcome))
                              return;
                          loaded_ = true;
                          Q_EMIT loaded();
                      });
}

// A medium that has none says so by an error.
void LiveSubdocument::askForParameters() {
    if (!process_ || process_->state() != MediumProcess::State::ready || !loaded_)
        return;
    const auto isCurrent = currentProcess();
    process_->request(ipc::ParameterList{},
                      [this, isCurrent](const Outcome<ipc::Parameters>& outcome) {
                          if (!isCurrent())
                              return;
                          std::vector<std::string> names;
                          if (const auto* list = std::get_if<ipc::Parameters>(&outcome))
                              for (const auto& parameter : list->items)
                                  names.push_back(parameter.name);
                          parameters_ = std::move(names);
                          Q_EMIT parametersChanged();
                      });
}

void LiveSubdocument::applyChange(MediumProcess& by, const ipc::Id& id,
                                  const ipc::SubdocumentChanged& change) {
    if (change.base != revision_) {
        by.refuse(id, {ipc::ErrorCode::staleBase,
                       "the text is at revision " + std::to_string(revision_)});
        return;
    }
    auto length = static_cast<std::size_t>(text_.size());
    if (!text::areOrdered(change.edits, length)) {
        by.refuse(id, {ipc::ErrorCode::invalidParameters,
                       "the edits must ascend, not overlap and lie in the text"});
        return;
    }
    for (const text::Edit& edit : change.edits)
        length = length - edit.range.size() + edit.text.size();
    if (length > ipc::longestText.most) {
        by.refuse(id, {ipc::ErrorCode::notPossible, "the text would be too long"});
        return;
    }
    applyingOwnChange_ = true;
    const std::optional<QString> refused =
        changeHandler_ ? changeHandler_(change) : QStringLiteral("the document cannot be edited");
    applyingOwnChange_ = false;
    if (refused)
        by.refuse(id, {ipc::ErrorCode::notPossible, refused->toStdString()});
    else
        by.answer(id, ipc::Revised{revision_});
}

// --- process -----------------------------------------------------------------------------------

std::unique_ptr<MediumProcess> LiveSubdocument::createProcess(Mode mode) {
    auto process = std::make_unique<MediumProcess>(manifest_, program_, mode, pipes_, limits_);
    MediumProcess* made = process.get();
    connect(made, &MediumProcess::told, this, [this, made](const ipc::ToHost& report) {
        if (made == process_.get())
            told(report);
    });
    connect(
        made, &MediumProcess::asked, this,
        [this, made](const ipc::Id& id, const ipc::ToHost& request) { asked(*made, id, request); });
    connect(made, &MediumProcess::respondingChanged, this, [this, made] {
        if (made == process_.get())
            setCondition(made->isResponding() ? Condition::live : Condition::notResponding);
    });
    return process;
}

void LiveSubdocument::startAgain() {
    restarts_.forget();
    start();
}

void LiveSubdocument::start() {
    restartTimer_.stop();
    if (isTooLong()) // said again, and later, as every end is
        QMetaObject::invokeMethod(this, &LiveSubdocument::conditionChanged, Qt::QueuedConnection);
    else if (!process_)
        begin(mode_);
}

void LiveSubdocument::begin(Mode mode) {
    std::unique_ptr<MediumProcess> process = createProcess(mode);
    MediumProcess* made = process.get();
    connect(made, &MediumProcess::ready, this, [this] { adopt(std::move(process_)); });
    connect(made, &MediumProcess::ended, this, &LiveSubdocument::processEnded);
    process_ = std::move(process);
    loaded_ = false;
    setCondition(Condition::starting);
    made->start();
}

// The process is ready: it gets the text, the renditions and the time that the last one had.
void LiveSubdocument::adopt(std::unique_ptr<MediumProcess> process) {
    process_ = std::move(process);
    ownName_ = QString::fromStdString(process_->introduction().name);
    menus_ = process_->introduction().menus;
    const QString why = std::exchange(reason_, {});
    loaded_ = false;
    load();
    steer(time_.forNextProcess());
    if (const auto values = watched_.forNextProcess())
        process_->request(*values);
    restoreWindows(why);
    const auto isCurrent = currentProcess();
    process_->request(ipc::PresentationList{},
                      [this, isCurrent](Outcome<ipc::Presentations> outcome) {
                          auto* list = std::get_if<ipc::Presentations>(&outcome);
                          if (!isCurrent() || !isReady())
                              return;
                          if (list)
                              presentations_ = std::move(list->items);
                          Q_EMIT presentationsChanged();
                          for (Rendition* rendition : renditions_)
                              rendition->attach(process_.get());
                          askForSize();
                      });
    setCondition(Condition::live);
    Q_EMIT menusChanged();
    invokeWaiting();
}

void LiveSubdocument::invokeWaiting() {
    for (const Invocation& one : std::exchange(whenReady_, {})) {
        const auto of = std::ranges::find_if(
            renditions_, [&](const Rendition* each) { return each->id() == one.rendition; });
        invoke(one.id, of == renditions_.end() ? nullptr : *of);
    }
}

void LiveSubdocument::steer(const KeptTime::Commands& commands) {
    if (commands.rate)
        process_->request(*commands.rate);
    if (commands.seek)
        process_->request(*commands.seek);
    if (commands.play)
        process_->request(ipc::TimePlay{});
}

void LiveSubdocument::restoreWindows(const QString& why) {
    if (process_->mode() != Mode::edit)
        return;
    if (const auto restore = kept_.handOver(name(), why))
        process_->notify(*restore);
}

void LiveSubdocument::setKeptState(const std::string& state) {
    kept_.keep(state);
    if (kept_.any())
        mode_ = Mode::edit;
}

void LiveSubdocument::dismissNotice() {
    if (kept_.dismiss())
        Q_EMIT conditionChanged();
}

void LiveSubdocument::discard(std::unique_ptr<MediumProcess>& process) {
    if (!process)
        return;
    if (&process == &process_ && !kept_.any()) // else they are open again soon
        windows_ = {};
    process->disconnect(this);
    for (Rendition* rendition : renditions_)
        if (rendition->process_ == process.get())
            rendition->attach(nullptr);
    // It may be in a call of its own, and may take its time to end.
    MediumProcess* leaving = process.release();
    if (leaving->state() == MediumProcess::State::ended) {
        leaving->deleteLater();
        return;
    }
    leaving->setParent(&pipes_.departing());
    connect(leaving, &MediumProcess::ended, leaving, &QObject::deleteLater);
    leaving->shutdown();
}

bool LiveSubdocument::hasWindows() const {
    return next_ || (process_ && process_->mode() == Mode::edit);
}

void LiveSubdocument::makeStill() {
    restartTimer_.stop();
    discard(next_);
    discard(process_);
    afterSwitch_.clear();
    whenReady_.clear();
    if (condition_ != Condition::failed)
        setCondition(Condition::still);
    Q_EMIT processGone();
}

void LiveSubdocument::processEnded(const QString& reason, bool mayStartAgain) {
    discard(process_);
    loaded_ = false;
    reason_ = QStringLiteral("%1 %2.").arg(manifest_.name, reason);
    whenReady_.clear(); // it may be what ended it
    if (mode_ == Mode::edit && kept_.any() && !kept_.opensAgain())
        mode_ = Mode::play;
    const bool again = mayStartAgain && restarts_.mayTry(clock_.elapsed());
    if (mayStartAgain && !again)
        reason_ = (reason_ + ' ' + restarts_.told(clock_.elapsed())).trimmed();
    setCondition(again ? Condition::starting : Condition::failed);
    if (again)
        restartTimer_.start(restartDelayMs);
    else
        Q_EMIT processGone();
}

void LiveSubdocument::switchMode(Mode mode, std::function<void()> then) {
    afterSwitch_.push_back(std::move(then));
    if (next_)
        return;
    mode_ = mode;
    next_ = createProcess(mode);
    connect(next_.get(), &MediumProcess::ended, this, &LiveSubdocument::nextEnded);
    connect(next_.get(), &MediumProcess::ready, this, [this] {
        next_->disconnect(SIGNAL(ended(QString, bool)));
        connect(next_.get(), &MediumProcess::ended, this, &LiveSubdocument::processEnded);
        discard(process_);
        adopt(std::move(next_));
        for (const auto& todo : std::exchange(afterSwitch_, {}))
            todo();
    });
    next_->start();
}

void LiveSubdocument::nextEnded(const QString& reason) {
    discard(next_);
    afterSwitch_.clear();
    mode_ = Mode::play;
    Q_EMIT message(QStringLiteral("%1 %2.").arg(manifest_.name, reason));
}

// --- what it says ------------------------------------------------------------------------------

void LiveSubdocument::told(const ipc::ToHost& report) {
    if (const auto* frame = std::get_if<ipc::RenditionFrame>(&report)) {
        takeFrame(*frame);
    } else if (const auto* time = std::get_if<ipc::TimeChanged>(&report)) {
        steer(time_.told(*time));
        Q_EMIT timeChanged();
    } else if (const auto* values = std::get_if<ipc::ValueChanged>(&report)) {
        const ValueWatch::Heard heard = watched_.told(*values);
        if (heard == ValueWatch::Heard::faulty)
            process_->end(QStringLiteral("told more or fewer values than it was asked for"));
        else if (heard == ValueWatch::Heard::taken)
            Q_EMIT valuesChanged();
    } else if (const auto* menus = std::get_if<ipc::MenuChanged>(&report)) {
        menus_ = menus->menus;
        Q_EMIT menusChanged();
    } else if (const auto* diagnostics = std::get_if<ipc::Diagnostics>(&report)) {
        diagnostics_ = *diagnostics;
        Q_EMIT diagnosticsChanged();
    } else if (const auto* windows = std::get_if<ipc::WindowsChanged>(&report)) {
        windows_ = *windows;
        Q_EMIT windowsChanged();
    } else if (const auto* keep = std::get_if<ipc::SessionKeep>(&report)) {
        if (process_->mode() != Mode::edit)
            return; // it has no windows to speak of
        kept_.keep(keep->state);
        Q_EMIT keptStateChanged();
    } else if (std::holds_alternative<ipc::PresentationResized>(report)) {
        askForSize();
    } else if (const auto* unhandled = std::get_if<ipc::RenditionUnhandled>(&report)) {
        for (Rendition* rendition : renditions_)
            if (rendition->id() == unhandled->rendition) {
                Q_EMIT rendition->unhandledInput(*unhandled); // which may scroll it out of use
                return;
            }
    } else if (const auto* state = std::get_if<ipc::RenditionState>(&report)) {
        for (Rendition* rendition : renditions_)
            if (rendition->id() == state->rendition)
                rendition->state_ = state->state;
    } else if (const auto* cursor = std::get_if<ipc::RenditionCursor>(&report)) {
        for (Rendition* rendition : renditions_)
            if (rendition->id() == cursor->rendition) {
                rendition->cursor_ = cursor->shape;
                Q_EMIT rendition->cursorChanged();
                return;
            }
    } else if (const auto* progress = std::get_if<ipc::ProgressReport>(&report)) {
        Q_EMIT message(QString::fromStdString(progress->message));
    } else if (const auto* over = std::get_if<ipc::ProgressEnd>(&report)) {
        Q_EMIT message(QString::fromStdString(over->message));
    }
}

void LiveSubdocument::takeFrame(const ipc::RenditionFrame& frame) {
    const bool isFirst = !hasPicture();
    for (Rendition* rendition : renditions_)
        if (rendition->id() == frame.rendition) {
            if (!rendition->take(frame))
                process_->end(
                    QStringLiteral("sent a picture that has no place, or more than may wait"));
            else if (isFirst && !rendition->picture().isNull())
                Q_EMIT firstPicture();
            return;
        }
    // One that was on its way when its rendition was destroyed is no fault.
}

void LiveSubdocument::asked(MediumProcess& by, const ipc::Id& id, const ipc::ToHost& request) {
    if (&by != process_.get()) {
        by.refuse(id, {ipc::ErrorCode::notPossible, "another process serves the subdocument now"});
    } else if (asksAsEditor(request) && by.mode() != Mode::edit) {
        by.refuse(id, {ipc::ErrorCode::notPossible,
                       "only a process in mode \"edit\" has windows to ask this from"});
    } else if (const auto* change = std::get_if<ipc::SubdocumentChanged>(&request)) {
        applyChange(by, id, *change);
    } else if (std::holds_alternative<ipc::EditUndo>(request)) {
        by.answer(id, ipc::Done{});
        Q_EMIT undoRequested();
    } else if (std::holds_alternative<ipc::EditRedo>(request)) {
        by.answer(id, ipc::Done{});
        Q_EMIT redoRequested();
    } else {
        by.refuse(id, {ipc::ErrorCode::notPossible, "the host has no commands yet"});
    }
}

// --- renditions --------------------------------------------------------------------------------

std::unique_ptr<Rendition> LiveSubdocument::createRendition() {
    auto rendition = std::unique_ptr<Rendition>(new Rendition(*this, ++lastRendition_));
    renditions_.push_back(rendition.get());
    if (isReady() && !presentations_.empty())
        rendition->attach(process_.get());
    return rendition;
}

void LiveSubdocument::forget(const Rendition& rendition) { std::erase(renditions_, &rendition); }

std::string LiveSubdocument::presentation() const {
    const auto isWanted = [&](const ipc::Presentation& one) {
        return one.id == wantedPresentation_;
    };
    if (std::ranges::any_of(presentations_, isWanted))
        return wantedPresentation_;
    return presentations_.empty() ? "picture" : presentations_.front().id;
}

void LiveSubdocument::setPresentation(const std::string& name) {
    const std::string before = presentation();
    wantedPresentation_ = name;
    if (presentation() == before || !isReady() || presentations_.empty())
        return;
    for (Rendition* rendition : renditions_)
        rendition->showAnew();
    askForSize();
}

void LiveSubdocument::setAvailable(QSizeF available) {
    if (available == available_)
        return;
    available_ = available;
    if (isReady() && loaded_)
        askForSize();
}

void LiveSubdocument::askForSize() {
    ipc::PresentationSize call;
    call.presentation = presentation();
    call.availableWidth = std::clamp(available_.width(), 1.0, 1e6);
    if (available_.height() >= 1)
        call.availableHeight = available_.height();
    const auto isCurrent = currentProcess();
    process_->request(call, [this, isCurrent](const Outcome<ipc::PreferredSize>& outcome) {
        const auto* size = std::get_if<ipc::PreferredSize>(&outcome);
        if (!isCurrent() || !size || preferredSize_ == QSizeF(size->width, size->height))
            return;
        preferredSize_ = QSizeF(size->width, size->height);
        Q_EMIT preferredSizeChanged();
    });
}

void LiveSubdocument::snapshot(QSize pixels, double scale, std::optional<double> time,
                               std::function<void(Snapshot)> done) {
    const QPointer<MediumProcess> process = process_.get();
    if (!process || process->state() != MediumProcess::State::ready) {
        done({{}, reason_.isEmpty() ? name() + " is not ready." : reason_});
        return;
    }
    const std::optional<Slot> slot = process->frames().allocate(pixels.width(), pixels.height());
    if (!slot) {
        done({{}, QStringLiteral("The picture is too large.")});
        return;
    }
    ipc::RenditionSnapshot call;
    call.presentation = presentation();
    call.width = pixels.width();
    call.height = pixels.height();
    call.scale = scale;
    call.time = time;
    call.offset = slot->offset;
    call.stride = slot->stride;
    process->request(call, [process, slot, pixels, done](const Outcome<ipc::Taken>& outcome) {
        Snapshot result;
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            result.error = QString::fromStdString(error->message);
        else if (process)
            result.picture = process->frames().picture(*slot, pixels.width(), pixels.height());
        if (process)
            process->frames().free(*slot);
        done(result);
    });
}

// --- commands ----------------------------------------------------------------------------------

void LiveSubdocument::invoke(const QString& id, const Rendition* rendition) {
    if (!isReady()) { // its menu may not be known yet
        whenReady_.push_back({id, rendition ? rendition->id() : 0});
        startAgain();
        Q_EMIT message(name() + QStringLiteral(" is starting."));
        return;
    }
    const std::string wanted = id.toStdString();
    const auto entry = std::find_if(menus_.begin(), menus_.end(),
                                    [&](const ipc::MenuEntry& e) { return e.id == wanted; });
    if (entry == menus_.end())
        return;
    ipc::MenuInvoke call;
    call.id = wanted;
    if (rendition && entry->scope == ipc::Scope::rendition)
        call.rendition = rendition->id();
    const auto tell = [this, call] {
        const auto isCurrent = currentProcess();
        process_->request(call, [this, isCurrent](const Outcome<ipc::Done>& outcome) {
            const auto* error = std::get_if<ipc::Error>(&outcome);
            if (isCurrent() && error)
                Q_EMIT message(QString::fromStdString(error->message));
        });
    };
    if (entry->mode == Mode::edit && process_->mode() != Mode::edit)
        switchMode(Mode::edit, tell);
    else
        tell();
}

bool LiveSubdocument::takesDrafts() const {
    return isReady() && std::ranges::any_of(menus_, [](const ipc::MenuEntry& entry) {
               return entry.id == updateDrafts && entry.enabled;
           });
}

void LiveSubdocument::takeDrafts() { invoke(updateDrafts, nullptr); }

void LiveSubdocument::play() {
    if (!process_)
        return;
    process_->request(ipc::TimePlay{}); // from the start, the first time: see KeptTime
}

void LiveSubdocument::pause() {
    if (process_)
        process_->request(ipc::TimePause{});
}

void LiveSubdocument::seek(double time) {
    if (!process_ || process_->isCongested())
        return;
    time_.chosenByHand();
    process_->request(ipc::TimeSeek{time});
}

void LiveSubdocument::setRate(double rate, bool loop) {
    if (process_)
        process_->request(ipc::TimeRate{rate, loop});
}

} // namespace media
