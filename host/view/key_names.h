// Input of Qt as the medium protocol names it, and keys back.
#pragma once

#include "ipc/messages.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace view {

// As the W3C's UI Events name them: "a", "A", " ", "ArrowLeft", "F5".
[[nodiscard]] std::string keyName(const QKeyEvent& event);
// The key that was pressed, with its modifiers; the key is 0 where Qt has none of that name.
[[nodiscard]] QKeyCombination keyOf(const ipc::Input& input);

[[nodiscard]] ipc::Input inputOf(const QKeyEvent& event);
// `pixels`: the place in the rendition, in its device pixels.
[[nodiscard]] ipc::Input inputOf(const QMouseEvent& event, QPointF pixels);
[[nodiscard]] ipc::Input inputOf(const QWheelEvent& event, QPointF pixels);
[[nodiscard]] Qt::CursorShape cursorOf(ipc::CursorShape shape);

} // namespace view
