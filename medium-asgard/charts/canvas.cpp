#include "charts/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace charts {

namespace {

constexpr double pixelsPerPointOfPng = 2;

} // namespace

void Canvas::keepFonts() {
    static const auto kept = [] {
        std::vector<cairo_scaled_font_t*> fonts;
        Canvas canvas(16, 16, 1);
        const auto keep = [&] {
            fonts.push_back(cairo_scaled_font_reference(cairo_get_scaled_font(canvas.cairo_)));
        };
        for (const bool bold : {false, true}) {
            canvas.text(0, 8, "a", 8, Anchor::start, bold);
            keep();
        }
        canvas.code(0, 8, "a", 8);
        keep();
        return fonts;
    }();
    (void)kept;
}

bool Canvas::knows(const std::string& file) {
    return file.ends_with(".svg") || file.ends_with(".pdf") || file.ends_with(".png");
}

Canvas::Canvas(const std::string& file, double width, double height) : file_(file) {
    if (file.ends_with(".svg")) {
        surface_ = cairo_svg_surface_create(file.c_str(), width, height);
    } else if (file.ends_with(".pdf")) {
        surface_ = cairo_pdf_surface_create(file.c_str(), width, height);
    } else {
        makeImage(width, height, pixelsPerPointOfPng);
    }
    begin();
}

Canvas::Canvas(double width, double height, double pixelsPerPoint) {
    makeImage(width, height, pixelsPerPoint);
    begin();
}

void Canvas::makeImage(double width, double height, double pixelsPerPoint) {
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                          static_cast<int>(std::ceil(width * pixelsPerPoint)),
                                          static_cast<int>(std::ceil(height * pixelsPerPoint)));
    cairo_surface_set_device_scale(surface_, pixelsPerPoint, pixelsPerPoint);
}

void Canvas::begin() {
    cairo_ = cairo_create(surface_);
    ink({1, 1, 1});
    cairo_paint(cairo_);
}

Pixels Canvas::pixels() const {
    Pixels result;
    if (!file_.empty() || cairo_surface_status(surface_) != CAIRO_STATUS_SUCCESS)
        return result;
    cairo_surface_flush(surface_);
    result.width = cairo_image_surface_get_width(surface_);
    result.height = cairo_image_surface_get_height(surface_);
    const int stride = cairo_image_surface_get_stride(surface_);
    const unsigned char* data = cairo_image_surface_get_data(surface_);
    const auto width = static_cast<std::size_t>(result.width);
    result.colors.resize(width * static_cast<std::size_t>(result.height));
    for (int y = 0; y < result.height; ++y)
        std::memcpy(&result.colors[static_cast<std::size_t>(y) * width],
                    data + static_cast<std::ptrdiff_t>(y) * stride, 4 * width);
    for (std::uint32_t& color : result.colors) // cairo leaves the first byte open
        color |= 0xff000000;
    return result;
}

Canvas::~Canvas() {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
}

std::string Canvas::finish() {
    cairo_status_t status = cairo_status(cairo_);
    if (status == CAIRO_STATUS_SUCCESS && file_.ends_with(".png"))
        status = cairo_surface_write_to_png(surface_, file_.c_str());
    cairo_surface_finish(surface_);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface_);
    return status == CAIRO_STATUS_SUCCESS ? "" : cairo_status_to_string(status);
}

void Canvas::ink(const Color& color, double opacity) {
    cairo_set_source_rgba(cairo_, color.red, color.green, color.blue, opacity);
}

void Canvas::line(double x0, double y0, double x1, double y1, double width) {
    cairo_set_line_width(cairo_, width);
    cairo_move_to(cairo_, x0, y0);
    cairo_line_to(cairo_, x1, y1);
    cairo_stroke(cairo_);
}

double Canvas::widthOf(const std::string& text, double size, bool bold) {
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::text(double x, double y, const std::string& text, double size, Anchor anchor,
                  bool bold) {
    const double width = widthOf(text, size, bold);
    const double left = anchor == Anchor::start ? 0 : anchor == Anchor::middle ? width / 2 : width;
    cairo_move_to(cairo_, x - left, y);
    cairo_show_text(cairo_, text.c_str());
}

void Canvas::code(double x, double y, const std::string& text, double size) {
    cairo_select_font_face(cairo_, "DejaVu Sans Mono", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, size);
    cairo_move_to(cairo_, x, y);
    cairo_show_text(cairo_, text.c_str());
}

void Canvas::textUpwards(double x, double y, const std::string& text, double size) {
    cairo_save(cairo_);
    cairo_translate(cairo_, x, y);
    cairo_rotate(cairo_, -std::numbers::pi / 2);
    this->text(0, 0, text, size, Anchor::middle);
    cairo_restore(cairo_);
}

} // namespace charts
