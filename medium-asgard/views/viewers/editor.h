// All windows that one scene has in this process, and the document that they share.
//
// Stand-alone: runEditor(). Under a host, in `edit` mode, the session makes an Editor, gives it a
// HostLink, and opens viewers as the host asks for them.
#pragma once

#include "dialogs/windows_stay.h"
#include "language/language_viewer.h"
#include "viewers/graphical_viewer.h"
#include "workbench/scene_document.h"

#include <QList>
#include <QObject>
#include <QPointer>

namespace script {
class Reader;
}

namespace views {

class ControlPanel;
class PlotsWindow;
class ShapeEditor;
class StudyWindow;
class TrajectoryEditor;

// The workshop of this program: texts read by `reader`, motion computed by simulation/.
[[nodiscard]] Workshop workshopOf(script::Reader& reader);

class Editor : public QObject {
    Q_OBJECT
public:
    explicit Editor(Workshop workshop, QObject* parent = nullptr);
    ~Editor() override; // closes its windows

    [[nodiscard]] SceneDocument& document() { return document_; }

    GraphicalViewer* openGraphicalViewer();
    LanguageViewer* openLanguageViewer();
    ControlPanel* openControlPanel();
    TrajectoryEditor* openTrajectoryEditor(); // one at a time
    // One at a time. "": with the shape of what is selected, else the one that it shows.
    ShapeEditor* openShapeEditor(const QString& name = {});
    PlotsWindow* openPlots(); // one at a time
    // How the methods do on the scene that is shown.
    StudyWindow* openStudy();
    [[nodiscard]] QList<GraphicalViewer*> graphicalViewers() const;
    [[nodiscard]] QList<LanguageViewer*> languageViewers() const;
    // Asks about drafts; false when the user wants to stay.
    bool closeViewers();
    bool settleDrafts();

    // Which windows are open, where, and what was typed there and is no change of the text yet;
    // empty: none is. LIMIT: not what was typed into fields, windows of studies, steps of undo, and
    // drafts that are longer than all of it may be.
    [[nodiscard]] std::string windowsState() const;
    // Opens them; drafts meet the text as it is now. `notice` is told in each of the viewers.
    void restoreWindows(const std::string& state, const QString& notice);

Q_SIGNALS:
    void viewersChanged(); // one was opened or closed, or has a draft or none

private:
    [[nodiscard]] Windows windows();
    void showBeside(QMainWindow& window); // with what every window has

    SceneDocument document_;
    std::shared_ptr<PictureThread> pictures_; // of all viewers
    QPointer<ControlPanel> controlPanel_;
    QPointer<TrajectoryEditor> trajectoryEditor_;
    QPointer<ShapeEditor> shapeEditor_;
    QPointer<PlotsWindow> plots_;
    QList<QPointer<GraphicalViewer>> graphical_;
    QList<QPointer<LanguageViewer>> language_;
    QList<QPointer<StudyWindow>> studies_;
    int graphicalCount_ = 0, languageCount_ = 0;
    dialogs::WindowsStay stay_;
};

// The stand-alone editor: control panel, a graphical and a language viewer; `file` may be "".
// `reader` was made before anything else of this process. Returns the exit code.
int runEditor(int argc, char** argv, const std::string& file, script::Reader& reader);

} // namespace views
