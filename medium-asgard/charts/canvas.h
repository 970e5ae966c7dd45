// A page to draw on with cairo, in points, kept as SVG, PDF or PNG by the name of its file, or as
// pixels in memory.
#pragma once

#include <cairo.h>

#include <cstdint>
#include <string>
#include <vector>

namespace charts {

struct Color {
    double red = 0, green = 0, blue = 0;
};

// Rows from the top, each pixel 0xffRRGGBB.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint32_t> colors;
};

class Canvas {
public:
    // PNG has two pixels to a point.
    Canvas(const std::string& file, double width, double height);
    // In memory: take pixels().
    Canvas(double width, double height, double pixelsPerPoint);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    // Loads the letters of texts and codes for the life of the process, which opens no file for
    // them any more: a confined one must not.
    static void keepFonts();
    [[nodiscard]] static bool knows(const std::string& file); // by its ending
    [[nodiscard]] cairo_t* cairo() const { return cairo_; }
    // Writes the file; empty, or why it could not be written.
    [[nodiscard]] std::string finish();
    // The drawing so far; empty where there is a file, or no memory for a page so large.
    [[nodiscard]] Pixels pixels() const;

    void ink(const Color& color, double opacity = 1);
    void line(double x0, double y0, double x1, double y1, double width);
    enum class Anchor { start, middle, end };
    void text(double x, double y, const std::string& text, double size, Anchor anchor,
              bool bold = false);
    // In letters of one width.
    void code(double x, double y, const std::string& text, double size);
    void textUpwards(double x, double y, const std::string& text, double size);
    [[nodiscard]] double widthOf(const std::string& text, double size, bool bold = false);

private:
    void makeImage(double width, double height, double pixelsPerPoint);
    void begin();

    std::string file_; // empty: none
    cairo_surface_t* surface_ = nullptr;
    cairo_t* cairo_ = nullptr;
};

} // namespace charts
