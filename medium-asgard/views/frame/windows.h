#pragma once

#include <QString>
#include <functional>

namespace views {

// The requests of a window beyond its own document.
struct Windows {
    std::function<void()> showText; // a language viewer, where what is selected is marked
    std::function<void()> openGraphicalViewer, openLanguageViewer, openTrajectoryEditor, openStudy,
        openPlots;
    // "": that of what is selected, else the one that was shown last.
    std::function<void(const QString& name)> openShapeEditor;
    std::function<void()> newShape;     // asks for a name
    std::function<void()> importShape;  // asks for a file
    std::function<void()> save;         // none: under a host, which saves
    std::function<bool()> closeViewers; // false: the user wants to stay
    // Of each draft: it becomes the text, or is dropped. False: the user wants to stay.
    std::function<bool()> settleDrafts = nullptr;
};

} // namespace views
