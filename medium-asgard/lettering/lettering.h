// Words on paper of their own, over a picture that is drawn.
#pragma once

#include "render/renderer.h"

#include <cairo.h>

#include <string>

namespace lettering {

class Lettering {
public:
    // `scale`: device pixels for each of the reader's.
    Lettering(const render::Image& into, double scale, bool isDark);
    ~Lettering();
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;

    // With the rim of their paper; device pixels.
    [[nodiscard]] Eigen::Vector2d sizeOf(const std::string& words) const;
    void write(const std::string& words, const Eigen::AlignedBox2d& box, const scene::Color& ink);

private:
    cairo_surface_t* surface_;
    cairo_t* cairo_;
    Eigen::Vector2d rim_;
    double ascent_, height_;
    double paper_; // its grey
};

} // namespace lettering
