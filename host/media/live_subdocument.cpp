#include "media/live_subdocument.h"

#include <QTimer>

#include <algorithm>
#include <memory>
#include <utility>

namespace media {

namespace {

constexpr const char* updateDrafts = "update-drafts";

// Wishes of a user for windows of the medium, which a process in mode edit has alone.
bool asksAsEditor(const ipc::ToHost& request) {
    return std::holds_alternative<ipc::EditUndo>(request) ||
           std::holds_alternative<ipc::EditRedo>(request);
}

} // namespace

LiveSubdocument::LiveSubdocument(const Manifest& manifest, QString program, PipeThread& pipes,
                                 TimeLimits limits, QObject* parent)
    : QObject(parent), processes_({manifest, std::move(program), pipes, limits}) {
    followProcesses();
}

void LiveSubdocument::followProcesses() {
    connect(&processes_, &Succession::begun, this, [this] {
        loaded_ = false;
        setCondition(Condition::starting);
    });
    connect(&processes_, &Succession::ready, this, &LiveSubdocument::adopt);
    connect(&processes_, &Succession::left, this,
            [this](const MediumProcess* one) { processLeft(*one); });
    connect(&processes_, &Succession::told, this, &LiveSubdocument::told);
    connect(&processes_, &Succession::asked, this,
            [this](MediumProcess* by, const ipc::Id& id, const ipc::ToHost& request) {
                asked(*by, id, request);
            });
    connect(&processes_, &Succession::respondingChanged, this, [this] {
        setCondition(process().isResponding() ? Condition::live : Condition::notResponding);
    });
    connect(&processes_, &Succession::failed, this, &LiveSubdocument::processFailed);
    connect(&processes_, &Succession::changeFailed, this, [this](const QString& reason) {
        Q_EMIT message(QStringLiteral("%1 %2.").arg(manifest().name, reason));
    });
}

LiveSubdocument::~LiveSubdocument() { processes_.end(); }

QString LiveSubdocument::name() const {
    return said_.name.isEmpty() ? manifest().name : said_.name;
}

void LiveSubdocument::setCondition(Condition condition) {
    condition_ = condition;
    Q_EMIT conditionChanged();
}

// --- text --------------------------------------------------------------------------------------

// After a change of the text: false when no medium can be sent it.
bool LiveSubdocument::judgeText(bool wasTooLong) {
    if (text_.isTooLong()) {
        makeStill();
        reason_ = text_.whyTooLong(manifest().name);
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
    const bool wasTooLong = text_.isTooLong();
    text_.set(text);
    if (judgeText(wasTooLong) && isReady())
        load();
}

void LiveSubdocument::edit(const text::Edits& edits, const QString& label) {
    const bool wasTooLong = text_.isTooLong();
    const auto call = text_.edit(edits, label);
    if (!judgeText(wasTooLong) || text_.isChangedByMedium() || !isReady())
        return; // it knows already, or is told by load()
    if (!call)
        return load();
    process().request(
        *call, [this, isCurrent = processes_.sameAsNow()](const Outcome<ipc::Done>& outcome) {
            if (isCurrent() && isReady() && std::holds_alternative<ipc::Error>(outcome))
                load();
        });
}

void LiveSubdocument::load() {
    process().request(text_.load(), [this, isCurrent = processes_.sameAsNow()](
                                        const Outcome<ipc::Done>& outcome) {
        if (!isCurrent() || !std::holds_alternative<ipc::Done>(outcome))
            return;
        loaded_ = true;
        Q_EMIT loaded();
    });
}

// A medium that has none says so by an error.
void LiveSubdocument::askForParameters() {
    if (!isReady() || !loaded_)
        return;
    process().request(ipc::ParameterList{}, [this, isCurrent = processes_.sameAsNow()](
                                                const Outcome<ipc::Parameters>& outcome) {
        if (!isCurrent())
            return;
        std::vector<std::string> names;
        if (const auto* list = std::get_if<ipc::Parameters>(&outcome))
            for (const auto& parameter : list->items)
                names.push_back(parameter.name);
        said_.parameters = std::move(names);
        Q_EMIT parametersChanged();
    });
}

void LiveSubdocument::applyChange(MediumProcess& by, const ipc::Id& id,
                                  const ipc::SubdocumentChanged& change) {
    const auto outcome = text_.change(change);
    if (const auto* error = std::get_if<ipc::Error>(&outcome))
        by.refuse(id, *error);
    else
        by.answer(id, std::get<ipc::Revised>(outcome));
}

// --- process -----------------------------------------------------------------------------------

void LiveSubdocument::startAgain() {
    processes_.forgetFailures();
    start();
}

void LiveSubdocument::start() {
    processes_.doNotTryAgain();
    if (text_.isTooLong()) // said again, and later, as every end is
        QMetaObject::invokeMethod(this, &LiveSubdocument::conditionChanged, Qt::QueuedConnection);
    else
        processes_.start();
}

// A process is ready: it gets the text, the renditions and the time that the last one had.
void LiveSubdocument::adopt() {
    said_.name = QString::fromStdString(process().introduction().name);
    said_.menus = process().introduction().menus;
    const QString why = std::exchange(reason_, {});
    loaded_ = false;
    load();
    steer(time_.forNextProcess());
    if (const auto values = watched_.forNextProcess())
        process().request(*values);
    restoreWindows(why);
    askForPresentations();
    setCondition(Condition::live);
    Q_EMIT menusChanged();
    invokeWaiting();
}

void LiveSubdocument::askForPresentations() {
    process().request(ipc::PresentationList{}, [this, isCurrent = processes_.sameAsNow()](
                                                   Outcome<ipc::Presentations> outcome) {
        auto* list = std::get_if<ipc::Presentations>(&outcome);
        if (!isCurrent() || !isReady())
            return;
        if (list)
            renditions_.setPresentations(std::move(list->items));
        Q_EMIT presentationsChanged();
        renditions_.attach(process());
        askForSize();
    });
}

void LiveSubdocument::invokeWaiting() {
    for (const Invocation& one : std::exchange(whenReady_, {}))
        invoke(one.id, renditions_.of(one.rendition), one.figure, one.asks);
}

void LiveSubdocument::steer(const KeptTime::Commands& commands) {
    if (commands.rate)
        process().request(*commands.rate);
    if (commands.seek)
        process().request(*commands.seek);
    if (commands.play)
        process().request(ipc::TimePlay{});
}

void LiveSubdocument::restoreWindows(const QString& why) {
    if (process().mode() != Mode::edit)
        return;
    if (const auto restore = kept_.handOver(name(), why))
        process().notify(*restore);
}

void LiveSubdocument::setKeptState(const std::string& state) {
    kept_.keep(state);
    if (kept_.any())
        processes_.setMode(Mode::edit);
}

void LiveSubdocument::dismissNotice() {
    if (kept_.dismiss())
        Q_EMIT conditionChanged();
}

void LiveSubdocument::processLeft(const MediumProcess& process) {
    if (&process == processes_.current() && !kept_.any()) // else they are open again soon
        said_.windows = {};
    renditions_.detach(process);
}

void LiveSubdocument::makeStill() {
    processes_.end();
    whenReady_.clear();
    if (condition_ != Condition::failed)
        setCondition(Condition::still);
    Q_EMIT processGone();
}

void LiveSubdocument::processFailed(const QString& reason, bool mayStartAgain) {
    loaded_ = false;
    reason_ = QStringLiteral("%1 %2.").arg(manifest().name, reason);
    whenReady_.clear(); // it may be what ended it
    if (processes_.mode() == Mode::edit && kept_.any() && !kept_.opensAgain())
        processes_.setMode(Mode::play);
    const bool again = mayStartAgain && processes_.tryAgain();
    if (mayStartAgain && !again)
        reason_ = (reason_ + ' ' + processes_.tried()).trimmed();
    setCondition(again ? Condition::starting : Condition::failed);
    if (!again)
        Q_EMIT processGone();
}

// --- what it says ------------------------------------------------------------------------------

void LiveSubdocument::told(const ipc::ToHost& report) {
    if (const auto* time = std::get_if<ipc::TimeChanged>(&report)) {
        steer(time_.told(*time));
        Q_EMIT timeChanged();
    } else if (const auto* values = std::get_if<ipc::ValueChanged>(&report)) {
        const ValueWatch::Heard heard = watched_.told(*values);
        if (heard == ValueWatch::Heard::faulty)
            process().end(QStringLiteral("told more or fewer values than it was asked for"));
        else if (heard == ValueWatch::Heard::taken)
            Q_EMIT valuesChanged();
    } else if (const auto* menus = std::get_if<ipc::MenuChanged>(&report)) {
        said_.menus = menus->menus;
        Q_EMIT menusChanged();
    } else if (const auto* diagnostics = std::get_if<ipc::Diagnostics>(&report)) {
        said_.diagnostics = *diagnostics;
        Q_EMIT diagnosticsChanged();
    } else if (const auto* windows = std::get_if<ipc::WindowsChanged>(&report)) {
        said_.windows = *windows;
        Q_EMIT windowsChanged();
    } else if (const auto* keep = std::get_if<ipc::SessionKeep>(&report)) {
        if (process().mode() != Mode::edit)
            return; // it has no windows to speak of
        kept_.keep(keep->state);
        Q_EMIT keptStateChanged();
    } else if (const auto* progress = std::get_if<ipc::ProgressReport>(&report)) {
        Q_EMIT message(QString::fromStdString(progress->message));
    } else if (const auto* over = std::get_if<ipc::ProgressEnd>(&report)) {
        Q_EMIT message(QString::fromStdString(over->message));
    } else {
        toldOfRenditions(report);
    }
}

void LiveSubdocument::toldOfRenditions(const ipc::ToHost& report) {
    if (const auto* frame = std::get_if<ipc::RenditionFrame>(&report))
        takeFrame(*frame);
    else if (std::holds_alternative<ipc::PresentationResized>(report))
        askForSize();
    else if (const auto* unhandled = std::get_if<ipc::RenditionUnhandled>(&report))
        renditions_.take(*unhandled);
    else if (const auto* state = std::get_if<ipc::RenditionState>(&report))
        renditions_.take(*state);
    else if (const auto* cursor = std::get_if<ipc::RenditionCursor>(&report))
        renditions_.take(*cursor);
}

void LiveSubdocument::takeFrame(const ipc::RenditionFrame& frame) {
    const Renditions::Taken taken = renditions_.take(frame);
    if (taken == Renditions::Taken::faulty)
        process().end(QStringLiteral("sent a picture that has no place, or more than may wait"));
    else if (taken == Renditions::Taken::first)
        Q_EMIT firstPicture();
}

void LiveSubdocument::asked(MediumProcess& by, const ipc::Id& id, const ipc::ToHost& request) {
    if (&by != processes_.current()) {
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
    auto rendition = renditions_.create(*this);
    if (isReady() && !presentations().empty())
        renditions_.attach(*rendition, process());
    return rendition;
}

void LiveSubdocument::setPresentation(const std::string& name) {
    if (!renditions_.want(name) || !isReady() || presentations().empty())
        return;
    renditions_.showAnew();
    askForSize();
}

void LiveSubdocument::setAvailable(QSizeF available) {
    if (renditions_.setAvailable(available) && isReady() && loaded_)
        askForSize();
}

void LiveSubdocument::askForSize() {
    process().request(renditions_.askForSize(), [this, isCurrent = processes_.sameAsNow()](
                                                    const Outcome<ipc::PreferredSize>& outcome) {
        const auto* size = std::get_if<ipc::PreferredSize>(&outcome);
        if (isCurrent() && size && renditions_.setPreferredSize({size->width, size->height}))
            Q_EMIT preferredSizeChanged();
    });
}

void LiveSubdocument::snapshot(QSize pixels, double scale, std::optional<double> time,
                               std::function<void(Snapshot)> done) {
    const QPointer<MediumProcess> process = processes_.current();
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

void LiveSubdocument::invoke(const QString& id, const Rendition* rendition,
                             std::optional<ipc::ScreenArea> figure, Asks asks) {
    if (!isReady()) { // its menu may not be known yet
        whenReady_.push_back({id, rendition ? rendition->id() : 0, figure, std::move(asks)});
        startAgain();
        Q_EMIT message(name() + QStringLiteral(" is starting."));
        return;
    }
    const std::string wanted = id.toStdString();
    const auto entry = std::ranges::find(said_.menus, wanted, &ipc::MenuEntry::id);
    if (entry == said_.menus.end())
        return;
    ipc::MenuInvoke call;
    call.id = wanted;
    call.figure = figure;
    if (rendition && entry->scope == ipc::Scope::rendition)
        call.rendition = rendition->id();
    const auto tell = [this, call, asks = std::move(asks)] {
        answer(call, [this, asks](const Outcome<ipc::Invoked>& outcome) {
            if (const auto* error = std::get_if<ipc::Error>(&outcome))
                Q_EMIT message(QString::fromStdString(error->message));
            else if (const auto& question = std::get<ipc::Invoked>(outcome).question;
                     question && asks)
                asks(*question);
        });
    };
    if (entry->mode == Mode::edit && process().mode() != Mode::edit)
        processes_.changeTo(Mode::edit, tell);
    else
        tell();
}

void LiveSubdocument::answer(ipc::MenuInvoke call,
                             std::function<void(Outcome<ipc::Invoked>)> done) {
    if (!isReady())
        return done(ipc::Error(ipc::ErrorCode::notPossible,
                               (name() + QStringLiteral(" is starting.")).toStdString()));
    process().request(std::move(call),
                      [isCurrent = processes_.sameAsNow(), done](Outcome<ipc::Invoked> outcome) {
                          if (isCurrent())
                              done(std::move(outcome));
                      });
}

void LiveSubdocument::whenHeard(std::function<void()> done) {
    if (!isReady())
        return done();
    constexpr int patienceMs = 200;
    const auto once = [done = std::make_shared<std::function<void()>>(std::move(done))] {
        if (const auto first = std::exchange(*done, nullptr))
            first();
    };
    QTimer::singleShot(patienceMs, this, once);
    process().request(ipc::Ping{}, [once](const Outcome<ipc::Done>&) { once(); });
}

bool LiveSubdocument::takesDrafts() const {
    return isReady() && std::ranges::any_of(said_.menus, [](const ipc::MenuEntry& entry) {
               return entry.id == updateDrafts && entry.enabled;
           });
}

void LiveSubdocument::takeDrafts() { invoke(updateDrafts, nullptr); }

// From the start, the first time: see KeptTime.
void LiveSubdocument::play() {
    if (hasCurrent())
        process().request(ipc::TimePlay{});
}

void LiveSubdocument::pause() {
    if (hasCurrent())
        process().request(ipc::TimePause{});
}

void LiveSubdocument::seek(double time) {
    if (!hasCurrent() || process().isCongested())
        return;
    time_.chosenByHand();
    process().request(ipc::TimeSeek{time});
}

void LiveSubdocument::setRate(double rate, bool loop) {
    if (hasCurrent())
        process().request(ipc::TimeRate{rate, loop});
}

} // namespace media
