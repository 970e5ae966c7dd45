// All windows that one scene has in this process, and the document that they share.
//
// Stand-alone: runEditor(). Under a host, in `edit` mode, the session makes an Editor, gives it a
// HostLink, and opens viewers as the host asks for them.
#pragma once

#include "dialogs/windows_stay.h"
#include "frame/session_actions.h"
#include "language/language_viewer.h"
#include "viewers/graphical_viewer.h"
#include "workbench/scene_document.h"

#include <QList>
#include <QObject>
#include <QPointer>

#include <functional>
#include <utility>

namespace views {

class PlotsPanel;
class SceneFiles;
class ShapeEditor;
class StudyWindow;
class TrajectoryEditor;

class Editor : public QObject {
    Q_OBJECT
public:
    explicit Editor(Workshop workshop, QObject* parent = nullptr);
    ~Editor() override; // closes its windows

    [[nodiscard]] SceneDocument& document() { return document_; }

    // From now on windows have the commands of a session with a file of its own, and the last one
    // to be closed asks about unsaved work.
    SceneFiles& beginSession();
    struct FirstPageActions {
        std::function<void()> show, close; // none: there is no such page
    };
    void setFirstPage(FirstPageActions actions) { firstPage_ = std::move(actions); }

    // A graphical viewer with the panes that one begins with, arranged as the last time.
    GraphicalViewer* openMainWindow();
    GraphicalViewer* openGraphicalViewer();
    LanguageViewer* openLanguageViewer();
    TrajectoryEditor* openTrajectoryEditor(); // one at a time
    // One at a time. "": with the shape of what is selected, else the one that it shows.
    ShapeEditor* openShapeEditor(const QString& name = {});
    PlotsPanel* openPlots(); // in the last graphical viewer
    // How the methods do on the scene that is shown.
    StudyWindow* openStudy();
    [[nodiscard]] QList<GraphicalViewer*> graphicalViewers() const;
    [[nodiscard]] QList<LanguageViewer*> languageViewers() const; // in windows and in panes
    // All of them, in the order in which they were opened.
    [[nodiscard]] QList<QMainWindow*> viewerWindows() const;
    // Asks about drafts; false when the user wants to stay.
    bool closeAll(const QList<QMainWindow*>& windows);
    bool settleDrafts();
    void quit(); // asks about unsaved work, then closes all

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
    [[nodiscard]] Session session();
    const std::shared_ptr<PictureThread>& pictures();
    LanguageViewer* makeText(LanguageViewer::Place place);
    void showText();
    bool takeDrafts();
    bool mayClose(QMainWindow& viewer);
    void showBeside(QMainWindow& window); // with what every window has

    SceneDocument document_;
    std::shared_ptr<PictureThread> pictures_; // of all windows
    SceneFiles* files_ = nullptr;             // none: under a host
    FirstPageActions firstPage_;
    QPointer<TrajectoryEditor> trajectoryEditor_;
    QPointer<ShapeEditor> shapeEditor_;
    QList<QPointer<GraphicalViewer>> graphical_;
    QList<QPointer<LanguageViewer>> language_;
    QList<QPointer<StudyWindow>> studies_;
    int graphicalCount_ = 0, languageCount_ = 0;
    bool closing_ = false; // all of them: nobody asks again
    dialogs::WindowsStay stay_;
};

} // namespace views
