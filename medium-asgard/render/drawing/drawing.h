// What a picture is asked to show, and where its pixels go.
#pragma once

#include "drawing/handle_set.h"
#include "framing/camera.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace render {

// The kinds of handles that are shown, by what they move.
struct ShownHandles {
    bool positionHandles = false;
    bool orientationHandles = false;
    bool velocityHandles = false;
    bool spinHandles = false; // angular velocities
    bool forceHandles = false;
    bool torqueHandles = false;
    bool linkHandles = false;
    bool jointHandles = false;
    bool lightHandles = false;
    bool trajectories = false; // their paths and points
};

struct Display : ShownHandles {
    bool wireframe = false;
    bool axes = false;
    bool grid = true;    // on the ground, standing still (grid.h)
    bool shadows = true; // bodies shade the ground and each other
    // A horizon behind everything, light or dark as the background; the grid reaches to it, with
    // numbers and coloured axes. Otherwise the picture lies on a page of the background's colour.
    bool studio = false;
    bool triad = false;         // in the corner (triad.h)
    bool contactForces = false; // arrows (contact_forces.h)
    bool frictionCones = false;
    bool rotationCenter = false; // the point that the view turns about
    bool trails = true;          // paths of the centres of mass up to now
    bool joints = true;          // their signs (joint_signs.h)
    // Bodies that are left out, with their trails and handles, by their names; null: none.
    std::shared_ptr<const std::set<std::string>> hidden = nullptr;
    std::optional<HandleName> opened = {}; // the largest of the crowd that is open
    scene::Color background{1, 1, 1};
    int samples = 4; // multisampling; clamped to what there is; 1 while it moves fast
};

[[nodiscard]] inline bool isDark(const scene::Color& c) {
    return 0.3 * c.red + 0.6 * c.green + 0.1 * c.blue < 0.45;
}

[[nodiscard]] inline bool isHidden(const Display& display, const scene::Body& body) {
    return display.hidden && display.hidden->contains(body.name);
}

struct Drawing {
    const scene::Scene* scene = nullptr;
    simulation::MotionPointer motion; // none: the bodies stand where they start
    double time = 0;
    Camera camera;
    Display display;
    // The handles that the display shows, where they are prepared already; none: they are made.
    std::shared_ptr<const HandleSet> handles = nullptr;
};

// Pixels B, G, R, X, top row first.
struct Image {
    std::span<std::byte> pixels; // at least stride * height
    std::size_t stride = 0;      // bytes per row, >= 4 * width
    Size size;
};

} // namespace render
