// Undo and Redo in a menu, with the names of what they take back or do again.
#pragma once

class QMenu;

namespace views {

class SceneDocument;

// `document` outlives the menu.
void addUndoActions(QMenu* menu, SceneDocument& document);

} // namespace views
