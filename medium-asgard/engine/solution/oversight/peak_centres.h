// Where within a step may there be the middle of a peak, by the values of its causes
// (equations/peaks.h)?
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace solution {

// Times in (from, to), in order, at which a cause or its rate is 0. `evaluate` gives the values of
// all causes, then their rates. The sign of a tiny rate means nothing, so a zero of a rate counts
// only where the cause changes enough to make its peak 16 times as large within the step as at the
// step's ends.
[[nodiscard]] std::vector<double>
centresPassed(const std::vector<double>& ratios, bool arePolynomials,
              const std::function<void(double t, std::span<double> values)>& evaluate, double from,
              double to);

} // namespace solution
