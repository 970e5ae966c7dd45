#include "workbench/scene_document.h"

#include "editing/changes.h"
#include "reports/report.h"
#include "script/locate.h"
#include "text/difference.h"
#include "workbench/stale_motion.h"
#include "workbench/worker.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <utility>

namespace views {

namespace {

bool same(const scene::Diagnostic& a, const scene::Diagnostic& b) {
    return a.severity == b.severity && a.range.from == b.range.from && a.range.to == b.range.to &&
           a.line == b.line && a.column == b.column && a.message == b.message &&
           a.suggestion == b.suggestion;
}

// Whether an element is at its place still: by its name, or by its command, which an edit moved at
// most. Quick for the usual case, where nothing comes or goes.
class Stays {
public:
    Stays(const scene::Scene& before, const scene::Scene& after, const text::Edit& edit)
        : before_(before), after_(after), edit_(edit) {}

    // Something came or went: then a command may stand where another one stood.
    [[nodiscard]] bool sameCounts() const {
        const auto counts = [](const scene::Scene& s) {
            return std::array{s.shapeSets.size(),   s.bodies.size(),   s.forces.size(),
                              s.links.size(),       s.joints.size(),   s.gears.size(),
                              s.ropes.size(),       s.contacts.size(), s.trajectories.size(),
                              s.constraints.size(), s.lights.size(),   s.views.size(),
                              s.parameters.size(),  s.plots.size()};
        };
        return counts(before_) == counts(after_);
    }
    bool operator()(const editing::Element& element) const {
        const scene::Source* old = editing::sourceOf(before_, element);
        const scene::Source* now = editing::sourceOf(after_, element);
        if (!old || !now || old->runs != now->runs)
            return false;
        const std::string name = editing::nameOf(before_, element);
        if (name != editing::nameOf(after_, element))
            return false;
        if (!name.empty())
            return true;
        const scene::Range command = old->command;
        if (old->runs != 1 || !command.known())
            return false;
        if (command.to <= edit_.range.from ||
            (command.from < edit_.range.from && edit_.range.to <= command.to))
            return now->command.from == command.from;
        return command.from >= edit_.range.to &&
               now->command.from == command.from - edit_.range.size() + edit_.text.size();
    }

private:
    const scene::Scene &before_, &after_;
    const text::Edit& edit_;
};

} // namespace

struct SceneDocument::Worker {
    explicit Worker(Workshop workshop) : thread(std::move(workshop)) {}
    WorkThread thread;
};

SceneDocument::SceneDocument(Workshop workshop, QObject* parent) : QObject(parent) {
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, [this] { showAwaited(nullptr); });
    if (!workshop.read)
        return;
    worker_ = std::make_unique<Worker>(std::move(workshop));
    // Results cross to this thread; what a newer start overtook is dropped on arrival.
    const auto post = [this](auto call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    };
    worker_->thread.onRead = [this, post](std::shared_ptr<const Reading> reading) {
        post([this, reading = std::move(reading)] { didRead(reading); });
    };
    worker_->thread.onProgress = [this, post](unsigned serial, const auto& scene,
                                              const auto& motion) {
        post([this, serial, scene, motion] { didMove(serial, scene, motion); });
    };
    worker_->thread.onMoved = [this, post](std::shared_ptr<const Moved> moved) {
        post([this, moved = std::move(moved)] { didFinish(*moved); });
    };
}

SceneDocument::~SceneDocument() = default;

bool SceneDocument::hasErrors() const {
    return std::any_of(diagnostics_.begin(), diagnostics_.end(),
                       [](const auto& d) { return d.severity == scene::Severity::error; });
}

QString SceneDocument::whyNotCurrent() const {
    if (sceneIsCurrent())
        return {};
    return hasErrors() ? tr("The text has errors; the scene that is shown is an older one.")
                       : tr("The text is being read still. A moment, and it can be changed.");
}

void SceneDocument::select(std::vector<editing::Element> elements) {
    std::ranges::sort(elements);
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    std::erase_if(elements, [this](const editing::Element& element) {
        return editing::sourceOf(*shown_.scene, element) == nullptr;
    });
    if (elements == selected_)
        return;
    selected_ = std::move(elements);
    Q_EMIT selectionChanged();
}

void SceneDocument::followSelection(const scene::Scene& before, const std::string& text) {
    const std::string textBefore = std::exchange(shownText_, text);
    if (selected_.empty())
        return;
    const text::Edit edit = text::difference(textBefore, shownText_);
    const Stays stays(before, *shown_.scene, edit);
    if (stays.sameCounts() && std::ranges::all_of(selected_, stays))
        return;
    const editing::Changes changes =
        editing::changesBetween({textBefore, before}, {shownText_, *shown_.scene});
    std::vector<editing::Element> now;
    for (const editing::Element& element : selected_)
        if (const auto after = changes.now(element))
            now.push_back(*after);
    select(std::move(now));
}

void SceneDocument::setText(const std::string& text, const QString& label) {
    if (text == text_)
        return;
    endGesture();
    const text::Edit edit = text::difference(text_, text);
    if (!host_.changed) {
        done_.push_back({edit, text::inverse(text_, {edit}).front(), label});
        undone_.clear();
    }
    replaceText(text);
    if (host_.changed) // last: who is told looks at the text
        host_.changed(edit, label);
}

void SceneDocument::preview(const std::string& text, int since, const void* hand) {
    const bool silent = host_.changed && !host_.preview;
    const bool goesOn = gesture_ && gesture_->since == since && gesture_->hand == hand;
    if (silent || (!goesOn && since != revision_) || text == text_)
        return;
    if (!goesOn)
        endGesture(); // another's: its hand is gone
    if (!gesture_)
        gesture_ = Gesture{text_, since, hand};
    replaceText(text);
    if (host_.preview)
        host_.preview(text);
}

void SceneDocument::finishPreview(const std::string& text, const QString& label, int since,
                                  const void* hand) {
    if (!gesture_ && since == revision_)
        return setText(text, label);
    if (!gesture_ || gesture_->since != since || gesture_->hand != hand)
        return; // the text was changed meanwhile
    const auto gesture = std::exchange(gesture_, std::nullopt);
    const text::Edit edit = text::difference(gesture->before, text);
    const bool changes = gesture->before != text;
    if (changes && !host_.changed) {
        done_.push_back({edit, text::inverse(gesture->before, {edit}).front(), label});
        undone_.clear();
    }
    if (text != text_)
        replaceText(text);
    else
        Q_EMIT nameChanged(); // what undo takes back is another change
    if (host_.preview)
        host_.preview(text);
    if (changes && host_.changed)
        host_.changed(edit, label);
}

QString SceneDocument::overtaken() {
    return tr("The text was changed meanwhile, so the drag has ended.");
}

void SceneDocument::endGesture() {
    if (gesture_)
        finishPreview(text_, tr("Drag"), gesture_->since, gesture_->hand);
}

gestures::Ground SceneDocument::ground() {
    const int since = revision_;
    const auto hand = std::make_shared<char>(); // another for each, as long as one of these lives
    return {text_, shown_.scene, shown_.motion,
            [=, this](const std::string& text) { preview(text, since, hand.get()); },
            [=, this](const std::string& text, const std::string& label) {
                finishPreview(text, QString::fromStdString(label), since, hand.get());
            }};
}

void SceneDocument::setTextFromHost(const std::string& text) {
    if (text == text_)
        return;
    gesture_.reset();
    replaceText(text);
}

void SceneDocument::didAccept() { Q_EMIT changeAccepted(); }

void SceneDocument::didRefuse(const std::string& hostText, const QString& why) {
    setTextFromHost(hostText);
    Q_EMIT changeRefused(why);
}

void SceneDocument::setComputed(Computed computed) {
    const bool otherScene = computed.shown.scene != shown_.scene;
    const bool otherMotion = otherScene || computed.shown.motion != shown_.motion;
    const bool otherFaults = computed.current != sceneIsCurrent() ||
                             !std::ranges::equal(computed.diagnostics, diagnostics_, same);
    const auto before = shown_.scene;
    shown_ = std::move(computed.shown);
    diagnostics_ = std::move(computed.diagnostics);
    statistics_ = computed.statistics;
    sceneRevision_ = computed.current ? revision_ : -1;
    motionOf_ = shown_.scene;
    if (otherScene) {
        followSelection(*before, computed.text);
        Q_EMIT sceneChanged();
    }
    if (otherMotion)
        Q_EMIT motionChanged();
    if (otherFaults)
        Q_EMIT diagnosticsChanged();
    const bool behind = !computed.current && !hasErrors() && shown_.motion;
    if (std::exchange(hostIsBehind_, behind) != behind && computed.work == work_)
        Q_EMIT workChanged();
    setWork(computed.work);
}

bool SceneDocument::canUndo() const { return host_.undo || !done_.empty(); }

bool SceneDocument::canRedo() const { return host_.redo || !undone_.empty(); }

QString SceneDocument::undoLabel() const {
    return host_.undo || done_.empty() ? QString() : done_.back().label;
}

QString SceneDocument::redoLabel() const {
    return host_.redo || undone_.empty() ? QString() : undone_.back().label;
}

void SceneDocument::undo() {
    endGesture();
    if (host_.undo)
        return host_.undo();
    if (done_.empty())
        return;
    const Change change = done_.back();
    done_.pop_back();
    undone_.push_back(change);
    replaceText(text::applied(text_, {change.backward}));
}

void SceneDocument::redo() {
    endGesture();
    if (host_.redo)
        return host_.redo();
    if (undone_.empty())
        return;
    const Change change = undone_.back();
    undone_.pop_back();
    done_.push_back(change);
    replaceText(text::applied(text_, {change.forward}));
}

void SceneDocument::replaceText(const std::string& text) {
    text_ = text;
    ++revision_;
    Q_EMIT textChanged();
    Q_EMIT nameChanged();
    start(false);
}

void SceneDocument::recompute() {
    if (host_.recompute)
        return host_.recompute();
    start(true);
}

bool SceneDocument::motionIsStale() const { return motionOf_ != shown_.scene || hostIsBehind_; }

void SceneDocument::setLive(Live live) {
    live_ = live;
    isSlow_ = gaveUp_ = false;
    if (waitsToBeAsked() && live != Live::never)
        start(false);
    Q_EMIT workChanged();
}

void SceneDocument::start(bool asked) {
    if (!worker_)
        return;
    WorkThread::Order order;
    order.moves = asked || live_ == Live::always || (live_ == Live::automatic && !gaveUp_);
    order.haste = gesture_ ? Haste::gesture : Haste::now;
    order.overlap = slow_.overlap;
    if (live_ == Live::automatic && isSlow_ && !asked)
        order.budget = slow_.attempt;
    worker_->thread.start(text_, order);
    if (!gesture_) {
        welcome_ = worker_->thread.serial();
        awaited_.reset();
        soon_.stop();
    }
    setWork(Work::reading);
}

void SceneDocument::setWork(Work work) {
    if (work == work_)
        return;
    work_ = work;
    Q_EMIT workChanged();
}

// --- what the worker has to say ---------------------------------------------------------------

void SceneDocument::didRead(const std::shared_ptr<const Reading>& reading) {
    if (reading->serial < welcome_)
        return;
    // What is quick is shown with its motion at once; what is not, before.
    constexpr std::chrono::milliseconds quick{30};
    const bool isLast = reading->serial == worker_->thread.serial();
    if (isLast) {
        diagnostics_ = reading->diagnostics;
        Q_EMIT diagnosticsChanged();
    }
    if (reading->scene) {
        awaited_ = reading;
        if (!reading->moves || lastMotion_ > quick)
            showAwaited(nullptr);
        else if (!soon_.isActive())
            soon_.start(quick);
    }
    if (isLast)
        setWork(reading->moves ? Work::simulating : Work::none);
}

void SceneDocument::show(Shown shown, ScenePointer motionOf) {
    const auto before = shown_.scene;
    const bool wasStale = motionIsStale();
    shown_ = std::move(shown);
    motionOf_ = std::move(motionOf);
    if (before != shown_.scene) {
        followSelection(*before, awaited_ ? awaited_->text : text_);
        Q_EMIT sceneChanged();
    }
    Q_EMIT motionChanged();
    if (wasStale != motionIsStale())
        Q_EMIT workChanged();
}

// With its own motion, or with what there is of the motion of the scene before.
void SceneDocument::showAwaited(const simulation::MotionPointer* motion) {
    soon_.stop();
    if (!awaited_)
        return;
    const auto reading = awaited_;
    sceneRevision_ = reading->serial == worker_->thread.serial() ? revision_ : -1;
    const ScenePointer of = motion ? reading->scene : motionOf_;
    show({reading->scene,
          motion ? *motion : staleMotion(*shown_.scene, shown_.motion, reading->scene)},
         of);
    awaited_.reset();
}

void SceneDocument::showMotion(const ScenePointer& scene, const simulation::MotionPointer& motion) {
    if (awaited_ && awaited_->scene == scene)
        return showAwaited(&motion);
    if (scene == shown_.scene)
        return show({scene, motion}, scene);
    // While a gesture lasts: of a place where the hand was a moment ago.
    if (auto stale = staleMotion(*scene, motion, shown_.scene))
        show({shown_.scene, std::move(stale)}, scene);
}

void SceneDocument::didMove(unsigned serial, const ScenePointer& scene,
                            const simulation::MotionPointer& motion) {
    if (serial >= welcome_)
        showMotion(scene, motion);
}

void SceneDocument::learnPace(const Moved& moved) {
    if (!moved.result.cancelled) {
        lastMotion_ = moved.lasted;
        isSlow_ = moved.lasted > slow_.motion;
        gaveUp_ = false;
    } else {
        isSlow_ = isSlow_ || moved.lasted > slow_.motion;
        gaveUp_ = gaveUp_ || moved.givenUp;
    }
}

void SceneDocument::didFinish(const Moved& moved) {
    learnPace(moved);
    if (moved.serial < welcome_)
        return;
    // Who is told of a motion or of faults may change the text, and then all begins anew.
    const auto isLast = [&] { return moved.serial == worker_->thread.serial(); };
    if (!moved.result.cancelled)
        showMotion(moved.scene, moved.result.motion);
    if (!isLast())
        return;
    if (moved.result.cancelled) {
        showAwaited(nullptr);
        motionOf_.reset(); // what was drawn of it is not all
    } else {
        statistics_ = moved.result.statistics;
        reportFaults(moved);
    }
    if (isLast())
        setWork(Work::none);
}

void SceneDocument::reportFaults(const Moved& moved) {
    const text::Places places(text_);
    const auto add = [&](scene::Diagnostic said) {
        script::locate(places, said);
        diagnostics_.push_back(std::move(said));
    };
    for (const std::string& sentence : moved.result.refusal)
        add(simulation::faultOf(*moved.scene, sentence));
    if (moved.result.motion)
        std::ranges::for_each(simulation::reportOf(*moved.scene, *moved.result.motion), add);
    Q_EMIT diagnosticsChanged();
}

QString SceneDocument::open(const QString& path) {
    // LIMIT: what is read of a file. What a scene may have, script::Reader says.
    constexpr std::size_t longest = std::size_t{64} << 20;
    files::FileSystem& system = files::FileSystem::real();
    const std::string name = QFile::encodeName(path).toStdString();
    files::removeAbandonedParts(system, name);
    const files::ReadFile file = files::readFile(system, name, longest);
    if (!file.read)
        return tr("Cannot read %1: %2.").arg(path, QString::fromStdString(file.reason));
    begin(path, {name, file.stamp}, file.bytes);
    return {};
}

void SceneDocument::reset(const std::string& text, const QString& name) {
    begin({}, {}, text);
    if (!name.isEmpty())
        setName(name);
}

void SceneDocument::begin(const QString& path, const files::KnownFile& file,
                          const std::string& text) {
    path_ = path;
    file_ = file;
    name_.clear();
    savedText_ = text;
    done_.clear();
    undone_.clear();
    gesture_.reset();
    isSlow_ = gaveUp_ = false;
    Q_EMIT opened();
    replaceText(text);
}

void SceneDocument::recover(const files::KnownFile& file, const std::string& text) {
    if (file.path.empty() || !open(QFile::decodeName(file.path.c_str())).isEmpty())
        reset();
    else
        file_ = file; // what another program did with it since is asked about
    setText(text, tr("Recover"));
}

files::SaveResult SceneDocument::save(const QString& path, files::SaveOptions options) {
    endGesture();
    files::SaveResult result = files::saveFile(
        files::FileSystem::real(), QFile::encodeName(path).toStdString(), text_, file_, options);
    if (!result)
        return result;
    path_ = path;
    name_.clear(); // the file's from now on
    savedText_ = text_;
    Q_EMIT nameChanged();
    return result;
}

QString SceneDocument::name() const {
    if (!name_.isEmpty())
        return name_;
    return path_.isEmpty() ? tr("untitled") : QFileInfo(path_).fileName();
}

void SceneDocument::setName(const QString& name) {
    name_ = name;
    Q_EMIT nameChanged();
}

} // namespace views
