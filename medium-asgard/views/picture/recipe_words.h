// How the Create commands write what was shown to them.
#pragma once

#include "picture/recipes.h"

#include <string>

namespace views {

// "{1 2 3}", in the digits that the resolution tells apart.
[[nodiscard]] std::string listed(const Vector& v, double resolution);
// What points along an axis of the world but for a hand's unsteadiness is meant to.
[[nodiscard]] Vector alongAxis(const Vector& v);

} // namespace views
