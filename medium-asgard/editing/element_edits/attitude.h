// Attitudes as people say them: so many degrees about an axis.
#pragma once

#include "scene/scene.h"

namespace editing {

struct Turn {
    double degrees = 0;                                // 0 to 180
    geometry::Vector axis = geometry::Vector::UnitY(); // of length 1
};

[[nodiscard]] Turn turnOf(const geometry::Vector& rotationVector); // radians
// Any axis but none: its length does not count. About no axis nothing turns.
[[nodiscard]] geometry::Vector rotationVectorOf(const Turn& turn);

} // namespace editing
