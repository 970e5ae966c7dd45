// Draws the charts of docs/performance.md from rows on standard input.
//
//     bench_chart FILE.svg TITLE SUBTITLE X-LABEL Y-LABEL          rows: series,x,y     log-log
//     lines bench_chart FILE.svg TITLE SUBTITLE X-LABEL --bars LIMIT     rows: group,series,x
//     logarithmic bars
//
// Tabs stand between the fields. A series whose name ends with * is dashed. LIMIT is a value that
// is marked by a line.
#include "charts/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using charts::Canvas;
using charts::Color;

constexpr std::array<Color, 8> colors = {{{0.80, 0.13, 0.16},
                                          {0.10, 0.35, 0.75},
                                          {0.15, 0.55, 0.25},
                                          {0.90, 0.55, 0.05},
                                          {0.50, 0.25, 0.65},
                                          {0.10, 0.60, 0.65},
                                          {0.45, 0.35, 0.25},
                                          {0.45, 0.45, 0.45}}};
constexpr Color dark = {0.12, 0.12, 0.14}, quiet = {0.42, 0.42, 0.46}, faint = {0.87, 0.87, 0.89};
constexpr double width = 700;

struct Point {
    double x = 0, y = 0;
};
struct Series {
    std::string name;
    std::vector<Point> points;
};

std::string power(int decade) {
    if (decade >= 0 && decade <= 4)
        return std::to_string(static_cast<int>(std::lround(std::pow(10, decade))));
    return "1e" + std::to_string(decade);
}

struct Axis {
    double from = 0, to = 0;  // points of the page
    double low = 0, high = 0; // decades
    [[nodiscard]] double at(double value) const {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
    void cover(const std::vector<double>& values) {
        low = std::floor(std::log10(*std::ranges::min_element(values)) + 1e-9);
        high = std::max(std::ceil(std::log10(*std::ranges::max_element(values)) - 1e-9), low + 1);
    }
};

std::vector<std::vector<std::string>> rows() {
    std::vector<std::vector<std::string>> all;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream fields(line);
        std::vector<std::string> row;
        for (std::string field; std::getline(fields, field, '\t');)
            row.push_back(field);
        if (row.size() == 3)
            all.push_back(row);
    }
    return all;
}

void head(Canvas& canvas, const char* title, const char* subtitle) {
    canvas.ink(dark);
    canvas.text(16, 24, title, 15, Canvas::Anchor::start, true);
    canvas.ink(quiet);
    canvas.text(16, 42, subtitle, 10.5, Canvas::Anchor::start);
}

class Lines {
public:
    explicit Lines(char** words) : words_(words) {
        for (const auto& row : rows()) {
            const Point point{std::atof(row[1].c_str()), std::atof(row[2].c_str())};
            if (!(point.x > 0 && point.y > 0 && std::isfinite(point.x) && std::isfinite(point.y)))
                continue;
            auto known = std::ranges::find(series_, row[0], &Series::name);
            if (known == series_.end())
                known = series_.insert(series_.end(), Series{row[0], {}});
            known->points.push_back(point);
        }
    }
    [[nodiscard]] bool empty() const { return series_.empty(); }
    std::string draw(const std::string& file);

private:
    void grid(Canvas& canvas) const;
    void line(Canvas& canvas, std::size_t index) const;

    char** words_;
    std::vector<Series> series_;
    Axis x_{64, 450}, y_{340, 62};
};

void Lines::grid(Canvas& canvas) const {
    for (int d = static_cast<int>(x_.low); d <= static_cast<int>(x_.high); ++d) {
        const double x = x_.at(std::pow(10, d));
        canvas.ink(faint);
        canvas.line(x, y_.to, x, y_.from, 0.8);
        canvas.ink(quiet);
        canvas.text(x, y_.from + 15, power(d), 10, Canvas::Anchor::middle);
    }
    for (int d = static_cast<int>(y_.low); d <= static_cast<int>(y_.high); ++d) {
        const double y = y_.at(std::pow(10, d));
        canvas.ink(faint);
        canvas.line(x_.from, y, x_.to, y, 0.8);
        canvas.ink(quiet);
        canvas.text(x_.from - 6, y + 3.5, power(d), 10, Canvas::Anchor::end);
    }
    canvas.ink(dark);
    canvas.text((x_.from + x_.to) / 2, y_.from + 33, words_[3], 11, Canvas::Anchor::middle);
    canvas.textUpwards(16, (y_.from + y_.to) / 2, words_[4], 11);
}

void Lines::line(Canvas& canvas, std::size_t index) const {
    const Series& series = series_[index];
    const bool dashed = series.name.ends_with('*');
    cairo_t* c = canvas.cairo();
    canvas.ink(colors[index % colors.size()]);
    const double dashes[] = {4, 3};
    cairo_set_dash(c, dashes, dashed ? 2 : 0, 0);
    cairo_set_line_width(c, 1.6);
    cairo_new_path(c);
    for (const Point& point : series.points)
        cairo_line_to(c, x_.at(point.x), y_.at(point.y));
    cairo_stroke(c);
    cairo_set_dash(c, nullptr, 0, 0);
    for (const Point& point : series.points) {
        cairo_arc(c, x_.at(point.x), y_.at(point.y), 2.6, 0, 6.3);
        cairo_fill(c);
    }
    const double y = y_.to + 8 + 18 * static_cast<double>(index);
    cairo_set_dash(c, dashes, dashed ? 2 : 0, 0);
    canvas.line(x_.to + 14, y, x_.to + 34, y, 1.8);
    cairo_set_dash(c, nullptr, 0, 0);
    canvas.ink(dark);
    canvas.text(x_.to + 40, y + 3.5,
                dashed ? series.name.substr(0, series.name.size() - 1) : series.name, 10,
                Canvas::Anchor::start);
}

std::string Lines::draw(const std::string& file) {
    std::vector<double> xs, ys;
    for (const Series& series : series_)
        for (const Point& point : series.points) {
            xs.push_back(point.x);
            ys.push_back(point.y);
        }
    x_.cover(xs);
    y_.cover(ys);
    Canvas canvas(file, width, 388);
    head(canvas, words_[1], words_[2]);
    grid(canvas);
    for (std::size_t i = series_.size(); i-- > 0;)
        line(canvas, i);
    return canvas.finish();
}

std::string drawBars(char** words, const std::string& file, double limit) {
    struct Bar {
        std::string group, series;
        double value = 0;
    };
    std::vector<Bar> bars;
    std::vector<double> values = {1, limit};
    std::map<std::string, std::size_t> colorOf;
    std::vector<std::string> names;
    for (const auto& row : rows()) {
        bars.push_back({row[0], row[1], std::atof(row[2].c_str())});
        if (bars.back().value > 0)
            values.push_back(bars.back().value);
        if (colorOf.emplace(row[1], colorOf.size()).second)
            names.push_back(row[1]);
    }
    Axis x{170, 610};
    x.cover(values);
    constexpr double top = 78, thick = 11;
    Canvas canvas(file, width, top + 13 * static_cast<double>(bars.size()) + 60);
    head(canvas, words[1], words[2]);
    double at = 170;
    for (const std::string& name : names) {
        canvas.ink(colors[colorOf[name] % colors.size()]);
        canvas.line(at, 60, at + 18, 60, 6);
        canvas.ink(dark);
        canvas.text(at + 24, 63.5, name, 10, Canvas::Anchor::start);
        at += 44 + canvas.widthOf(name, 10);
    }
    const double end = top + 13 * static_cast<double>(bars.size()) + 6;
    for (int d = static_cast<int>(x.low); d <= static_cast<int>(x.high); ++d) {
        canvas.ink(faint);
        canvas.line(x.at(std::pow(10, d)), top - 4, x.at(std::pow(10, d)), end, 0.8);
        canvas.ink(quiet);
        canvas.text(x.at(std::pow(10, d)), end + 14, power(d), 10, Canvas::Anchor::middle);
    }
    double y = top + 4;
    std::string group;
    for (const Bar& bar : bars) {
        if (bar.group != group) {
            canvas.ink(dark);
            canvas.text(x.from - 8, y + 4, bar.group, 10, Canvas::Anchor::end);
            group = bar.group;
        }
        if (bar.value > 0) {
            canvas.ink(colors[colorOf[bar.series] % colors.size()], 0.85);
            canvas.line(x.at(std::min(1.0, bar.value)), y, x.at(std::max(1.0, bar.value)), y,
                        thick);
        }
        y += 13;
    }
    canvas.ink(dark);
    canvas.line(x.at(1), top - 4, x.at(1), end, 1.2);
    canvas.ink({0.85, 0.05, 0.15});
    canvas.line(x.at(limit), top - 4, x.at(limit), end, 1);
    canvas.ink(dark);
    canvas.text((x.from + x.to) / 2, end + 32, words[3], 11, Canvas::Anchor::middle);
    return canvas.finish();
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 6) {
        std::fputs("usage: bench_chart FILE TITLE SUBTITLE X-LABEL Y-LABEL|--bars LIMIT\n", stderr);
        return 2;
    }
    char** words = argv + 1;
    std::string why;
    if (std::string(argv[5]) == "--bars") {
        why = drawBars(words, argv[1], argc > 6 ? std::atof(argv[6]) : 1);
    } else {
        Lines lines(words);
        why = lines.empty() ? "there are no rows" : lines.draw(argv[1]);
    }
    if (!why.empty())
        std::fprintf(stderr, "bench_chart: %s: %s\n", argv[1], why.c_str());
    return why.empty() ? 0 : 1;
}
