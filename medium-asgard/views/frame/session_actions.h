// Commands of every window for the whole stand-alone session: its file, another scene, the end.
#pragma once

#include <functional>

class QMainWindow;
class QMenu;

namespace views {

struct Session {
    std::function<void()> newScene, open, save, saveAs, exports, firstPage, quit;
    std::function<void(QMenu*)> fillRecent; // with the files that were opened last
};

// Into the menu File, which a window without one gets: New Scene, Open, Open Recent, Save, Save As,
// Export and Quit, and Close where there was none. Without `quit`, under a host, only Close.
// Escape in one of the window's menus gives the keyboard back to who had it.
void addSessionActions(QMainWindow& window, const Session& session);

// Closes it by Escape too: a window that is only looked at.
void closeByEscape(QMainWindow& window);

} // namespace views
