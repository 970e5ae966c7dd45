// The menu Shapes of a graphical viewer: new shapes, from the library or by hand, and the editor.
#pragma once

class QMenu;

namespace views {

class SceneDocument;
struct Windows;

// Both outlive the menu.
void buildShapesMenu(QMenu* menu, SceneDocument& document, const Windows& windows);

} // namespace views
