#include "scene/curves.h"

#include <algorithm>

namespace scene {

namespace {

double shareAt(const BezierCurve& curve, double time) {
    return (time - curve.from) / (curve.to - curve.from);
}

} // namespace

// A cubic's inner control points lie a third of the interval along the slopes of its ends.
std::vector<BezierCurve> smoothCurves(const std::vector<std::pair<double, Vector>>& points) {
    const auto slope = [&](std::size_t i) -> Vector {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = std::min(i + 1, points.size() - 1);
        return (points[after].second - points[before].second) /
               (points[after].first - points[before].first);
    };
    std::vector<BezierCurve> curves;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto& [t0, p0] = points[i];
        const auto& [t1, p1] = points[i + 1];
        const double third = (t1 - t0) / 3;
        curves.push_back({t0, t1, {p0, p0 + third * slope(i), p1 - third * slope(i + 1), p1}});
    }
    return curves;
}

std::optional<Vector> valueAt(const std::vector<BezierCurve>& curves, double time) {
    for (const BezierCurve& curve : curves) {
        const bool isLast = &curve == &curves.back();
        if (time < curve.from || time > curve.to || (time == curve.to && !isLast))
            continue;
        std::vector<Vector> p = curve.control;
        for (std::size_t n = p.size() - 1; n > 0; --n)
            for (std::size_t i = 0; i < n; ++i)
                p[i] += shareAt(curve, time) * (p[i + 1] - p[i]);
        return p.front();
    }
    return std::nullopt;
}

std::pair<BezierCurve, BezierCurve> split(const BezierCurve& curve, double time) {
    BezierCurve left{curve.from, time, {}}, right{time, curve.to, {}};
    std::vector<Vector> p = curve.control;
    for (std::size_t n = p.size(); n > 0; --n) {
        left.control.push_back(p.front());
        right.control.push_back(p[n - 1]);
        for (std::size_t i = 0; i + 1 < n; ++i)
            p[i] += shareAt(curve, time) * (p[i + 1] - p[i]);
    }
    std::ranges::reverse(right.control);
    return {left, right};
}

} // namespace scene
