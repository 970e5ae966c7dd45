#include "lettering/lettering.h"

namespace lettering {

Lettering::Lettering(const render::Image& into, double scale, bool isDark)
    : surface_(cairo_image_surface_create_for_data(
          reinterpret_cast<unsigned char*>(into.pixels.data()), CAIRO_FORMAT_RGB24, into.size.width,
          into.size.height, static_cast<int>(into.stride))),
      cairo_(cairo_create(surface_)), rim_(3 * scale, scale), paper_(isDark ? 0.12 : 1) {
    // The letters of charts::Canvas, which a confined process has.
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, 11 * scale);
    cairo_font_extents_t font;
    cairo_font_extents(cairo_, &font);
    ascent_ = font.ascent;
    height_ = font.ascent + font.descent;
}

Lettering::~Lettering() {
    cairo_destroy(cairo_);
    cairo_surface_finish(surface_);
    cairo_surface_destroy(surface_);
}

Eigen::Vector2d Lettering::sizeOf(const std::string& words) const {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, words.c_str(), &extents);
    return Eigen::Vector2d(extents.x_advance, height_) + 2 * rim_;
}

void Lettering::write(const std::string& words, const Eigen::AlignedBox2d& box,
                      const scene::Color& ink) {
    cairo_set_source_rgba(cairo_, paper_, paper_, paper_, 0.8);
    cairo_rectangle(cairo_, box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y());
    cairo_fill(cairo_);
    cairo_set_source_rgb(cairo_, ink.red, ink.green, ink.blue);
    cairo_move_to(cairo_, box.min().x() + rim_.x(), box.min().y() + rim_.y() + ascent_);
    cairo_show_text(cairo_, words.c_str());
}

} // namespace lettering
