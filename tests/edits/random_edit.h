// One random edit of a scene, of any kind that an author can make.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace edits {

using Random = std::mt19937_64;

struct Made {
    std::size_t kind = 0; // in kindsOfEdits()
    std::string what;     // in words; "": there is nothing to be edited that way, this time
};
// `mostly`: every other one is of this kind.
[[nodiscard]] Made randomEdit(scene::Scene& scene, Random& random,
                              std::optional<std::size_t> mostly = {});

[[nodiscard]] const std::vector<std::string>& kindsOfEdits();

} // namespace edits
