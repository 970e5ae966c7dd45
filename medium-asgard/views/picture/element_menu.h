// The menu of what is under the pointer, or is selected: what can be done with this very element
// (dissertation 4.1.2, 4.1.5, 4.1.6), and on the background what can be made there.
#pragma once

#include "editing/element.h"
#include "handles/handles.h"

#include <QPointF>

#include <functional>
#include <memory>
#include <optional>

class QMenu;

namespace views {

class SceneDisplay;
class SceneDocument;

struct MenuPlace {
    QPointF position; // in the display
    std::optional<editing::Element> element;
    std::optional<render::Handle> handle; // of it, that is there
};

// The thing at `position`: a handle, a body, a trajectory's line, or nothing.
[[nodiscard]] MenuPlace menuPlaceAt(SceneDocument& document, SceneDisplay& display,
                                    const QPointF& position);
// The element that is selected, where it is seen.
[[nodiscard]] MenuPlace menuPlaceOfSelection(SceneDocument& document, SceneDisplay& display);

struct MenuWindows {
    std::function<void()> openTrajectoryEditor, showText, openPlots;
    std::function<void()> duplicate = {}, copy = {}, paste = {}; // what is selected
};
[[nodiscard]] std::unique_ptr<QMenu> elementMenu(SceneDocument& document, SceneDisplay& display,
                                                 const MenuPlace& place,
                                                 const MenuWindows& windows);

} // namespace views
