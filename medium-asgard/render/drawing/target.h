// The framebuffer that pictures are drawn into and read back from, multisampled where it can be.
#pragma once

#include "drawing/drawing.h"
#include "drawing/gl.h"

namespace render {

class Target {
public:
    explicit Target(const Gl& gl) : gl_(gl) {}
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // Bound for drawing, at that size, with at most that many samples: fewer where the driver
    // refuses. False when not even one sample fits.
    [[nodiscard]] bool prepare(Size size, int samples);
    [[nodiscard]] int samples() const { return samples_; }

    // Resolves the samples and copies the pixels, bottom row of the framebuffer first.
    void read(const Image& into) const;

private:
    bool make(Size size, int samples);
    void drop();

    const Gl& gl_;
    Size size_{0, 0};
    int asked_ = 0;
    int samples_ = 0;
    GLuint drawing_ = 0, color_ = 0, depth_ = 0; // what is drawn into
    GLuint resolved_ = 0, resolvedColor_ = 0;    // what is read; 0 without multisampling
};

} // namespace render
