#include "charts/work_precision.h"

#include "charts/canvas.h"
#include "charts/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace charts {

namespace {

constexpr double width = chartWidth, height = chartHeight;
constexpr double left = 74, right = 720, top = 86, bottom = 606; // of the frame
constexpr double lane = 13; // above the frame's lines: a method's points without an error
constexpr double markerSize = 4.4, smallMarker = 2.8, laneMarker = 3.2, letterSize = 9;
constexpr double leastError = 1e-14, mostError = 1, leastSeconds = 1e-6;

constexpr Color dark{0.13, 0.15, 0.18}, quiet{0.42, 0.45, 0.5}, faint{0.88, 0.89, 0.91};
constexpr Color ringed{0.85, 0.05, 0.15};

std::vector<WorkPoint> sortedByTime(std::vector<WorkPoint> points) {
    std::erase_if(points, [](const WorkPoint& p) { return p.error && *p.error <= mostError; });
    std::ranges::stable_sort(points, {}, &WorkPoint::seconds);
    return points;
}

bool hasPlace(const WorkPoint& point) { return point.error && *point.error <= mostError; }

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
    [[nodiscard]] double xOf(const WorkPoint& point) const {
        return x_.at(std::max(point.seconds, leastSeconds));
    }
    [[nodiscard]] double yOf(const WorkPoint& point) const {
        return y_.at(std::max(*point.error, leastError));
    }
    void grid();
    void words();
    void series(std::size_t index);
    void join(const std::vector<WorkPoint>& points, bool fixedStep, const Color& color);
    void point(const WorkPoint& point, std::size_t index);
    void letter(double x, double y, const WorkPoint& point, std::size_t index);
    void ring(double x, double y, double size);
    void lanes();
    void letters();
    void legend();
    [[nodiscard]] std::string failuresOf(const WorkSeries& series);
    void key();
    [[nodiscard]] std::string letterOf(const std::string& failure);
    [[nodiscard]] double band() const { return lane * static_cast<double>(lanes_.size()); }
    // Below the lanes, so that their markers keep clear of the numbers of the axis.
    [[nodiscard]] double axisTop() const { return top + band() + (lanes_.empty() ? 0 : lane); }

    const WorkPrecision& chart_;
    Canvas canvas_;
    Axis x_, y_;
    std::vector<std::size_t> lanes_; // series with points that have no place in the frame
    bool anyChosen_ = false, anyFixed_ = false;
    std::map<std::string, std::string> letters_; // by failure
    std::string minor_;                          // the failure that has none
    struct Box {
        double x, y, width, height;
    };
    std::vector<Box> taken_; // by letters and markers
};

void Drawing::choosePlaces() {
    double least = 1e300, most = 0, small = 1e300, large = 0;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
        bool isComplete = true;
        for (const WorkPoint& point : chart_.series[i].points) {
            least = std::min(least, std::max(point.seconds, leastSeconds));
            most = std::max(most, std::max(point.seconds, leastSeconds));
            anyChosen_ = anyChosen_ || point.chosen;
            anyFixed_ = anyFixed_ || point.fixedStep;
            isComplete = isComplete && hasPlace(point);
            if (!hasPlace(point))
                continue;
            small = std::min(small, std::max(*point.error, leastError));
            large = std::max(large, std::max(*point.error, leastError));
        }
        if (!isComplete)
            lanes_.push_back(i);
    }
    x_ = axisOver(most > 0 ? least : 1e-3, most > 0 ? most : 1, left, right);
    y_ = axisOver(large > 0 ? small : 1e-6, large > 0 ? large : 1, bottom, axisTop());
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
    if (!lanes_.empty()) {
        canvas_.ink(faint, 0.45);
        cairo_rectangle(canvas_.cairo(), left, top, right - left, band());
        cairo_fill(canvas_.cairo());
        canvas_.ink(quiet);
        canvas_.text(left + 6, top - 5,
                     "no result, or an error larger than the scene: a row for each method", 9.5,
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
        if (last && hasPlace(point) && hasPlace(*last)) {
            canvas_.ink(color, point.failure.empty() && last->failure.empty() ? 0.8 : 0.3);
            cairo_move_to(c, xOf(*last), yOf(*last));
            cairo_line_to(c, xOf(point), yOf(point));
            cairo_stroke(c);
        }
        last = &point;
    }
    cairo_set_dash(c, nullptr, 0, 0);
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

void Drawing::ring(double x, double y, double size) {
    canvas_.ink(ringed);
    cairo_set_line_width(canvas_.cairo(), 2);
    cairo_new_path(canvas_.cairo());
    cairo_arc(canvas_.cairo(), x, y, size, 0, 2 * std::numbers::pi);
    cairo_stroke(canvas_.cairo());
}

// At a corner of the marker where no other letter stands; where all are taken, a neighbour's
// letter says it.
void Drawing::letter(double x, double y, const WorkPoint& point, std::size_t index) {
    const std::string text = letterOf(point.failure);
    const double wide = canvas_.widthOf(text, letterSize, true), high = letterSize;
    const std::array<std::pair<double, double>, 4> corners = {
        {{x + 5, y - 3}, {x - 5 - wide, y - 3}, {x + 5, y + high}, {x - 5 - wide, y + high}}};
    for (const auto& [at, base] : corners) {
        const Box box{at, base - high + 1, wide, high};
        const bool isFree = std::ranges::none_of(taken_, [&](const Box& other) {
            return box.x < other.x + other.width && other.x < box.x + box.width &&
                   box.y < other.y + other.height && other.y < box.y + box.height;
        });
        if (!isFree)
            continue;
        taken_.push_back(box);
        canvas_.ink(colorOf(index));
        canvas_.text(at, base, text, letterSize, Canvas::Anchor::start, true);
        return;
    }
}

void Drawing::point(const WorkPoint& point, std::size_t index) {
    const double x = xOf(point), y = yOf(point);
    drawMark(canvas_, x, y, index, point.fixedStep ? smallMarker : markerSize,
             point.failure.empty() ? Fill::full : Fill::hollow);
    if (point.chosen)
        ring(x, y, 11);
}

// A row for each method that has such points: its marker at the left, and letters where they fell.
void Drawing::lanes() {
    double y = top + lane / 2;
    for (const std::size_t index : lanes_) {
        drawMark(canvas_, left - 10, y, index, laneMarker, Fill::hollow);
        double freeFrom = left;
        for (const WorkPoint& point : sortedByTime(chart_.series[index].points)) {
            const std::string text = point.minor ? "·" : letterOf(point.failure);
            const double wide = canvas_.widthOf(text, letterSize, true);
            const double x = std::max(xOf(point) - wide / 2, freeFrom);
            canvas_.ink(colorOf(index));
            canvas_.text(x, y + 3.2, text, letterSize, Canvas::Anchor::start, true);
            freeFrom = x + wide + 1;
            if (point.chosen)
                ring(x + wide / 2, y, 8);
        }
        y += lane;
    }
}

void Drawing::series(std::size_t index) {
    const std::vector<WorkPoint>& points = chart_.series[index].points;
    join(points, true, colorOf(index));
    join(points, false, colorOf(index));
    for (const WorkPoint& p : points)
        if (hasPlace(p))
            point(p, index);
}

// "4 of 12 ok: hollow 5, u 2, t 1"
std::string Drawing::failuresOf(const WorkSeries& series) {
    std::map<std::string, std::size_t> counts;
    std::size_t minor = 0, failed = 0;
    for (const WorkPoint& point : series.points) {
        failed += point.failure.empty() ? 0 : 1;
        if (point.minor)
            ++minor;
        else if (!point.failure.empty())
            ++counts[letterOf(point.failure)];
    }
    if (failed == 0)
        return "";
    std::string text = std::to_string(series.points.size() - failed) + " of " +
                       std::to_string(series.points.size()) + " ok: ";
    if (minor > 0)
        text += "hollow " + std::to_string(minor) + (counts.empty() ? "" : ", ");
    bool isFirst = true;
    for (const auto& [letter, count] : counts) {
        text += (isFirst ? "" : ", ") + letter + " " + std::to_string(count);
        isFirst = false;
    }
    return text;
}

void Drawing::legend() {
    double y = top + 2;
    const double x = right + 30;
    for (std::size_t i = 0; i < chart_.series.size(); ++i, y += 27) {
        canvas_.ink(colorOf(i), 0.9);
        canvas_.line(x - 13, y, x + 13, y, 1.6);
        drawMark(canvas_, x, y, i, markerSize, Fill::full);
        canvas_.ink(dark);
        canvas_.text(x + 22, y + 3, chart_.series[i].name, 11.5, Canvas::Anchor::start);
        canvas_.ink(quiet);
        canvas_.text(x + 22, y + 13.5, failuresOf(chart_.series[i]), 8.5, Canvas::Anchor::start);
    }
    y += 8;
    const auto sample = [&](const std::string& words, bool dashed) {
        const double dashes[] = {3, 3};
        cairo_set_dash(canvas_.cairo(), dashes, dashed ? 2 : 0, 0);
        canvas_.ink(quiet);
        canvas_.line(x - 13, y, x + 13, y, dashed ? 1 : 1.6);
        cairo_set_dash(canvas_.cairo(), nullptr, 0, 0);
        cairo_new_path(canvas_.cairo());
        cairo_arc(canvas_.cairo(), x, y, dashed ? smallMarker : markerSize, 0,
                  2 * std::numbers::pi);
        cairo_fill(canvas_.cairo());
        canvas_.text(x + 22, y + 4, words, 10.5, Canvas::Anchor::start);
        y += 20;
    };
    if (anyFixed_) {
        sample("error controlled", false);
        sample("fixed steps", true);
    }
    if (anyChosen_) {
        ring(x, y, 8);
        canvas_.ink(quiet);
        canvas_.text(x + 22, y + 4, chart_.chosen, 10.5, Canvas::Anchor::start);
        canvas_.text(x + 22, y + 17, chart_.chosenName, 9.5, Canvas::Anchor::start);
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

// After all markers, on which none may stand.
void Drawing::letters() {
    for (const WorkSeries& series : chart_.series)
        for (const WorkPoint& point : series.points) {
            if (point.minor)
                minor_ = point.failure;
            if (hasPlace(point))
                taken_.push_back({xOf(point) - 3, yOf(point) - 3, 6, 6});
        }
    for (std::size_t i = 0; i < chart_.series.size(); ++i)
        for (const WorkPoint& p : chart_.series[i].points)
            if (hasPlace(p) && !p.minor && !p.failure.empty())
                letter(xOf(p), yOf(p), p, i);
}

Canvas& Drawing::run() {
    choosePlaces();
    grid();
    words();
    for (std::size_t i = chart_.series.size(); i-- > 0;)
        series(i);
    lanes();
    letters();
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
