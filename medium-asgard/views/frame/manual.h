// The manual in a window of its own, and the menu Help that opens it.
#pragma once

#include <QString>

#include <functional>

class QMenu;
class QMainWindow;
class QWidget;

namespace views {

// "What Is This?" (F1) shows the page about the thing under the pointer, by setHelp() or as
// `pointed` says it, else the one about the window.
QMenu* addHelpMenu(QMainWindow* window, const QString& topic,
                   std::function<QString(const QWidget&)> pointed = {});

// At a chapter, or at its beginning. One at a time; it closes with the last other window.
void showManual(const QString& chapter = {});

} // namespace views
