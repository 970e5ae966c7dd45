// The changes of an edit that the motion of bodies depends on. Places in the text, colours, lights,
// views and plots are no part of them.
#pragma once

#include "scene/connections.h"

#include <memory>
#include <optional>
#include <vector>

namespace scene {

// A scene with what it is made of worked out.
struct Version {
    explicit Version(std::shared_ptr<const Scene> of) : scene(std::move(of)), connections(*scene) {}
    std::shared_ptr<const Scene> scene;
    Connections connections;
};

struct Difference {
    std::vector<std::size_t> before; // by body: the same body in the scene before; noElement: new
    std::vector<std::size_t> after;  // by body before: the same one now; noElement: removed
    // By body: it moves by other equations, from other values, or has another shape.
    std::vector<bool> changed;
    // By body: an element of it stands on another line than before.
    std::vector<bool> moved;
};

[[nodiscard]] Difference differenceBetween(const Version& before, const Version& after);

// Start, first step, accuracy, method and collisions are the same; the finish may differ.
[[nodiscard]] bool sameButFinish(const Simulator& a, const Simulator& b);

} // namespace scene
