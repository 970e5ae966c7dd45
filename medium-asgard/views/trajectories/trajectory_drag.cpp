#include "trajectories/trajectory_drag.h"

namespace views {

namespace {

// Two points are never nearer in time than this part of the whole.
constexpr double leastGap = 1e-3;

} // namespace

TrajectoryDrag::TrajectoryDrag(SceneDocument& document, std::size_t trajectory)
    : document_(document), text_(document.text()), since_(document.revision()),
      name_(QString::fromStdString(document.shown().scene->trajectories[trajectory].name)),
      curves_(document.shown().scene->trajectories[trajectory].curves),
      edits_(text_, document.shown().scene, trajectory),
      leastInterval_(leastGap * (curves_.back().to - curves_.front().from)) {}

void TrajectoryDrag::move(std::size_t point, double time, const geometry::Vector& place,
                          bool breaks) {
    moves_ = true;
    answer_ = edits_.move(point, time, place, leastInterval_, breaks);
    if (!answer_.possible())
        return;
    curves_ = edits_.moved(point, time, place, leastInterval_, breaks);
    document_.preview(text::applied(text_, answer_.edits), since_, this);
}

QString TrajectoryDrag::reason() const {
    return moves_ && !document_.mayGoOn(since_) ? SceneDocument::overtaken()
                                                : QString::fromStdString(answer_.reason);
}

void TrajectoryDrag::finish(const QString& label) {
    document_.finishPreview(
        answer_.possible() ? text::applied(text_, answer_.edits) : text_,
        label.isEmpty() ? QObject::tr("Change Trajectory %1").arg(name_) : label, since_, this);
    moves_ = false;
}

void TrajectoryDrag::cancel() {
    document_.finishPreview(text_, {}, since_, this);
    moves_ = false;
}

bool TrajectoryDrag::doAtOnce(editing::Answer answer, const QString& label) {
    answer_ = std::move(answer);
    if (answer_.possible())
        document_.setText(text::applied(text_, answer_.edits), label);
    return answer_.possible();
}

bool TrajectoryDrag::add(double time, const geometry::Vector& place) {
    return doAtOnce(edits_.add(time, place), QObject::tr("Add Point to %1").arg(name_));
}

bool TrajectoryDrag::remove(std::size_t point) {
    return doAtOnce(edits_.remove(point), QObject::tr("Delete Point of %1").arg(name_));
}

} // namespace views
