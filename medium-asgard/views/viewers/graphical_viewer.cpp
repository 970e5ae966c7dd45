#include "viewers/graphical_viewer.h"

#include "frame/help_page.h"
#include "frame/hint_line.h"
#include "frame/icons.h"
#include "frame/placing.h"
#include "frame/tool_bar.h"
#include "frame/typed_field.h"
#include "framing/framing.h"
#include "gestures/new_point.h"
#include "language/language_viewer.h"
#include "language/notice_bar.h"
#include "language/scene_editor.h"
#include "offers/keep_view.h"
#include "panels/motion_notice.h"
#include "panels/parameters_panel.h"
#include "picture/create_menu.h"
#include "plain/plain.h"
#include "plots/plots_panel.h"
#include "properties/element_commands.h"
#include "recipes/recipes.h"
#include "start/tour.h"
#include "viewers/scene_panes.h"

#include <QCloseEvent>
#include <QCursor>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace views {

namespace {

QString helpTopicOf(editing::Kind kind) {
    using editing::Kind;
    switch (kind) {
    case Kind::body:
    case Kind::shapeSet:
        return QStringLiteral("Body");
    case Kind::joint:
    case Kind::gear:
        return QStringLiteral("Joint");
    case Kind::force:
        return QStringLiteral("Force");
    case Kind::link:
        return QStringLiteral("Link");
    case Kind::rope:
        return QStringLiteral("Rope");
    case Kind::trajectory:
    case Kind::constraint:
        return QStringLiteral("Trajectory");
    case Kind::light:
        return QStringLiteral("Light");
    default:
        return {};
    }
}

} // namespace

GraphicalViewer::GraphicalViewer(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                                 Windows windows, int number)
    : document_(document), windows_(std::move(windows)), number_(number), panes_(*this) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("graphicalViewer%1").arg(number_));
    buildPicture(std::move(pictures));
    buildPanes();
    commands_ = new ElementCommands(document_, this);
    connect(commands_, &ElementCommands::refused, this,
            [this](const QString& why) { display_->editing().say(why); });
    connect(commands_, &ElementCommands::added, display_, &SceneDisplay::showWhole);
    buildMenus();
    connectParts();
    updateTitle();
    display_->setFocus();
    resize(900, 640);
}

// The middle: what happened, the picture, the time, and what the buttons do.
void GraphicalViewer::buildPicture(std::shared_ptr<PictureThread> pictures) {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    auto* frame = new QFrame;
    frame->setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    display_ = new SceneDisplay(document_, std::move(pictures));
    display_->setObjectName("scene");
    auto* inFrame = new QVBoxLayout(frame);
    inFrame->setContentsMargins(1, 1, 1, 1);
    inFrame->addWidget(display_);
    told_ = new ToldBar;
    told_->setObjectName("told");
    column->addWidget(told_);
    column->addWidget(frame, 1);
    auto* notice = new MotionNotice(document_, playback_, *display_);
    connect(notice, &MotionNotice::stopWanted, &document_, &SceneDocument::stopComputing);
    connect(notice, &MotionNotice::floorWanted, display_,
            [this] { display_->creating().start(newFloor()); });
    connect(notice, &MotionNotice::gravityWanted, display_, [this] {
        playback_.seek(playback_.start()); // where they fall from is seen
        display_->creating().start(weightForAll(usualGravity(*document_.shown().scene)));
    });
    connect(&display_->throwing(), &Throwing::letGo, notice, [notice](bool isChanged) {
        if (isChanged)
            notice->tellNewStart();
    });
    times_ = new TimeRows(document_, playback_);
    column->addWidget(times_);
    hint_ = new HintLine;
    hint_->setObjectName("hint");
    column->addWidget(hint_);
    setCentralWidget(whole);
}

void GraphicalViewer::buildPanes() {
    panel_ = new StatusPanel(document_, playback_, display_->display());
    panel_->setObjectName("status");
    sliders_ = new ParametersPanel(document_, this); // before it is in its pane, too
    sliders_->hide();
    if (windows_.makeText)
        panes_.add({"text", tr("Text"), Qt::LeftDockWidgetArea, windows_.makeText});
    panes_.add({"parameters",
                tr("Parameters"),
                Qt::RightDockWidgetArea,
                [this] { return scrolled(sliders_, true); },
                {},
                {},
                [this] { return sliders_->isEmpty(); }});
    panes_.add({"status", tr("Motion and Handles"), Qt::RightDockWidgetArea,
                [this] { return scrolled(panel_); }});
    panes_.add({"plots", tr("Plots"), Qt::BottomDockWidgetArea, [this] { return makePlots(); }});
    addScenePanes(panes_, document_, *display_, playback_, windows_,
                  [this](const editing::Element& element, const QPoint& global) {
                      document_.select({element});
                      showMenu(menuPlaceOfSelection(document_, *display_), global);
                  });
    panes_.add({"tour", tr("Tour"), Qt::RightDockWidgetArea, [this] { return makeTour(); }});
    connect(&panes_, &Panes::contentMade, this, [this](const QString& name, QWidget* content) {
        const std::pair<const char*, const char*> topics[] = {
            {"text", "The text"},         {"status", "Motion and handles"}, {"plots", "Plots"},
            {"properties", "Properties"}, {"sceneList", "Scene list"},      {"faults", "Faults"},
            {"tour", "The tour"},         {"parameters", "Parameters"}};
        for (const auto& [pane, topic] : topics)
            if (name == QLatin1String(pane))
                setHelp(*content, QLatin1String(topic));
    });
    const auto showSliders = [this] {
        panes_.setTitle("parameters", sliders_->title());
        panes_.update("parameters");
    };
    connect(sliders_, &ParametersPanel::rebuilt, this, showSliders);
    showSliders();
    panes_.show("status");
}

QWidget* GraphicalViewer::makePlots() {
    auto* plots = new PlotsPanel(document_);
    plots->setTime(playback_.time());
    connect(&playback_, &Playback::timeChanged, plots,
            [this, plots] { plots->setTime(playback_.time()); });
    connect(plots, &PlotsPanel::timeChosen, &playback_, &Playback::seek);
    connect(plots, &PlotsPanel::plotWanted, this, [this] { askForPlot(document_, *display_); });
    connect(plots, &PlotsPanel::menuWanted, this, [this](std::size_t plot, const QPoint& global) {
        document_.select({{editing::Kind::plot, plot}});
        showMenu(menuPlaceOfSelection(document_, *display_), global);
    });
    return plots;
}

// A step that plays is done when one has seen the motion go on for a while.
QWidget* GraphicalViewer::makeTour() {
    auto* tour = new Tour(document_);
    connect(&playback_, &Playback::timeChanged, tour, [this, tour] {
        constexpr double seen = 1; // s
        if (playback_.isPlaying() && playback_.time() > playback_.start() + seen)
            tour->played();
    });
    connect(tour, &Tour::built, display_, &SceneDisplay::frameAll); // there is room to swing
    connect(tour, &Tour::ended, this, [this] { panes_.hide("tour"); });
    return tour;
}

// The plane in which the pendulum is built, with room for it.
void GraphicalViewer::showTour() {
    panes_.show("tour");
    render::Camera camera =
        render::fitted(render::extentOf(scene::Scene(), nullptr),
                       render::facing(geometry::Vector::UnitZ(), geometry::Vector::UnitY()),
                       display_->sight().size);
    camera.scale /= 7; // whatever was seen before
    display_->setCamera(camera);
    display_->setFocus();
}

void GraphicalViewer::buildToolBar() {
    auto* bar = new ToolBar(*this);
    setHelp(*bar, QStringLiteral("Tools"));
    const auto add = [bar](std::initializer_list<std::pair<const char*, Icon>> commands) {
        for (const auto& [name, which] : commands)
            bar->add(name, which);
        bar->separate();
    };
    add({{"newScene", Icon::newScene}, {"open", Icon::open}, {"save", Icon::save}});
    add({{"undo", Icon::undo}, {"redo", Icon::redo}});
    add({{"frameAll", Icon::frameAll}, {"plots", Icon::plots}});
    add({{"createBody", Icon::body},
         {"createForce", Icon::force},
         {"createJoint", Icon::joint},
         {"createSpring", Icon::link},
         {"createRope", Icon::rope}});
    bar->add("help", Icon::help);
}

// A wide window has the text above the scene list at the left, and the values of the selected in
// front of the switches at the right; a narrow one has all of them behind each other.
void GraphicalViewer::showUsualPanes() {
    auto* text = findChild<QDockWidget*>("pane.text");
    constexpr int wide = 1150; // enough for three columns
    const bool isWide = width() >= wide;
    if (text && !isWide)
        tabifyDockWidget(findChild<QDockWidget*>("pane.status"), text);
    if (isWide)
        panes_.show("sceneList");
    if (text)
        panes_.show("text");
    panes_.show("status");
    panes_.show("properties");
    if (auto* sliders = findChild<QDockWidget*>("pane.parameters"); !sliders->isHidden())
        resizeDocks({sliders}, {sliders->sizeHint().height()}, Qt::Vertical);
    if (!isWide) // the picture has the most
        resizeDocks({findChild<QDockWidget*>("pane.properties")}, {width() / 3}, Qt::Horizontal);
    if (!text || !isWide)
        return;
    constexpr int usual = 460;
    auto* values = findChild<QDockWidget*>("pane.properties");
    resizeDocks({text, values}, {std::min(usual, width() * 3 / 10), values->sizeHint().width()},
                Qt::Horizontal);
    resizeDocks({text, findChild<QDockWidget*>("pane.sceneList")}, {3, 2}, Qt::Vertical);
}

// A window that a larger arrangement has made wider does not become narrow by itself.
void GraphicalViewer::arrange(const QByteArray& panes) {
    if (panes_.restore(panes, screen()->availableSize()))
        return;
    layout()->activate(); // it needs less room now
    fitScreen(*this, nullptr);
    showUsualPanes();
    moveWithinScreen(*this, pos());
}

LanguageViewer* GraphicalViewer::text() const {
    return qobject_cast<LanguageViewer*>(panes_.content("text"));
}

void GraphicalViewer::showText() {
    panes_.show("text");
    activateWindow();
    if (LanguageViewer* viewer = text())
        viewer->editor().setFocus();
}

void GraphicalViewer::connectParts() {
    connect(&display_->creating(), &Creating::created, this, &GraphicalViewer::showCreated);
    connect(&display_->creating(), &Creating::needs, panel_, &StatusPanel::show);
    connect(panel_, &StatusPanel::displayChanged, display_, &SceneDisplay::setDisplay);
    connect(&display_->editing(), &PictureEditing::shapeWanted, this,
            [this](const QString& name) { windows_.openShapeEditor(name); });
    connect(&times_->controls(), &TimeControls::left, display_, [this] { display_->setFocus(); });
    connect(&times_->controls(), &TimeControls::refused, this,
            [this](const QString& why) { display_->editing().say(why); });
    connect(&playback_, &Playback::timeChanged, this, [this] {
        display_->setTime(playback_.time(), playback_.isPlaying() || times_->bar().isSliderDown());
    });
    const auto showState = [this] {
        if (!playback_.isPlaying())
            display_->setTime(playback_.time(), false);
        display_->throwing().setPlays(playback_.isPlaying());
    };
    connect(&playback_, &Playback::stateChanged, this, showState);
    showState();
    connect(&playback_, &Playback::started, this, &GraphicalViewer::beginPlaying);
    connect(&document_, &SceneDocument::nameChanged, this, &GraphicalViewer::updateTitle);
    connect(&document_, &SceneDocument::opened, display_, &SceneDisplay::frameOpened);
    connect(&document_, &SceneDocument::opened, this, [this] { // no empty pane of another scene
        connect(
            &document_, &SceneDocument::sceneChanged, this,
            [this] {
                if (document_.shown().scene->plots.empty())
                    panes_.hide("plots");
            },
            Qt::SingleShotConnection);
    });
    for (QAbstractButton* button : findChildren<QAbstractButton*>())
        button->installEventFilter(this);
    connectTimeStrip();
    connectThrowing();
    connect(display_, &SceneDisplay::menuWanted, this, [this](const MenuPlace& place) {
        showMenu(place, display_->mapToGlobal(place.position.toPoint()));
    });
    connect(&display_->pointing(), &Pointing::changed, this, &GraphicalViewer::showHint);
    connect(&display_->creating(), &Creating::changed, this, &GraphicalViewer::showHint);
    connect(display_, &SceneDisplay::handleDragged, this, &GraphicalViewer::showHint);
    connect(&document_, &SceneDocument::sceneChanged, this, &GraphicalViewer::showHint);
}

// Of the element of the scene under the pointer.
QString GraphicalViewer::helpAt(const QWidget& under) const {
    if (&under != display_)
        return {};
    const auto element =
        menuPlaceAt(document_, *display_, display_->mapFromGlobal(QCursor::pos())).element;
    return element ? helpTopicOf(element->kind) : QString();
}

// The keyboard goes to the text, and back to the picture.
void GraphicalViewer::switchPane() {
    if (display_->hasFocus())
        showText();
    else
        display_->setFocus();
}

void GraphicalViewer::toggleFullScreen() { setWindowState(windowState() ^ Qt::WindowFullScreen); }

void GraphicalViewer::tell(const QString& sentence) { told_->tell(sentence); }

void GraphicalViewer::showHint() { hint_->say(display_->pointing().hint()); }

// An element that is being created is given up first, wherever the keyboard is; nothing stays
// selected.
void GraphicalViewer::stop() {
    const bool goesOn = playback_.isPlaying() || document_.work() == Work::simulating;
    if (display_->creating().active())
        display_->creating().cancel();
    else if (!goesOn && !document_.selected().empty())
        document_.select({});
    else if (!playback_.isPlaying() && isFullScreen())
        toggleFullScreen();
    else
        times_->controls().stop();
}

// What another part of the window has no use for belongs to what is being created.
void GraphicalViewer::keyPressEvent(QKeyEvent* event) {
    if (!display_->creating().key(*event))
        QMainWindow::keyPressEvent(event);
}

// A `view` of the scene; turning alone is no edit.
void GraphicalViewer::keepView() {
    const gestures::Sight sight = display_->sight();
    const auto& views = document_.shown().scene->views;
    if (!views.empty() && document_.sceneIsCurrent()) {
        KeepViewDialog dialog(document_, sight, display_->lastView(), this);
        const int revision = document_.revision();
        if (dialog.exec() != QDialog::Accepted)
            return;
        if (document_.revision() != revision)
            return display_->editing().say(
                tr("The text was changed meanwhile: the view was not kept."));
        if (!dialog.wantsNew())
            return document_.setText(text::applied(document_.text(), dialog.answer().edits),
                                     tr("Keep the View %1").arg(dialog.name()));
    }
    display_->creating().start(keptView(sight.camera, sight.pixelLength(sight.camera.center)));
}

// What is new is shown with its handles, and marked.
void GraphicalViewer::showCreated(const std::optional<editing::Element>& element,
                                  HandleSwitch handles) {
    if (handles)
        panel_->show(handles);
    if (!element)
        return;
    if (element->kind == editing::Kind::plot)
        panes_.show("plots");
    display_->editing().expect({*element});
}

// While a body is held the time stands still. A motion that played goes on from there, as soon as
// it is known.
void GraphicalViewer::connectThrowing() {
    Throwing& throwing = display_->throwing();
    connect(&throwing, &Throwing::grabbed, this, [this, &throwing] {
        if (playback_.isPlaying())
            throwing.setRate(playback_.rate());
        playback_.hold();
    });
    connect(&throwing, &Throwing::letGo, this, [this](bool isChanged) {
        if (!isChanged)
            playback_.goOn();
    });
    connect(&document_, &SceneDocument::motionChanged, this, [this, &throwing] {
        if (!document_.motionIsStale() && !throwing.active())
            playback_.goOn();
    });
}

// A point that is chosen in the strip is chosen in the picture, and the other way about.
void GraphicalViewer::connectTimeStrip() {
    PictureEditing& editing = display_->editing();
    TimeStrip& strip = times_->strip();
    strip.setHeld([&editing] { return editing.dragging(); });
    strip.setTrajectoriesShown(display_->display().trajectories);
    connect(panel_, &StatusPanel::displayChanged, &strip,
            [&strip](const auto& display) { strip.setTrajectoriesShown(display.trajectories); });
    connect(&strip, &TimeStrip::says, &editing, &PictureEditing::say);
    connect(&strip, &TimeStrip::markChosen, this,
            [this, &editing](std::size_t trajectory, std::size_t point) {
                const auto& all = document_.shown().scene->trajectories;
                editing.choose(render::HandleKind::trajectoryPoint, trajectory,
                               gestures::partOf(all[trajectory], point));
            });
    connect(&editing, &PictureEditing::changed, &strip, [this, &editing, &strip] {
        const auto trajectory = strip.trajectory();
        const auto marked = trajectory ? editing.marked() : std::nullopt;
        if (marked && marked->kind == render::HandleKind::trajectoryPoint &&
            marked->element == *trajectory)
            strip.setChosen(gestures::pointOf(document_.shown().scene->trajectories[*trajectory],
                                              marked->part));
    });
}

void GraphicalViewer::showMenu(const MenuPlace& place, const QPoint& global) {
    if (place.handle)
        display_->editing().choose(place.handle->kind, place.handle->element, place.handle->part);
    else if (place.element &&
             std::ranges::find(document_.selected(), *place.element) == document_.selected().end())
        document_.select({*place.element});
    // It goes when it is closed, or with the window.
    QMenu* menu = elementMenu(document_, *display_, place,
                              {windows_.openTrajectoryEditor, windows_.showText,
                               [this] { panes_.show("plots"); }, [this] { commands_->duplicate(); },
                               [this] { commands_->copy(); }, [this] { commands_->paste(); }})
                      .release();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->popup(global);
}

void GraphicalViewer::beginPlaying() {
    if (document_.waitsToBeAsked() || document_.computingWasStopped())
        document_.recompute();
    const auto& bodies = document_.shown().scene->bodies;
    if (document_.sceneIsCurrent() && !bodies.empty() &&
        std::ranges::all_of(bodies, &scene::Body::fixed))
        display_->editing().say(tr("Nothing moves: every body is fixed."), false);
}

void GraphicalViewer::updateTitle() {
    const QString viewer =
        number_ == 1 ? tr("Graphical Viewer") : tr("Graphical Viewer %1").arg(number_);
    setWindowTitle(tr("%1[*] – %2").arg(plain::title(document_.name()), viewer));
    const LanguageViewer* typed = text();
    setWindowModified((typed && typed->hasDraft()) ||
                      (!document_.hasHost() && document_.isModified()));
}

// Space presses the button or box that has the keyboard; elsewhere it plays.
bool GraphicalViewer::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        event->accept();
        return true;
    }
    return QMainWindow::eventFilter(watched, event);
}

void GraphicalViewer::closeEvent(QCloseEvent* event) {
    LanguageViewer* viewer = text();
    event->setAccepted(TypedField::maySettle(document_, this) &&
                       (!viewer || viewer->settleDraft()) &&
                       (!windows_.mayClose || windows_.mayClose(*this)));
}

} // namespace views
