// Which widget commands of a menu are for.
#pragma once

class QWidget;

namespace controls {

// The one that has the keyboard, or had it before a menu took it; null: none.
[[nodiscard]] QWidget* keyboardWidget();

} // namespace controls
