// What a graphical viewer lets one take hold of: places and velocities at the start of the motion.
//
// A handle is a small ball of constant size on screen, its colour says of what kind it is
// (dissertation 4.1.3). A velocity's ball stands at the head of an arrow from the body's centre of
// mass, as far away as the body would get in `velocityTime`.
#pragma once

#include "render/renderer.h"

#include <vector>

namespace render {

enum class HandleKind : std::uint8_t { position, velocity };

struct Handle {
    HandleKind kind = HandleKind::position;
    std::size_t body = 0;
    Vector base;  // world: foot of the arrow; the same as `place` for positions
    Vector place; // world
};

// Pixels, in a picture 480 high. A velocity of zero lies on its body's position, smaller.
[[nodiscard]] double radiusOf(HandleKind kind);

[[nodiscard]] scene::Color colorOf(HandleKind kind);

// The time in which a velocity's arrow is covered: 1, or the power of ten that keeps the longest
// arrow shorter than the scene.
[[nodiscard]] double velocityTime(const scene::Scene& scene, double sceneSize);

// Handles of the kinds that the display shows, of bodies that are not fixed.
[[nodiscard]] std::vector<Handle> handlesOf(const Drawing& drawing, double sceneSize);

} // namespace render
