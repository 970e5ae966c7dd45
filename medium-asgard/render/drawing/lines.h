// Lines of any width with soft edges, in view coordinates: edges, trails, grid, axes, arrows.
#pragma once

#include "drawing/frame.h"
#include "drawing/program.h"

#include <Eigen/Core>

#include <array>
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

    // The picture that lines are added to from now on.
    void begin(const Frame& frame, const std::array<float, 16>& projection);

    // Segments are cut off at the eye.
    void add(Eigen::Vector3d from, Eigen::Vector3d to, const Ink& ink) {
        add(from, to, ink, ink.alpha);
    }
    void add(Eigen::Vector3d from, Eigen::Vector3d to, const Ink& ink, float alphaTo);
    // As wide as the ink says at one end, pointed at the other: the head of an arrow.
    void addPointed(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Ink& ink);

    // Draws what was added. `nearer` lifts the lines off surfaces, in depth.
    void show(float nearer, float opacity = 1) const;
    void forget() { segments_.clear(); }
    void draw(float nearer) {
        show(nearer);
        forget();
    }

private:
    struct Segment {
        float from[3], to[3], colorFrom[4], colorTo[4], width[2];
    };

    const Gl& gl_;
    Program program_;
    GLuint array_ = 0, buffer_ = 0;
    std::vector<Segment> segments_;
    std::array<float, 16> projection_{};
    Eigen::Vector2f halfSize_ = Eigen::Vector2f::Ones();
    double limit_ = 0; // view z
};

} // namespace render
