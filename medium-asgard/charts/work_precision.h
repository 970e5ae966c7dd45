// Error against time, both logarithmic: a line and a marker for each method.
//
// Points that failed are hollow, in a lighter line, and carry a letter that the key under the chart
// explains. Those that have no error, or one larger than the scene, stand above the frame, each
// method in a row of its own; beside a method's name stands how often it failed, and how. Points at
// fixed steps are small and joined by dashes. The chosen point is ringed.
#pragma once

#include "charts/canvas.h"

#include <optional>
#include <string>
#include <vector>

namespace charts {

struct WorkPoint {
    double seconds = 0;
    std::optional<double> error;
    std::string failure; // empty: none; else one word or two, the same for the same failure
    bool minor = false;  // a failure without a letter: the marker is hollow
    bool fixedStep = false;
    bool chosen = false;
};

struct WorkSeries {
    std::string name;
    std::vector<WorkPoint> points; // in the order in which they are joined
};

struct WorkPrecision {
    std::string title, subtitle;
    std::vector<WorkSeries> series;
    std::string chosen = "chosen"; // what the ring means
    std::string chosenName = {};   // and what that is here
};

// Into `file`, whose name ends with .svg, .png or .pdf. Empty, or why it could not be written.
[[nodiscard]] std::string draw(const WorkPrecision& chart, const std::string& file);

// For a window: a chart is 980 by 700 points.
inline constexpr double chartWidth = 980, chartHeight = 700;
[[nodiscard]] Pixels pixelsOf(const WorkPrecision& chart, double pixelsPerPoint);

} // namespace charts
