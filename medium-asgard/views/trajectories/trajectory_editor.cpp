#include "trajectories/trajectory_editor.h"

#include "frame/help_menu.h"
#include "frame/hint_line.h"
#include "frame/names_box.h"
#include "frame/tool_bar.h"
#include "frame/undo_actions.h"
#include "plain/plain.h"
#include "scene/curves.h"
#include "trajectories/point_table.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

QString held(scene::Held what) {
    using scene::Held;
    switch (what) {
    case Held::position:
        return TrajectoryEditor::tr("the position of %1");
    case Held::attitude:
        return TrajectoryEditor::tr("the orientation of %1 (a rotation vector, in radians)");
    case Held::velocity:
        return TrajectoryEditor::tr("the velocity of %1");
    case Held::angularVelocity:
        return TrajectoryEditor::tr("the angular velocity of %1");
    default:
        return TrajectoryEditor::tr("one component of %1");
    }
}

} // namespace

TrajectoryEditor::TrajectoryEditor(SceneDocument& document)
    : document_(document), names_(new QComboBox), role_(plain::label()), words_(new HintLine),
      table_(new PointTable) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("trajectoryEditor");
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    role_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(role_);
    auto* graphs = new QWidget;
    auto* above = new QVBoxLayout(graphs);
    above->setContentsMargins(0, 0, 0, 0);
    const QString axes[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    for (int i = 0; i < 3; ++i) {
        auto* graph = new TrajectoryGraph(i, axes[i]);
        graph->setObjectName("graph" + axes[i]);
        graphs_[at(i)] = graph;
        above->addWidget(graph, 1);
        connectGraph(graph);
    }
    auto* middle = new QSplitter;
    middle->setChildrenCollapsible(false);
    middle->addWidget(graphs);
    buildMenus();
    buildTools();
    middle->addWidget(buildTable());
    middle->setStretchFactor(0, 1);
    column->addWidget(middle, 1);
    words_->setObjectName("hint");
    column->addWidget(words_);
    setCentralWidget(whole);
    connect(names_, &QComboBox::currentTextChanged, this, [this] { followScene(); });
    connect(&document_, &SceneDocument::sceneChanged, this, &TrajectoryEditor::followScene);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &TrajectoryEditor::followScene);
    const auto name = [this] {
        setWindowTitle(tr("%1[*] – Trajectory Editor").arg(plain::title(document_.name())));
        setWindowModified(!document_.hasHost() && document_.isModified());
    };
    connect(&document_, &SceneDocument::nameChanged, this, name);
    name();
    followScene();
    resize(960, 720);
}

void TrajectoryEditor::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    addUndoActions(edit, document_);
    edit->addSeparator();
    add_ = edit->addAction(tr("&Add Point"), QKeySequence(Qt::Key_Insert), this,
                           &TrajectoryEditor::addAfterChosen);
    add_->setObjectName("addPoint");
    remove_ = edit->addAction(tr("&Delete Point"), QKeySequence(Qt::Key_Delete), this,
                              &TrajectoryEditor::removeChosen);
    remove_->setObjectName("deletePoint");
    edit->addSeparator();
    edit->addAction(tr("&Next Point"), QKeySequence(Qt::Key_PageDown), this,
                    [this] { chooseNext(1); });
    edit->addAction(tr("&Previous Point"), QKeySequence(Qt::Key_PageUp), this,
                    [this] { chooseNext(-1); });
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("Zoom &In"), QKeySequence::ZoomIn, this, [this] { zoomTimes(1 / 1.5); })
        ->setObjectName("zoomIn");
    view->addAction(tr("Zoom &Out"), QKeySequence::ZoomOut, this, [this] { zoomTimes(1.5); })
        ->setObjectName("zoomOut");
    view->addAction(tr("&Whole Trajectory"), QKeySequence(Qt::CTRL | Qt::Key_0), this,
                    &TrajectoryEditor::fitTimes)
        ->setObjectName("whole");
    addHelpMenu(this, QStringLiteral("Trajectory editor"));
}

void TrajectoryEditor::buildTools() {
    names_->setObjectName("trajectories");
    names_->setAccessibleName(tr("Trajectory"));
    names_->setMinimumContentsLength(12);
    names_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* bar = new ToolBar(*this);
    bar->addWidget(names_);
    for (const auto& group : std::initializer_list<std::vector<std::pair<const char*, Icon>>>{
             {{"undo", Icon::undo}, {"redo", Icon::redo}},
             {{"addPoint", Icon::add}, {"deletePoint", Icon::remove}},
             {{"zoomIn", Icon::zoomIn}, {"zoomOut", Icon::zoomOut}, {"whole", Icon::frameAll}},
             {{"help", Icon::help}}}) {
        bar->addSeparator();
        for (const auto& [name, which] : group)
            bar->add(name, which);
    }
}

// With the two commands that change its rows.
QWidget* TrajectoryEditor::buildTable() {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_, 1);
    auto* row = new QHBoxLayout;
    for (QAction* command : {add_, remove_}) {
        auto* button = new QToolButton;
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setDefaultAction(command);
        row->addWidget(button);
    }
    row->addStretch();
    column->addLayout(row);
    connect(table_, &PointTable::chosen, this, [this](std::size_t point) {
        if (!gesture_)
            choose(point);
    });
    connect(table_, &PointTable::typed, this, &TrajectoryEditor::setFromCell);
    return whole;
}

void TrajectoryEditor::connectGraph(TrajectoryGraph* graph) {
    const int component = graph->component();
    connect(graph, &TrajectoryGraph::chosen, this, [this](std::size_t point) {
        gesture_.reset();
        choose(point);
    });
    connect(graph, &TrajectoryGraph::dragged, this,
            [this, component](double time, double value, Qt::KeyboardModifiers modifiers) {
                drag(component, time, value, modifiers);
            });
    connect(graph, &TrajectoryGraph::released, this, [this] {
        if (gesture_ && gesture_->moves())
            gesture_->finish();
        gesture_.reset();
        for (TrajectoryGraph* one : graphs_)
            one->setHoldsValues(false);
        followScene();
    });
    connect(graph, &TrajectoryGraph::addWanted, this,
            [this, component](double time, double value) { addAt(component, time, value); });
    connect(graph, &TrajectoryGraph::menuWanted, this,
            [this, component](const QPoint& position, std::optional<std::size_t> point, double time,
                              double value) { showMenu(component, position, point, time, value); });
    connect(graph, &TrajectoryGraph::timesWanted, this, &TrajectoryEditor::setTimes);
}

// --- what is shown -----------------------------------------------------------------------------

QString TrajectoryEditor::trajectory() const { return names_->currentText(); }

QString TrajectoryEditor::words() const { return words_->all(); }

std::optional<std::size_t> TrajectoryEditor::index() const {
    return indexNamed(document_.shown().scene->trajectories, names_->currentText());
}

void TrajectoryEditor::showTrajectory(const QString& name) {
    if (const int row = names_->findText(name); row >= 0)
        names_->setCurrentIndex(row);
}

void TrajectoryEditor::setNow(std::optional<double> time) {
    for (TrajectoryGraph* graph : graphs_)
        graph->setNow(time);
}

QString TrajectoryEditor::roleOf(const scene::Trajectory& trajectory) const {
    for (const scene::Constraint& constraint : document_.shown().scene->constraints)
        if (constraint.trajectory == trajectory.name)
            return tr("leads %1")
                .arg(held(constraint.held).arg(QString::fromStdString(constraint.body)));
    return tr("leads nothing yet");
}

// Of the places, by what the trajectory leads; "": nothing, or various things.
QString TrajectoryEditor::unitOf(const scene::Trajectory& trajectory) const {
    using scene::Held;
    QString unit;
    for (const scene::Constraint& constraint : document_.shown().scene->constraints) {
        if (constraint.trajectory != trajectory.name)
            continue;
        const Held held = constraint.held;
        const QString one = held == Held::attitude          ? QStringLiteral("rad")
                            : held == Held::velocity        ? QStringLiteral("m/s")
                            : held == Held::angularVelocity ? QStringLiteral("rad/s")
                                                            : QStringLiteral("m");
        if (!unit.isEmpty() && one != unit)
            return {};
        unit = one;
    }
    return unit;
}

void TrajectoryEditor::followScene() {
    const auto& all = document_.shown().scene->trajectories;
    fill(*names_, namesOf(all));
    const auto here = index();
    names_->setEnabled(here.has_value());
    const bool hadNone = !table_->isEnabled();
    table_->setEnabled(here.has_value());
    add_->setEnabled(here.has_value());
    role_->setText(here ? roleOf(all[*here]) : QString());
    table_->setUnit(here ? unitOf(all[*here]) : QString());
    if (here && shownName_ != names_->currentText()) {
        shownName_ = names_->currentText();
        chosen_.reset();
        fitTimes();
    }
    showCurves();
    if (!here)
        tell(tr("This scene has no trajectory. Create > Trajectory in the viewer makes one, or in "
                "the text  "
                "trajectory path -points {{0 0 0 0} {1 2 0 0}}"));
    else if (words_->all().isEmpty() || hadNone)
        tell({});
}

void TrajectoryEditor::showCurves() {
    const auto here = index();
    std::vector<scene::BezierCurve> curves;
    std::vector<editing::ControlPoint> points;
    if (gesture_ && gesture_->moves()) { // the text may be on its way
        curves = gesture_->curves();
        points = editing::controlPointsOf(curves);
    } else if (here) {
        curves = document_.shown().scene->trajectories[*here].curves;
        points = editing::controlPointsOf(curves);
    }
    if (chooseAt_ && document_.sceneIsCurrent()) {
        const auto there = std::ranges::find_if(points, [&](const auto& point) {
            return point.onCurve && std::abs(point.time - *chooseAt_) < 1e-9;
        });
        chooseAt_.reset();
        if (there != points.end())
            chosen_ = static_cast<std::size_t>(there - points.begin());
    }
    if (chosen_ && *chosen_ >= points.size())
        chosen_.reset();
    for (TrajectoryGraph* graph : graphs_) {
        graph->setCurves(curves, points);
        graph->setChosen(chosen_);
    }
    const bool ownTangents = here && document_.shown().scene->trajectories[*here].points.empty();
    table_->setPoints(points, ownTangents || (gesture_ && gesture_->edits().hasOwnTangents()));
    table_->setChosen(chosen_);
    remove_->setEnabled(chosen_ && points[*chosen_].onCurve);
}

void TrajectoryEditor::tell(const QString& words, bool isFault) {
    words_->say(words.isEmpty()
                    ? tr("Drag moves a point or the tangents beside it, Shift breaks a tangent  ·  "
                         "a double click adds a point, Delete removes it  ·  Page Up, Page Down: "
                         "point by point, the arrow keys move it")
                    : words,
                isFault);
}

// --- the axis of time --------------------------------------------------------------------------

void TrajectoryEditor::fitTimes() {
    const auto here = index();
    if (!here)
        return;
    const auto& curves = document_.shown().scene->trajectories[*here].curves;
    const double room = 0.05 * (curves.back().to - curves.front().from);
    setTimes(curves.front().from - room, curves.back().to + room);
}

void TrajectoryEditor::zoomTimes(double factor) {
    const double middle = (from_ + to_) / 2;
    setTimes(middle + factor * (from_ - middle), middle + factor * (to_ - middle));
}

void TrajectoryEditor::setTimes(double from, double to) {
    constexpr double least = 1e-6, most = 1e6;
    if (!(to - from > least) || !(to - from < most))
        return;
    from_ = from;
    to_ = to;
    for (TrajectoryGraph* graph : graphs_)
        graph->setTimes(from, to);
}

// --- what is chosen; trajectory_changes.cpp has what gestures change ---------------------------

void TrajectoryEditor::choose(std::optional<std::size_t> point) {
    chosen_ = point;
    showCurves();
    tell({});
}

void TrajectoryEditor::chooseNext(int direction) {
    const auto here = index();
    if (!here)
        return;
    const auto points =
        editing::controlPointsOf(document_.shown().scene->trajectories[*here].curves);
    const auto count = static_cast<int>(points.size());
    const int from = chosen_         ? static_cast<int>(*chosen_) + direction
                     : direction > 0 ? 0
                                     : count - 1;
    if (from >= 0 && from < count)
        choose(static_cast<std::size_t>(from));
}

void TrajectoryEditor::showMenu(int component, const QPoint& position,
                                std::optional<std::size_t> point, double time, double value) {
    QMenu menu;
    if (point) {
        choose(point);
        menu.addAction(remove_);
    } else {
        menu.addAction(tr("&Add Point Here"), this, [=, this] { addAt(component, time, value); });
    }
    menu.exec(position);
}

void TrajectoryEditor::keyPressEvent(QKeyEvent* event) {
    int component = 0;
    for (TrajectoryGraph* graph : graphs_)
        if (graph->hasFocus())
            component = graph->component();
    const double many = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_Up:
        return nudge(component, 0, many);
    case Qt::Key_Down:
        return nudge(component, 0, -many);
    case Qt::Key_Left:
        return nudge(component, -many, 0);
    case Qt::Key_Right:
        return nudge(component, many, 0);
    case Qt::Key_Escape:
        if (gesture_ && gesture_->moves())
            gesture_->cancel();
        finishGesture();
        return followScene();
    default:
        QMainWindow::keyPressEvent(event);
    }
}

} // namespace views
