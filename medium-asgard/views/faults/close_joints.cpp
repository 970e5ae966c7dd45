#include "faults/close_joints.h"

#include "element_edits/closing.h"
#include "physics/assembly.h"
#include "plain/plain.h"

#include <QApplication>
#include <QPointer>
#include <QThreadPool>
#include <QToolTip>

#include <algorithm>

namespace views {

int openJoints(const SceneDocument& document) {
    return static_cast<int>(
        std::ranges::count_if(document.diagnostics(), [](const scene::Diagnostic& fault) {
            return physics::asksToAssemble(fault.message);
        }));
}

CloseJoints::CloseJoints(SceneDocument& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
    setObjectName(QStringLiteral("closeJoints"));
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    setToolTip(plain::tip(tr("Moves the free bodies as little as possible, so that the joints "
                             "close, and writes it into the text")));
    connect(this, &QPushButton::clicked, this, &CloseJoints::close);
    for (const auto signal : {&SceneDocument::diagnosticsChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, &CloseJoints::refresh);
    refresh();
}

void CloseJoints::refresh() {
    const int open = openJoints(document_);
    setText(closing_ ? tr("Closing…") : open > 1 ? tr("Close Them") : tr("Close It"));
    setEnabled(!closing_);
    setVisible(open > 0 && document_.sceneIsCurrent());
}

void CloseJoints::close() {
    reason_ = document_.whyNotCurrent();
    if (!reason_.isEmpty())
        return say();
    closing_ = true;
    refresh();
    QThreadPool::globalInstance()->start([button = QPointer<CloseJoints>(this),
                                          text = document_.text(), scene = document_.shown().scene,
                                          revision = document_.revision()] {
        const auto take = [button, now = closed(text, scene), revision] {
            if (button)
                button->take(now, revision);
        };
        QMetaObject::invokeMethod(qApp, take, Qt::QueuedConnection);
    });
}

// On the other thread.
CloseJoints::Closed CloseJoints::closed(const std::string& text,
                                        const std::shared_ptr<const scene::Scene>& scene) {
    const physics::Assembly assembly = physics::assembled(*scene);
    if (!assembly.reason.empty())
        return {{}, assembly.reason};
    std::vector<editing::NewPlace> places;
    for (const physics::Assembly::Moved& moved : assembly.moved)
        places.push_back({moved.body, moved.pose, moved.turns});
    const editing::Closing closing =
        editing::closingEdits(editing::Mapper(text, scene), *scene, places);
    return {text::applied(text, closing.edits), closing.reason};
}

void CloseJoints::take(const Closed& now, int revision) {
    closing_ = false;
    refresh();
    reason_ = revision == document_.revision()
                  ? QString::fromStdString(now.reason)
                  : tr("The text has changed meanwhile: close them again.");
    if (!reason_.isEmpty())
        return say();
    document_.setText(now.text, tr("Close Joints"));
}

void CloseJoints::say() const {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), plain::tip(reason_));
}

} // namespace views
