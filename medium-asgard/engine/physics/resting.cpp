#include "physics/resting.h"

#include "expression/tape.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using expression::Phase;

const Phase& phaseAt(const std::vector<Phase>& phases, double time) {
    const auto after = std::ranges::upper_bound(phases, time, {}, &Phase::from);
    return after == phases.begin() ? phases.front() : *(after - 1);
}

// Along the axes of the body's spin.
Matrix inverseInertia(const BodyMotion& body, const Held& held) {
    return held.attitude ? Matrix(Matrix::Zero()) : Matrix(body.mass.inertia.inverse());
}

Vector withoutHeld(Vector v, const Held& held) {
    for (std::size_t i = 0; i < 3; ++i)
        if (held.position[i])
            v[static_cast<Eigen::Index>(i)] = 0;
    return v;
}

Eigen::MatrixXd mobilityOf(const BodyMotion& body, const Held& held, std::span<const GapRow> rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    const Matrix inverse = inverseInertia(body, held);
    Eigen::MatrixXd a(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const GapRow& p = rows[static_cast<std::size_t>(i)];
            const GapRow& q = rows[static_cast<std::size_t>(j)];
            a(i, j) = withoutHeld(p.linear, held).dot(q.linear) / body.mass.mass +
                      p.angular.dot(inverse * q.angular);
        }
    return a;
}

Node lengthOf(Graph& g, const NodeVector& v) { return g.apply(Op::sqrt, dot(g, v, v)); }

} // namespace

Held unyieldingAt(const EquationsOfMotion& equations, std::size_t body, double time) {
    constexpr double rounding = 1e-12; // of the radius, in the centre of mass
    const BodyMotion& motion = equations.bodies[body];
    Held held = motion.heldAt(time);
    if (motion.mass.centroid.norm() <= rounding * motion.mass.radius)
        return held;
    for (std::size_t i = 0; i < 3; ++i) { // else its velocity is held, that of the centre
        const expression::Unknown& place = equations.set.unknowns[motion.unknown(x) + i];
        held.attitude =
            held.attitude || (held.position[i] && phaseAt(place.phases, time).given.has_value());
    }
    return held;
}

std::vector<std::size_t> independentOf(const BodyMotion& body, const Held& held,
                                       std::span<const GapRow> rows) {
    // Gram and Schmidt by way of the mobility matrix: a row counts when enough of it is left.
    constexpr double left = 1e-8;
    const Eigen::MatrixXd a = mobilityOf(body, held, rows);
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        double rest = a(i, i);
        if (!chosen.empty()) {
            const Eigen::VectorXd column = a(chosen, i);
            const Eigen::VectorXd part = a(chosen, chosen).ldlt().solve(column);
            rest -= column.dot(part);
        }
        if (rest > left * a(i, i) && a(i, i) > 0)
            chosen.push_back(i);
    }
    return {chosen.begin(), chosen.end()};
}

VelocityChange changeToRates(const BodyMotion& body, const Held& held,
                             std::span<const GapRow> rows) {
    VelocityChange change;
    if (rows.empty())
        return change;
    Eigen::VectorXd rates(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        rates[static_cast<Eigen::Index>(i)] = -rows[i].rate;
    const Eigen::VectorXd impulses = mobilityOf(body, held, rows).ldlt().solve(rates);
    const Matrix inverse = inverseInertia(body, held);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double impulse = impulses[static_cast<Eigen::Index>(i)];
        change.linear += withoutHeld(rows[i].linear, held) * (impulse / body.mass.mass);
        change.angular += inverse * rows[i].angular * impulse;
    }
    return change;
}

GapExpressions::GapExpressions(expression::EquationSet& set, const EquationsOfMotion& free,
                               std::size_t body, double time)
    : set_(set), g_(set.graph), free_(free), body_(body), time_(time),
      held_(unyieldingAt(free, body, time)) {
    for (std::size_t i = 0; i < set.unknowns.size(); ++i)
        unknownOf_.emplace(set.unknowns[i].symbol.index, i);
}

Node GapExpressions::freeRate(std::size_t unknown) const {
    return phaseAt(free_.set.unknowns[unknown].phases, time_).derivative;
}

Node GapExpressions::rateOf(Node value) {
    const std::size_t first = free_.bodies[body_].firstUnknown;
    Node rate = differentiate(g_, value, set_.time);
    for (const Node symbol : symbolsOf(g_, std::span(&value, 1))) {
        const auto unknown = unknownOf_.find(symbol.index);
        if (unknown == unknownOf_.end())
            continue;
        const std::size_t own = unknown->second - first;
        const bool isOwnVelocity = unknown->second >= first && own < bodyUnknowns &&
                                   ((own >= dx && own < qw && !held_.position[own - dx]) ||
                                    (own >= w1 && !held_.attitude));
        if (!isOwnVelocity)
            rate = g_.add(rate,
                          g_.multiply(differentiate(g_, value, symbol), freeRate(unknown->second)));
    }
    return rate;
}

Node GapExpressions::gapOf(const GapConstraint& c) {
    const BodySymbols& body = free_.bodies[body_].symbols;
    BodySymbols support = free_.bodies[c.support].symbols;
    if (!c.supportTurns)
        for (int i = 0; i < 3; ++i)
            support.rotation[static_cast<std::size_t>(i)] = constant(g_, c.supportRotation.row(i));
    using Kind = GapConstraint::Kind;
    const NodeVector apart =
        subtract(g_, add(g_, body.position, body.toWorld(g_, constant(g_, c.bodyPoint))),
                 add(g_, support.position, support.toWorld(g_, constant(g_, c.supportPoint))));
    const Node radius = g_.constant(c.radius);
    switch (c.kind) {
    case Kind::onSupportPlane:
        return g_.subtract(dot(g_, support.toWorld(g_, constant(g_, c.normal)), apart), radius);
    case Kind::onBodyPlane:
        return g_.subtract(dot(g_, body.toWorld(g_, constant(g_, c.normal)), apart), radius);
    case Kind::roundOnPoint:
        return g_.subtract(lengthOf(g_, apart), radius);
    case Kind::roundOnLine: {
        const NodeVector edge = support.toWorld(g_, constant(g_, c.supportEdge));
        const NodeVector along = scaled(g_, dot(g_, edge, apart), edge);
        return g_.subtract(lengthOf(g_, subtract(g_, apart, along)), radius);
    }
    case Kind::edgeOnEdge:
    case Kind::tilt:
        break;
    }
    const NodeVector a = body.toWorld(g_, constant(g_, c.bodyEdge));
    const NodeVector b = support.toWorld(g_, constant(g_, c.supportEdge));
    return dot(g_, c.flipped ? cross(g_, b, a) : cross(g_, a, b), apart);
}

// J_w is an axis of the body: as it stands when the spin is along the body's axes too.
GapExpressions::Row GapExpressions::tiltRow(const Vector& axis) {
    const BodySymbols& s = free_.bodies[body_].symbols;
    Row row;
    row.linear = constant(g_, Vector::Zero());
    row.angular = s.isSpinInWorldAxes ? s.toWorld(g_, constant(g_, axis)) : constant(g_, axis);
    row.rate = dot(g_, row.angular, s.spin);
    // A world vector that turns with the body: its rate is w x axis, which w has no part of.
    row.rest = g_.constant(0);
    return row;
}

GapExpressions::Row GapExpressions::rowOf(const GapConstraint& constraint) {
    if (constraint.kind == GapConstraint::Kind::tilt)
        return tiltRow(constraint.bodyEdge);
    const BodySymbols& s = free_.bodies[body_].symbols;
    Row row;
    row.rate = rateOf(gapOf(constraint));
    for (std::size_t i = 0; i < 3; ++i) {
        row.linear[i] =
            held_.position[i] ? g_.constant(0) : differentiate(g_, row.rate, s.velocity[i]);
        row.angular[i] = held_.attitude ? g_.constant(0) : differentiate(g_, row.rate, s.spin[i]);
    }
    row.rest = rateOf(row.rate);
    return row;
}

std::vector<GapRow> GapExpressions::rowsAt(std::span<const GapConstraint> constraints,
                                           std::span<const double> state) {
    std::vector<Node> inputs, outputs;
    for (const expression::Unknown& unknown : set_.unknowns)
        inputs.push_back(unknown.symbol);
    inputs.push_back(set_.time);
    std::vector<double> values(state.begin(), state.end());
    values.push_back(time_);
    for (const GapConstraint& constraint : constraints) {
        const Row row = rowOf(constraint);
        outputs.insert(outputs.end(), row.linear.begin(), row.linear.end());
        outputs.insert(outputs.end(), row.angular.begin(), row.angular.end());
        outputs.push_back(row.rate);
    }
    std::vector<double> results(outputs.size());
    expression::Tape::Scratch scratch;
    expression::Tape(g_, inputs, outputs).evaluate(values, results, scratch);
    std::vector<GapRow> rows;
    for (std::size_t i = 0; i < results.size(); i += 7)
        rows.push_back({.linear = {results[i], results[i + 1], results[i + 2]},
                        .angular = {results[i + 3], results[i + 4], results[i + 5]},
                        .rate = results[i + 6]});
    return rows;
}

// I^-1 J_w.
NodeVector GapExpressions::loadOf(const NodeVector& angular) {
    const Matrix inverse = inverseInertia(free_.bodies[body_], held_);
    NodeMatrix rows;
    for (int i = 0; i < 3; ++i)
        rows[static_cast<std::size_t>(i)] = constant(g_, inverse.row(i));
    return times(g_, rows, angular);
}

ConstrainedRates GapExpressions::constrained(std::span<const GapConstraint> independent) {
    const BodyMotion& body = free_.bodies[body_];
    const Node inverseMass = g_.constant(1 / body.mass.mass);
    ConstrainedRates rates;
    for (std::size_t i = 0; i < 3; ++i) {
        rates.acceleration[i] = freeRate(body.unknown(dx) + i);
        rates.spinRate[i] = freeRate(body.unknown(w1) + i);
    }
    // J M^-1 J' = L D L', eliminated row by row; `right` becomes L^-1 of the right side.
    const std::size_t n = independent.size();
    std::vector<Row> rows;
    std::vector<NodeVector> pushes, turns; // M^-1 J'
    std::vector<std::vector<Node>> a(n, std::vector<Node>(n));
    std::vector<Node> right(n);
    for (const GapConstraint& constraint : independent)
        rows.push_back(rowOf(constraint));
    for (const Row& row : rows) {
        pushes.push_back(scaled(g_, inverseMass, row.linear));
        turns.push_back(loadOf(row.angular));
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Node free = g_.add(dot(g_, rows[i].linear, rates.acceleration),
                                 dot(g_, rows[i].angular, rates.spinRate));
        right[i] = g_.negate(g_.add(free, rows[i].rest));
        for (std::size_t j = 0; j < n; ++j)
            a[i][j] =
                g_.add(dot(g_, rows[i].linear, pushes[j]), dot(g_, rows[i].angular, turns[j]));
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i) {
            const Node factor = g_.divide(a[i][k], a[k][k]);
            for (std::size_t j = k; j < n; ++j)
                a[i][j] = g_.subtract(a[i][j], g_.multiply(factor, a[k][j]));
            right[i] = g_.subtract(right[i], g_.multiply(factor, right[k]));
        }
    std::vector<Node> forces(n);
    for (std::size_t i = n; i-- > 0;) {
        Node sum = right[i];
        for (std::size_t j = i + 1; j < n; ++j)
            sum = g_.subtract(sum, g_.multiply(a[i][j], forces[j]));
        forces[i] = g_.divide(sum, a[i][i]);
        rates.acceleration = add(g_, rates.acceleration, scaled(g_, forces[i], pushes[i]));
        rates.spinRate = add(g_, rates.spinRate, scaled(g_, forces[i], turns[i]));
    }
    return rates;
}

} // namespace physics
