// New shapes and other names for them, as changes of the text, each one step of undo.
#pragma once

#include "workbench/scene_document.h"

namespace views {

// "" or the sentence that says why there can be no shape of that name.
[[nodiscard]] QString faultOfShapeName(const SceneDocument& document, const QString& name);

// "" or the sentence that says why not.
[[nodiscard]] QString makeShape(SceneDocument& document, const QString& name,
                                const std::vector<scene::Part>& parts, const QString& label);
[[nodiscard]] QString renameShape(SceneDocument& document, std::size_t shapeSet,
                                  const QString& name);

// A name that nothing in the text has, like `wish` or the names of the other shapes.
[[nodiscard]] QString unusedShapeName(const SceneDocument& document, const QString& wish = {});
// The shape of what is selected: a shape set, or a body's. "": none, or of several.
[[nodiscard]] QString selectedShape(const SceneDocument& document);

} // namespace views
