// A trajectory as points and tangents that are moved, added and removed, each as a change of the
// text (dissertation 4.1.4).
//
// The author drags the control points of the trajectory's Bezier curves. A curve's parameter is
// linear in time, so control point i of a curve of degree n belongs to the time t0 + i/n (t1 - t0):
// there it stands in a graph of one component against time, and the first and the last lie on the
// curve. Where one curve ends as the next begins there is one point, which belongs to both.
//
// -points has the points alone; its tangents follow from them. A drag of such a tangent needs
// -bezier: then the whole list is rewritten.
//
// Reference: dissertation 4.1.4; docs/scene-language.md, `trajectory`.
#pragma once

#include "editing/value_edit.h"

namespace editing {

struct ControlPoint {
    std::size_t curve = 0, index = 0; // of the curve that it ends, where it also begins one
    double time = 0;
    geometry::Vector place = geometry::Vector::Zero();
    bool onCurve = true; // else the end of a tangent (or of a higher degree's inner polygon)
    bool joins = false;  // it also begins the next curve
};

// In the order of time.
[[nodiscard]] std::vector<ControlPoint>
controlPointsOf(const std::vector<scene::BezierCurve>& curves);

class TrajectoryEdits {
public:
    // Of `scene`, which was read from `text`.
    TrajectoryEdits(std::string text, std::shared_ptr<const scene::Scene> scene,
                    std::size_t trajectory);

    [[nodiscard]] const std::vector<ControlPoint>& points() const { return points_; }
    // Written as -points: moving a tangent rewrites the list.
    [[nodiscard]] bool hasOwnTangents() const { return !fromPoints_; }

    // The point now, as numbers of the text: of -points with its time. Of a point on the curve
    // between -points, or a control point of -bezier.
    [[nodiscard]] Wish wishOf(std::size_t point) const;

    // The point goes there; its tangents go with it. Between two curves that meet smoothly a
    // dragged tangent turns its opposite, unless `breaks`. Times stay in order, with
    // `leastInterval` between two points; tangents keep theirs. Values are taken as they are.
    [[nodiscard]] Answer move(std::size_t point, double time, const geometry::Vector& place,
                              double leastInterval, bool breaks = false) const;
    // A new point at a time at which there is none; before the first and after the last the
    // trajectory becomes longer.
    [[nodiscard]] Answer add(double time, const geometry::Vector& place) const;
    // LIMIT: of -bezier's points only those between two cubic curves, and the first and the last.
    [[nodiscard]] Answer remove(std::size_t point) const;

    // The curves after a move, before they are text: what is drawn while the text cannot follow.
    [[nodiscard]] std::vector<scene::BezierCurve> moved(std::size_t point, double time,
                                                        const geometry::Vector& place,
                                                        double leastInterval, bool breaks) const;

private:
    using Curves = std::vector<scene::BezierCurve>;
    [[nodiscard]] const scene::Trajectory& trajectory() const {
        return scene_->trajectories[trajectory_];
    }
    [[nodiscard]] std::size_t knotOf(std::size_t point) const; // its place among -points
    [[nodiscard]] double allowedTime(std::size_t point, double time, double leastInterval) const;
    [[nodiscard]] Wish wish(std::string option, std::vector<std::size_t> path,
                            std::vector<double> values) const;
    [[nodiscard]] Answer numbersOf(const Curves& curves) const;
    [[nodiscard]] Answer rewritten(const Curves& curves) const;
    // Where element `index` of the option's list stands, with its braces; unknown: it cannot be
    // told, or changed.
    [[nodiscard]] Answer place(const std::string& option, std::size_t index,
                               scene::Range& range) const;
    [[nodiscard]] Answer insertAt(const std::string& option, std::size_t before, std::size_t count,
                                  const std::string& element) const;
    [[nodiscard]] Answer removeAt(const std::string& option, std::size_t index,
                                  std::size_t count) const;
    // The scene's curves are in the order of time, the text's in the author's.
    [[nodiscard]] std::size_t placeInText(std::size_t curve) const;

    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
    std::size_t trajectory_;
    Mapper mapper_;
    bool fromPoints_;
    std::vector<ControlPoint> points_;
};

} // namespace editing
