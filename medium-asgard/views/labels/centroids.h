// Centres of mass of a scene's bodies: those of its motion, or those that shapes and -center give
// while there is none.
#pragma once

#include "geometry/pose.h"
#include "workbench/scene_document.h"

#include <memory>
#include <optional>
#include <vector>

namespace views {

class Centroids {
public:
    // In the body's frame; its shape's origin where it has no mass.
    [[nodiscard]] geometry::Vector of(const Shown& shown, std::size_t body);

private:
    std::shared_ptr<const scene::Scene> scene_;
    std::vector<std::optional<geometry::Vector>> known_; // of its bodies
};

} // namespace views
