#include "complementarity/together.h"

#include "complementarity/at_centre.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

// Of a law: a number, or the radius of a disc and its two or three forces.
using Point = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

// How far it is inside its cone  head >= |tail|, squared.
double depthIn(const Point& point) {
    const double length = point.tail(point.size() - 1).norm();
    return (point[0] - length) * (point[0] + length);
}
Point joined(const Point& one, const Point& other) {
    Point p = one[0] * other + other[0] * one;
    p[0] = one.dot(other);
    return p;
}
// How much of the way stays in the cone; unbounded: all ways as long.
double lengthWithin(const Point& point, const Point& way) {
    const Index n = point.size() - 1;
    double length = way[0] < 0 ? -point[0] / way[0] : unbounded;
    if (n == 0)
        return length;
    const double a = way[0] * way[0] - way.tail(n).squaredNorm(), c = depthIn(point);
    const double b = point[0] * way[0] - point.tail(n).dot(way.tail(n));
    const double root = b * b - a * c;
    if (root < 0)
        return length;
    const double sum = -(b + std::copysign(std::sqrt(root), b));
    for (const double zero : {a != 0 ? sum / a : -1, sum != 0 ? c / sum : -1})
        if (zero > 0)
            length = std::min(length, zero);
    return length;
}

// The room of a law's force, and the push off its bounds: (f - low, l) and (high - f, h) of an
// interval, (r, f) and (s, w) of a disc, both at its centre.
struct Place {
    std::size_t law = 0;
    double side = 1; // of an interval: 1 at low, -1 at high
    Index slip = -1; // of a disc: the place of s among the unknowns
    Vector centre = {};
    Point room = {}, push = {};
};

class Together {
public:
    Together(const Matrix& a, const Vector& b, const Laws& laws)
        : a_(a), b_(b), laws_(laws), forces_(Vector::Zero(b.size())),
          rates_(Vector::Zero(b.size())), unknowns_(b.size()) {
        stiff_ = std::max(a.diagonal().maxCoeff(), 1e-300);
        rate_ = std::max(b.cwiseAbs().maxCoeff(), 1e-300);
        force_ = rate_ / stiff_;
        for (std::size_t k = 0; k < laws.size(); ++k)
            begin(k);
        followSlips();
        for (Place& cone : cones_) {
            cone.centre = centreOf(lawOf(cone), forces_);
            cone.room = roomOf(cone);
            cone.push = Point::Unit(cone.room.size(), 0) * rate_;
        }
    }

    Approach follow() {
        constexpr int most = 100;
        constexpr double end = 1e-22, small = 1e-11, none = 1e-13, half = 0.5, tiny = 1e-8;
        int steps = 0;
        for (double lastWrong = unbounded, lastGap = unbounded; steps < most; ++steps) {
            const double wrong = residual().cwiseAbs().maxCoeff(), gap = meanProduct() / size();
            const bool isRight = wrong <= none * rate_ || wrong > half * lastWrong;
            if (isRight && (gap <= end || (gap < small && gap > half * lastGap)))
                break;
            if (!(step() > tiny))
                break;
            lastWrong = wrong;
            lastGap = gap;
        }
        return {forces_, states(), steps};
    }

private:
    // The rooms and pushes of discs are differences of numbers, which err by so much of these.
    static constexpr double rounding = 1e-15;

    [[nodiscard]] static bool isInterval(const Law& law) { return law.kind == Law::Kind::interval; }
    [[nodiscard]] const Law& lawOf(const Place& cone) const { return laws_[cone.law]; }
    [[nodiscard]] bool hasRoom(std::size_t k) const {
        const Law& law = laws_[k];
        if (law.kind == Law::Kind::slip)
            return false;
        return isInterval(law) ? law.low < law.high
                               : law.radius > 0 || (law.normal >= 0 && law.coefficient > 0);
    }

    void begin(std::size_t k) {
        const Law& law = laws_[k];
        if (!isInterval(law)) {
            if (hasRoom(k))
                cones_.push_back({.law = k, .slip = unknowns_++});
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
    void followSlips() {
        for (const Law& law : laws_)
            if (law.kind == Law::Kind::slip)
                forces_.segment(law.first, law.rows) = forceOf(law, forces_);
    }

    [[nodiscard]] Point roomOf(const Place& cone) const {
        const Law& law = lawOf(cone);
        if (isInterval(law))
            return Point::Constant(1, cone.side > 0 ? forces_[law.first] - law.low
                                                    : law.high - forces_[law.first]);
        Point room(law.rows + 1);
        room << radiusOf(law, forces_), forcesAt(cone.centre, forces_.segment(law.first, law.rows));
        return room;
    }
    // Adds the push to the rates of its law.
    void addPush(const Place& cone, Vector& rates) const {
        const Law& law = lawOf(cone);
        if (isInterval(law)) {
            rates[law.first] += cone.side * cone.push[0];
            return;
        }
        rates.segment(law.first, law.rows) += rates_.segment(law.first, law.rows);
    }
    // Of room and push, what is more than rounding.
    [[nodiscard]] double productOf(const Place& cone) const {
        const double sum = cone.room.dot(cone.push);
        return std::max(0.0, sum - 2 * leastOf(cone));
    }
    [[nodiscard]] double leastOf(const Place& cone) const {
        const Law& law = lawOf(cone);
        const double size = !isInterval(law) ? cone.room[0]
                            : cone.side > 0  ? std::abs(law.low)
                                             : std::abs(law.high);
        return rounding * size * cone.push[0];
    }
    [[nodiscard]] double meanProduct() const {
        double sum = 0;
        for (const Place& cone : cones_)
            sum += productOf(cone);
        return cones_.empty() ? 0 : sum / static_cast<double>(cones_.size());
    }
    // Of forces times rates.
    [[nodiscard]] double size() const {
        return std::max(force_, forces_.cwiseAbs().maxCoeff()) * rate_;
    }
    // Rates less the pushes that they are in the end.
    [[nodiscard]] Vector residual() const {
        Vector wrong = a_ * forces_ + b_, pushes = Vector::Zero(b_.size());
        for (const Place& cone : cones_)
            addPush(cone, pushes);
        wrong -= pushes;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                wrong.segment(laws_[k].first, laws_[k].rows).setZero();
        return wrong;
    }

    // Of one step: the changes of all forces, then of s of each disc in units of stiff_.
    struct Equations {
        Vector scales; // that make the largest number of each row 1
        std::vector<AtCentre> centres;
        Eigen::PartialPivLU<Matrix> linear;
    };
    [[nodiscard]] Equations equations() const {
        // Redundant laws share their forces in many ways: a pull to where the forces are leaves one
        // of them, and hardly shortens the steps of forces that the laws tell (the proximal point
        // method).
        constexpr double pull = 1e-5;
        Equations made;
        const Index n = b_.size();
        Matrix change = Matrix::Zero(unknowns_, unknowns_);
        change.topLeftCorner(n, n) = a_;
        change.topLeftCorner(n, n).diagonal() += pull * a_.diagonal();
        for (const Place& cone : cones_)
            if (const Law& law = lawOf(cone); !isInterval(law)) {
                made.centres.emplace_back(law, forces_);
                putAt(made.centres.back(), law, change);
            }
        auto at = made.centres.begin();
        for (const Place& cone : cones_)
            if (const Law& law = lawOf(cone); isInterval(law))
                change(law.first, law.first) += cone.push[0] / cone.room[0];
            else
                addDisc(cone, *at++, change);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                keep(laws_[k], change);
        made.scales = change.cwiseAbs().rowwise().maxCoeff().cwiseMax(1e-300).cwiseInverse();
        made.linear.compute(made.scales.asDiagonal() * change);
        return made;
    }
    // The rows of a law without room: its forces stay, or follow their normal forces.
    void keep(const Law& law, Matrix& change) const {
        for (Index i = law.first; i < law.first + law.rows; ++i) {
            change.row(i).setZero();
            change(i, i) = 1;
        }
        if (law.kind == Law::Kind::slip && law.normal >= 0)
            change.block(law.first, law.normal, law.rows, law.normals) = -changesOf(law, forces_);
    }
    // The forces of its rows become those at the centre, which moves with its normal forces.
    static void putAt(const AtCentre& at, const Law& disc, Matrix& change) {
        const Index last = disc.first + disc.rows - 1;
        for (Index i = 0; i + 1 < disc.rows; ++i)
            change.col(disc.first + i) += at.centre[i] * change.col(last);
        const Vector turned = at.moves.transpose() * at.force.head(disc.rows - 1);
        for (Index i = 0; i < turned.size(); ++i)
            change.col(disc.normal + i) += turned[i] * change.col(last);
    }
    // For changes dr, df of the room and ds, dw of the push
    //     r dw + dr w + s df + ds f = wanted
    // where dw is that of the rates; without it in the row of the slip.
    void addDisc(const Place& cone, const AtCentre& at, Matrix& change) const {
        const Law& law = lawOf(cone);
        const Index n = law.rows, first = law.first;
        const double r = cone.room[0], s = cone.push[0];
        const Vector f = cone.room.tail(n), w = cone.push.tail(n);
        for (Index i = 0; i + 1 < n; ++i)
            change.row(first + i) += at.centre[i] * change.row(first + n - 1);
        change.middleRows(first, n) *= r;
        change.block(first, first, n, n).diagonal().array() += s;
        change.col(cone.slip).segment(first, n) = stiff_ * f;
        change.row(cone.slip).segment(first, n) = w - s / r * f;
        change(cone.slip, cone.slip) = stiff_ * depthIn(cone.room) / r;
        for (Index i = 0; law.normal >= 0 && i < law.normals; ++i) {
            auto column = change.col(law.normal + i);
            column.segment(first, n) += law.coefficient * w;
            column.segment(first, n - 1) += r * w[n - 1] * at.moves.col(i);
            column[cone.slip] += law.coefficient * (s - w.dot(f) / r);
        }
    }

    struct Way {
        Vector forces;
        std::vector<Point> rooms, pushes;
        double length = unbounded; // inside
    };
    // The way on which the products of rooms and pushes change so, to first order.
    [[nodiscard]] Way wayTo(const Equations& equations, const Vector& wrong,
                            const std::vector<Point>& wanted) const {
        Vector right = Vector::Zero(unknowns_);
        right.head(b_.size()) = -wrong;
        auto at = equations.centres.begin();
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            const Place& cone = cones_[c];
            const Law& law = lawOf(cone);
            if (isInterval(law)) {
                right[law.first] += cone.side * wanted[c][0] / cone.room[0];
                continue;
            }
            const Vector f = cone.room.tail(law.rows), tail = wanted[c].tail(law.rows);
            right.segment(law.first, law.rows) =
                tail - cone.room[0] * ratesAt((at++)->centre, wrong.segment(law.first, law.rows));
            right[cone.slip] = wanted[c][0] - f.dot(tail) / cone.room[0];
        }
        const Vector all = equations.linear.solve(equations.scales.cwiseProduct(right));
        Way way{all.head(b_.size()), {}, {}};
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            const Place& cone = cones_[c];
            const Law& law = lawOf(cone);
            const Point room = isInterval(law)
                                   ? Point(Point::Constant(1, cone.side * all[law.first]))
                                   : changeOf(law, way.forces);
            Point push = wanted[c];
            if (isInterval(law)) {
                push[0] = (wanted[c][0] - cone.push[0] * room[0]) / cone.room[0];
            } else {
                const Index n = law.rows;
                push[0] = stiff_ * all[cone.slip];
                push.tail(n) -= room[0] * cone.push.tail(n) + cone.push[0] * room.tail(n) +
                                push[0] * cone.room.tail(n);
                push.tail(n) /= cone.room[0];
            }
            way.length = std::min(
                {way.length, lengthWithin(cone.room, room), lengthWithin(cone.push, push)});
            way.rooms.push_back(room);
            way.pushes.push_back(push);
        }
        return way;
    }
    // How the room changes where the forces go this way.
    [[nodiscard]] static Point changeOf(const Law& disc, const Vector& way) {
        Point change(disc.rows + 1);
        const bool hasNormals = disc.normal >= 0;
        change << (hasNormals ? disc.coefficient * way.segment(disc.normal, disc.normals).sum()
                              : 0),
            way.segment(disc.first, disc.rows);
        return change;
    }

    // Towards the end of the path, with what its curvature brings (Mehrotra, SIAM Journal on
    // Optimization 2, 1992). The part of it that stays inside; 0: none.
    double step() {
        constexpr double inside = 0.99;
        const Vector wrong = residual();
        const Equations linear = equations();
        std::vector<Point> wanted;
        for (const Place& cone : cones_)
            wanted.push_back(-joined(cone.room, cone.push));
        const Way ahead = wayTo(linear, wrong, wanted);
        if (!ahead.forces.allFinite())
            return 0;
        const double left = 1 - std::min(1.0, ahead.length);
        const double next = std::max(left * left * left, 1e-6) * meanProduct();
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            wanted[c] -= joined(ahead.rooms[c], ahead.pushes[c]);
            wanted[c][0] += std::max(next, leastOf(cones_[c]));
        }
        const Way way = wayTo(linear, wrong, wanted);
        const double fraction = std::min(1.0, inside * way.length);
        if (!way.forces.allFinite() || !std::isfinite(fraction))
            return 0;
        return go(linear.centres, way, fraction) ? fraction : 0;
    }
    // That part of the way. Where centres move, the rooms and the changes of rates leave no
    // straight line, and s takes up what these do at the centre: so its errors are small where a
    // disc is.
    bool go(const std::vector<AtCentre>& centres, const Way& way, double fraction) {
        Vector forces = forces_ + fraction * way.forces;
        for (std::size_t c = 0; c < cones_.size(); ++c)
            if (const Law& law = lawOf(cones_[c]); !isInterval(law)) {
                Place& cone = cones_[c];
                const Vector f = cone.room.tail(law.rows) + fraction * way.rooms[c].tail(law.rows);
                cone.centre = centreOf(law, forces);
                forces.segment(law.first, law.rows) = forcesFrom(cone.centre, f);
            }
        std::swap(forces_, forces);
        followSlips();
        bool isInside = true; // but for rounding
        auto at = centres.begin();
        for (std::size_t c = 0; c < cones_.size(); ++c) {
            Place& cone = cones_[c];
            if (const Law& law = lawOf(cone); isInterval(law))
                cone.push += fraction * way.pushes[c];
            else
                push(cone, law, *at++, fraction * way.pushes[c], forces_ - forces);
            cone.room = roomOf(cone);
            isInside = isInside && isWithin(cone.room) && isWithin(cone.push);
        }
        return isInside;
    }
    // Of a disc. The rates of its rows follow from what they are at the old centre.
    void push(Place& cone, const Law& law, const AtCentre& at, const Point& change,
              const Vector& moved) {
        const Index n = law.rows;
        Vector rates = change.tail(n);
        if (law.levers.size() > 0)
            rates.head(n - 1) -= cone.push[n] * at.moves * moved.segment(law.normal, law.normals);
        rates_.segment(law.first, n) += ratesAt(-at.centre, rates);
        cone.push += change;
        if (law.levers.size() == 0)
            return;
        const double depth = cone.push[0] - cone.push.tail(n).norm();
        cone.push.tail(n) = ratesAt(cone.centre, rates_.segment(law.first, n));
        cone.push[0] = cone.push.tail(n).norm() + depth;
    }
    [[nodiscard]] static bool isWithin(const Point& point) {
        return point[0] > 0 && depthIn(point) > 0;
    }

    // A law is at its bound if the push is larger than the room, both in the row's units.
    [[nodiscard]] States states() const {
        States states(laws_.size(), State::inside);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                states[k] = isInterval(laws_[k]) ? State::low : State::edge;
        for (const Place& cone : cones_) {
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
    Vector forces_, rates_; // the latter of discs, as they are in the end
    std::vector<Place> cones_;
    Index unknowns_;
    double rate_ = 0, force_ = 0, stiff_ = 0; // sizes
};

} // namespace

Approach approachTogether(const Matrix& a, const Vector& b, const Laws& laws) {
    return Together(a, b, laws).follow();
}

Answer endOf(const Matrix& a, const Vector& b, const Laws& laws, const Approach& of) {
    Answer end{of.forces, {}, of.states};
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (laws[k].kind == Law::Kind::interval && end.states[k] != State::inside)
            end.forces[laws[k].first] = end.states[k] == State::low ? laws[k].low : laws[k].high;
    end.rates = a * end.forces + b;
    return end;
}

} // namespace complementarity
