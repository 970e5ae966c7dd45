#include "faults/close_joints.h"

#include "element_edits/closing.h"
#include "physics/assembly.h"
#include "placing/placing.h"
#include "plain/plain.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPointer>
#include <QThreadPool>
#include <QToolTip>

#include <algorithm>

namespace views {

Misplaced misplacedIn(const SceneDocument& document) {
    Misplaced found;
    for (const scene::Diagnostic& fault : document.diagnostics()) {
        found.openJoints += physics::asksToClose(fault.message) ? 1 : 0;
        found.overlaps += physics::asksToPart(fault.message) ? 1 : 0;
    }
    return found;
}

CloseJoints::CloseJoints(SceneDocument& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
    setObjectName(QStringLiteral("closeJoints"));
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    setToolTip(plain::tip(tr("Moves the free bodies as little as possible, so that joints close "
                             "and no bodies overlap, and writes it into the text")));
    connect(this, &QPushButton::clicked, this, &CloseJoints::startOrStop);
    connect(&document_, &SceneDocument::textChanged, this, &CloseJoints::textChanged);
    for (const auto signal : {&SceneDocument::diagnosticsChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, &CloseJoints::refresh);
    refresh();
}

CloseJoints::~CloseJoints() { cancel(); }

void CloseJoints::refresh() {
    const auto [open, overlaps] = misplacedIn(document_);
    setText(search_     ? tr("Stop Moving")
            : open > 1  ? tr("Close Them")
            : open == 1 ? tr("Close It")
                        : tr("Move Apart"));
    setVisible(search_ || (open + overlaps > 0 && document_.sceneIsCurrent()));
}

void CloseJoints::startOrStop() {
    if (!search_)
        return start();
    cancel();
    reason_ = tr("Stopped: all bodies are where they were.");
    say();
}

void CloseJoints::mouseDoubleClickEvent(QMouseEvent* event) { event->accept(); }

void CloseJoints::cancel() {
    if (!search_)
        return;
    *search_ = true;
    search_.reset();
    refresh();
}

void CloseJoints::textChanged() {
    if (!search_)
        return;
    cancel();
    reason_ = tr("The text has changed meanwhile: try again.");
    say();
}

void CloseJoints::start() {
    reason_ = document_.whyNotCurrent();
    if (!reason_.isEmpty())
        return say();
    search_ = std::make_shared<std::atomic<bool>>(false);
    refresh();
    QThreadPool::globalInstance()->start([button = QPointer<CloseJoints>(this),
                                          text = document_.text(), scene = document_.shown().scene,
                                          search = search_] {
        const auto take = [button, now = closed(text, scene, search), search] {
            if (button)
                button->take(now, search);
        };
        QMetaObject::invokeMethod(qApp, take, Qt::QueuedConnection);
    });
}

// On the other thread.
CloseJoints::Closed CloseJoints::closed(const std::string& text,
                                        const std::shared_ptr<const scene::Scene>& scene,
                                        const Search& search) {
    const physics::Assembly assembly = simulation::placed(*scene, [&] { return search->load(); });
    if (assembly.cancelled)
        return {};
    if (!assembly.reason.empty())
        return {{}, assembly.reason};
    std::vector<editing::NewPlace> places;
    for (const physics::Assembly::Moved& moved : assembly.moved)
        places.push_back({moved.body, moved.pose, moved.turns});
    const editing::Closing closing =
        editing::closingEdits(editing::Mapper(text, scene), *scene, places);
    return {text::applied(text, closing.edits), closing.reason};
}

void CloseJoints::take(const Closed& now, const Search& search) {
    if (search != search_)
        return; // it was ended
    search_.reset();
    refresh();
    reason_ = QString::fromStdString(now.reason);
    if (!reason_.isEmpty())
        return say();
    document_.setText(now.text, misplacedIn(document_).openJoints > 0 ? tr("Close Joints")
                                                                      : tr("Move Bodies Apart"));
}

void CloseJoints::say() const {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), plain::tip(reason_));
}

} // namespace views
