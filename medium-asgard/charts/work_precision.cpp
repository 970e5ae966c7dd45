#include "charts/work_precision.h"

#include "charts/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace charts {

namespace {

constexpr double width = chartWidth, height = chartHeight;
constexpr double left = 74, right = 700, top = 84, bottom = 510; // of the frame
constexpr double band = 26; // above the frame's lines: points without an error
constexpr double markerSize = 4.2;
constexpr double leastError = 1e-14, mostError = 1;

constexpr Color dark{0.13, 0.15, 0.18}, quiet{0.42, 0.45, 0.5}, faint{0.88, 0.89, 0.91};

// Colours that stay apart for readers who see red and green alike (after Okabe and Ito), darker
// ones for the second round; shapes tell apart what colours cannot.
constexpr std::array<Color, 8> colors = {{{0.13, 0.13, 0.13},
                                          {0.90, 0.50, 0.00},
                                          {0.20, 0.60, 0.87},
                                          {0.00, 0.55, 0.40},
                                          {0.80, 0.68, 0.05},
                                          {0.00, 0.35, 0.65},
                                          {0.80, 0.28, 0.00},
                                          {0.74, 0.40, 0.60}}};
constexpr std::size_t shapes = 5;

struct Axis {
    double low = 0, high = 1; // decades
    double from = 0, to = 1;  // points
    [[nodiscard]] double at(double value) const {
        return from + (std::log10(value) - low) / (high - low) * (to - from);
    }
};

std::string power(int decade) {
    static const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = decade < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(decade)))
        text += digits[digit - '0'];
    return text;
}

Axis axisOver(double least, double most, double from, double to) {
    Axis axis{.low = std::floor(std::log10(least) - 0.05),
              .high = std::ceil(std::log10(most) + 0.05),
              .from = from,
              .to = to};
    if (axis.high - axis.low < 1)
        axis.high = axis.low + 1;
    return axis;
}

class Drawing {
public:
    Drawing(const WorkPrecision& chart, const std::string& file)
        : chart_(chart), canvas_(file, width, height) {}
    Drawing(const WorkPrecision& chart, double pixelsPerPoint)
        : chart_(chart), canvas_(width, height, pixelsPerPoint) {}

    Canvas& run();

private:
    void choosePlaces();
    void grid();
    void words();
    void series(std::size_t index);
    void join(const std::vector<WorkPoint>& points, bool fixedStep, const Color& color);
    void mark(double x, double y, std::size_t index, bool filled);
    void point(const WorkPoint& point, std::size_t index);
    void legend();
    void key();
    [[nodiscard]] double yOf(const WorkPoint& point) const;
    [[nodiscard]] std::string letterOf(const std::string& failure);

    const WorkPrecision& chart_;
    Canvas canvas_;
    Axis x_, y_;
    bool anyWithout_ = false, anyChosen_ = false, anyFixed_ = false;
    std::map<std::string, std::string> letters_; // by failure
    std::string minor_;                          // the failure that has none
};

Color colorOf(std::size_t index) { return colors[index % colors.size()]; }

void Drawing::choosePlaces() {
    double least = 1e300, most = 0, small = 1e300, large = 0;
    for (const WorkSeries& series : chart_.series)
        for (const WorkPoint& point : series.points) {
            least = std::min(least, std::max(point.seconds, 1e-6));
            most = std::max(most, std::max(point.seconds, 1e-6));
            anyChosen_ = anyChosen_ || point.chosen;
            anyFixed_ = anyFixed_ || point.fixedStep;
            if (!point.error || *point.error > mostError) {
                anyWithout_ = true;
                continue;
            }
            small = std::min(small, std::max(*point.error, leastError));
            large = std::max(large, std::max(*point.error, leastError));
        }
    x_ = axisOver(most > 0 ? least : 1e-3, most > 0 ? most : 1, left, right);
    y_ = axisOver(large > 0 ? small : 1e-6, large > 0 ? large : 1, bottom,
                  anyWithout_ ? top + band : top);
}

double Drawing::yOf(const WorkPoint& point) const {
    if (!point.error || *point.error > mostError)
        return top + band / 2;
    return y_.at(std::max(*point.error, leastError));
}

void Drawing::grid() {
    for (int decade = static_cast<int>(x_.low); decade <= static_cast<int>(x_.high); ++decade) {
        const double x = x_.at(std::pow(10, decade));
        canvas_.ink(faint);
        canvas_.line(x, top, x, bottom, 0.8);
        canvas_.ink(quiet);
        canvas_.text(x, bottom + 17, power(decade), 11, Canvas::Anchor::middle);
        for (int part = 2; part < 10 && decade < static_cast<int>(x_.high); ++part)
            canvas_.line(x_.at(part * std::pow(10, decade)), bottom,
                         x_.at(part * std::pow(10, decade)), bottom + 3, 0.6);
    }
    const int step = y_.high - y_.low > 10 ? 2 : 1;
    for (int decade = static_cast<int>(y_.low); decade <= static_cast<int>(y_.high);
         decade += step) {
        const double y = y_.at(std::pow(10, decade));
        canvas_.ink(faint);
        canvas_.line(left, y, right, y, 0.8);
        canvas_.ink(quiet);
        canvas_.text(left - 8, y + 4, power(decade), 11, Canvas::Anchor::end);
    }
    canvas_.ink(quiet);
    canvas_.line(left, bottom, right, bottom, 1);
    canvas_.line(left, top, left, bottom, 1);
    if (anyWithout_) {
        canvas_.ink(faint, 0.45);
        cairo_rectangle(canvas_.cairo(), left, top, right - left, band);
        cairo_fill(canvas_.cairo());
        canvas_.ink(quiet);
        canvas_.text(left + 6, top - 5, "no result, or an error larger than the scene", 9.5,
                     Canvas::Anchor::start);
    }
}

void Drawing::words() {
    canvas_.ink(dark);
    canvas_.text(left, 34, chart_.title, 17, Canvas::Anchor::start, true);
    canvas_.ink(quiet);
    canvas_.text(left, 54, chart_.subtitle, 11, Canvas::Anchor::start);
    canvas_.ink(dark);
    canvas_.text((left + right) / 2, bottom + 38, "processor time of the motion, seconds", 12,
                 Canvas::Anchor::middle);
    canvas_.textUpwards(22, (top + bottom) / 2, "largest position error over the size of the scene",
                        12);
}

void Drawing::join(const std::vector<WorkPoint>& points, bool fixedStep, const Color& color) {
    cairo_t* c = canvas_.cairo();
    const double dashes[] = {3, 3};
    cairo_set_dash(c, dashes, fixedStep ? 2 : 0, 0);
    cairo_set_line_width(c, fixedStep ? 1 : 1.6);
    const WorkPoint* last = nullptr;
    for (const WorkPoint& point : points) {
        if (point.fixedStep != fixedStep)
            continue;
        if (last && point.error && last->error && *point.error <= mostError &&
            *last->error <= mostError) {
            canvas_.ink(color, point.failure.empty() && last->failure.empty() ? 0.9 : 0.3);
            cairo_move_to(c, x_.at(std::max(last->seconds, 1e-6)), yOf(*last));
            cairo_line_to(c, x_.at(std::max(point.seconds, 1e-6)), yOf(point));
            cairo_stroke(c);
        }
        last = &point;
    }
    cairo_set_dash(c, nullptr, 0, 0);
}

void Drawing::mark(double x, double y, std::size_t index, bool filled) {
    cairo_t* c = canvas_.cairo();
    const std::size_t shape = (index + index / colors.size()) % shapes;
    cairo_new_path(c);
    if (shape == 0) {
        cairo_arc(c, x, y, markerSize, 0, 2 * std::numbers::pi);
    } else {
        // Squares, triangles up and down, diamonds: corners on a circle.
        const int corners = shape == 2 || shape == 3 ? 3 : 4;
        const double turn = shape == 1   ? std::numbers::pi / 4
                            : shape == 3 ? std::numbers::pi / 2
                                         : -std::numbers::pi / 2;
        for (int i = 0; i < corners; ++i) {
            const double angle = turn + 2 * std::numbers::pi * i / corners;
            cairo_line_to(c, x + 1.3 * markerSize * std::cos(angle),
                          y + 1.3 * markerSize * std::sin(angle));
        }
        cairo_close_path(c);
    }
    canvas_.ink(filled ? colorOf(index) : Color{1, 1, 1});
    cairo_fill_preserve(c);
    canvas_.ink(colorOf(index));
    cairo_set_line_width(c, 1.1);
    cairo_stroke(c);
}

std::string Drawing::letterOf(const std::string& failure) {
    if (const auto known = letters_.find(failure); known != letters_.end())
        return known->second;
    for (const char candidate : failure) {
        const std::string letter(1, candidate);
        if (std::ranges::none_of(letters_, [&](const auto& l) { return l.second == letter; }))
            return letters_[failure] = letter;
    }
    return letters_[failure] = std::to_string(letters_.size());
}

void Drawing::point(const WorkPoint& point, std::size_t index) {
    const double x = x_.at(std::max(point.seconds, 1e-6)), y = yOf(point);
    mark(x, y, index, point.failure.empty());
    if (point.minor) {
        minor_ = point.failure;
    } else if (!point.failure.empty()) {
        canvas_.ink(colorOf(index));
        canvas_.text(x + 6, y - 4, letterOf(point.failure), 9, Canvas::Anchor::start, true);
    }
    if (point.chosen) {
        canvas_.ink({0.85, 0.05, 0.15});
        cairo_set_line_width(canvas_.cairo(), 2);
        cairo_new_path(canvas_.cairo());
        cairo_arc(canvas_.cairo(), x, y, 11, 0, 2 * std::numbers::pi);
        cairo_stroke(canvas_.cairo());
    }
}

void Drawing::series(std::size_t index) {
    const std::vector<WorkPoint>& points = chart_.series[index].points;
    join(points, true, colorOf(index));
    join(points, false, colorOf(index));
    for (const WorkPoint& p : points)
        point(p, index);
}

void Drawing::legend() {
    double y = top + 6;
    const double x = right + 34;
    for (std::size_t i = 0; i < chart_.series.size(); ++i, y += 20) {
        canvas_.ink(colorOf(i), 0.9);
        canvas_.line(x - 13, y, x + 13, y, 1.6);
        mark(x, y, i, true);
        canvas_.ink(dark);
        canvas_.text(x + 22, y + 4, chart_.series[i].name, 11.5, Canvas::Anchor::start);
    }
    y += 12;
    const auto sample = [&](const std::string& words, bool dashed) {
        const double dashes[] = {3, 3};
        cairo_set_dash(canvas_.cairo(), dashes, dashed ? 2 : 0, 0);
        canvas_.ink(quiet);
        canvas_.line(x - 13, y, x + 13, y, dashed ? 1 : 1.6);
        cairo_set_dash(canvas_.cairo(), nullptr, 0, 0);
        canvas_.text(x + 22, y + 4, words, 10.5, Canvas::Anchor::start);
        y += 20;
    };
    if (anyFixed_) {
        sample("error controlled", false);
        sample("fixed steps", true);
    }
    if (anyChosen_) {
        canvas_.ink({0.85, 0.05, 0.15});
        cairo_set_line_width(canvas_.cairo(), 2);
        cairo_new_path(canvas_.cairo());
        cairo_arc(canvas_.cairo(), x, y, 8, 0, 2 * std::numbers::pi);
        cairo_stroke(canvas_.cairo());
        canvas_.ink(quiet);
        canvas_.text(x + 22, y + 4, "what auto takes", 10.5, Canvas::Anchor::start);
    }
}

void Drawing::key() {
    double x = left;
    canvas_.ink(quiet);
    for (const auto& [failure, letter] : letters_) {
        canvas_.text(x, height - 24, letter, 10.5, Canvas::Anchor::start, true);
        x += canvas_.widthOf(letter, 10.5, true) + 5;
        canvas_.text(x, height - 24, failure, 10.5, Canvas::Anchor::start);
        x += canvas_.widthOf(failure, 10.5) + 18;
    }
    if (!minor_.empty())
        canvas_.text(x, height - 24, "hollow without a letter: " + minor_, 10.5,
                     Canvas::Anchor::start);
}

Canvas& Drawing::run() {
    choosePlaces();
    grid();
    words();
    for (std::size_t i = chart_.series.size(); i-- > 0;)
        series(i);
    legend();
    key();
    return canvas_;
}

} // namespace

std::string draw(const WorkPrecision& chart, const std::string& file) {
    if (!Canvas::knows(file))
        return "its name ends with none of .svg, .png, .pdf";
    return Drawing(chart, file).run().finish();
}

Pixels pixelsOf(const WorkPrecision& chart, double pixelsPerPoint) {
    return Drawing(chart, pixelsPerPoint).run().pixels();
}

} // namespace charts
