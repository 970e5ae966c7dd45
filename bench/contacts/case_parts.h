// How cases are put together, and the groups of them.
#pragma once

#include "cases.h"

#include <functional>

namespace bench::contacts {

[[nodiscard]] std::vector<Case> contactCases();
[[nodiscard]] std::vector<Case> jointCases();
[[nodiscard]] std::vector<Case> boxCases(bool few);
[[nodiscard]] std::vector<Case> machineCases();
[[nodiscard]] std::vector<Case> chainCases(bool few);

[[nodiscard]] std::vector<double> timesTo(double end, int count);
// `along` metres up the slope, `above` metres over it.
[[nodiscard]] Place onSlope(double slope, double along, double above);
[[nodiscard]] std::vector<Place> centres(const std::vector<Body>& bodies);
[[nodiscard]] Case withFloor(std::string name, double slope, double friction);
// All bodies move along the floor by the same distance.
void moveAlong(Case& scene, const std::function<double(double)>& distance);

} // namespace bench::contacts
