// The Create menu of a graphical viewer (dissertation 4.1.2 to 4.1.8), and what of it needs a
// small dialog.
#pragma once

#include "recipes/recipes.h"
#include "workbench/scene_document.h"

#include <functional>

class QMenu;

namespace views {

class SceneDisplay;

// Filled anew each time it opens: it lists the scene's shapes. All three live as long as the menu.
void buildCreateMenu(QMenu* menu, SceneDocument& document, SceneDisplay& display);

// The types of joints, with a tip for each, and a gear; `add` puts a command into the menu, which
// begins its recipe.
void addJointTypes(QMenu* menu,
                   const std::function<void(const QString&, std::function<Recipe()>)>& add);

// With arrows as long as the display draws them, and the gravity that other bodies have.
[[nodiscard]] Recipe newWeight(SceneDisplay& display);

// The dialog of a new plot, and the plot.
void askForPlot(SceneDocument& document, SceneDisplay& display);

} // namespace views
