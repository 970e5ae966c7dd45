#include "charts/marks.h"

#include <array>
#include <cmath>
#include <numbers>

namespace charts {
namespace {

// Hues go round twice, dark and bright in turn, so that neighbours in the list differ in both; who
// sees red and green alike has brightness and shape.
constexpr std::array<Color, 16> colors = {{{0.10, 0.10, 0.10},
                                           {0.90, 0.50, 0.00},
                                           {0.00, 0.35, 0.70},
                                           {0.45, 0.75, 0.20},
                                           {0.70, 0.05, 0.30},
                                           {0.25, 0.70, 0.90},
                                           {0.45, 0.30, 0.10},
                                           {0.95, 0.45, 0.70},
                                           {0.00, 0.45, 0.30},
                                           {0.60, 0.45, 0.90},
                                           {0.80, 0.15, 0.05},
                                           {0.00, 0.65, 0.60},
                                           {0.35, 0.10, 0.55},
                                           {0.75, 0.65, 0.00},
                                           {0.35, 0.45, 0.55},
                                           {0.60, 0.35, 0.35}}};
constexpr std::size_t shapes = 8;

// Corners on a circle, the first at an angle; a star's lie on two.
struct Shape {
    int corners;
    double turn, inner;
};
constexpr double quarter = std::numbers::pi / 2;
constexpr std::array<Shape, shapes> outlines = {{{0, 0, 1},
                                                 {4, quarter / 2, 1},
                                                 {3, -quarter, 1},
                                                 {4, -quarter, 1},
                                                 {3, quarter, 1},
                                                 {5, -quarter, 0.45},
                                                 {6, 0, 1},
                                                 {4, -quarter, 0.4}}};

} // namespace

Color colorOf(std::size_t series) { return colors[series % colors.size()]; }

void drawMark(Canvas& canvas, double x, double y, std::size_t series, double size, Fill fill) {
    cairo_t* c = canvas.cairo();
    // The second round of eight shapes begins elsewhere, so that no colour meets its shape again.
    const Shape& shape = outlines[(series + series / shapes) % shapes];
    cairo_new_path(c);
    if (shape.corners == 0)
        cairo_arc(c, x, y, size, 0, 4 * quarter);
    const bool isStar = shape.inner < 1;
    const int points = isStar ? 2 * shape.corners : shape.corners;
    for (int i = 0; i < points; ++i) {
        const double angle = shape.turn + 4 * quarter * i / points;
        const double radius = size * (isStar && i % 2 == 1 ? 1.6 * shape.inner
                                      : isStar             ? 1.6
                                                           : 1.3);
        cairo_line_to(c, x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    cairo_close_path(c);
    canvas.ink(fill == Fill::full ? colorOf(series) : Color{1, 1, 1});
    cairo_fill_preserve(c);
    canvas.ink(colorOf(series));
    cairo_set_line_width(c, 1.1);
    cairo_stroke(c);
}

} // namespace charts
