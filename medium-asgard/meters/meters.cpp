#include "meters/meters.h"

#include "expression/tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace meters {

namespace {

using editing::Element, editing::Kind;

// They share one set of names.
std::optional<Element> named(const scene::Scene& scene, std::string_view name) {
    const auto in = [&](Kind kind, const auto& all) -> std::optional<Element> {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!all[i].name.empty() && all[i].name == name)
                return Element{kind, i};
        return std::nullopt;
    };
    auto found = in(Kind::body, scene.bodies);
    found = found ? found : in(Kind::joint, scene.joints);
    found = found ? found : in(Kind::link, scene.links);
    found = found ? found : in(Kind::rope, scene.ropes);
    return found ? found : in(Kind::contact, scene.contacts);
}

std::optional<Element> firstIn(const scene::Scene& scene, const std::string& expression) {
    using expression::TokenKind;
    expression::Tokens tokens(expression);
    for (; tokens.now().kind != TokenKind::end && !tokens.fault(); tokens.advance()) {
        const std::string_view text = tokens.now().text; // "b1.x"
        if (tokens.now().kind == TokenKind::name && text.find('.') != text.npos)
            if (const auto found = named(scene, text.substr(0, text.find('.'))))
                return found;
    }
    return std::nullopt;
}

// Between two samples; NaN where there is none.
double valueAt(const charts::Plot& plot, const std::vector<double>& values, double time) {
    if (values.size() != plot.times.size() || plot.times.empty() || time > plot.times.back())
        return std::nan("");
    const auto after =
        static_cast<std::size_t>(std::ranges::lower_bound(plot.times, time) - plot.times.begin());
    if (after == 0)
        return values.front();
    const double from = plot.times[after - 1], to = plot.times[after];
    const double share = to > from ? (time - from) / (to - from) : 1;
    return values[after - 1] + share * (values[after] - values[after - 1]);
}

// A value that is the rounding of large ones is 0.
double withoutNoise(double value, const std::vector<double>& values) {
    double size = 0;
    for (const double one : values)
        size = std::isfinite(one) ? std::max(size, std::abs(one)) : size;
    return std::abs(value) <= 1e-9 * size ? 0 : value;
}

} // namespace

std::vector<Meter> metersOf(const scene::Scene& scene) {
    std::vector<Meter> all;
    for (std::size_t i = 0; i < std::min(most, scene.plots.size()); ++i) {
        const scene::Plot& plot = scene.plots[i];
        for (std::size_t k = 0; plot.beside && k < plot.values.size(); ++k)
            if (const auto of = firstIn(scene, plot.values[k]); of && all.size() < most)
                all.push_back({i, k, *of,
                               k < plot.labels.size() && !plot.labels[k].empty() ? plot.labels[k]
                                                                                 : plot.values[k]});
    }
    return all;
}

const charts::Plot* Sampled::of(const scene::Plot& plot) const {
    for (std::size_t i = 0; i < plots.size(); ++i)
        if (scene->plots[i].values == plot.values)
            return &plots[i];
    return nullptr;
}

std::string wordsOf(const Meter& meter, const charts::Plot* sampled, double time) {
    if (sampled == nullptr || meter.value >= sampled->curves.size())
        return meter.label + " …";
    const charts::Curve& curve = sampled->curves[meter.value];
    const double value = valueAt(*sampled, curve.values, time);
    if (!std::isfinite(value))
        return meter.label + " –";
    char digits[32];
    const auto end = std::to_chars(std::begin(digits), std::end(digits),
                                   withoutNoise(value, curve.values), std::chars_format::general, 3)
                         .ptr;
    return meter.label + " " + std::string(digits, end) +
           (curve.unit.empty() ? "" : " " + curve.unit);
}

} // namespace meters
