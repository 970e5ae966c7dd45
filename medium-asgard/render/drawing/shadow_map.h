// The shadow of one light: the depth of the nearest opaque surface, as the light sees it.
//
// Shadow mapping (L. Williams, Casting curved shadows on curved surfaces, SIGGRAPH 1978), filtered
// by percentage closer filtering (Reeves, Salesin, Cook, SIGGRAPH 1987). The map covers the bodies
// that can throw a shadow into the picture and no more, so that its texels are small. A picture
// that reaches far has a second map of what is near.
#pragma once

#include "drawing/frame.h"
#include "drawing/solids.h"

#include <optional>
#include <span>
#include <vector>

namespace render {

// Half spaces throw none on what is above them.
[[nodiscard]] std::vector<Solid> throwingShadows(std::span<const Solid> solids);

// The light's sight of the solids whose shadows reach `room`, a box of the view. None: nothing to
// see, or a point light among the solids. LIMIT: a point light throws shadows only while it is
// outside of the ball about them.
[[nodiscard]] std::optional<LightSight> sightOf(const Light& light, std::span<const Solid> solids,
                                                const Eigen::AlignedBox3d& room, int texels);

// The room that the picture shows between two depths, as a box of the view.
[[nodiscard]] Eigen::AlignedBox3d visibleRoom(const Frame& frame, double nearestZ,
                                              double furthestZ);

class ShadowMap {
public:
    explicit ShadowMap(const Gl& gl) : gl_(gl) {}
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    // Cleared, with the state that drawing depths needs. False: the driver refuses.
    [[nodiscard]] bool begin(int texels);
    void bind(std::size_t map); // for drawing
    // Undoes begin(); the maps are bound as texture 0.
    void end();

private:
    const Gl& gl_;
    int texels_ = 0;
    GLuint framebuffer_ = 0, texture_ = 0;
};

} // namespace render
