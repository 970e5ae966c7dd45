#include "complementarity/interior.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

// Points of a cone  head >= |tail|,  of rays where there is no tail, and their algebra.
double depthOf(const Vector& point) { // squared
    return point[0] * point[0] - point.tail(point.size() - 1).squaredNorm();
}
Vector product(const Vector& one, const Vector& other) {
    Vector p = one[0] * other + other[0] * one;
    p[0] = one.dot(other);
    return p;
}
Vector quotient(const Vector& above, const Vector& below) {
    Vector q(below.size());
    const Index n = below.size() - 1;
    q[0] = (below[0] * above[0] - below.tail(n).dot(above.tail(n))) / depthOf(below);
    q.tail(n) = (above.tail(n) - q[0] * below.tail(n)) / below[0];
    return q;
}
Vector mirrored(Vector point) {
    point.tail(point.size() - 1) *= -1;
    return point;
}
// How much of the way stays in the cone; unbounded: all ways as long.
double lengthInside(const Vector& point, const Vector& way) {
    const double a = depthOf(way), b = mirrored(point).dot(way), c = depthOf(point);
    double length = way[0] < 0 ? -point[0] / way[0] : unbounded;
    const double root = b * b - a * c;
    if (root < 0 || way.size() == 1)
        return length;
    const double sum = -(b + std::copysign(std::sqrt(root), b));
    for (const double zero : {a != 0 ? sum / a : -1, sum != 0 ? c / sum : -1})
        if (zero > 0)
            length = std::min(length, zero);
    return length;
}

// The room of a law's force, and the push off its bounds: (f - low, l) and (high - f, h) of an
// interval, (r, f) and (s, w) of a disc.
struct Cone {
    std::size_t law = 0;
    double side = 1; // of an interval: 1 at low, -1 at high
    Vector room = {}, push = {};
    // The scaling of Nesterov and Todd, and its inverse, which make one point of both.
    Matrix scaling = {}, inverse = {};
    Vector middle = {};

    void scale() {
        const double rooms = std::sqrt(depthOf(room)), pushes = std::sqrt(depthOf(push));
        const Vector at = room / rooms, from = push / pushes;
        const Vector between = (at + mirrored(from)) / std::sqrt(2 * (1 + at.dot(from)));
        Vector axis = between;
        axis[0] += 1;
        axis /= std::sqrt(2 * axis[0]);
        const double size = std::sqrt(rooms / pushes);
        scaling = size * reflection(axis);
        inverse = reflection(mirrored(axis)) / size;
        middle = scaling * push;
    }
    static Matrix reflection(const Vector& axis) {
        Matrix through = 2 * axis * axis.transpose();
        through.diagonal().array() += 1;
        through(0, 0) -= 2;
        return through;
    }
};

class Path {
public:
    Path(const Matrix& a, const Vector& b, const Laws& laws, bool isConvex = false)
        : a_(a), b_(b), laws_(laws), isConvex_(isConvex), forces_(Vector::Zero(b.size())) {
        const double stiff = std::max(a.diagonal().maxCoeff(), 1e-300);
        rate_ = std::max(b.cwiseAbs().maxCoeff(), 1e-300);
        force_ = rate_ / stiff;
        for (std::size_t k = 0; k < laws.size(); ++k)
            begin(k);
        for (Cone& cone : cones_) {
            cone.room = roomOf(cone);
            cone.push = Vector::Unit(cone.room.size(), 0) * rate_;
        }
    }

    Approach follow() {
        constexpr int most = 100;
        int steps = 0;
        for (double fraction = 1; steps < most; ++steps) {
            const double wrong = residual().cwiseAbs().maxCoeff(), gap = meanProduct() / size();
            // The smaller the gap, the clearer are states of laws at their limits, while it goes on
            // to fall by whole steps.
            constexpr double whole = 0.9;
            const bool isThere = gap <= 1e-11 && wrong <= 1e-8 * rate_;
            if (isThere && (fraction < whole || gap <= 1e-18))
                break;
            fraction = step();
            if (!(fraction > 1e-8))
                break;
        }
        return {forces_, states(), steps};
    }

private:
    [[nodiscard]] static bool isInterval(const Law& law) { return law.kind == Law::Kind::interval; }
    [[nodiscard]] const Law& lawOf(const Cone& cone) const { return laws_[cone.law]; }
    [[nodiscard]] bool hasRoom(std::size_t k) const {
        const Law& law = laws_[k];
        return isInterval(law) ? law.low < law.high
                               : law.radius > 0 || (law.normal >= 0 && law.coefficient > 0);
    }

    void begin(std::size_t k) {
        const Law& law = laws_[k];
        if (!isInterval(law)) {
            if (hasRoom(k))
                cones_.push_back({.law = k});
            return;
        }
        const bool hasLow = law.low > -unbounded, hasHigh = law.high < unbounded;
        double& f = forces_[law.first];
        f = hasLow && hasHigh ? (law.low + law.high) / 2
            : hasLow          ? std::max(law.low + force_, 0.0)
            : hasHigh         ? std::min(law.high - force_, 0.0)
                              : 0;
        if (!hasRoom(k))
            return;
        if (hasLow && f <= law.low)
            f = law.low + force_;
        if (hasLow)
            cones_.push_back({.law = k, .side = 1});
        if (hasHigh)
            cones_.push_back({.law = k, .side = -1});
    }

    [[nodiscard]] Vector roomOf(const Cone& cone) const {
        const Law& law = lawOf(cone);
        if (isInterval(law))
            return Vector::Constant(1, cone.side > 0 ? forces_[law.first] - law.low
                                                     : law.high - forces_[law.first]);
        Vector room(law.rows + 1);
        room << radiusOf(law, forces_), forces_.segment(law.first, law.rows);
        return room;
    }
    // How the room changes where the forces go this way.
    [[nodiscard]] Vector changeOf(const Cone& cone, const Vector& way) const {
        const Law& law = lawOf(cone);
        if (isInterval(law))
            return Vector::Constant(1, cone.side * way[law.first]);
        Vector change(law.rows + 1);
        change << (law.normal < 0 ? 0
                                  : law.coefficient * way.segment(law.normal, law.normals).sum()),
            way.segment(law.first, law.rows);
        return change;
    }
    // Adds the push to the rates of its law.
    void addPush(const Cone& cone, const Vector& push, Vector& rates) const {
        const Law& law = lawOf(cone);
        if (isInterval(law))
            rates[law.first] += cone.side * push[0];
        else
            rates.segment(law.first, law.rows) += push.tail(law.rows);
        if (pushesNormals(law))
            rates.segment(law.normal, law.normals).array() += law.coefficient * push[0];
    }
    [[nodiscard]] bool pushesNormals(const Law& law) const {
        return isConvex_ && !isInterval(law) && law.normal >= 0;
    }

    // Of rooms and pushes.
    [[nodiscard]] double meanProduct() const {
        double sum = 0;
        for (const Cone& cone : cones_)
            sum += cone.room.dot(cone.push);
        return cones_.empty() ? 0 : sum / static_cast<double>(cones_.size());
    }
    // Of forces times rates.
    [[nodiscard]] double size() const {
        return std::max(force_, forces_.cwiseAbs().maxCoeff()) * rate_;
    }
    // Rates less the pushes that they are in the end.
    [[nodiscard]] Vector residual() const {
        Vector wrong = a_ * forces_ + b_, pushes = Vector::Zero(b_.size());
        for (const Cone& cone : cones_)
            addPush(cone, cone.push, pushes);
        wrong -= pushes;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                wrong.segment(laws_[k].first, laws_[k].rows).setZero();
        return wrong;
    }

    // The linear equations of one step.
    [[nodiscard]] Eigen::PartialPivLU<Matrix> equations() const {
        // Redundant laws share their forces in many ways: a pull to where the forces are leaves one
        // of them, and hardly shortens the steps of forces that the laws tell (the proximal point
        // method).
        constexpr double pull = 1e-5;
        Matrix change = a_;
        change.diagonal() += pull * a_.diagonal();
        for (const Cone& cone : cones_) {
            const Law& law = lawOf(cone);
            const Matrix stiffness = cone.inverse * cone.inverse;
            if (isInterval(law)) {
                change(law.first, law.first) += stiffness(0, 0);
                continue;
            }
            change.block(law.first, law.first, law.rows, law.rows) +=
                stiffness.bottomRightCorner(law.rows, law.rows);
            if (law.normal >= 0)
                change.block(law.first, law.normal, law.rows, law.normals).colwise() +=
                    law.coefficient * stiffness.bottomLeftCorner(law.rows, 1).col(0);
            if (!pushesNormals(law))
                continue;
            change.block(law.normal, law.first, law.normals, law.rows).rowwise() +=
                law.coefficient * stiffness.topRightCorner(1, law.rows).row(0);
            change.block(law.normal, law.normal, law.normals, law.normals).array() +=
                law.coefficient * law.coefficient * stiffness(0, 0);
        }
        for (std::size_t k = 0; k < laws_.size(); ++k)
            for (Index i = laws_[k].first; !hasRoom(k) && i < laws_[k].first + laws_[k].rows; ++i) {
                change.row(i).setZero();
                change(i, i) = 1;
            }
        return change.partialPivLu();
    }

    struct Way {
        Vector forces;
        std::vector<Vector> rooms, pushes;
        double length = unbounded; // inside
    };
    // The way on which the products of rooms and pushes change so, to first order.
    template <class Wanted>
    [[nodiscard]] Way wayTo(const Eigen::PartialPivLU<Matrix>& equations, const Vector& wrong,
                            const Wanted& wanted) const {
        std::vector<Vector> halves;
        Vector right = -wrong;
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            halves.push_back(quotient(wanted(c), cones_[c].middle));
            addPush(cones_[c], cones_[c].inverse * halves.back(), right);
        }
        Way way{equations.solve(right), {}, {}};
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            const Cone& cone = cones_[c];
            way.rooms.push_back(changeOf(cone, way.forces));
            way.pushes.push_back(cone.inverse * (halves[c] - cone.inverse * way.rooms.back()));
            way.length = std::min({way.length, lengthInside(cone.room, way.rooms.back()),
                                   lengthInside(cone.push, way.pushes.back())});
        }
        return way;
    }

    // Towards the end of the path, with what its curvature brings (Mehrotra, SIAM Journal on
    // Optimization 2, 1992). The part of it that stays inside; 0: none.
    double step() {
        constexpr double inside = 0.99;
        for (Cone& cone : cones_)
            cone.scale();
        const Vector wrong = residual();
        const auto linear = equations();
        const auto square = [&](std::size_t c) {
            return product(cones_[c].middle, cones_[c].middle);
        };
        const Way ahead = wayTo(linear, wrong, [&](std::size_t c) { return Vector(-square(c)); });
        if (!ahead.forces.allFinite())
            return 0;
        const double left = 1 - std::min(1.0, ahead.length);
        const double next = std::max(left * left * left, 1e-6) * meanProduct();
        const Way way = wayTo(linear, wrong, [&](std::size_t c) {
            const Cone& cone = cones_[c];
            Vector wanted =
                -square(c) - product(cone.inverse * ahead.rooms[c], cone.scaling * ahead.pushes[c]);
            wanted[0] += next;
            return wanted;
        });
        const double fraction = std::min(1.0, inside * way.length);
        if (!way.forces.allFinite() || !std::isfinite(fraction))
            return 0;
        forces_ += fraction * way.forces;
        bool isInside = true; // but for rounding
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            cones_[c].room = roomOf(cones_[c]);
            cones_[c].push += fraction * way.pushes[c];
            isInside = isInside && depthOf(cones_[c].room) > 0 && depthOf(cones_[c].push) > 0;
        }
        return isInside ? fraction : 0;
    }

    // A law is at its bound if the push is larger than the room, both in the row's units.
    [[nodiscard]] States states() const {
        States states(laws_.size(), State::inside);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                states[k] = isInterval(laws_[k]) ? State::low : State::edge;
        for (const Cone& cone : cones_) {
            const Law& law = lawOf(cone);
            const double stiff = std::max(a_(law.first, law.first), 1e-300);
            const double room = cone.room[0] - cone.room.tail(cone.room.size() - 1).norm();
            if (cone.push[0] > stiff * room)
                states[cone.law] = !isInterval(law) ? State::edge
                                   : cone.side > 0  ? State::low
                                                    : State::high;
        }
        return states;
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    bool isConvex_;
    Vector forces_;
    std::vector<Cone> cones_;
    double rate_ = 0, force_ = 0; // sizes
};

} // namespace

Approach approach(const Matrix& a, const Vector& b, const Laws& laws) {
    return Path(a, b, laws).follow();
}

Approach approachConvex(const Matrix& a, const Vector& b, const Laws& laws, const Vector& slips) {
    Vector widened = b;
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (laws[k].kind != Law::Kind::interval && laws[k].normal >= 0)
            widened.segment(laws[k].normal, laws[k].normals).array() +=
                laws[k].coefficient * slips[static_cast<Index>(k)];
    return Path(a, widened, laws, true).follow();
}

} // namespace complementarity
