#include "charts/plots.h"

#include "charts/marks.h"
#include "charts/scale.h"
#include "expression/tokens.h"
#include "scene/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace charts {

namespace {

// Of the body, its shape, or the first of its parts that has one.
std::optional<scene::Color> bodyColor(const scene::Scene& scene, const scene::Body& body) {
    if (body.appearance.color)
        return body.appearance.color;
    const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
    if (!set)
        return std::nullopt;
    for (const scene::Part& part : set->parts)
        if (part.appearance.color)
            return part.appearance.color;
    return set->appearance.color;
}

// The bodies whose quantities it reads.
std::set<std::string> bodiesIn(const scene::Scene& scene, const std::string& expression) {
    using expression::TokenKind;
    std::set<std::string> found;
    expression::Tokens tokens(expression);
    for (; tokens.now().kind != TokenKind::end && !tokens.fault(); tokens.advance()) {
        const std::string_view text = tokens.now().text; // "b1.x"
        const std::size_t dot = text.find('.');
        if (tokens.now().kind != TokenKind::name || dot == text.npos)
            continue;
        const std::string name(text.substr(0, dot));
        if (scene::findBody(scene, name))
            found.insert(name);
    }
    return found;
}

// As grey as the eye sees it, 0 to 1.
double brightness(const Color& color) {
    return 0.344 * color.red + 0.5 * color.green + 0.156 * color.blue;
}

Color onPaper(const scene::Color& color) {
    Color ink{color.red, color.green, color.blue};
    constexpr double lightest = 0.65; // that is seen on white
    constexpr double darker = 0.926;
    while (brightness(ink) > lightest)
        ink = {ink.red * darker, ink.green * darker, ink.blue * darker};
    return ink;
}

bool alike(const Color& a, const Color& b) {
    return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) < 0.24;
}

Color curveColor(const scene::Scene& scene, const scene::Plot& plot, std::size_t curve) {
    const auto bodies = bodiesIn(scene, plot.values[curve]);
    const auto color = bodies.size() == 1
                           ? bodyColor(scene, *scene::findBody(scene, *bodies.begin()))
                           : std::nullopt;
    return color ? onPaper(*color) : colorOf(curve);
}

std::string spelled(double number, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, number);
    return text.data();
}

constexpr double letters = 11, leftSpace = 68, rightSpace = 12, topSpace = 24, bottomSpace = 36;

std::string joined(const std::string& words, const std::string& unit) {
    return words.empty() || unit.empty() ? words + unit : words + ", " + unit;
}

// The words of a plot of these curves beside its values; of several bodies, the words that all
// share.
std::string nameOfValues(const scene::Units& units, const scene::Plot& plot,
                         const std::vector<Curve>& curves) {
    std::set<std::string> measures, words;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const std::string all = units.wordsOf(plot.values[i]);
        measures.insert(curves[i].unit);
        words.insert(curves.size() == 1 ? all : all.substr(0, all.find(" of ")));
    }
    if (curves.size() == 1 && !plot.labels.empty() && !plot.labels.front().empty())
        words = {plot.labels.front()};
    if (measures.size() != 1)
        return {};
    return joined(words.size() == 1 ? *words.begin() : "", *measures.begin());
}

class Axes {
public:
    Axes(Canvas& canvas, const PlotArea& inside, const Range& range)
        : canvas_(canvas), a_(inside), range_(range) {}

    [[nodiscard]] double x(double time) const {
        return a_.left + (time - a_.start) / (a_.finish - a_.start) * a_.width;
    }
    [[nodiscard]] double y(double value) const {
        return a_.top + (range_.high - value) / (range_.high - range_.low) * a_.height;
    }

    void drawTimes() const {
        const double span = a_.finish - a_.start, bottom = a_.top + a_.height;
        for (const double time :
             multiplesOf(roundStep(span * 70 / a_.width), a_.start, a_.finish)) {
            setLine(false);
            canvas_.line(x(time), a_.top, x(time), bottom, 0.7);
            canvas_.ink({}, 0.67);
            canvas_.text(x(time), bottom + 15, spelled(time, 6), letters, Canvas::Anchor::middle);
        }
        canvas_.ink({}, 0.67);
        canvas_.text(a_.left + a_.width / 2, bottom + 29, timeAxis, letters,
                     Canvas::Anchor::middle);
    }

    void drawValues() const {
        const double height = range_.high - range_.low, step = roundStep(height * 30 / a_.height);
        // Values that differ in their last digits only are written by what they are above a round
        // one.
        constexpr int widest = 7; // digits
        const double size = std::max(std::abs(range_.low), std::abs(range_.high));
        const double round = 10 * roundStep(height);
        const double base =
            digitsFor(size, step) > widest ? std::floor(range_.low / round) * round : 0;
        if (base != 0) {
            canvas_.ink({}, 0.67);
            canvas_.text(a_.left - leftSpace + 16, a_.top - 3,
                         spelled(base, digitsFor(base, round)) + " +", letters,
                         Canvas::Anchor::start);
        }
        for (const double value : multiplesOf(step, range_.low, range_.high)) {
            setLine(value == 0);
            canvas_.line(a_.left, y(value), a_.left + a_.width, y(value), 0.7);
            const double above = std::abs(value - base) < step / 2 ? 0 : value - base;
            canvas_.ink({}, 0.67);
            canvas_.text(a_.left - 5, y(value) + 4,
                         spelled(above, base != 0 ? 4 : digitsFor(value, step)), letters,
                         Canvas::Anchor::end);
        }
    }

    // As much of it as there is room for: the unit, which comes last, rather than the words.
    void drawName(const std::string& name) const {
        const std::size_t comma = name.rfind(", ");
        const bool fits = canvas_.widthOf(name, letters) <= a_.height;
        canvas_.ink({}, 0.67);
        canvas_.textUpwards(a_.left - leftSpace + 12, a_.top + a_.height / 2,
                            fits || comma == std::string::npos ? name : name.substr(comma + 2),
                            letters);
    }

    void drawCurve(const Plot& plot, const Curve& curve) const {
        cairo_t* c = canvas_.cairo();
        cairo_new_path(c);
        bool joined = false;
        for (std::size_t i = 0; i < std::min(curve.values.size(), plot.times.size()); ++i) {
            if (!(std::abs(curve.values[i]) <= 1e300)) {
                joined = false;
                continue;
            }
            if (joined)
                cairo_line_to(c, x(plot.times[i]), y(curve.values[i]));
            else
                cairo_move_to(c, x(plot.times[i]), y(curve.values[i]));
            joined = true;
        }
        stroke(curve, 1.4);
    }

    // The curve's value where time is now.
    void drawPoint(const Plot& plot, const Curve& curve, double now) const {
        const auto after = std::ranges::lower_bound(plot.times, now);
        const auto i = static_cast<std::size_t>(after - plot.times.begin());
        if (i >= curve.values.size() || !std::isfinite(curve.values[i]))
            return;
        double value = curve.values[i];
        if (i > 0 && std::isfinite(curve.values[i - 1])) {
            const double part = (now - plot.times[i - 1]) / (plot.times[i] - plot.times[i - 1]);
            value = curve.values[i - 1] + part * (value - curve.values[i - 1]);
        }
        canvas_.ink(curve.color);
        cairo_arc(canvas_.cairo(), x(now), y(value), 2.8, 0, 7);
        cairo_fill(canvas_.cairo());
    }

    void stroke(const Curve& curve, double width) const {
        static const std::array<std::vector<double>, 4> dashes = {
            {{}, {5, 3}, {1.4, 2.4}, {5, 2.4, 1.4, 2.4}}};
        const std::vector<double>& dash = dashes[static_cast<std::size_t>(curve.stroke)];
        cairo_t* c = canvas_.cairo();
        canvas_.ink(curve.color);
        cairo_set_dash(c, dash.data(), static_cast<int>(dash.size()), 0);
        cairo_set_line_width(c, width);
        cairo_stroke(c);
        cairo_set_dash(c, nullptr, 0, 0);
    }

private:
    void setLine(bool isStrong) const { canvas_.ink({}, isStrong ? 0.4 : 0.12); }

    Canvas& canvas_;
    PlotArea a_;
    Range range_;
};

void drawKey(Canvas& canvas, const Axes& axes, const Plot& plot, const PlotArea& area) {
    const double line = area.top + 15;
    double x = area.left + leftSpace;
    canvas.ink({});
    canvas.text(x, line, plot.title, letters + 1, Canvas::Anchor::start, true);
    x += canvas.widthOf(plot.title, letters + 1, true) + 14;
    for (const Curve& curve : plot.curves) {
        cairo_move_to(canvas.cairo(), x, line - 3);
        cairo_line_to(canvas.cairo(), x + 18, line - 3);
        axes.stroke(curve, 2);
        canvas.ink({});
        // The key has units that the axis cannot say.
        const std::string label =
            plot.values.empty() ? joined(curve.label, curve.unit) : curve.label;
        canvas.text(x + 22, line, label, letters, Canvas::Anchor::start);
        x += 34 + canvas.widthOf(label, letters);
    }
}

} // namespace

Said saidAs(const std::string& unit) {
    return unit == "rad" ? Said{"°", 180 / M_PI} : Said{unit, 1};
}

Plot named(const scene::Scene& scene, const scene::Plot& plot) {
    Plot result{.title = plot.title.empty() ? plot.name : plot.title};
    const scene::Units units(scene);
    for (std::size_t i = 0; i < plot.values.size(); ++i) {
        Curve curve{.label =
                        i < plot.labels.size() ? plot.labels[i] : units.wordsOf(plot.values[i]),
                    .color = curveColor(scene, plot, i)};
        if (curve.label.empty() && i >= plot.labels.size())
            curve.label = plot.values[i];
        const auto before = std::ranges::count_if(
            result.curves, [&](const Curve& one) { return alike(one.color, curve.color); });
        curve.stroke = static_cast<Stroke>(before % 4);
        curve.unit = saidAs(units.of(plot.values[i])).unit;
        result.curves.push_back(std::move(curve));
    }
    result.values = nameOfValues(units, plot, result.curves);
    return result;
}

std::optional<Plot> sampled(simulation::ReadableScene& readable, const scene::Scene& scene,
                            const scene::Plot& plot, const simulation::MotionPointer& motion,
                            const std::function<bool()>& isOvertaken) {
    constexpr int intervals = 600; // more than a chart has pixels for each
    Plot result = named(scene, plot);
    if (!motion)
        return result;
    const simulation::Quantities quantities = readable.quantities(motion, plot.values);
    for (const std::string& fault : quantities.faults())
        if (!fault.empty())
            result.fault += (result.fault.empty() ? "" : "\n") + fault;
    if (!result.fault.empty())
        return result;
    std::vector<double> factors;
    for (const std::string& value : plot.values)
        factors.push_back(saidAs(scene::Units(scene).of(value)).factor);
    const double start = motion->start(), length = motion->computed() - start;
    for (int i = 0; i <= intervals; ++i) {
        if (isOvertaken())
            return std::nullopt;
        const double time = start + length * i / intervals;
        const std::vector<double> values = quantities.at(time);
        result.times.push_back(time);
        for (std::size_t k = 0; k < values.size() && k < result.curves.size(); ++k)
            result.curves[k].values.push_back(factors[k] * values[k]);
    }
    return result;
}

Range rangeOf(const Plot& plot) {
    constexpr double largest = 1e300; // so that a range is a number, too
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : plot.curves)
        for (const double value : curve.values)
            if (std::abs(value) <= largest) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
    if (!(low <= high))
        low = high = 0;
    // A value that does not change, but for rounding, is a line in the middle.
    const double size = std::max(std::abs(low), std::abs(high));
    const double least = size > 0 ? 1e-9 * size : 1;
    const double room = 0.08 * (high - low) + std::max(0.0, least - (high - low)) / 2;
    return {low - room, high + room};
}

double PlotArea::timeAt(double x) const {
    return start + std::clamp((x - left) / width, 0.0, 1.0) * (finish - start);
}

PlotArea insideOf(const PlotArea& area) {
    PlotArea inside = area;
    inside.left += leftSpace;
    inside.top += topSpace;
    inside.width = std::max(1.0, area.width - leftSpace - rightSpace);
    inside.height = std::max(1.0, area.height - topSpace - bottomSpace);
    if (!(inside.finish > inside.start))
        inside.finish = inside.start + 1;
    return inside;
}

void draw(Canvas& canvas, const Plot& plot, const PlotArea& area, double now) {
    const PlotArea inside = insideOf(area);
    const Axes axes(canvas, inside, rangeOf(plot));
    drawKey(canvas, axes, plot, area);
    if (!plot.fault.empty()) {
        canvas.ink({0.7, 0, 0});
        double y = inside.top + 12;
        for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1, y += 14) {
            to = plot.fault.find('\n', from);
            canvas.text(area.left + 4, y, plot.fault.substr(from, to - from), letters,
                        Canvas::Anchor::start);
        }
        return;
    }
    axes.drawTimes();
    axes.drawValues();
    axes.drawName(plot.values);
    cairo_save(canvas.cairo());
    cairo_rectangle(canvas.cairo(), inside.left - 3, inside.top - 3, inside.width + 6,
                    inside.height + 6);
    cairo_clip(canvas.cairo());
    for (const Curve& curve : plot.curves)
        axes.drawCurve(plot, curve);
    if (now >= inside.start && now <= inside.finish) {
        canvas.ink({}, 0.45);
        canvas.line(axes.x(now), inside.top, axes.x(now), inside.top + inside.height, 0.8);
        for (const Curve& curve : plot.curves)
            axes.drawPoint(plot, curve, now);
    }
    cairo_restore(canvas.cairo());
}

} // namespace charts
