#include "service/handle_labels.h"

#include "handles/handle_layout.h"

#include <cairo.h>

#include <vector>

namespace service {

void drawLabels(const render::HandleSet& handles, const gestures::Sight& sight, double scale,
                bool isDark, const render::Image& into) {
    const std::vector<const render::Handle*> all = render::labelled(handles);
    if (all.empty())
        return;
    cairo_surface_t* surface = cairo_image_surface_create_for_data(
        reinterpret_cast<unsigned char*>(into.pixels.data()), CAIRO_FORMAT_RGB24, into.size.width,
        into.size.height, static_cast<int>(into.stride));
    cairo_t* cairo = cairo_create(surface);
    // The letters of charts::Canvas, which a confined process has.
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, 11 * scale);
    cairo_font_extents_t font;
    cairo_font_extents(cairo, &font);
    const Eigen::Vector2d rim(3 * scale, scale);
    std::vector<render::LabelWish> wishes;
    wishes.reserve(all.size());
    for (const render::Handle* handle : all) {
        cairo_text_extents_t extents;
        cairo_text_extents(cairo, handle->label.c_str(), &extents);
        wishes.push_back(
            {render::standOf(*handle, sight.camera, sight.size),
             Eigen::Vector2d(extents.x_advance, font.ascent + font.descent) + 2 * rim});
    }
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0),
                                      Eigen::Vector2d(into.size.width, into.size.height));
    const auto boxes = render::placedLabels(wishes, picture, 7 * scale);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double paper = isDark ? 0.12 : 1, ink = isDark ? 1.3 : 0.65;
        cairo_set_source_rgba(cairo, paper, paper, paper, 0.8);
        cairo_rectangle(cairo, boxes[i].min().x(), boxes[i].min().y(), boxes[i].sizes().x(),
                        boxes[i].sizes().y());
        cairo_fill(cairo);
        const scene::Color& color = render::colorOf(all[i]->kind);
        cairo_set_source_rgb(cairo, ink * color.red, ink * color.green, ink * color.blue);
        cairo_move_to(cairo, boxes[i].min().x() + rim.x(),
                      boxes[i].min().y() + rim.y() + font.ascent);
        cairo_show_text(cairo, all[i]->label.c_str());
    }
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
}

} // namespace service
