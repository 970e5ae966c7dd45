#pragma once

#include <QString>
#include <functional>

class QMainWindow;
class QWidget;

namespace views {

// The requests of a window beyond its own document.
struct Windows {
    std::function<void()> showText; // a language viewer, where what is selected is marked
    std::function<void()> openGraphicalViewer, openLanguageViewer, openTrajectoryEditor, openStudy;
    // "": that of what is selected, else the one that was shown last.
    std::function<void(const QString& name)> openShapeEditor;
    std::function<void()> newShape;    // asks for a name
    std::function<void()> importShape; // asks for a file
    std::function<void()> save;        // none: under a host, which saves
    // A viewer that is about to close asks first; the last one asks about unsaved work. False: the
    // user wants to stay.
    std::function<bool(QMainWindow&)> mayClose;
    // The text in a pane of a window; nullptr where there is none.
    std::function<QWidget*()> makeText;
};

} // namespace views
