// Undo and Redo in a menu, with the names of what they take back or do again.
#pragma once

#include <functional>

class QAction;
class QMenu;

namespace views {

class SceneDocument;

struct UndoActions {
    QAction *undo, *redo;
};
// `document` outlives the menu. `typing` comes first: it takes back typed letters where the
// keyboard is, or gives false where there are none.
UndoActions addUndoActions(QMenu* menu, SceneDocument& document,
                           std::function<bool(bool redo)> typing = {});

} // namespace views
