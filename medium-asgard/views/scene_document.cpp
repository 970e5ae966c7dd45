#include "views/scene_document.h"

#include "editing/changes.h"
#include "script/places.h"
#include "simulation/report.h"
#include "views/worker.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <utility>

namespace views {

namespace {

std::string applied(const std::string& text, std::size_t from, std::size_t to,
                    const std::string& replacement) {
    return text.substr(0, from) + replacement + text.substr(to);
}

bool same(const scene::Diagnostic& a, const scene::Diagnostic& b) {
    return a.severity == b.severity && a.range.from == b.range.from && a.range.to == b.range.to &&
           a.line == b.line && a.column == b.column && a.message == b.message &&
           a.suggestion == b.suggestion;
}

} // namespace

struct SceneDocument::Worker {
    explicit Worker(Workshop workshop) : thread(std::move(workshop)) {}
    WorkThread thread;
};

SceneDocument::SceneDocument(Workshop workshop, QObject* parent) : QObject(parent) {
    if (!workshop.read)
        return;
    worker_ = std::make_unique<Worker>(std::move(workshop));
    // Results cross to this thread; what a newer start overtook is dropped on arrival.
    const auto post = [this](auto call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    };
    worker_->thread.onRead = [this, post](unsigned serial, const script::ReadResult& result) {
        post([this, serial, result] { didRead(serial, result); });
    };
    worker_->thread.onProgress = [this, post](unsigned serial, const auto& scene,
                                              const auto& motion) {
        post([this, serial, scene, motion] { didMove(serial, scene, motion); });
    };
    worker_->thread.onFinished = [this, post](unsigned serial, const auto& scene,
                                              const simulation::Result& result) {
        post([this, serial, scene, result] { didFinish(serial, scene, result); });
    };
}

SceneDocument::~SceneDocument() = default;

bool SceneDocument::hasErrors() const {
    return std::any_of(diagnostics_.begin(), diagnostics_.end(),
                       [](const auto& d) { return d.severity == scene::Severity::error; });
}

void SceneDocument::select(std::vector<editing::Element> elements) {
    std::ranges::sort(elements);
    const auto same = std::ranges::unique(elements);
    elements.erase(same.begin(), same.end());
    std::erase_if(elements, [this](const editing::Element& element) {
        return editing::sourceOf(*shown_.scene, element) == nullptr;
    });
    if (elements == selected_)
        return;
    selected_ = std::move(elements);
    Q_EMIT selectionChanged();
}

void SceneDocument::followSelection(const scene::Scene& before) {
    const std::string textBefore = std::exchange(shownText_, text_);
    if (selected_.empty())
        return;
    const editing::Changes changes =
        editing::changesBetween({textBefore, before}, {text_, *shown_.scene});
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
    const TextEdit edit = editBetween(text_, text);
    if (!host_.changed) {
        done_.push_back({edit, text_.substr(edit.from, edit.to - edit.from), label});
        undone_.clear();
    }
    replaceText(text);
    if (host_.changed) // last: who is told looks at the text
        host_.changed(edit, label);
}

void SceneDocument::preview(const std::string& text, int since) {
    const bool silent = host_.changed && !host_.preview;
    if (gesture_ && gesture_->since != since)
        endGesture(); // its hand is gone
    if (silent || (!gesture_ && since != revision_) || text == text_)
        return;
    if (!gesture_)
        gesture_ = Gesture{text_, since};
    replaceText(text);
    if (host_.preview)
        host_.preview(text);
}

void SceneDocument::finishPreview(const std::string& text, const QString& label, int since) {
    if (!gesture_ && since == revision_)
        return setText(text, label);
    if (!gesture_ || gesture_->since != since)
        return; // the text was changed meanwhile
    const auto gesture = std::exchange(gesture_, std::nullopt);
    const TextEdit edit = editBetween(gesture->before, text);
    const bool changes = gesture->before != text;
    if (changes && !host_.changed) {
        done_.push_back({edit, gesture->before.substr(edit.from, edit.to - edit.from), label});
        undone_.clear();
    }
    if (text != text_)
        replaceText(text);
    if (host_.preview)
        host_.preview(text);
    if (changes && host_.changed)
        host_.changed(edit, label);
}

void SceneDocument::endGesture() {
    if (gesture_)
        finishPreview(text_, tr("Drag"), gesture_->since);
}

gestures::Ground SceneDocument::ground() {
    const int since = revision_;
    return {text_, shown_.scene, shown_.motion,
            [this, since](const std::string& text) { preview(text, since); },
            [this, since](const std::string& text, const std::string& label) {
                finishPreview(text, QString::fromStdString(label), since);
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
    if (otherScene) {
        followSelection(*before);
        Q_EMIT sceneChanged();
    }
    if (otherMotion)
        Q_EMIT motionChanged();
    if (otherFaults)
        Q_EMIT diagnosticsChanged();
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
    replaceText(applied(text_, change.edit.from, change.edit.from + change.edit.text.size(),
                        change.removed));
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
    replaceText(applied(text_, change.edit.from, change.edit.to, change.edit.text));
}

void SceneDocument::replaceText(const std::string& text) {
    text_ = text;
    ++revision_;
    Q_EMIT textChanged();
    Q_EMIT nameChanged();
    start();
}

void SceneDocument::recompute() {
    if (host_.recompute)
        return host_.recompute();
    start();
}

void SceneDocument::start() {
    if (!worker_)
        return;
    worker_->thread.start(text_);
    setWork(Work::reading);
}

void SceneDocument::setWork(Work work) {
    if (work == work_)
        return;
    work_ = work;
    Q_EMIT workChanged();
}

void SceneDocument::didRead(unsigned serial, const script::ReadResult& result) {
    if (serial != worker_->thread.serial())
        return;
    diagnostics_ = result.diagnostics;
    Q_EMIT diagnosticsChanged();
    setWork(result.usable ? Work::simulating : Work::none);
}

void SceneDocument::didMove(unsigned serial, const std::shared_ptr<const scene::Scene>& scene,
                            const simulation::MotionPointer& motion) {
    if (serial != worker_->thread.serial())
        return;
    const auto before = shown_.scene;
    shown_ = {scene, motion};
    sceneRevision_ = revision_;
    if (before != scene) {
        followSelection(*before);
        Q_EMIT sceneChanged();
    }
    Q_EMIT motionChanged();
}

void SceneDocument::didFinish(unsigned serial, const std::shared_ptr<const scene::Scene>& scene,
                              const simulation::Result& result) {
    if (serial != worker_->thread.serial())
        return;
    statistics_ = result.statistics;
    const script::Places places(text_);
    const auto add = [&](scene::Diagnostic said) {
        places.locate(said);
        diagnostics_.push_back(std::move(said));
    };
    for (const std::string& sentence : result.refusal)
        add(simulation::faultOf(*scene, sentence));
    if (result.motion)
        std::ranges::for_each(simulation::reportOf(*scene, *result.motion), add);
    didMove(serial, scene, result.motion);
    Q_EMIT diagnosticsChanged();
    setWork(Work::none);
}

QString SceneDocument::open(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tr("Cannot read %1: %2.").arg(path, file.errorString());
    const QByteArray bytes = file.readAll();
    begin(path, bytes.toStdString());
    return {};
}

void SceneDocument::reset() { begin({}, {}); }

void SceneDocument::begin(const QString& path, const std::string& text) {
    path_ = path;
    savedText_ = text;
    done_.clear();
    undone_.clear();
    gesture_.reset();
    Q_EMIT opened();
    replaceText(text);
}

QString SceneDocument::save(const QString& path) {
    endGesture();
    // Written beside it and renamed: a full disk leaves the old file as it was.
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(text_.data(), static_cast<qint64>(text_.size())) !=
            static_cast<qint64>(text_.size()) ||
        !file.commit())
        return tr("Cannot write %1: %2.").arg(path, file.errorString());
    path_ = path;
    savedText_ = text_;
    Q_EMIT nameChanged();
    return {};
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
