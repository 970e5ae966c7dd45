// The ground that a scene stands on, and the shadows on it.
//
// A scene's own floor (a large level face of something that never moves, and that reaches below 0)
// bears the grid; beside it shadows fall on the grid's plane. Without one the ground lies under
// everything, at a round height, so that it stays where it is while one edits; it is not seen
// itself, but shadows fall on it.
#pragma once

#include "drawing/frame.h"
#include "drawing/program.h"
#include "drawing/solids.h"
#include "framing/extent.h"
#include "surroundings/grid.h"

#include <optional>
#include <span>

namespace render {

struct Ground {
    GroundPlane plane;
    std::optional<Eigen::Vector3f> floor; // the colour of the scene's own; none: it has none
    std::optional<GroundPlane> shadowed;  // none: an endless floor bears all shadows itself
};
[[nodiscard]] Ground groundOf(std::span<const Solid> solids, const Extent& extent,
                              const Frame& frame, Solids& meshes);

// It lies under everything, and not far below.
[[nodiscard]] bool isGroundOf(const Extent& extent, double height);
// 0 while all is above it and not far; else under everything: exactly under what is fixed, and a
// little lower under what moves where that is not round.
[[nodiscard]] double groundHeight(const Extent& extent);

class GroundShadow {
public:
    explicit GroundShadow(const Gl& gl) : gl_(gl), program_(gl) {}
    ~GroundShadow();
    GroundShadow(const GroundShadow&) = delete;
    GroundShadow& operator=(const GroundShadow&) = delete;

    [[nodiscard]] std::string build();
    // The shadow maps are bound; nothing where the ground is seen from below.
    void show(const GroundPlane& ground, const Light& light, std::span<const LightSight> sights,
              const Frame& frame, const float* projection, float strength) const;

private:
    const Gl& gl_;
    Program program_;
    GLuint array_ = 0;
};

} // namespace render
