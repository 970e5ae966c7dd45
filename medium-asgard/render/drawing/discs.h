// Flat discs of a size in pixels, with a soft edge and a rim: handles, the ends of the triad.
#pragma once

#include "drawing/frame.h"
#include "drawing/program.h"

#include <array>
#include <string>
#include <vector>

namespace render {

struct Disc {
    Vector middle;                  // view
    Eigen::Vector4f fill, rim;      // sRGB and alpha
    float radius = 1, rimWidth = 0; // pixels of the picture; the rim lies inside the radius
};

class Discs {
public:
    explicit Discs(const Gl& gl) : gl_(gl), program_(gl) {}
    ~Discs();
    Discs(const Discs&) = delete;
    Discs& operator=(const Discs&) = delete;

    [[nodiscard]] std::string build();
    // In the order given.
    void show(const std::vector<Disc>& discs, const Frame& frame,
              const std::array<float, 16>& projection, float opacity = 1) const;

private:
    struct Instance {
        float middle[3], fill[4], rim[4], radius[2];
    };

    const Gl& gl_;
    Program program_;
    GLuint array_ = 0, buffer_ = 0;
};

} // namespace render
