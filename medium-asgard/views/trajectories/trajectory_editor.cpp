#include "trajectories/trajectory_editor.h"

#include "frame/help_menu.h"
#include "frame/names_box.h"
#include "frame/undo_actions.h"
#include "plain/plain.h"
#include "scene/curves.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

QString text(double value) { return QString::number(value, 'g', 12); }

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
    : document_(document), names_(new QComboBox), role_(plain::label()), words_(plain::label()) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("trajectoryEditor");
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(12, 10, 12, 10);
    auto* top = new QHBoxLayout;
    names_->setObjectName("trajectories");
    names_->setAccessibleName(tr("Trajectory"));
    names_->setMinimumContentsLength(12);
    names_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    role_->setForegroundRole(QPalette::PlaceholderText);
    top->addWidget(names_);
    top->addWidget(role_, 1);
    for (const auto& [label, tip, factor] :
         {std::tuple(QStringLiteral("−"), tr("See more of the time (Ctrl+-)"), 1.5),
          std::tuple(QStringLiteral("+"), tr("See less of the time, larger (Ctrl++)"), 1 / 1.5)}) {
        auto* button = new QToolButton;
        button->setText(plain::ours(label));
        button->setToolTip(plain::tip(tip));
        connect(button, &QToolButton::clicked, this, [this, by = factor] { zoomTimes(by); });
        top->addWidget(button);
    }
    auto* fit = new QToolButton;
    fit->setText(tr("All"));
    fit->setToolTip(tr("See the whole trajectory (Ctrl+0)"));
    connect(fit, &QToolButton::clicked, this, &TrajectoryEditor::fitTimes);
    top->addWidget(fit);
    column->addLayout(top);
    const QString axes[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    for (int i = 0; i < 3; ++i) {
        auto* graph = new TrajectoryGraph(i, axes[i]);
        graph->setObjectName("graph" + axes[i]);
        graphs_[at(i)] = graph;
        column->addWidget(graph, 1);
        connectGraph(graph);
    }
    column->addWidget(fields_ = buildFields());
    words_->setWordWrap(true);
    words_->setMinimumHeight(2 * words_->fontMetrics().height());
    words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    words_->setObjectName("hint");
    words_->setAccessibleName(tr("Hint"));
    column->addWidget(words_);
    setCentralWidget(whole);
    buildMenus();
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
    resize(700, 720);
}

void TrajectoryEditor::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    addUndoActions(edit, document_);
    edit->addSeparator();
    edit->addAction(tr("&Add Point"), QKeySequence(Qt::Key_Insert), this,
                    &TrajectoryEditor::addAfterChosen);
    remove_ = edit->addAction(tr("&Delete Point"), QKeySequence(Qt::Key_Delete), this,
                              &TrajectoryEditor::removeChosen);
    edit->addSeparator();
    edit->addAction(tr("&Next Point"), QKeySequence(Qt::Key_PageDown), this,
                    [this] { chooseNext(1); });
    edit->addAction(tr("&Previous Point"), QKeySequence(Qt::Key_PageUp), this,
                    [this] { chooseNext(-1); });
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("Zoom &In"), QKeySequence::ZoomIn, this, [this] { zoomTimes(1 / 1.5); });
    view->addAction(tr("Zoom &Out"), QKeySequence::ZoomOut, this, [this] { zoomTimes(1.5); });
    view->addAction(tr("&Whole Trajectory"), QKeySequence(Qt::CTRL | Qt::Key_0), this,
                    &TrajectoryEditor::fitTimes);
    addHelpMenu(this, QStringLiteral("Trajectory editor"));
}

QWidget* TrajectoryEditor::buildFields() {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    const auto field = [&](const QString& name, const QString& accessible) {
        auto* label = plain::label(name);
        auto* edit = new QLineEdit;
        edit->setAccessibleName(accessible);
        edit->setMaximumWidth(130);
        label->setBuddy(edit);
        line->addWidget(label);
        line->addWidget(edit);
        // Return or another field: what was typed is the value.
        connect(edit, &QLineEdit::editingFinished, this, [this, edit] {
            if (edit->isModified())
                setFromFields();
        });
        return edit;
    };
    time_ = field(tr("time"), tr("Time of the point"));
    const QString axes[] = {tr("x"), tr("y"), tr("z")};
    for (int i = 0; i < 3; ++i)
        values_[i] = field(axes[i], tr("%1 of the point").arg(axes[i]));
    line->addStretch();
    return row;
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

QString TrajectoryEditor::words() const { return words_->text(); }

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

void TrajectoryEditor::followScene() {
    const auto& all = document_.shown().scene->trajectories;
    fill(*names_, namesOf(all));
    const auto here = index();
    names_->setEnabled(here.has_value());
    const bool hadNone = !fields_->isEnabled();
    fields_->setEnabled(here.has_value());
    role_->setText(here ? roleOf(all[*here]) : QString());
    if (here && shownName_ != names_->currentText()) {
        shownName_ = names_->currentText();
        chosen_.reset();
        fitTimes();
    }
    showCurves();
    if (!here)
        tell(tr("This scene has no trajectory. One is written as  "
                "trajectory path -points {{0 0 0 0} {1 2 0 0}}"));
    else if (words_->text().isEmpty() || hadNone)
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
    showPoint();
    remove_->setEnabled(chosen_ && points[*chosen_].onCurve);
}

void TrajectoryEditor::showPoint() {
    const auto here = index();
    const auto points =
        !here ? std::vector<editing::ControlPoint>()
              : editing::controlPointsOf(gesture_ && gesture_->moves()
                                             ? gesture_->curves()
                                             : document_.shown().scene->trajectories[*here].curves);
    const bool is = chosen_ && *chosen_ < points.size();
    for (QLineEdit* field : {time_, values_[0], values_[1], values_[2]})
        field->setEnabled(is);
    time_->setReadOnly(is && !points[*chosen_].onCurve);
    const auto put = [](QLineEdit* field, const QString& value) {
        if (!field->isModified() || !field->hasFocus())
            field->setText(value);
    };
    put(time_, is ? text(points[*chosen_].time) : QString());
    for (int i = 0; i < 3; ++i)
        put(values_[i], is ? text(points[*chosen_].place[i]) : QString());
}

void TrajectoryEditor::tell(const QString& words, bool isFault) {
    words_->setForegroundRole(isFault ? QPalette::WindowText : QPalette::PlaceholderText);
    words_->setText(
        words.isEmpty()
            ? tr("Drag points and the tangents beside them. A double click adds a point, Delete "
                 "removes it; Shift breaks a tangent. Page Up and Page Down go from point to "
                 "point, "
                 "the arrow keys move it.")
            : words);
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
