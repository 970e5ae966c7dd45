#include "workbench/scene_document.h"

#include "editing/followed.h"
#include "gestures/hand.h"
#include "text/difference.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace views {

SceneDocument::SceneDocument(Workshop workshop, QObject* parent) : QObject(parent) {
    due_.setSingleShot(true);
    due_.setTimerType(Qt::PreciseTimer);
    connect(&due_, &QTimer::timeout, this, &SceneDocument::update);
    if (workshop.read)
        follower_ = std::make_unique<computing::Follower>(std::move(workshop), [this] {
            QMetaObject::invokeMethod(this, &SceneDocument::update, Qt::QueuedConnection);
        });
}

SceneDocument::~SceneDocument() = default;

bool SceneDocument::hasErrors() const {
    return std::any_of(computed_.diagnostics.begin(), computed_.diagnostics.end(),
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
        return editing::sourceOf(*shown().scene, element) == nullptr;
    });
    if (elements == selected_)
        return;
    selected_ = std::move(elements);
    Q_EMIT selectionChanged();
}

void SceneDocument::followSelection(const scene::Scene& before, const std::string& textBefore,
                                    const std::vector<editing::Renamed>& renamed) {
    if (selected_.empty())
        return;
    select(
        editing::followed(selected_, {textBefore, before}, {shownText(), *shown().scene}, renamed));
}

void SceneDocument::setText(const std::string& text, const QString& label) {
    if (text == text_)
        return;
    endGesture();
    if (text == text_)
        return; // the gesture was taken back
    const text::Edit edit = text::difference(text_, text);
    if (!host_.changed) {
        history_.add(text_, edit, label, selected_);
    }
    replaceText(text);
    if (host_.changed) // last: who is told looks at the text
        host_.changed(edit, label);
}

void SceneDocument::preview(const std::string& text, int since, const void* hand,
                            Unfinished unfinished) {
    const bool silent = host_.changed && !host_.preview;
    const bool goesOn = gesture_ && gesture_->since == since && gesture_->hand == hand;
    if (silent || (!goesOn && since != revision_) || text == text_)
        return;
    if (!goesOn)
        endGesture(); // another's: its hand is gone
    if (!gesture_)
        gesture_ = Gesture{text_, since, hand, unfinished};
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
        history_.add(gesture->before, edit, label, selected_);
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

QString SceneDocument::overtaken() { return QString::fromUtf8(gestures::Hand::overtaken); }

void SceneDocument::endGesture() {
    if (!gesture_)
        return;
    const std::string text = gesture_->unfinished == Unfinished::step ? text_ : gesture_->before;
    finishPreview(text, tr("Drag"), gesture_->since, gesture_->hand);
}

gestures::Ground SceneDocument::ground() {
    const int since = revision_;
    const auto hand = std::make_shared<char>(); // another for each, as long as one of these lives
    return {text_, shown().scene, shown().motion,
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
    const bool wasAwaited = isAwaited();
    const int revision = revision_;
    const Computed before = std::exchange(computed_, std::move(computed));
    const bool otherScene = computed_.shown.scene != before.shown.scene;
    const bool otherMotion = otherScene || computed_.shown.motion != before.shown.motion;
    const bool otherFaults =
        computed_.current != sceneIsCurrent() || computed_.diagnostics != before.diagnostics;
    if (!otherScene)
        computed_.text = before.text;
    sceneRevision_ = computed_.current ? revision_ : -1;
    // Of an older text than the host's session shows: that is stale, too.
    const bool behind =
        hasHost() && !computed_.current && !hasErrors() && computed_.shown.motion != nullptr;
    computed_.stale = computed_.stale || behind;
    const bool otherStale = computed_.stale != before.stale || computed_.stopped != before.stopped;
    const Work came = std::exchange(computed_.work, before.work);
    if (otherScene) {
        const auto renamed = std::exchange(isAnother_, false)
                                 ? std::vector<editing::Renamed>()
                                 : editing::renamedBetween(*before.shown.scene, *shown().scene);
        followSelection(*before.shown.scene, before.text, renamed);
        if (wanted_.revision == sceneRevision_ && selected_.empty())
            select(wanted_.selected);
        if (!renamed.empty())
            Q_EMIT elementsRenamed(renamed);
        Q_EMIT sceneChanged();
    }
    if (otherMotion)
        Q_EMIT motionChanged();
    if (otherFaults)
        Q_EMIT diagnosticsChanged();
    // Who is told of a scene may have changed the text, and then all begins anew.
    const Work now = follower_ ? follower_->work() : revision == revision_ ? came : work();
    if (otherStale && now == work())
        Q_EMIT workChanged();
    setWork(now);
    if (wasAwaited && !isAwaited())
        Q_EMIT wasRead();
}

bool SceneDocument::canUndo() const { return host_.undo || history_.canUndo(); }

bool SceneDocument::canRedo() const { return host_.redo || history_.canRedo(); }

QString SceneDocument::undoLabel() const { return host_.undo ? QString() : history_.undoLabel(); }

QString SceneDocument::redoLabel() const { return host_.redo ? QString() : history_.redoLabel(); }

void SceneDocument::take(const History::Step& step) { replaceText(step.text, step.selected); }

void SceneDocument::undo() {
    endGesture();
    if (host_.undo)
        host_.undo();
    else if (history_.canUndo())
        take(history_.undone(text_, selected_));
}

void SceneDocument::redo() {
    endGesture();
    if (host_.redo)
        host_.redo();
    else if (history_.canRedo())
        take(history_.redone(text_, selected_));
}

void SceneDocument::replaceText(const std::string& text, History::Selected wanted) {
    text_ = text;
    ++revision_;
    wanted_ = {revision_, std::move(wanted)};
    Q_EMIT textChanged();
    Q_EMIT nameChanged();
    start(false);
}

void SceneDocument::recompute() {
    if (host_.recompute)
        return host_.recompute();
    start(true);
}

void SceneDocument::stopComputing() {
    if (host_.stopComputing)
        host_.stopComputing();
    else if (follower_)
        follower_->cancel();
}

void SceneDocument::setLive(Live live) {
    live_ = live;
    if (host_.setLive)
        host_.setLive(live);
    if (follower_)
        follower_->setLive(live);
    if (waitsToBeAsked() && live != Live::never && !host_.setLive)
        start(false);
    Q_EMIT workChanged();
}

void SceneDocument::setOverlap(std::chrono::milliseconds overlap) {
    if (follower_)
        follower_->setOverlap(overlap);
}

void SceneDocument::start(bool asked) {
    if (!follower_ && hasHost()) // the host's session reads it
        setWork(Work::reading);
    if (!follower_)
        return;
    computing::Ask ask;
    ask.asked = asked;
    ask.gesture = gesture_.has_value();
    follower_->follow(text_, ask, computing::Clock::now());
    setWork(Work::reading);
}

void SceneDocument::setWork(Work work) {
    if (work == computed_.work)
        return;
    computed_.work = work;
    Q_EMIT workChanged();
}

void SceneDocument::update() {
    const auto now = computing::Clock::now();
    follower_->update(now);
    if (const auto due = follower_->deadline())
        due_.start(std::max(std::chrono::ceil<std::chrono::milliseconds>(*due - now),
                            std::chrono::milliseconds(0)));
    else
        due_.stop();
    Computed computed;
    computed.shown = shown();
    if (follower_->shown().scene) // until then it is the empty one
        computed.shown = {follower_->shown().scene, follower_->shown().motion};
    computed.text = follower_->shownText();
    computed.diagnostics = follower_->diagnostics();
    computed.statistics = follower_->statistics();
    computed.work = follower_->work();
    computed.current = follower_->isCurrent();
    computed.stale = follower_->motionIsStale();
    computed.stopped = follower_->isCancelled();
    setComputed(std::move(computed));
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
    file_ = {path, {}, file, text};
    history_.clear();
    gesture_.reset();
    isAnother_ = true;
    Q_EMIT opened();
    replaceText(text);
}

void SceneDocument::recover(const files::KnownFile& file, const std::string& text) {
    if (file.path.empty() || !open(QFile::decodeName(file.path.c_str())).isEmpty())
        reset();
    else
        file_.known = file; // what another program did with it since is asked about
    setText(text, tr("Recover"));
}

files::SaveResult SceneDocument::save(const QString& path, files::SaveOptions options) {
    endGesture();
    files::SaveResult result =
        files::saveFile(files::FileSystem::real(), QFile::encodeName(path).toStdString(), text_,
                        file_.known, options);
    if (!result)
        return result;
    file_.path = path;
    file_.name.clear(); // the file's from now on
    file_.text = text_;
    Q_EMIT nameChanged();
    return result;
}

QString SceneDocument::name() const {
    if (!file_.name.isEmpty())
        return file_.name;
    return file_.path.isEmpty() ? tr("untitled") : QFileInfo(file_.path).fileName();
}

void SceneDocument::setName(const QString& name) {
    file_.name = name;
    Q_EMIT nameChanged();
}

} // namespace views
