// What the gestures of a trajectory editor change of its trajectory.
#include "editing/number_text.h"
#include "scene/curves.h"
#include "script/numbers.h"
#include "trajectories/point_table.h"
#include "trajectories/trajectory_editor.h"

#include <QComboBox>

#include <cmath>

namespace views {

namespace {

// To a decimal that the pointer can tell apart, free of the digits that rounding leaves.
double decimal(double value, double pixel) {
    return editing::roundedTo(value, editing::decimalStep(pixel));
}

} // namespace

bool TrajectoryEditor::begin() {
    const auto here = index();
    if (gesture_)
        return true;
    if (const QString fault = document_.whyNotCurrent(); !here || !fault.isEmpty()) {
        if (!fault.isEmpty())
            tell(fault, true);
        return false;
    }
    gesture_ = std::make_unique<TrajectoryDrag>(document_, *here);
    return true;
}

std::optional<Asked> TrajectoryEditor::asked() const {
    return gesture_ && gesture_->moves() ? std::optional(gesture_->asked()) : std::nullopt;
}

// What was dragged stays where it is, and the hand lets go of it.
void TrajectoryEditor::finishGesture() {
    if (gesture_ && gesture_->moves())
        gesture_->finish();
    gesture_.reset();
    for (TrajectoryGraph* graph : graphs_)
        graph->letGo();
}

void TrajectoryEditor::drag(int component, double time, double value,
                            Qt::KeyboardModifiers modifiers) {
    if (!chosen_ || !begin())
        return;
    const auto& point = gesture_->edits().points()[*chosen_];
    for (TrajectoryGraph* graph : graphs_)
        graph->setHoldsValues(true);
    const TrajectoryGraph& graph = *graphs_[at(component)];
    Place place = point.place;
    // What was hardly moved was not meant, and keeps its digits.
    if (std::abs(value - place[component]) > 0.5 * graph.valueStep())
        place[component] = decimal(value, graph.valueStep());
    if (time != point.time)
        time = decimal(time, graph.timeStep());
    gesture_->move(*chosen_, time, place, modifiers & Qt::ShiftModifier);
    showCurves();
    if (!gesture_->reason().isEmpty())
        tell(gesture_->reason(), true);
    else if (!point.onCurve && !gesture_->edits().hasOwnTangents())
        tell(tr("A tangent of its own: %1 is now written with -bezier, as curves. Undo takes it "
                "back.")
                 .arg(names_->currentText()));
}

// By keys: a pixel's worth in one graph, one step of undo for each.
void TrajectoryEditor::nudge(int component, double times, double values) {
    if (!chosen_ || !begin())
        return;
    const TrajectoryGraph& graph = *graphs_[at(component)];
    const auto& point = gesture_->edits().points()[*chosen_];
    const double timeStep = editing::decimalStep(graph.timeStep() * 10);
    const double valueStep = editing::decimalStep(graph.valueStep() * 10);
    Place place = point.place;
    if (values != 0)
        place[component] = decimal(place[component] + values * valueStep, valueStep);
    gesture_->move(*chosen_,
                   times == 0 ? point.time : decimal(point.time + times * timeStep, timeStep),
                   place, false);
    const QString reason = gesture_->reason();
    gesture_->finish();
    gesture_.reset();
    if (!reason.isEmpty())
        tell(reason, true);
}

void TrajectoryEditor::setFromCell(std::size_t which, int column, const QString& typed) {
    finishGesture();
    const auto refuse = [&](const QString& why) {
        gesture_.reset();
        table_->refuse(which, column, typed, why);
        tell(why, true);
    };
    if (!begin())
        return refuse(document_.whyNotCurrent());
    choose(which);
    const auto value = script::decimalNumber(typed.toStdString());
    if (!value)
        return refuse(tr("\"%1\" is no number.").arg(typed));
    const editing::ControlPoint point = gesture_->edits().points()[which];
    Place place = point.place;
    if (column > 0)
        place[column - 1] = *value;
    const double time = column == 0 ? *value : point.time;
    gesture_->move(which, time, place, false);
    if (const QString why = gesture_->reason(); !why.isEmpty()) {
        gesture_->cancel();
        return refuse(why);
    }
    const double is = editing::controlPointsOf(gesture_->curves())[which].time;
    if (std::abs(is - time) > 1e-9 * std::max(1.0, std::abs(time))) {
        gesture_->cancel();
        return refuse(tr("A point stays between its neighbours: %1 s is as near as it gets.")
                          .arg(QString::number(is, 'g', 6)));
    }
    table_->forgive();
    gesture_->finish();
    gesture_.reset();
    followScene();
    tell({});
}

void TrajectoryEditor::addAt(int component, double time, double value) {
    finishGesture();
    if (!begin())
        return;
    const TrajectoryGraph& graph = *graphs_[at(component)];
    const auto& curves = gesture_->curves();
    time = decimal(time, graph.timeStep());
    // On the curve in the other components; beyond its ends as at the nearest.
    const Place end =
        time < curves.front().from ? curves.front().control.front() : curves.back().control.back();
    Place place = scene::valueAt(curves, time).value_or(end);
    for (int i = 0; i < 3; ++i)
        place[i] = decimal(i == component ? value : place[i], graphs_[at(i)]->valueStep());
    if (gesture_->add(time, place))
        chooseAt_ = time;
    else
        tell(gesture_->reason(), true);
    gesture_.reset();
    followScene();
}

// In the middle of the way to the next point; after the last as far again as from the one before.
void TrajectoryEditor::addAfterChosen() {
    finishGesture();
    if (!begin())
        return;
    std::vector<editing::ControlPoint> knots;
    std::size_t after = 0;
    const auto& points = gesture_->edits().points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].onCurve)
            continue;
        knots.push_back(points[i]);
        if (!chosen_ || i <= *chosen_)
            after = knots.size() - 1;
    }
    const double now = knots[after].time;
    const double time = after + 1 < knots.size() ? (now + knots[after + 1].time) / 2
                        : after > 0              ? 2 * now - knots[after - 1].time
                                                 : gesture_->curves().back().to + 1;
    const auto on = scene::valueAt(gesture_->curves(), time).value_or(knots[after].place);
    gesture_.reset();
    addAt(0, time, on.x());
}

void TrajectoryEditor::removeChosen() {
    finishGesture();
    if (!chosen_ || !begin())
        return;
    if (gesture_->remove(*chosen_))
        chosen_.reset();
    else
        tell(gesture_->reason(), true);
    gesture_.reset();
    followScene();
}

} // namespace views
