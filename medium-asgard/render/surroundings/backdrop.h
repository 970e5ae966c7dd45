// Behind everything: the sky, the ground and the soft horizon between them.
//
// Light or dark, as the background is. An orthographic picture has no horizon: its sky turns into
// ground from top to bottom.
#pragma once

#include "drawing/frame.h"
#include "drawing/program.h"

#include <string>
#include <vector>

namespace render {

// Where the horizon is in the picture, and which side of it is the sky.
struct Horizon {
    Eigen::Vector2d toSky = Eigen::Vector2d::UnitY(); // length 1, x right, y up
    double offset = 0; // view units at z = 0: points p of it have toSky . p = offset
};
// None: the ground, or the sky alone, fills the picture; or it is orthographic.
[[nodiscard]] std::optional<Horizon> horizonOf(const Frame& frame, const Vector& upInView);

class Backdrop {
public:
    explicit Backdrop(const Gl& gl) : gl_(gl), program_(gl) {}
    ~Backdrop();
    Backdrop(const Backdrop&) = delete;
    Backdrop& operator=(const Backdrop&) = delete;

    [[nodiscard]] std::string build();
    void show(const Frame& frame, const Vector& upInView, bool dark) const;

private:
    const Gl& gl_;
    Program program_;
    GLuint array_ = 0, buffer_ = 0;
};

} // namespace render
