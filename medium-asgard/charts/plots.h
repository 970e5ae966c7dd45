// The plots of a scene: quantities against time, and how they look on a page.
#pragma once

#include "charts/canvas.h"
#include "scene/scene.h"
#include "simulation/simulation.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace charts {

enum class Stroke { solid, dashed, dotted, dashDotted };

struct Curve {
    std::string label;
    std::vector<double> values = {}; // at the plot's times, in its unit; NaN: not defined there
    Color color = {};
    Stroke stroke = Stroke::solid;
    std::string unit = {}; // "m/s", "°"; "": none, or not known
};

struct Plot {
    std::string title;
    std::vector<double> times = {}; // s
    std::vector<Curve> curves = {};
    std::string fault = {};  // "" or why there are no values
    std::string values = {}; // the name of their axis: "x of b1, m"; "" where curves differ
};

inline constexpr const char* timeAxis = "time, s";

// The unit in which charts show values that have this one in expressions, and how many of it one
// is: angles are said in degrees, as everywhere that people read them.
struct Said {
    std::string unit;
    double factor = 1;
};
[[nodiscard]] Said saidAs(const std::string& unit);

// Its title and its curves, without values. A curve about one coloured body has that body's colour,
// darkened where white paper would swallow it; curves that would look alike differ in their
// strokes.
[[nodiscard]] Plot named(const scene::Scene& scene, const scene::Plot& plot);

// With the values as far as the motion is computed; `readable` is of that scene. None:
// `isOvertaken` said so meanwhile.
[[nodiscard]] std::optional<Plot> sampled(
    simulation::ReadableScene& readable, const scene::Scene& scene, const scene::Plot& plot,
    const simulation::MotionPointer& motion,
    const std::function<bool()>& isOvertaken = [] { return false; });

// The least and the greatest value, with some room about them.
struct Range {
    double low = 0, high = 1;
};
[[nodiscard]] Range rangeOf(const Plot& plot);

// Where a plot stands on a canvas, and the times between its left and right edge.
struct PlotArea {
    double left = 0, top = 0, width = 0, height = 0;
    double start = 0, finish = 1;

    // Of a point of the canvas: within start..finish.
    [[nodiscard]] double timeAt(double x) const;
};

// Title, key, axes, curves; a line at the time `now`.
void draw(Canvas& canvas, const Plot& plot, const PlotArea& area,
          double now = std::numeric_limits<double>::quiet_NaN());
// The part of the area between the axes.
[[nodiscard]] PlotArea insideOf(const PlotArea& area);

} // namespace charts
