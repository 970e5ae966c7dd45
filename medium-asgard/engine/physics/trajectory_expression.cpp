#include "physics/trajectory_expression.h"

#include <algorithm>
#include <limits>
#include <span>

namespace physics {
namespace {

constexpr std::size_t mostHornerDegree = 8;

// Coefficients of u^k: a_k = C(n,k) sum_i (-1)^(k-i) C(k,i) p_i, the k-th differences.
std::vector<Vector> powerBasis(std::vector<Vector> points) {
    const std::size_t n = points.size() - 1;
    std::vector<Vector> coefficients;
    double binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        coefficients.emplace_back(binomial * points[0]);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            points[i] = points[i + 1] - points[i];
        points.pop_back();
        binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return coefficients;
}

NodeVector hornerRule(Graph& g, Node u, const std::vector<Vector>& coefficients) {
    NodeVector value = constant(g, coefficients.back());
    for (std::size_t k = coefficients.size() - 1; k-- > 0;)
        value = add(g, constant(g, coefficients[k]), scaled(g, u, value));
    return value;
}

NodeVector deCasteljau(Graph& g, Node u, const std::vector<Vector>& points) {
    std::vector<NodeVector> level;
    for (const Vector& p : points)
        level.push_back(constant(g, p));
    for (; level.size() > 1; level.pop_back())
        for (std::size_t i = 0; i + 1 < level.size(); ++i)
            level[i] = add(g, level[i], scaled(g, u, subtract(g, level[i + 1], level[i])));
    return level[0];
}

NodeVector curveValue(Graph& g, Node time, const scene::BezierCurve& curve) {
    const Node u =
        g.divide(g.subtract(time, g.constant(curve.from)), g.constant(curve.to - curve.from));
    return curve.control.size() <= mostHornerDegree + 1
               ? hornerRule(g, u, powerBasis(curve.control))
               : deCasteljau(g, u, curve.control);
}

// Straight on from an end of a curve, with its slope there.
NodeVector continued(Graph& g, Node time, const scene::BezierCurve& curve, bool isAfter) {
    const auto& p = curve.control;
    const std::size_t n = p.size() - 1;
    const double rate = static_cast<double>(n) / (curve.to - curve.from);
    Vector slope = Vector::Zero();
    if (n > 0)
        slope = isAfter ? rate * (p[n] - p[n - 1]) : rate * (p[1] - p[0]);
    const Node since = g.subtract(time, g.constant(isAfter ? curve.to : curve.from));
    return add(g, constant(g, isAfter ? p[n] : p[0]), scaled(g, since, constant(g, slope)));
}

NodeVector chosen(Graph& g, Node time, std::span<const TrajectoryPiece> pieces) {
    if (pieces.size() == 1)
        return pieces[0].value;
    const std::size_t middle = pieces.size() / 2;
    const NodeVector early = chosen(g, time, pieces.first(middle));
    const NodeVector late = chosen(g, time, pieces.subspan(middle));
    const Node isEarly = g.apply(Op::less, time, g.constant(pieces[middle].from));
    return {g.apply(Op::select, isEarly, early[0], late[0]),
            g.apply(Op::select, isEarly, early[1], late[1]),
            g.apply(Op::select, isEarly, early[2], late[2])};
}

} // namespace

std::vector<TrajectoryPiece> piecesOf(Graph& g, Node time, const scene::Trajectory& trajectory) {
    std::vector<TrajectoryPiece> pieces;
    const auto add = [&](double from, const NodeVector& value) {
        pieces.push_back({from, value, differentiated(g, value, time)});
    };
    const auto& curves = trajectory.curves;
    constexpr double always = -std::numeric_limits<double>::infinity();
    add(always,
        curves.empty() ? constant(g, Vector::Zero()) : continued(g, time, curves.front(), false));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        add(curves[i].from, curveValue(g, time, curves[i]));
        const bool isLast = i + 1 == curves.size();
        if (isLast || curves[i + 1].from > curves[i].to)
            add(curves[i].to, continued(g, time, curves[i], true));
    }
    return pieces;
}

const TrajectoryPiece& pieceAt(const std::vector<TrajectoryPiece>& pieces, double t) {
    const auto after = std::ranges::upper_bound(pieces, t, {}, &TrajectoryPiece::from);
    return after == pieces.begin() ? pieces.front() : *(after - 1);
}

NodeVector valueOf(Graph& g, Node time, const std::vector<TrajectoryPiece>& pieces) {
    return chosen(g, time, pieces);
}

NodeVector differentiated(Graph& g, const NodeVector& v, Node symbol) {
    return {differentiate(g, v[0], symbol), differentiate(g, v[1], symbol),
            differentiate(g, v[2], symbol)};
}

} // namespace physics
