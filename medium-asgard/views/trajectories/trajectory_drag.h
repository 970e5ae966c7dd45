// A gesture on a trajectory: the text follows it, and it is one step of undo (dissertation 4.1.4).
#pragma once

#include "point_edits/trajectory_edit.h"
#include "workbench/scene_document.h"

namespace views {

class TrajectoryDrag {
public:
    // Of the trajectory in the scene that is shown, which must be the text's.
    TrajectoryDrag(SceneDocument& document, std::size_t trajectory);

    [[nodiscard]] const editing::TrajectoryEdits& edits() const { return edits_; }

    // The point that is dragged, to a place that is rounded to what the pointer can tell apart.
    void move(std::size_t point, double time, const geometry::Vector& place, bool breaks);
    void finish(const QString& label = {}); // "": it is a change of the trajectory
    void cancel();                          // the text is as it was
    // Gestures that are done at once; false: the text cannot be changed so, see reason().
    bool add(double time, const geometry::Vector& place);
    bool remove(std::size_t point);

    [[nodiscard]] bool moves() const { return moves_; }
    [[nodiscard]] Asked asked() const { return {since_, answer_}; }
    // The curves as they are now; the scene follows when its text is read.
    [[nodiscard]] const std::vector<scene::BezierCurve>& curves() const { return curves_; }
    [[nodiscard]] QString reason() const; // why it stays as it is; "": it does not

private:
    bool doAtOnce(editing::Answer answer, const QString& label);

    SceneDocument& document_;
    std::string text_; // when it began
    int since_;        // its revision
    QString name_;
    std::vector<scene::BezierCurve> curves_;
    editing::TrajectoryEdits edits_;
    editing::Answer answer_;
    bool moves_ = false;
    double leastInterval_;
};

} // namespace views
