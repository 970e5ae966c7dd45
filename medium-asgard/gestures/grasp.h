// The target of a shifted button (dissertation 4.1.3, 4.1.4): the left one drags the handle nearest
// to the pointer, or the body under it; the middle one turns the body, the right one rolls it about
// the line of sight. On a trajectory's point the middle one draws a new one out, the right one
// removes it.
#pragma once

#include "gestures/picking.h"

namespace gestures {

constexpr double handleReach = 14; // pixels, of a handle

// A drag of the picture may mean the body where it is seen. An endless floor lies behind
// everything: a drag that missed something else does not mean it. Its handle moves it.
[[nodiscard]] bool isGrasped(const scene::Scene& scene, std::size_t body);

struct Grasp {
    enum class What { drag, roll, newPoint, removePoint } what = What::drag;
    render::Handle handle;
    std::vector<std::size_t> company = {}; // bodies that go with it
};

// `handles`: those that are shown. `reach`: how far from its middle a handle is taken.
[[nodiscard]] std::optional<Grasp> graspAt(const render::Drawing& drawing,
                                           const render::HandleSet& handles, const Sight& sight,
                                           render::CameraControl::Button button,
                                           const Eigen::Vector2d& pixels, double reach);

} // namespace gestures
