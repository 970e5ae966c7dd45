#include "physics/node_vector.h"

#include <cmath>
#include <functional>
#include <span>

namespace physics {
namespace {

// a1 + a2 + ... without a leading 0.
Node sum(Graph& g, std::initializer_list<Node> terms) {
    Node total = g.constant(0);
    for (const Node term : terms)
        total = g.add(total, term);
    return total;
}

Node squared(Graph& g, Node a) { return g.multiply(a, a); }

// c0 + x (c1 + x (c2 + ...))
Node horner(Graph& g, Node x, std::span<const double> coefficients) {
    Node value = g.constant(coefficients.back());
    for (std::size_t i = coefficients.size() - 1; i-- > 0;)
        value = g.add(g.constant(coefficients[i]), g.multiply(x, value));
    return value;
}

// Functions of the angle a that are even and smooth at 0: `closed` where a² is not small.
Node nearZeroOr(Graph& g, Node square, std::span<const double> series, Node closed) {
    constexpr double small = 0.01; // five terms are then exact to the last place
    return g.apply(Op::select, g.apply(Op::less, square, g.constant(small)),
                   horner(g, square, series), closed);
}

} // namespace

Node numberOf(Graph& g, double value, Node owner, std::uint32_t place) {
    return value == 0 || std::abs(value) == 1 ? g.constant(value)
                                              : g.parameter(value, owner, place);
}

NodeVector numbersOf(Graph& g, const Vector& v, Node owner) {
    const std::hash<double> hash;
    const std::size_t all = hash(v[0]) + 31 * (hash(v[1]) + 31 * hash(v[2]));
    const auto place = static_cast<std::uint32_t>(all ^ (all >> 32));
    return {numberOf(g, v[0], owner, place), numberOf(g, v[1], owner, place + 1),
            numberOf(g, v[2], owner, place + 2)};
}

NodeVector constant(Graph& g, const Vector& v) {
    return {g.constant(v[0]), g.constant(v[1]), g.constant(v[2])};
}

NodeVector add(Graph& g, const NodeVector& a, const NodeVector& b) {
    return {g.add(a[0], b[0]), g.add(a[1], b[1]), g.add(a[2], b[2])};
}

NodeVector subtract(Graph& g, const NodeVector& a, const NodeVector& b) {
    return {g.subtract(a[0], b[0]), g.subtract(a[1], b[1]), g.subtract(a[2], b[2])};
}

NodeVector scaled(Graph& g, Node factor, const NodeVector& v) {
    return {g.multiply(factor, v[0]), g.multiply(factor, v[1]), g.multiply(factor, v[2])};
}

NodeVector cross(Graph& g, const NodeVector& a, const NodeVector& b) {
    const auto component = [&](std::size_t i, std::size_t j) {
        return g.subtract(g.multiply(a[i], b[j]), g.multiply(a[j], b[i]));
    };
    return {component(1, 2), component(2, 0), component(0, 1)};
}

Node dot(Graph& g, const NodeVector& a, const NodeVector& b) {
    return sum(g, {g.multiply(a[0], b[0]), g.multiply(a[1], b[1]), g.multiply(a[2], b[2])});
}

NodeVector times(Graph& g, const NodeMatrix& m, const NodeVector& v) {
    return {dot(g, m[0], v), dot(g, m[1], v), dot(g, m[2], v)};
}

NodeVector transposedTimes(Graph& g, const NodeMatrix& m, const NodeVector& v) {
    const auto column = [&](std::size_t i) { return NodeVector{m[0][i], m[1][i], m[2][i]}; };
    return {dot(g, column(0), v), dot(g, column(1), v), dot(g, column(2), v)};
}

bool isZero(const Graph& g, const NodeVector& v) {
    return g.isConstant(v[0], 0) && g.isConstant(v[1], 0) && g.isConstant(v[2], 0);
}

NodeMatrix rotationMatrix(Graph& g, const NodeQuaternion& q) {
    const auto [w, x, y, z] = q;
    const Node one = g.constant(1);
    const Node s = g.divide(g.constant(2),
                            sum(g, {squared(g, w), squared(g, x), squared(g, y), squared(g, z)}));
    const auto diagonal = [&](Node a, Node b) {
        return g.subtract(one, g.multiply(s, g.add(squared(g, a), squared(g, b))));
    };
    const auto product = [&](Node a, Node b) { return g.multiply(a, b); };
    const auto plus = [&](Node a, Node b) { return g.multiply(s, g.add(a, b)); };
    const auto minus = [&](Node a, Node b) { return g.multiply(s, g.subtract(a, b)); };
    return {NodeVector{diagonal(y, z), minus(product(x, y), product(w, z)),
                       plus(product(x, z), product(w, y))},
            NodeVector{plus(product(x, y), product(w, z)), diagonal(x, z),
                       minus(product(y, z), product(w, x))},
            NodeVector{minus(product(x, z), product(w, y)), plus(product(y, z), product(w, x)),
                       diagonal(x, y)}};
}

NodeQuaternion attitudeRate(Graph& g, const NodeQuaternion& q, const NodeVector& w,
                            bool isInWorldAxes) {
    const NodeVector axis{q[1], q[2], q[3]};
    const NodeVector turn = isInWorldAxes ? cross(g, w, axis) : cross(g, axis, w);
    const Node half = g.constant(0.5);
    const auto component = [&](std::size_t i) {
        return g.multiply(half, g.add(g.multiply(q[0], w[i]), turn[i]));
    };
    return {g.multiply(g.constant(-0.5), dot(g, axis, w)), component(0), component(1),
            component(2)};
}

NodeQuaternion attitudeOf(Graph& g, const NodeVector& v) {
    static constexpr double series[] = {1 / 2., -1 / 48., 1 / 3840., -1 / 645120., 1 / 185794560.};
    const Node square = dot(g, v, v);
    const Node angle = g.apply(Op::sqrt, square), half = g.divide(angle, g.constant(2));
    const Node factor =
        nearZeroOr(g, square, series, g.divide(g.apply(Op::sin, half), angle)); // sin(a/2)/a
    const NodeVector axis = scaled(g, factor, v);
    return {g.apply(Op::cos, half), axis[0], axis[1], axis[2]};
}

NodeVector spinOf(Graph& g, const NodeVector& v, const NodeVector& u, bool inWorldAxes) {
    static constexpr double alongSeries[] = {1, -1 / 6., 1 / 120., -1 / 5040., 1 / 362880.};
    static constexpr double acrossSeries[] = {1 / 2., -1 / 24., 1 / 720., -1 / 40320.,
                                              1 / 3628800.};
    static constexpr double backSeries[] = {1 / 6., -1 / 120., 1 / 5040., -1 / 362880.,
                                            1 / 39916800.};
    const Node square = dot(g, v, v), angle = g.apply(Op::sqrt, square);
    const Node sine = g.apply(Op::sin, angle);
    const Node halfSine = g.apply(Op::sin, g.divide(angle, g.constant(2)));
    const Node along = nearZeroOr(g, square, alongSeries, g.divide(sine, angle));
    const Node across = nearZeroOr( // (1 - cos a)/a² without cancellation
        g, square, acrossSeries, g.divide(g.multiply(g.constant(2), squared(g, halfSine)), square));
    const Node back = nearZeroOr(g, square, backSeries,
                                 g.divide(g.subtract(angle, sine), g.multiply(angle, square)));
    const NodeVector sideways = inWorldAxes ? cross(g, v, u) : cross(g, u, v);
    return add(g, add(g, scaled(g, along, u), scaled(g, across, sideways)),
               scaled(g, g.multiply(back, dot(g, v, u)), v));
}

} // namespace physics
