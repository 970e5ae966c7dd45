// The manual in a window of its own, and the menu Help that opens it.
#pragma once

#include <QString>

class QMenu;
class QMainWindow;

namespace views {

// "Keys and Buttons" (F1) opens the manual at the chapter that is about this window.
QMenu* addHelpMenu(QMainWindow* window, const QString& chapter);

// At a chapter, or at its beginning. One at a time; it closes with the last other window.
void showManual(const QString& chapter = {});

} // namespace views
