// The viewers' icons, drawn in the palette's own colours, sharp at any scale.
#pragma once

#include <QIcon>
#include <QPalette>

namespace views {

enum class Icon { first, stepBack, play, pause, stop, stepForward, last, loop, frameAll };

[[nodiscard]] QIcon icon(Icon which, const QPalette& palette);

// A ball on a rod, for windows and task bars.
[[nodiscard]] QIcon applicationIcon();

} // namespace views
