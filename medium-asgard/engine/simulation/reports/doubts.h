// Parts of a scene that can be computed, but are hardly meant.
#pragma once

#include "scene/diagnostic.h"
#include "scene/scene.h"

#include <vector>

namespace simulation {

// Warnings, each at the element that it is about: parts of a shape that overlap, of which mass,
// centre of mass and inertia of a body that moves count twice what they share; an inertia that no
// distribution of mass has; a velocity at the start of what is fixed.
[[nodiscard]] std::vector<scene::Diagnostic> doubtsAbout(const scene::Scene& scene);

} // namespace simulation
