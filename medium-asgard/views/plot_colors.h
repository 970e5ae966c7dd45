// The colours of a plot's curves: that of the body that each is about.
#pragma once

#include "scene/scene.h"
#include "views/plot_chart.h"

namespace views {

// Each curve of the plot, in its order: a curve about one coloured body has its colour, darkened
// where white paper would swallow it; what would look alike has another kind of line.
void colorCurves(const scene::Scene& scene, const scene::Plot& plot,
                 std::vector<PlotCurve>& curves);

} // namespace views
