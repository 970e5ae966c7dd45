// Attitudes as people say them: so many degrees about an axis.
#pragma once

#include "scene/scene.h"

namespace editing {

struct Turn {
    double degrees = 0;                                // -180 to 180
    geometry::Vector axis = geometry::Vector::UnitZ(); // of length 1
};

// Of radians. Of the two ways to say it the one whose axis goes along `like`, as it was said
// before, or along an axis of the world; where nothing is turned, about `like`.
[[nodiscard]] Turn turnOf(const geometry::Vector& rotationVector,
                          const geometry::Vector& like = geometry::Vector::UnitZ());
// Any axis but none: its length does not count. About no axis nothing turns.
[[nodiscard]] geometry::Vector rotationVectorOf(const Turn& turn);

} // namespace editing
