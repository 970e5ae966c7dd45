#include "viewers/editor.h"

#include "frame/icons.h"
#include "frame/readable.h"
#include "frame/session_actions.h"
#include "frame/spoken.h"
#include "plain/plain.h"
#include "plain/qt_messages.h"
#include "plots/plots_window.h"
#include "plots/study_window.h"
#include "resimulation/resimulation.h"
#include "script/reader.h"
#include "shapes/shape_editor.h"
#include "shapes/shape_names.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/control_panel.h"
#include "workbench/autosave.h"
#include "workbench/recent_files.h"

#include <QApplication>
#include <QScreen>
#include <QTimer>

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

constexpr int frame = 8, title = 32; // of the window manager, around a window

// No new window is larger than its screen: with large letters a screen is small.
void fitScreen(QWidget& window, const QWidget* asked) {
    const QSize room = (asked ? asked : &window)->screen()->availableGeometry().size();
    window.resize(window.size().boundedTo(room - QSize(2 * frame, frame + title)));
}

// To that place, or as near to it as the screen shows the whole window.
void moveWithin(const QRect& screen, QWidget& window, int x, int y) {
    const auto within = [](int at, int low, int high) {
        return std::clamp(at, low, std::max(low, high));
    };
    const QSize least = window.size().expandedTo(window.minimumSizeHint());
    window.move(within(x, screen.left(), screen.right() - least.width() - frame),
                within(y, screen.top(), screen.bottom() - least.height() - frame - title));
}

// A new window lies a little below and right of the one that asked for it, within the screen.
void placeBeside(QWidget& window, const QWidget* asked) {
    constexpr int step = 40;
    moveWithin(asked->screen()->availableGeometry(), window, asked->x() + step, asked->y() + step);
}

// Control panel at the top left, the language viewer below it, the graphical one beside them, as
// far as the screen allows (dissertation, Figure 4.1). On a small screen they overlap.
void arrange(ControlPanel& panel, GraphicalViewer& graphical, LanguageViewer& language) {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    const int gap = 12;
    const int left = std::max(panel.sizeHint().width(), screen.width() * 9 / 25);
    panel.move(screen.left() + gap, screen.top() + title);
    const int under = panel.sizeHint().height() + 2 * title + gap;
    constexpr int leastHeight = 280;
    language.resize(left - 2 * gap, std::max(leastHeight, screen.height() - under - 2 * gap));
    moveWithin(screen, language, screen.left() + gap, screen.top() + under);
    // The picture four to three, as scenes' views are made for, or as high as what stands beside
    // it.
    constexpr int beside = 232, below = 168, panelHeight = 610; // what else stands in the window
    const int width = screen.width() - left - 2 * gap;
    graphical.resize(width, std::min(screen.height() - title - 3 * gap,
                                     std::max((width - beside) * 3 / 4, panelHeight) + below));
    moveWithin(screen, graphical, screen.left() + left + gap / 2, screen.top() + title);
}

} // namespace

Workshop workshopOf(script::Reader& reader) {
    return {[&reader](std::string_view text) { return reader.read(text); },
            [&reader] { reader.cancel(); },
            [kept = std::make_shared<simulation::Resimulation>()](
                const auto& scene, const auto& options, const auto& observer) {
                return kept->update(scene, options, observer);
            }};
}

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
    for (QWidget* window :
         std::initializer_list<QWidget*>{plots_, trajectoryEditor_, shapeEditor_, controlPanel_})
        if (window)
            window->hide();
    for (GraphicalViewer* viewer : graphicalViewers())
        delete viewer;
    for (LanguageViewer* viewer : languageViewers())
        delete viewer;
    for (StudyWindow* study : alive(studies_))
        delete study;
    delete plots_;
    delete trajectoryEditor_;
    delete shapeEditor_;
    delete controlPanel_;
}

Windows Editor::windows() {
    Windows windows;
    windows.showText = [this] {
        const auto open = languageViewers();
        QWidget* viewer = open.isEmpty() ? openLanguageViewer() : open.back();
        viewer->raise();
        viewer->activateWindow();
    };
    windows.openGraphicalViewer = [this] { openGraphicalViewer(); };
    windows.openLanguageViewer = [this] { openLanguageViewer(); };
    windows.openTrajectoryEditor = [this] { openTrajectoryEditor(); };
    windows.openShapeEditor = [this](const QString& name) { openShapeEditor(name); };
    windows.importShape = [this] { openShapeEditor()->askToImport(); };
    windows.newShape = [this] { openShapeEditor()->askForNewShape(); };
    windows.openPlots = [this] { openPlots(); };
    windows.openStudy = [this] { openStudy(); };
    windows.closeViewers = [this] { return closeViewers(); };
    windows.settleDrafts = [this] { return settleDrafts(); };
    if (!document_.hasHost())
        windows.save = [this] {
            if (controlPanel_)
                controlPanel_->save(QApplication::activeWindow());
        };
    return windows;
}

void Editor::showBeside(QMainWindow& window) {
    Session session;
    if (controlPanel_) {
        session.newScene = [this] { controlPanel_->newScene(QApplication::activeWindow()); };
        session.quit = [this] { controlPanel_->close(); };
    }
    const char* prepared = "prepared";
    if (!window.property(prepared).toBool()) { // later it lies where it was put
        addSessionActions(window, session);
        const QWidget* asked = QApplication::activeWindow();
        fitScreen(window, asked);
        if (asked) // else the window manager finds a place: beside a host's window, say
            placeBeside(window, asked);
    }
    window.setProperty(prepared, true);
    window.show();
}

GraphicalViewer* Editor::openGraphicalViewer() {
    if (!pictures_)
        pictures_ = std::make_shared<PictureThread>();
    auto* viewer = new GraphicalViewer(document_, pictures_, windows(), ++graphicalCount_);
    // A new viewer begins where the last one is.
    if (const auto open = graphicalViewers(); !open.isEmpty())
        viewer->playback().seek(open.back()->playback().time());
    graphical_.push_back(viewer);
    connect(viewer, &QObject::destroyed, this, &Editor::viewersChanged);
    showBeside(*viewer);
    Q_EMIT viewersChanged();
    return viewer;
}

LanguageViewer* Editor::openLanguageViewer() {
    auto* viewer = new LanguageViewer(document_, windows(), ++languageCount_);
    language_.push_back(viewer);
    connect(viewer, &QObject::destroyed, this, &Editor::viewersChanged);
    connect(viewer, &LanguageViewer::draftChanged, this, &Editor::viewersChanged);
    showBeside(*viewer);
    Q_EMIT viewersChanged();
    return viewer;
}

ControlPanel* Editor::openControlPanel() {
    if (!controlPanel_)
        controlPanel_ = new ControlPanel(document_, windows());
    controlPanel_->exports().pictured = [this]() -> std::optional<ToExport> {
        const auto open = graphicalViewers();
        if (open.isEmpty())
            return std::nullopt;
        SceneDisplay& display = open.back()->display();
        return ToExport{document_.shown(), display.time(),
                        display.camera(),  display.followedView().toStdString(),
                        display.display(), display.sight().size};
    };
    controlPanel_->show();
    return controlPanel_;
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
        shapeEditor_ = new ShapeEditor(document_);
    if (const QString wanted = name.isEmpty() ? selectedShape(document_) : name; !wanted.isEmpty())
        shapeEditor_->showShape(wanted);
    showBeside(*shapeEditor_);
    shapeEditor_->raise();
    shapeEditor_->activateWindow();
    return shapeEditor_;
}

PlotsWindow* Editor::openPlots() {
    if (!plots_)
        plots_ = new PlotsWindow(document_);
    showBeside(*plots_);
    plots_->raise();
    plots_->activateWindow();
    return plots_;
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

bool Editor::closeViewers() {
    for (LanguageViewer* viewer : languageViewers())
        if (!viewer->close())
            return false;
    for (GraphicalViewer* viewer : graphicalViewers())
        viewer->close();
    for (StudyWindow* study : alive(studies_))
        study->close();
    if (plots_)
        plots_->close();
    if (trajectoryEditor_)
        trajectoryEditor_->close();
    if (shapeEditor_)
        shapeEditor_->close();
    return true;
}

int runEditor(int argc, char** argv, const std::string& file, script::Reader& reader) {
    plain::printQtMessages("asgard", plain::QtMessages::all);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("asgard"));
    QApplication::setApplicationName(QStringLiteral("asgard"));
    takeOverOldSettings();
    QApplication::setApplicationDisplayName(QStringLiteral("Asgard"));
    QApplication::setQuitOnLastWindowClosed(true);
    QApplication::setWindowIcon(applicationIcon());
    Editor editor(workshopOf(reader));
    ControlPanel* panel = editor.openControlPanel();
    SceneDocument& document = editor.document();
    const QString path = QString::fromStdString(file);
    if (!path.isEmpty()) {
        if (const QString fault = document.open(path); !fault.isEmpty()) {
            plain::Message::tell(QMessageBox::Critical, panel, QStringLiteral("Asgard"), fault);
            return 1;
        }
        rememberFile(path);
    } else {
        document.reset(); // it has a motion from the first moment, too
    }
    const std::string journal = files::journalFolder("asgard");
    Autosave autosave(
        document, journal,
        {[&editor] {
             const bool any =
                 std::ranges::any_of(editor.languageViewers(),
                                     [](const LanguageViewer* one) { return one->hasDraft(); });
             return any ? editor.windowsState() : std::string();
         },
         [&editor](const std::string& state) {
             editor.closeViewers(); // those of a program that begins
             editor.restoreWindows(state,
                                   Autosave::tr("Asgard ended before this was saved. Its windows "
                                                "are open again with what was typed."));
         }});
    QObject::connect(&editor, &Editor::viewersChanged, &autosave, &Autosave::lookAtDrafts,
                     Qt::QueuedConnection);
    QObject::connect(&autosave, &Autosave::failed, panel, [panel](const QString& sentence) {
        plain::Message::tell(QMessageBox::Warning, panel, QStringLiteral("Asgard"), sentence);
    });
    GraphicalViewer* graphical = editor.openGraphicalViewer();
    LanguageViewer* language = editor.openLanguageViewer();
    arrange(*panel, *graphical, *language);
    QTimer::singleShot(0, panel, [&] { offerRecovery(panel, autosave, journal, path); });
    return QApplication::exec();
}

} // namespace views
