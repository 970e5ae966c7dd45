// A new point of a trajectory, dragged out of one that is there: before or after it, by the
// direction in which the pointer goes (dissertation 4.1.4). One step of undo, as HandleDrag.
#pragma once

#include "gestures/ground.h"
#include "gestures/picking.h"
#include "point_edits/trajectory_edit.h"

namespace gestures {

// Which of editing/'s points a handle is.
[[nodiscard]] std::size_t pointOf(const editing::TrajectoryEdits& edits,
                                  const render::Handle& handle);

// The same, of a trajectory: editing::controlPointsOf() and a handle's part.
[[nodiscard]] std::size_t pointOf(const scene::Trajectory& trajectory, std::size_t part);
[[nodiscard]] std::size_t partOf(const scene::Trajectory& trajectory, std::size_t point);

class NewPoint {
public:
    NewPoint(Ground ground, const Sight& sight, const render::Handle& from);

    void move(const Eigen::Vector2d& pixels);
    // As the keys do it: halfway to the next point.
    void after();
    void finish();
    void cancel();
    [[nodiscard]] std::string words() const;
    [[nodiscard]] geometry::Vector place() const { return handle_.placeOf(place_); } // world
    [[nodiscard]] const editing::Answer& answer() const { return answer_; }

private:
    [[nodiscard]] double timeTowards(bool later) const;
    void update();

    Ground ground_;
    editing::TrajectoryEdits edits_;
    Sight sight_;
    render::Handle handle_; // of the point that it is drawn out of
    std::size_t from_, trajectory_;
    geometry::Vector place_; // the trajectory's value
    double time_ = 0;
    std::optional<bool> later_; // once the direction is clear
    editing::Answer answer_;
};

} // namespace gestures
