#include "drawing/stroke_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace render {

namespace {

using Point = Eigen::Vector2d;
using Pen = std::vector<Point>; // one stroke

struct Glyph {
    double width; // of digits' height
    std::vector<Pen> strokes;
};

// Part of an ellipse, in degrees anticlockwise from the right.
Pen arc(double x, double y, double rx, double ry, double from, double to) {
    constexpr int parts = 10;
    Pen pen;
    for (int i = 0; i <= parts; ++i) {
        const double angle = (from + (to - from) * i / parts) * M_PI / 180;
        pen.emplace_back(x + rx * std::cos(angle), y + ry * std::sin(angle));
    }
    return pen;
}

Pen joined(Pen first, const Pen& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

// Digits are 1 high and 0.56 wide.
const Glyph* glyphOf(char c) {
    constexpr double w = 0.56;
    static const Glyph zero{w, {arc(0.28, 0.5, 0.28, 0.5, 0, 360)}};
    static const Glyph one{0.36, {{{0.04, 0.76}, {0.28, 1}, {0.28, 0}}}};
    static const Glyph two{w,
                           {joined(arc(0.28, 0.72, 0.27, 0.28, 160, -35), {{0.02, 0}, {0.56, 0}})}};
    static const Glyph three{
        w, {joined(arc(0.26, 0.75, 0.25, 0.25, 150, -90), arc(0.26, 0.25, 0.29, 0.25, 90, -150))}};
    static const Glyph four{w, {{{0.44, 0}, {0.44, 1}, {0, 0.28}, {0.58, 0.28}}}};
    static const Glyph five{
        w, {joined({{0.50, 1}, {0.10, 1}, {0.05, 0.55}}, arc(0.26, 0.31, 0.29, 0.31, 125, -150))}};
    static const Glyph six{
        w,
        {joined(arc(0.52, 0.30, 0.51, 0.70, 105, 180), arc(0.285, 0.30, 0.275, 0.30, 180, 540))}};
    static const Glyph seven{w, {{{0, 1}, {0.54, 1}, {0.18, 0}}}};
    static const Glyph eight{
        w, {arc(0.28, 0.755, 0.23, 0.245, -90, 270), arc(0.28, 0.255, 0.28, 0.255, 90, 450)}};
    static const Glyph nine{
        w, {joined(arc(0.04, 0.70, 0.51, 0.70, -75, 0), arc(0.275, 0.70, 0.275, 0.30, 0, 360))}};
    static const Glyph point{0.14, {{{0.07, 0}, {0.07, 0.16}}}}; // seen at any height
    static const Glyph minus{0.46, {{{0.02, 0.46}, {0.44, 0.46}}}};
    static const Glyph e{
        0.5, {joined({{0.03, 0.36}, {0.49, 0.36}}, arc(0.26, 0.34, 0.24, 0.34, 5, 320))}};
    static const Glyph x{0.52, {{{0, 0.72}, {0.5, 0}}, {{0.5, 0.72}, {0, 0}}}};
    static const Glyph y{0.52, {{{0, 0.72}, {0.26, 0.04}}, {{0.52, 0.72}, {0.14, -0.28}}}};
    static const Glyph z{0.5, {{{0.02, 0.72}, {0.48, 0.72}, {0.02, 0}, {0.48, 0}}}};
    static const std::array digits{&zero, &one, &two,   &three, &four,
                                   &five, &six, &seven, &eight, &nine};
    if (c >= '0' && c <= '9')
        return digits[static_cast<std::size_t>(c - '0')];
    switch (c) {
    case '.':
        return &point;
    case '-':
        return &minus;
    case 'e':
        return &e;
    case 'x':
        return &x;
    case 'y':
        return &y;
    case 'z':
        return &z;
    default:
        return nullptr;
    }
}

constexpr double gap = 0.22; // between letters

double advance(char c) {
    const Glyph* glyph = glyphOf(c);
    return (glyph ? glyph->width : 0.3) + gap;
}

} // namespace

double textWidth(std::string_view text, double height) {
    double width = text.empty() ? 0 : -gap;
    for (const char c : text)
        width += advance(c);
    return width * height;
}

void addText(Lines& lines, const Frame& frame, const Vector& at, const Eigen::Vector2d& aside,
             std::string_view text, double height, Anchor anchor, const Ink& ink) {
    const double pixel = 1 / std::max(frame.pixels(1, at.z()), 1e-12);
    double left = aside.x();
    if (anchor != Anchor::left)
        left -= textWidth(text, height) * (anchor == Anchor::middle ? 0.5 : 1);
    const auto place = [&](const Point& p) -> Vector {
        return at + pixel * Vector(left + height * p.x(), aside.y() + height * (p.y() - 0.5), 0);
    };
    for (const char c : text) {
        if (const Glyph* glyph = glyphOf(c))
            for (const Pen& pen : glyph->strokes)
                for (std::size_t i = 1; i < pen.size(); ++i)
                    lines.add(place(pen[i - 1]), place(pen[i]), ink);
        left += height * advance(c);
    }
}

std::string coordinateText(double value, double step) {
    if (std::abs(value) < 1e-9 * step)
        return "0";
    char text[40];
    const int decimals = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (decimals > 4 || std::abs(value) >= 1e5)
        std::snprintf(text, sizeof text, "%.3g", value);
    else
        std::snprintf(text, sizeof text, "%.*f", std::max(0, decimals), value);
    std::string written = text;
    std::erase(written, '+');
    for (std::size_t zero = written.find("e0"); zero != std::string::npos;
         zero = written.find("e0"))
        written.erase(zero + 1, 1);
    if (const std::size_t zero = written.find("e-0"); zero != std::string::npos)
        written.erase(zero + 2, 1);
    return written;
}

} // namespace render
