// The icons of windows, drawn by one pen: lines in the palette's own colour, and one other colour
// for the thing that a command makes. Sharp at any scale.
#pragma once

#include <QIcon>
#include <QPalette>

namespace views {

enum class Icon {
    first,
    stepBack,
    play,
    pause,
    stop,
    stepForward,
    last,
    loop,
    frameAll,
    newScene,
    open,
    save,
    undo,
    redo,
    body,
    force,
    joint,
    link,
    rope,
    text,
    plots,
    help,
    add,
    remove,
    zoomIn,
    zoomOut,
    close,
    tearOff
};

[[nodiscard]] QIcon icon(Icon which, const QPalette& palette);

// A ball on a rod, for windows and task bars.
[[nodiscard]] QIcon applicationIcon();

} // namespace views
