#include "viewers/graphical_viewer.h"

#include "frame/manual.h"
#include "frame/undo_actions.h"
#include "gestures/new_point.h"
#include "language/notice_bar.h"
#include "motion/known_span.h"
#include "picture/create_menu.h"
#include "picture/keep_view.h"
#include "plain/plain.h"
#include "shapes/shapes_menu.h"
#include "viewers/motion_span.h"

#include <QActionGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace views {

namespace {

constexpr double rates[] = {0.1, 0.25, 0.5, 1, 2, 4};

QString rateText(double rate) { return QStringLiteral("%1 × ").arg(rate); }

} // namespace

GraphicalViewer::GraphicalViewer(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                                 Windows windows, int number)
    : document_(document), windows_(std::move(windows)), number_(number) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("graphicalViewer%1").arg(number_));
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* frame = new QFrame;
    frame->setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    display_ = new SceneDisplay(document_, std::move(pictures));
    display_->setObjectName("scene");
    auto* inFrame = new QVBoxLayout(frame);
    inFrame->setContentsMargins(1, 1, 1, 1);
    inFrame->addWidget(display_);
    panel_ = new StatusPanel(document_, playback_, display_->display());
    panel_->setObjectName("status");
    row->addWidget(frame, 1);
    auto* scroll = new QScrollArea; // a low window has room for the picture
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidgetResizable(true);
    scroll->setWidget(panel_);
    scroll->setFixedWidth(panel_->width() + scroll->verticalScrollBar()->sizeHint().width());
    scroll->setFocusPolicy(Qt::NoFocus);
    row->addWidget(scroll);
    told_ = new ToldBar;
    told_->setObjectName("told");
    column->addWidget(told_);
    column->addLayout(row, 1);
    timeBar_ = new TimeBar;
    timeBar_->setObjectName("timeBar");
    timeStrip_ = new TimeStrip(document_);
    timeStrip_->setObjectName("timeStrip");
    buildTimeControls(column);
    hint_ = plain::label();
    hint_->setObjectName("hint");
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // what does not fit is cut
    hint_->setForegroundRole(QPalette::PlaceholderText);
    hint_->setAccessibleName(tr("What the buttons do here"));
    column->addWidget(hint_);
    setCentralWidget(whole);
    buildMenus();

    connect(&display_->creating(), &Creating::created, this, &GraphicalViewer::showCreated);
    connect(&display_->creating(), &Creating::needs, panel_, &StatusPanel::show);
    connect(panel_, &StatusPanel::displayChanged, display_, &SceneDisplay::setDisplay);
    connectBody();
    connect(&playback_, &Playback::timeChanged, this, [this] {
        display_->setTime(playback_.time(), playback_.isPlaying() || timeBar_->isSliderDown());
        timeBar_->setTime(playback_.time());
        timeStrip_->setTime(playback_.time());
        timeLabel_->setText(timeText(playback_.time(), playback_.finish() - playback_.start()));
    });
    connect(&playback_, &Playback::stateChanged, this, &GraphicalViewer::updateState);
    connect(timeBar_, &TimeBar::timeChosen, &playback_, &Playback::seek);
    connect(&document_, &SceneDocument::motionChanged, this, &GraphicalViewer::updateRange);
    connect(&document_, &SceneDocument::workChanged, timeBar_,
            [this] { timeBar_->setStale(document_.motionIsStale()); });
    connect(&document_, &SceneDocument::sceneChanged, this, &GraphicalViewer::fillViewsMenu);
    connect(&document_, &SceneDocument::nameChanged, this, &GraphicalViewer::updateTitle);
    connect(display_, &SceneDisplay::viewFollowed, this, &GraphicalViewer::fillViewsMenu);
    connect(&document_, &SceneDocument::opened, this, [this] { // seen as if for the first time
        playback_.stop();
        display_->frameAll();
    });
    for (QAbstractButton* button : findChildren<QAbstractButton*>())
        button->installEventFilter(this);
    connectTimeStrip();
    connect(display_, &SceneDisplay::menuWanted, this, &GraphicalViewer::showMenu);
    connect(&display_->pointing(), &Pointing::changed, this, &GraphicalViewer::showHint);
    connect(&display_->creating(), &Creating::changed, this, &GraphicalViewer::showHint);
    connect(display_, &SceneDisplay::handleDragged, this, &GraphicalViewer::showHint);
    connect(&document_, &SceneDocument::sceneChanged, this, &GraphicalViewer::showHint);
    updateRange();
    updateState();
    updateTitle();
    fillViewsMenu();
    display_->setFocus();
    resize(900, 640);
}

QToolButton* GraphicalViewer::addButton(QHBoxLayout* row, const char* name, Icon which,
                                        const QString& tip, std::function<void()> action) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setIconSize(QSize(20, 20));
    button->setAutoRaise(true);
    button->setToolTip(plain::tip(tip));
    button->setAccessibleName(tip.section(QStringLiteral(" ("), 0, 0));
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, std::move(action));
    row->addWidget(button);
    buttons_.emplace_back(button, which);
    return button;
}

void GraphicalViewer::buildTimeControls(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    addButton(row, "first", Icon::first, tr("First moment (Home)"),
              [this] { playback_.seek(playback_.start()); });
    addButton(row, "stepBack", Icon::stepBack, tr("Step back (Left)"),
              [this] { playback_.step(-1); });
    playButton_ = addButton(row, "play", Icon::play, tr("Play or pause (Space)"),
                            [this] { togglePlaying(); });
    addButton(row, "stop", Icon::stop, tr("Stop (Escape)"), [this] { playback_.stop(); });
    addButton(row, "stepForward", Icon::stepForward, tr("Step (Right)"),
              [this] { playback_.step(1); });
    addButton(row, "last", Icon::last, tr("Last moment (End)"),
              [this] { playback_.seek(playback_.finish()); });
    loopButton_ = addButton(row, "loop", Icon::loop, tr("Play again and again (L)"),
                            [this] { playback_.setLoops(!playback_.loops()); });
    loopButton_->setCheckable(true);
    rateButton_ = new QToolButton;
    rateButton_->setObjectName("rate");
    rateButton_->setAutoRaise(true);
    rateButton_->setPopupMode(QToolButton::InstantPopup);
    rateButton_->setToolTip(tr("How fast it is played"));
    rateButton_->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(rateButton_);
    for (double rate : rates)
        menu->addAction(plain::caption(rateText(rate)), this,
                        [this, rate] { playback_.setRate(rate); });
    rateButton_->setMenu(menu);
    row->addWidget(rateButton_);
    row->addStretch();
    auto* span = new MotionSpan(document_);
    connect(span, &MotionSpan::left, display_, [this] { display_->setFocus(); });
    row->addWidget(span);
    row->addSpacing(12);
    timeLabel_ = plain::label();
    timeLabel_->setObjectName("time");
    QFont font = timeLabel_->font();
    font.setBold(true);
    timeLabel_->setFont(font);
    timeLabel_->setAccessibleName(tr("Time"));
    row->addWidget(timeLabel_);
    column->addLayout(row);
    auto* times = new QGridLayout; // the same times above each other
    times->setSpacing(2);
    times->addWidget(timeStrip_->controls(), 0, 0);
    times->addWidget(timeStrip_, 0, 1);
    times->addWidget(timeBar_, 1, 1);
    column->addLayout(times);
    updateIcons();
}

void GraphicalViewer::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("New &Graphical Viewer"), QKeySequence(Qt::CTRL | Qt::Key_N), this,
                    [this] { windows_.openGraphicalViewer(); });
    file->addAction(tr("New &Language Viewer"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                    [this] { windows_.openLanguageViewer(); });
    file->addSeparator();
    file->addAction(tr("&Save"), QKeySequence::Save, this, [this] {
        if (windows_.save)
            windows_.save();
        else
            display_->editing().say(tr("What is changed here is in the document already; the "
                                       "document is saved in its own window, with Ctrl+S."),
                                    false);
    });
    file->addAction(tr("&Close"), QKeySequence::Close, this, &QWidget::close);

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    addUndoActions(edit, document_);
    edit->addSeparator();
    QAction* remove =
        edit->addAction(tr("&Delete"), this, [this] { display_->editing().deleteMarked(); });
    QAction* value =
        edit->addAction(tr("E&xact Value…"), this, [this] { display_->editing().openEntry(); });
    // Nothing selected: nothing to delete, and no value. A new element's handle is known with its
    // first picture, which tells nobody: the menu looks when it opens.
    connect(edit, &QMenu::aboutToShow, this, [this, remove, value] {
        const bool marked = display_->editing().marked().has_value();
        remove->setEnabled(marked || !document_.selected().empty());
        value->setEnabled(marked);
    });
    buildShapesMenu(menuBar()->addMenu(tr("&Shapes")), document_, windows_);
    buildCreateMenu(menuBar()->addMenu(tr("&Create")), document_, *display_);
    buildViewMenu();

    QMenu* motion = menuBar()->addMenu(tr("A&nimation"));
    playAction_ = motion->addAction(tr("&Play"), QKeySequence(Qt::Key_Space), this,
                                    [this] { togglePlaying(); });
    motion->addAction(tr("S&top"), QKeySequence(Qt::Key_Escape), this, [this] { stop(); });
    motion->addAction(tr("&Step"), QKeySequence(Qt::Key_Right), this,
                      [this] { playback_.step(1); });
    motion->addAction(tr("Step &Back"), QKeySequence(Qt::Key_Left), this,
                      [this] { playback_.step(-1); });
    motion->addAction(tr("&First Moment"), QKeySequence(Qt::Key_Home), this,
                      [this] { playback_.seek(playback_.start()); });
    motion->addAction(tr("&Last Moment"), QKeySequence(Qt::Key_End), this,
                      [this] { playback_.seek(playback_.finish()); });
    loopAction_ = motion->addAction(tr("L&oop"), QKeySequence(Qt::Key_L), this,
                                    [this] { playback_.setLoops(!playback_.loops()); });
    loopAction_->setCheckable(true);
    motion->addSeparator();
    motion->addAction(tr("&Recompute Motion"), QKeySequence(Qt::Key_F5), this,
                      [this] { document_.recompute(); });
    if (!document_.hasHost()) // which decides for all of the document
        buildLiveMenu(motion->addMenu(tr("Compute &While Editing")));
    motion->addAction(tr("&Trajectory Editor"), QKeySequence(Qt::CTRL | Qt::Key_T), this,
                      [this] { windows_.openTrajectoryEditor(); });
    motion->addAction(tr("Plo&ts"), this, [this] { windows_.openPlots(); });
    motion->addAction(tr("Speed and &Accuracy…"), this, [this] { windows_.openStudy(); });
    addHelpMenu(this, QStringLiteral("In a picture"));
}

void GraphicalViewer::buildLiveMenu(QMenu* menu) {
    auto* choices = new QActionGroup(menu);
    const std::pair<Live, QString> all[] = {
        {Live::automatic, tr("&Automatically, While It Is Quick")},
        {Live::always, tr("&Always")},
        {Live::never, tr("&Only When Asked (F5)")},
    };
    for (const auto& choice : all) {
        const Live live = choice.first;
        QAction* action = choices->addAction(plain::ours(choice.second));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, live] { document_.setLive(live); });
        connect(menu, &QMenu::aboutToShow, action,
                [this, action, live] { action->setChecked(document_.live() == live); });
    }
    menu->addActions(choices->actions());
}

void GraphicalViewer::buildViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("&Frame All"), QKeySequence(Qt::Key_F), this,
                    [this] { display_->frameAll(); });
    view->addAction(tr("Frame the &Motion, From Here"), this, [this] { display_->frameMotion(); });
    view->addAction(tr("Frame &Now"), QKeySequence(Qt::Key_N), this,
                    [this] { display_->frameNow(); });
    view->addAction(tr("Frame &Selected"), QKeySequence(Qt::SHIFT | Qt::Key_F), this,
                    [this] { display_->frameSelected(); });
    QAction* parallel = view->addAction(tr("&Orthographic"), QKeySequence(Qt::Key_O), this,
                                        [this](bool on) { display_->setOrthographic(on); });
    parallel->setCheckable(true);
    viewsMenu_ = view->addMenu(tr("&Views of the Scene"));
    view->addSeparator();
    const struct {
        QString label;
        QKeySequence key;
        geometry::Vector toward;
    } directions[] = {
        {tr("Along &z: the Plane x y"), QKeySequence(Qt::Key_3), geometry::Vector::UnitZ()},
        {tr("Along &x: the Plane y z"), QKeySequence(Qt::Key_1), geometry::Vector::UnitX()},
        {tr("Along &y: the Plane x z"), QKeySequence(Qt::Key_2), geometry::Vector::UnitY()},
        {tr("Against z"), QKeySequence(Qt::SHIFT | Qt::Key_3), -geometry::Vector::UnitZ()},
        {tr("Against x"), QKeySequence(Qt::SHIFT | Qt::Key_1), -geometry::Vector::UnitX()},
        {tr("Against y"), QKeySequence(Qt::SHIFT | Qt::Key_2), -geometry::Vector::UnitY()},
    };
    for (const auto& direction : directions)
        view->addAction(plain::ours(direction.label), direction.key, this,
                        [this, toward = direction.toward] { display_->lookAlong(toward); });
    view->addSeparator();
    view->addAction(tr("&Level the Horizon"), QKeySequence(Qt::Key_U), this,
                    [this] { display_->levelHorizon(); });
    view->addAction(tr("&Centre of Rotation in the Middle"), this,
                    [this] { display_->centerAt(QRectF(display_->rect()).center()); });
    view->addAction(tr("&Keep This View"), QKeySequence(Qt::CTRL | Qt::Key_K), this,
                    [this] { keepView(); });
    view->addSeparator();
    QMenu* handles = menuBar()->addMenu(tr("&Handles"));
    const auto all = [this](bool on) {
        for (const StatusPanel::Switch& one : panel_->switches())
            if (one.isHandle)
                one.box->setChecked(on);
    };
    handles->addAction(tr("&All"), this, [all] { all(true); });
    handles->addAction(tr("&None"), this, [all] { all(false); });
    handles->addSeparator();
    for (const StatusPanel::Switch& one : panel_->switches()) {
        QAction* action = (one.isHandle ? handles : view)->addAction(plain::ours(one.box->text()));
        action->setCheckable(true);
        action->setChecked(one.box->isChecked());
        connect(action, &QAction::toggled, one.box, &QCheckBox::setChecked);
        connect(one.box, &QCheckBox::toggled, action, &QAction::setChecked);
    }
}

void GraphicalViewer::tell(const QString& sentence) { told_->tell(sentence); }

void GraphicalViewer::showHint() {
    hint_->setText(hint_->fontMetrics().elidedText(display_->pointing().hint(), Qt::ElideRight,
                                                   hint_->width()));
}

void GraphicalViewer::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    showHint();
}

// What is being created is given up first, wherever the keyboard is.
void GraphicalViewer::stop() {
    if (display_->creating().active())
        display_->creating().cancel();
    else
        playback_.stop();
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
void GraphicalViewer::showCreated(editing::Element element, HandleSwitch handles) {
    if (handles)
        panel_->show(handles);
    if (element.kind == editing::Kind::plot)
        windows_.openPlots();
    display_->editing().expect(element);
}

void GraphicalViewer::connectBody() {
    PictureEditing& editing = display_->editing();
    connect(&panel_->body(), &BodyPanel::fixWanted, &editing, &PictureEditing::setFixed);
    connect(&panel_->body(), &BodyPanel::sizeWanted, &editing, &PictureEditing::openSize);
    connect(&panel_->body(), &BodyPanel::surfaceWanted, &editing, &PictureEditing::openSurface);
    const auto open = [this](const QString& name) { windows_.openShapeEditor(name); };
    connect(&panel_->body(), &BodyPanel::shapeWanted, this, open);
    connect(&editing, &PictureEditing::shapeWanted, this, open);
}

// A point that is chosen in the strip is chosen in the picture, and the other way about.
void GraphicalViewer::connectTimeStrip() {
    PictureEditing& editing = display_->editing();
    timeStrip_->setHeld([&editing] { return editing.dragging(); });
    timeStrip_->setTrajectoriesShown(display_->display().trajectories);
    connect(panel_, &StatusPanel::displayChanged, timeStrip_, [this](const auto& display) {
        timeStrip_->setTrajectoriesShown(display.trajectories);
    });
    connect(timeStrip_, &TimeStrip::says, &editing, &PictureEditing::say);
    connect(timeStrip_, &TimeStrip::markChosen, this,
            [this, &editing](std::size_t trajectory, std::size_t point) {
                const auto& all = document_.shown().scene->trajectories;
                editing.choose(render::HandleKind::trajectoryPoint, trajectory,
                               gestures::partOf(all[trajectory], point));
            });
    connect(&editing, &PictureEditing::changed, timeStrip_, [this, &editing] {
        const auto trajectory = timeStrip_->trajectory();
        const auto marked = trajectory ? editing.marked() : std::nullopt;
        if (marked && marked->kind == render::HandleKind::trajectoryPoint &&
            marked->element == *trajectory)
            timeStrip_->setChosen(gestures::pointOf(
                document_.shown().scene->trajectories[*trajectory], marked->part));
    });
}

void GraphicalViewer::showMenu(const MenuPlace& place) {
    if (place.handle)
        display_->editing().choose(place.handle->kind, place.handle->element, place.handle->part);
    else if (place.element)
        document_.select({*place.element});
    // It goes when it is closed, or with the window.
    QMenu* menu =
        elementMenu(document_, *display_, place,
                    {windows_.openTrajectoryEditor, windows_.showText, windows_.openPlots})
            .release();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->popup(display_->mapToGlobal(place.position.toPoint()));
}

void GraphicalViewer::fillViewsMenu() {
    viewsMenu_->clear();
    const auto& views = document_.shown().scene->views;
    viewsMenu_->setEnabled(!views.empty());
    for (const scene::View& view : views) {
        const QString name = QString::fromStdString(view.name);
        QAction* action =
            viewsMenu_->addAction(name.isEmpty() ? tr("(unnamed)") : plain::caption(name), this,
                                  [this, name] { display_->followView(name); });
        action->setCheckable(true);
        action->setChecked(name == display_->followedView());
    }
}

void GraphicalViewer::togglePlaying() {
    if (playback_.isPlaying())
        playback_.pause();
    else
        playback_.play();
}

void GraphicalViewer::updateRange() {
    const Shown& shown = document_.shown();
    const scene::Simulator& simulator = shown.scene->simulator;
    const bool known = shown.motion != nullptr;
    playback_.setRange(known ? shown.motion->start() : simulator.start,
                       known ? shown.motion->finish() : simulator.finish,
                       known ? shown.motion->computed() : simulator.start);
    std::vector<double> impacts;
    if (known)
        for (const simulation::Impact& impact : shown.motion->impacts())
            impacts.push_back(impact.time);
    const simulation::KnownSpan span = known ? simulation::knownSpan(*shown.motion)
                                             : simulation::KnownSpan{playback_.computed(), {}, 0};
    timeBar_->setRange(playback_.start(), playback_.finish(), span.computed);
    timeBar_->setMarks(span.reliableUntil, impacts);
    timeBar_->setEnabled(known);
}

void GraphicalViewer::updateState() {
    timeBar_->setTime(playback_.time());
    timeStrip_->setRange(playback_.start(), playback_.finish());
    timeStrip_->setTime(playback_.time());
    loopButton_->setChecked(playback_.loops());
    loopAction_->setChecked(playback_.loops());
    rateButton_->setText(rateText(playback_.rate()));
    rateButton_->setAccessibleName(tr("Rate: %1").arg(rateText(playback_.rate()).trimmed()));
    playAction_->setText(playback_.isPlaying() ? tr("&Pause") : tr("&Play"));
    timeLabel_->setText(timeText(playback_.time(), playback_.finish() - playback_.start()));
    updateIcons();
    if (!playback_.isPlaying())
        display_->setTime(playback_.time(), false);
}

void GraphicalViewer::updateIcons() {
    for (const auto& [button, which] : buttons_)
        button->setIcon(
            icon(button == playButton_ && playback_.isPlaying() ? Icon::pause : which, palette()));
}

void GraphicalViewer::updateTitle() {
    const QString viewer =
        number_ == 1 ? tr("Graphical Viewer") : tr("Graphical Viewer %1").arg(number_);
    setWindowTitle(tr("%1[*] – %2").arg(plain::title(document_.name()), viewer));
    setWindowModified(document_.hasHost() ? false : document_.isModified());
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

void GraphicalViewer::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && playButton_ != nullptr)
        updateIcons();
}

} // namespace views
