#include "viewers/editor.h"

#include "frame/placing.h"
#include "frame/readable.h"
#include "frame/spoken.h"
#include "plots/plots_panel.h"
#include "plots/study_window.h"
#include "shapes/shape_editor.h"
#include "shapes/shape_names.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/scene_files.h"
#include "workbench/recent_files.h"

#include <QApplication>
#include <QLayout>
#include <QSettings>

#include <algorithm>

namespace views {

namespace {

template <class Window> QList<Window*> alive(const QList<QPointer<Window>>& windows) {
    QList<Window*> result;
    for (const QPointer<Window>& window : windows)
        if (window)
            result.push_back(window);
    return result;
}

} // namespace

Editor::Editor(Workshop workshop, QObject* parent)
    : QObject(parent), document_(std::move(workshop)) {
    new ReadablePalette(this);
    speakValues();
}

Editor::~Editor() {
    // A hand that holds something lets go while all windows are there to hear of it.
    for (GraphicalViewer* viewer : graphicalViewers())
        viewer->hide();
    for (LanguageViewer* viewer : languageViewers())
        viewer->hide();
    for (QWidget* window : std::initializer_list<QWidget*>{trajectoryEditor_, shapeEditor_})
        if (window)
            window->hide();
    for (QMainWindow* viewer : viewerWindows())
        delete viewer;
    for (StudyWindow* study : alive(studies_))
        delete study;
    delete trajectoryEditor_;
    delete shapeEditor_;
}

SceneFiles& Editor::beginSession() {
    if (!files_)
        files_ = new SceneFiles(
            document_, {[this] { return settleDrafts(); }, [this] { return takeDrafts(); }}, this);
    files_->exports().pictured = [this]() -> std::optional<ToExport> {
        const auto open = graphicalViewers();
        if (open.isEmpty())
            return std::nullopt;
        SceneDisplay& display = open.back()->display();
        return ToExport{document_.shown(), display.time(),
                        display.camera(),  display.followedView().toStdString(),
                        display.display(), display.sight().size};
    };
    connect(&files_->exports(), &Exports::says, this, [this](const QString& sentence) {
        if (const auto open = graphicalViewers(); !open.isEmpty())
            open.back()->tell(sentence);
    });
    return *files_;
}

Windows Editor::windows() {
    Windows windows;
    windows.showText = [this] { showText(); };
    windows.openGraphicalViewer = [this] { openGraphicalViewer(); };
    windows.openLanguageViewer = [this] { openLanguageViewer(); };
    windows.openTrajectoryEditor = [this] { openTrajectoryEditor(); };
    windows.openShapeEditor = [this](const QString& name) { openShapeEditor(name); };
    windows.importShape = [this] { openShapeEditor()->askToImport(); };
    windows.newShape = [this] { openShapeEditor()->askForNewShape(); };
    windows.openStudy = [this] { openStudy(); };
    windows.mayClose = [this](QMainWindow& viewer) { return mayClose(viewer); };
    windows.makeText = [this] { return makeText(LanguageViewer::Place::pane); };
    if (!document_.hasHost())
        windows.save = [this] {
            if (files_)
                files_->save();
        };
    return windows;
}

Session Editor::session() {
    if (!files_)
        return {};
    return {[this] { files_->newScene(); },
            [this] { files_->open(); },
            [this] { files_->save(); },
            [this] { files_->saveAs(); },
            [this] { files_->exports().ask(); },
            firstPage_.show,
            [this] { quit(); },
            [this](QMenu* menu) {
                fillWithRecentFiles(menu, [this](const QString& path) { files_->open(path); });
            }};
}

// The selected is marked in all of them: a window that is open, else a pane of a picture.
void Editor::showText() {
    for (LanguageViewer* viewer : languageViewers())
        if (!viewer->isPane()) {
            viewer->raise();
            return viewer->activateWindow();
        }
    const auto pictures = graphicalViewers();
    for (GraphicalViewer* viewer : pictures)
        if (viewer->isActiveWindow())
            return viewer->showText();
    if (!pictures.isEmpty())
        pictures.back()->showText();
    else
        openLanguageViewer();
}

void Editor::showBeside(QMainWindow& window) {
    const char* prepared = "prepared";
    if (!window.property(prepared).toBool()) { // later it lies where it was put
        addSessionActions(window, session());
        auto* viewer = qobject_cast<GraphicalViewer*>(&window);
        if (viewer)
            viewer->buildToolBar();
        QWidget* asked = QApplication::activeWindow();
        if (viewer && asked && viewer->minimumSizeHint().width() > mostBeside(*asked)) {
            viewer->panes().hide("status"); // its picture has room beside the other one
            viewer->layout()->activate();
        }
        fitScreen(window, asked);
        if (asked) // else the window manager finds a place: beside a host's window, say
            placeBeside(window, *asked);
    }
    window.setProperty(prepared, true);
    window.show();
}

namespace {

constexpr const char* placeKey = "mainWindow/place";
constexpr const char* panesKey = "mainWindow/panes";
constexpr const char* shownKey = "mainWindow/switches";

// Beside a document a window has no place of its own.
void remember(GraphicalViewer& viewer, bool withPlace) {
    QSettings settings;
    if (withPlace)
        settings.setValue(placeKey, viewer.saveGeometry());
    settings.setValue(panesKey, viewer.panes().arrangement());
    settings.setValue(shownKey, viewer.switches().chosen());
}

} // namespace

GraphicalViewer* Editor::openMainWindow() {
    GraphicalViewer* viewer = openGraphicalViewer();
    viewer->setProperty("isMain", true);
    const QSettings settings;
    if (document_.hasHost()) {
        viewer->resize(1180, 760);
        fitScreen(*viewer, nullptr);
    } else {
        placeFirst(*viewer);
        viewer->restoreGeometry(settings.value(placeKey).toByteArray());
    }
    viewer->arrange(settings.value(panesKey).toByteArray());
    viewer->panes().hide("tour");
    if (!viewer->isMaximized() && !viewer->isFullScreen()) { // its panes may have made it larger
        viewer->layout()->activate();
        fitScreen(*viewer, nullptr);
        moveWithinScreen(*viewer, viewer->pos());
    }
    if (settings.contains(shownKey))
        viewer->switches().setShown(settings.value(shownKey).toStringList());
    return viewer;
}

const std::shared_ptr<PictureThread>& Editor::pictures() {
    if (!pictures_)
        pictures_ = std::make_shared<PictureThread>();
    return pictures_;
}

GraphicalViewer* Editor::openGraphicalViewer() {
    auto* viewer = new GraphicalViewer(document_, pictures(), windows(), ++graphicalCount_);
    // A new viewer begins where the last one is.
    if (const auto open = graphicalViewers(); !open.isEmpty())
        viewer->playback().seek(open.back()->playback().time());
    graphical_.push_back(viewer);
    connect(viewer, &QObject::destroyed, this, &Editor::viewersChanged);
    connect(&viewer->switches(), &StatusPanel::displayChanged, this, &Editor::viewersChanged);
    showBeside(*viewer);
    Q_EMIT viewersChanged();
    return viewer;
}

LanguageViewer* Editor::makeText(LanguageViewer::Place place) {
    auto* viewer = new LanguageViewer(document_, windows(), ++languageCount_, place);
    language_.push_back(viewer);
    connect(viewer, &QObject::destroyed, this, &Editor::viewersChanged);
    connect(viewer, &LanguageViewer::draftChanged, this, &Editor::viewersChanged);
    return viewer;
}

LanguageViewer* Editor::openLanguageViewer() {
    LanguageViewer* viewer = makeText(LanguageViewer::Place::window);
    showBeside(*viewer);
    Q_EMIT viewersChanged();
    return viewer;
}

TrajectoryEditor* Editor::openTrajectoryEditor() {
    if (!trajectoryEditor_)
        trajectoryEditor_ = new TrajectoryEditor(document_);
    showBeside(*trajectoryEditor_);
    trajectoryEditor_->raise();
    trajectoryEditor_->activateWindow();
    return trajectoryEditor_;
}

ShapeEditor* Editor::openShapeEditor(const QString& name) {
    if (!shapeEditor_)
        shapeEditor_ = new ShapeEditor(document_, pictures());
    if (const QString wanted = name.isEmpty() ? selectedShape(document_) : name; !wanted.isEmpty())
        shapeEditor_->showShape(wanted);
    showBeside(*shapeEditor_);
    shapeEditor_->raise();
    shapeEditor_->activateWindow();
    return shapeEditor_;
}

PlotsPanel* Editor::openPlots() {
    const auto open = graphicalViewers();
    GraphicalViewer* viewer = open.isEmpty() ? openGraphicalViewer() : open.back();
    viewer->panes().show("plots");
    return qobject_cast<PlotsPanel*>(viewer->panes().content("plots"));
}

StudyWindow* Editor::openStudy() {
    const auto& scene = document_.shown().scene;
    auto* study = new StudyWindow(scene, simulation::usualPlan(*scene), document_.name());
    studies_.removeIf([](const QPointer<StudyWindow>& one) { return one.isNull(); });
    studies_.push_back(study);
    showBeside(*study);
    return study;
}

QList<GraphicalViewer*> Editor::graphicalViewers() const { return alive(graphical_); }

QList<LanguageViewer*> Editor::languageViewers() const { return alive(language_); }

bool Editor::settleDrafts() {
    if (shapeEditor_) // what leaving it makes of a shape is part of what is saved
        shapeEditor_->settle();
    for (LanguageViewer* viewer : languageViewers())
        if (!viewer->settleDraft())
            return false;
    return true;
}

bool Editor::takeDrafts() {
    if (shapeEditor_)
        shapeEditor_->settle();
    const auto viewers = languageViewers();
    return std::ranges::all_of(viewers, [](LanguageViewer* viewer) {
        return !viewer->hasDraft() || viewer->updateDocument();
    });
}

QList<QMainWindow*> Editor::viewerWindows() const {
    QList<QMainWindow*> all;
    for (GraphicalViewer* viewer : graphicalViewers())
        all.push_back(viewer);
    for (LanguageViewer* viewer : languageViewers())
        if (!viewer->isPane())
            all.push_back(viewer);
    return all;
}

// Closing one window closes that one; the last one ends the session.
bool Editor::mayClose(QMainWindow& viewer) {
    if (closing_)
        return true;
    const auto viewers = viewerWindows();
    const bool isLast = std::ranges::none_of(
        viewers, [&](const QMainWindow* other) { return other != &viewer && other->isVisible(); });
    if (isLast && files_ && !files_->mayLeave())
        return false;
    if (viewer.property("isMain").toBool())
        remember(static_cast<GraphicalViewer&>(viewer), !document_.hasHost());
    if (isLast && files_)
        closeAll({});
    return true;
}

bool Editor::closeAll(const QList<QMainWindow*>& windows) {
    const bool before = std::exchange(closing_, true);
    const bool closed = std::ranges::all_of(windows, [](QMainWindow* one) { return one->close(); });
    closing_ = before;
    if (!closed)
        return false;
    for (StudyWindow* study : alive(studies_))
        study->close();
    if (trajectoryEditor_)
        trajectoryEditor_->close();
    if (shapeEditor_)
        shapeEditor_->close();
    return true;
}

void Editor::quit() {
    if (files_ && !files_->mayLeave())
        return;
    for (GraphicalViewer* viewer : graphicalViewers())
        if (viewer->property("isMain").toBool())
            remember(*viewer, true);
    if (closeAll(viewerWindows()) && firstPage_.close)
        firstPage_.close();
}

} // namespace views
