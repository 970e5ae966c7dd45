// The scenes that were opened last, over all sessions of the user.
#pragma once

#include <QStringList>

class QMenu;

#include <functional>

namespace views {

// The last one first; files that are no more are not among them.
[[nodiscard]] QStringList recentFiles();
void rememberFile(const QString& path);
// Fills the menu each time it is opened. `open` is called with the path of the one chosen.
void fillWithRecentFiles(QMenu* menu, std::function<void(const QString& path)> open);

// Settings lay in a folder without our name once, "Unknown Organization": what is there becomes
// ours, if we have none yet.
void takeOverOldSettings();

} // namespace views
