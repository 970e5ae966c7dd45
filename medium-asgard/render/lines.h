// Lines of any width with soft edges, in view coordinates: edges, trails, grid, axes, arrows.
#pragma once

#include "render/program.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace render {

struct Ink {
    Eigen::Vector3f color = Eigen::Vector3f::Zero(); // sRGB
    float alpha = 1;
    float width = 1; // pixels
};

class Lines {
public:
    explicit Lines(const Gl& gl) : gl_(gl), program_(gl) {}
    ~Lines();
    Lines(const Lines&) = delete;
    Lines& operator=(const Lines&) = delete;

    [[nodiscard]] std::string build();

    // Segments are cut off at the eye.
    void add(Eigen::Vector3d from, Eigen::Vector3d to, const Ink& ink) {
        add(from, to, ink, ink.alpha);
    }
    void add(Eigen::Vector3d from, Eigen::Vector3d to, const Ink& ink, float alphaTo);

    // Draws what was added and forgets it. `nearer` lifts the lines off surfaces, in depth.
    void draw(const float* projection, const Eigen::Vector2f& halfSize, float nearer);

private:
    struct Segment {
        float from[3], to[3], colorFrom[4], colorTo[4], width;
    };

    const Gl& gl_;
    Program program_;
    GLuint array_ = 0, buffer_ = 0;
    std::vector<Segment> segments_;
};

} // namespace render
