#include "frame/undo_actions.h"

#include "plain/plain.h"
#include "workbench/scene_document.h"

#include <QAction>
#include <QMenu>

namespace views {

UndoActions addUndoActions(QMenu* menu, SceneDocument& document,
                           std::function<bool(bool redo)> typing) {
    const auto add = [&](const QString& label, QKeySequence::StandardKey key, bool redo) {
        return menu->addAction(plain::ours(label), key, &document, [&document, typing, redo] {
            if (typing && typing(redo))
                return;
            redo ? document.redo() : document.undo();
        });
    };
    QAction* undo = add(SceneDocument::tr("&Undo"), QKeySequence::Undo, false);
    QAction* redo = add(SceneDocument::tr("&Redo"), QKeySequence::Redo, true);
    undo->setObjectName("undo");
    redo->setObjectName("redo");
    const auto show = [undo, redo, &document] {
        const auto named = [](const QString& what, const QString& label) {
            return label.isEmpty() ? what : what + QLatin1Char(' ') + plain::caption(label);
        };
        undo->setText(plain::ours(named(SceneDocument::tr("&Undo"), document.undoLabel())));
        redo->setText(plain::ours(named(SceneDocument::tr("&Redo"), document.redoLabel())));
        undo->setEnabled(document.canUndo());
        redo->setEnabled(document.canRedo());
    };
    QObject::connect(&document, &SceneDocument::nameChanged, menu, show);
    show();
    return {undo, redo};
}

} // namespace views
