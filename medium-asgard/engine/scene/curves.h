// The curves of trajectories as values (docs/scene-language.md, `trajectory`).
#pragma once

#include "scene/scene.h"

namespace scene {

// The curves of -points: cubic segments through points whose times increase, C1. The slope at point
// i is that of the chord from its predecessor to its successor, at the ends that of the one chord.
// At least two points.
[[nodiscard]] std::vector<BezierCurve>
smoothCurves(const std::vector<std::pair<double, Vector>>& points);

// Where they are at a time; none: no curve says anything of it. The last one holds at its end too.
[[nodiscard]] std::optional<Vector> valueAt(const std::vector<BezierCurve>& curves, double time);

// A curve in two at a time within it, which together are what it was (de Casteljau).
[[nodiscard]] std::pair<BezierCurve, BezierCurve> split(const BezierCurve& curve, double time);

} // namespace scene
