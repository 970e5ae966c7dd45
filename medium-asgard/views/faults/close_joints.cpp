#include "faults/close_joints.h"

#include "element_edits/closing.h"
#include "physics/assembly.h"
#include "plain/plain.h"

#include <QToolTip>

#include <algorithm>

namespace views {
namespace {

struct Closed {
    std::string text, reason;
};

Closed closed(const std::string& text, const std::shared_ptr<const scene::Scene>& scene) {
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

} // namespace

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
    setText(open > 1 ? tr("Close Them") : tr("Close It"));
    setVisible(open > 0 && document_.sceneIsCurrent());
}

void CloseJoints::close() {
    reason_ = document_.whyNotCurrent();
    if (reason_.isEmpty()) {
        const Closed now = closed(document_.text(), document_.shown().scene);
        reason_ = QString::fromStdString(now.reason);
        if (reason_.isEmpty())
            document_.setText(now.text, tr("Close Joints"));
    }
    if (!reason_.isEmpty())
        QToolTip::showText(mapToGlobal(rect().bottomLeft()), plain::tip(reason_), this);
}

} // namespace views
