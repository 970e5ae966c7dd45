// Scenes that are edited: all that the repository has, and some put beside each other.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace edits {

struct NamedScene {
    std::string name;
    scene::Scene scene;
};

// Short enough that a run of any of them is quick.
[[nodiscard]] std::vector<NamedScene> scenes();

// The elements of both in one scene, those of `second` renamed. The first one's simulator counts.
[[nodiscard]] scene::Scene besides(const scene::Scene& first, const scene::Scene& second,
                                   const scene::Vector& shift);

} // namespace edits
