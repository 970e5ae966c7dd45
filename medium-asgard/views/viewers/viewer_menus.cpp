// A graphical viewer's menus.
#include "frame/help_menu.h"
#include "frame/undo_actions.h"
#include "framing/framing.h"
#include "gestures/present.h"
#include "language/language_viewer.h"
#include "picture/create_menu.h"
#include "plain/plain.h"
#include "properties/element_commands.h"
#include "shapes/shapes_menu.h"
#include "viewers/graphical_viewer.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>

namespace views {

namespace {

// A switch of the panel as an entry of a menu.
void addSwitch(QMenu& menu, const StatusPanel::Switch& one) {
    QAction* action = menu.addAction(plain::ours(one.box->text()));
    action->setCheckable(true);
    action->setChecked(one.box->isChecked());
    QObject::connect(action, &QAction::toggled, one.box, &QCheckBox::setChecked);
    QObject::connect(one.box, &QCheckBox::toggled, action, &QAction::setChecked);
}

// The moment that is seen becomes the start of the scene, as one step of undo; else why it cannot.
void startFromHere(SceneDocument& document, SceneDisplay& display) {
    if (!document.sceneIsCurrent())
        return display.editing().say(document.whyNotCurrent());
    const auto& motion = document.shown().motion;
    const double time = motion ? gestures::roundMoment(*motion, display.time()) : display.time();
    const gestures::Ground ground = document.ground();
    const editing::Answer answer = gestures::startingAt(ground, time);
    if (!answer.possible())
        return display.editing().say(QString::fromStdString(answer.reason));
    document.setText(text::applied(document.text(), answer.edits),
                     QObject::tr("Start From %1 s").arg(time));
    display.editing().say(QString::fromStdString(gestures::countsAnew(ground, time)), false);
}

// The views of the scene, checked while the picture follows one.
void buildViewsMenu(QMenu* menu, SceneDocument& document, SceneDisplay& display) {
    const auto fill = [menu, &document, &display] {
        menu->clear();
        const auto& views = document.shown().scene->views;
        menu->setEnabled(!views.empty());
        for (const scene::View& view : views) {
            const QString name = QString::fromStdString(view.name);
            QAction* action =
                menu->addAction(name.isEmpty() ? QObject::tr("(unnamed)") : plain::caption(name),
                                &display, [&display, name] { display.followView(name); });
            action->setCheckable(true);
            action->setChecked(name == display.followedView());
        }
    };
    QObject::connect(&document, &SceneDocument::sceneChanged, menu, fill);
    // Later: an action of the menu that follows a view is not deleted while it acts.
    QObject::connect(&display, &SceneDisplay::viewFollowed, menu, fill, Qt::QueuedConnection);
    fill();
}

} // namespace

void GraphicalViewer::buildMenus() {
    buildFileMenu();
    buildEditMenu();
    buildShapesMenu(menuBar()->addMenu(tr("&Shapes")), document_, windows_);
    buildCreateMenu(menuBar()->addMenu(tr("&Create")), document_, *display_);
    buildViewMenu();
    buildHandlesMenu();
    buildMotionMenu();
    buildTextMenu();
    addHelpMenu(this, QStringLiteral("The picture"),
                [this](const QWidget& under) { return helpAt(under); });
}

// The text's own menus, once it is in a pane of this window.
void GraphicalViewer::buildTextMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Text"));
    menu->menuAction()->setVisible(false);
    connect(&panes_, &Panes::contentMade, menu, [menu](const QString&, QWidget* content) {
        const auto* text = qobject_cast<LanguageViewer*>(content);
        if (!text)
            return;
        for (QAction* one : text->menuBar()->actions())
            menu->addAction(one);
        menu->menuAction()->setVisible(true);
        connect(text, &QObject::destroyed, menu, [menu] { menu->menuAction()->setVisible(false); });
    });
}

void GraphicalViewer::buildFileMenu() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("New &Graphical Viewer"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G),
                    this, [this] { windows_.openGraphicalViewer(); });
    file->addAction(tr("New &Language Viewer"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                    [this] { windows_.openLanguageViewer(); });
    file->addSeparator();
    if (document_.hasHost())
        file->addAction(tr("&Save"), QKeySequence::Save, this, [this] {
            display_->editing().say(tr("What is changed here is in the document already; the "
                                       "document is saved in its own window, with Ctrl+S."),
                                    false);
        });
    file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
}

void GraphicalViewer::buildEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    const UndoActions undo =
        addUndoActions(edit, document_, [this](bool redo) { return typing(redo); });
    edit->addSeparator();
    // While there is a draft, Undo has something to do.
    connect(&panes_, &Panes::contentMade, this, [this, undo](const QString&, QWidget* content) {
        if (const auto* text = qobject_cast<LanguageViewer*>(content))
            connect(text, &LanguageViewer::draftChanged, this, [this, text, undo] {
                undo.undo->setEnabled(text->hasDraft() || document_.canUndo());
                undo.redo->setEnabled(text->hasDraft() || document_.canRedo());
                updateTitle();
            });
    });
    // Where the picture or a pane of elements has the keyboard: a text copies words.
    const QList<QAction*> copying{
        edit->addAction(tr("Cu&t"), QKeySequence::Cut, this,
                        [this] {
                            if (commands_->copy())
                                display_->editing().remove(document_.selected());
                        }),
        edit->addAction(tr("&Copy"), QKeySequence::Copy, commands_, &ElementCommands::copy),
        edit->addAction(tr("&Paste"), QKeySequence::Paste, commands_, &ElementCommands::paste),
        edit->addAction(tr("Dup&licate"), QKeySequence(Qt::CTRL | Qt::Key_D), commands_,
                        &ElementCommands::duplicate),
        edit->addAction(tr("Select &All"), QKeySequence::SelectAll, this,
                        [this] { display_->selecting().selectAll(); })};
    for (QAction* one : copying)
        one->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    display_->addActions(copying);
    connect(&panes_, &Panes::contentMade, this, [copying](const QString& name, QWidget* content) {
        if (name == QLatin1String("sceneList") || name == QLatin1String("properties"))
            content->addActions(copying);
    });
    QAction* remove =
        edit->addAction(tr("&Delete"), this, [this] { display_->editing().deleteMarked(); });
    QAction* hide =
        edit->addAction(tr("&Hide"), this, [this] { display_->hide(document_.selected()); });
    QAction* showAll =
        edit->addAction(tr("Sho&w All Bodies"), this, [this] { display_->setHidden({}); });
    QAction* value =
        edit->addAction(tr("E&xact Value…"), this, [this] { display_->editing().openEntry(); });
    // Nothing selected: nothing to delete, and no value. A new element's handle is known with its
    // first picture, which tells nobody: the menu looks when it opens.
    connect(edit, &QMenu::aboutToShow, this, [this, remove, value, hide, showAll] {
        const bool marked = display_->editing().marked().has_value();
        remove->setEnabled(marked || !document_.selected().empty());
        value->setEnabled(marked);
        hide->setEnabled(std::ranges::any_of(
            document_.selected(), [](const auto& one) { return one.kind == editing::Kind::body; }));
        showAll->setEnabled(!display_->hidden().empty());
    });
}

bool GraphicalViewer::typing(bool redo) {
    LanguageViewer* viewer = text();
    if (!viewer || !viewer->hasDraft() || !viewer->isAncestorOf(focusWidget()))
        return false;
    redo ? viewer->redo() : viewer->undo();
    return true;
}

void GraphicalViewer::buildMotionMenu() {
    QMenu* motion = menuBar()->addMenu(tr("A&nimation"));
    times_->controls().fillMenu(*motion, [this] { stop(); });
    motion->addSeparator();
    motion->addAction(tr("Start From &Here"), this,
                      [this] { startFromHere(document_, *display_); });
    motion->addAction(tr("&Recompute Motion"), QKeySequence(Qt::Key_F5), this,
                      [this] { document_.recompute(); });
    buildLiveMenu(motion->addMenu(tr("Compute &While Editing")));
    motion->addAction(tr("&Trajectory Editor"), QKeySequence(Qt::CTRL | Qt::Key_T), this,
                      [this] { windows_.openTrajectoryEditor(); });
    motion->addAction(tr("Plo&ts"), this, [this] { panes_.show("plots"); })->setObjectName("plots");
    motion->addAction(tr("Speed and &Accuracy…"), this, [this] { windows_.openStudy(); });
}

void GraphicalViewer::buildLiveMenu(QMenu* menu) {
    auto* choices = new QActionGroup(menu);
    const std::pair<Live, QString> all[] = {
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
                    [this] { display_->frameAll(); })
        ->setObjectName("frameAll");
    view->addAction(tr("Frame the &Motion, From Here"), this, [this] { display_->frameMotion(); });
    view->addAction(tr("Frame &Now"), QKeySequence(Qt::Key_N), this,
                    [this] { display_->frameNow(); });
    view->addAction(tr("Frame &Selected"), QKeySequence(Qt::SHIFT | Qt::Key_F), this,
                    [this] { display_->frameSelected(); });
    QAction* parallel =
        view->addAction(tr("&Orthographic"), QKeySequence(Qt::Key_O), this, [this](bool on) {
            if (on != display_->camera().orthographic)
                display_->setOrthographic(on);
        });
    parallel->setCheckable(true);
    connect(display_, &SceneDisplay::cameraChanged, parallel,
            [this, parallel] { parallel->setChecked(display_->camera().orthographic); });
    buildViewsMenu(view->addMenu(tr("&Views of the Scene")), document_, *display_);
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
    view->addAction(tr("From the &Side and Above"), QKeySequence(Qt::Key_4), this, [this] {
        display_->lookAlong(render::sideAndAbove(render::upOf(*document_.shown().scene)));
    });
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
    QMenu* panes = view->addMenu(tr("&Panes"));
    panes_.fillMenu(*panes);
    panes->addSeparator();
    panes->addAction(tr("As at First"), this, [this] {
        panes_.beginAnew();
        showUsualPanes();
    });
    view->addAction(tr("Te&xt and Picture"), QKeySequence(Qt::Key_F6), this,
                    &GraphicalViewer::switchPane);
    view->addAction(tr("F&ull Screen"), QKeySequence(Qt::Key_F11), this,
                    &GraphicalViewer::toggleFullScreen);
    view->addSeparator();
    for (const StatusPanel::Switch& one : panel_->switches())
        if (!one.isHandle)
            addSwitch(*view, one);
}

void GraphicalViewer::buildHandlesMenu() {
    QMenu* handles = menuBar()->addMenu(tr("&Handles"));
    const auto all = [this](bool on) {
        for (const StatusPanel::Switch& one : panel_->switches())
            if (one.isHandle)
                one.box->setChecked(on);
    };
    handles->addAction(tr("&All"), this, [all] { all(true); });
    handles->addAction(tr("&None"), this, [all] { all(false); });
    handles->addSeparator();
    for (const StatusPanel::Switch& one : panel_->switches())
        if (one.isHandle)
            addSwitch(*handles, one);
}

} // namespace views
