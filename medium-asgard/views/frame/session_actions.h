// Commands of every window for the whole stand-alone session: a new scene, the end.
#pragma once

#include <functional>

class QMainWindow;

namespace views {

struct Session {
    std::function<void()> newScene, quit;
};

// Into the menu File, which a window without one gets: New Scene (Ctrl+Shift+N), Quit (Ctrl+Q),
// and Close (Ctrl+W) where there was none.
void addSessionActions(QMainWindow& window, const Session& session);

// Closes it by Escape too: a window that is only looked at.
void closeByEscape(QMainWindow& window);

} // namespace views
