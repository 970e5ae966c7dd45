#include "views/plot_colors.h"

#include "expression/tokens.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace views {

namespace {

// Of the body, its shape, or the first of its parts that has one.
std::optional<scene::Color> colorOf(const scene::Scene& scene, const scene::Body& body) {
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

QColor onPaper(const scene::Color& color) {
    QColor ink = QColor::fromRgbF(static_cast<float>(color.red), static_cast<float>(color.green),
                                  static_cast<float>(color.blue));
    constexpr int lightest = 165; // of 255: what is seen on white
    for (int i = 0; i < 20 && qGray(ink.rgb()) > lightest; ++i)
        ink = ink.darker(108);
    return ink;
}

bool alike(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
               std::abs(a.blue() - b.blue()) <
           60;
}

} // namespace

void colorCurves(const scene::Scene& scene, const scene::Plot& plot,
                 std::vector<PlotCurve>& curves) {
    constexpr Qt::PenStyle lines[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    const std::size_t count = std::min(curves.size(), plot.values.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto bodies = bodiesIn(scene, plot.values[i]);
        const auto color = bodies.size() == 1
                               ? colorOf(scene, *scene::findBody(scene, *bodies.begin()))
                               : std::nullopt;
        curves[i].color = color ? onPaper(*color) : PlotChart::usualColor(i);
        const auto before =
            std::count_if(curves.begin(), curves.begin() + static_cast<std::ptrdiff_t>(i),
                          [&](const PlotCurve& one) { return alike(one.color, curves[i].color); });
        curves[i].line = lines[static_cast<std::size_t>(before) % std::size(lines)];
    }
}

} // namespace views
