#include "frame/undo_actions.h"

#include "plain/plain.h"
#include "workbench/scene_document.h"

#include <QAction>
#include <QMenu>

namespace views {

void addUndoActions(QMenu* menu, SceneDocument& document) {
    QAction* undo = menu->addAction(SceneDocument::tr("&Undo"), QKeySequence::Undo, &document,
                                    &SceneDocument::undo);
    QAction* redo = menu->addAction(SceneDocument::tr("&Redo"), QKeySequence::Redo, &document,
                                    &SceneDocument::redo);
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
}

} // namespace views
