// The menu Help of every window.
#pragma once

#include <QString>

#include <functional>

class QMainWindow;
class QMenu;
class QWidget;

namespace views {

// "What Is This?" (F1) shows the page about the thing under the pointer, by setHelp() or as
// `pointed` says it, else the one about the window.
QMenu* addHelpMenu(QMainWindow* window, const QString& topic,
                   std::function<QString(const QWidget&)> pointed = {});

} // namespace views
