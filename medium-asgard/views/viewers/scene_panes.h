// The panes of a viewer that are about its scene: what is in it, what is selected, what is wrong.
#pragma once

#include "frame/panes.h"
#include "frame/windows.h"
#include "workbench/scene_document.h"

#include <functional>

class QPoint;

namespace views {

class Playback;
class SceneDisplay;

// `showMenu`: of an element, at a place of the screen. All outlive the panes.
void addScenePanes(
    Panes& panes, SceneDocument& document, SceneDisplay& display, Playback& playback,
    const Windows& windows,
    const std::function<void(const editing::Element&, const QPoint& global)>& showMenu);

} // namespace views
