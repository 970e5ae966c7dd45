#include "complementarity/interior.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

// One law: its room to the bounds, and the multipliers of these.
struct Barrier {
    double low = 0, high = 0; // multipliers of an interval
    double slip = 0;          // s of a disc
    Vector rate;              // w of a disc, which the equations give in the limit
};

class Path {
public:
    Path(const Matrix& a, const Vector& b, const Laws& laws)
        : a_(a), b_(b), laws_(laws), forces_(Vector::Zero(b.size())), barriers_(laws.size()) {
        const double stiff = std::max(a.diagonal().maxCoeff(), 1e-300);
        rate_ = std::max(b.cwiseAbs().maxCoeff(), 1e-300);
        force_ = rate_ / stiff;
        for (std::size_t k = 0; k < laws.size(); ++k)
            begin(k, force_);
    }

    Approach follow() {
        int steps = 0;
        const double first = complementarity(), firstWrong = residual().cwiseAbs().maxCoeff();
        for (constexpr int most = 100; steps < most; ++steps) {
            const double gap = complementarity(), wrong = residual().cwiseAbs().maxCoeff();
            if (gap <= 1e-11 * size_ && wrong <= 1e-8 * rate_)
                break;
            // The gap may not fall while the equations are still wrong.
            const bool isBehind = wrong > 1e-8 * rate_ && wrong * first > 10 * firstWrong * gap;
            if (!step(isBehind ? gap : target_ * gap))
                break;
        }
        return {forces_, states(), steps};
    }

private:
    [[nodiscard]] static bool isInterval(const Law& law) { return law.kind == Law::Kind::interval; }
    [[nodiscard]] bool hasRoom(std::size_t k) const {
        const Law& law = laws_[k];
        return isInterval(law) ? law.low < law.high
                               : law.radius > 0 || (law.normal >= 0 && law.coefficient > 0);
    }
    // The square of a disc's radius less that of its force.
    [[nodiscard]] double roomOf(const Law& disc, const Vector& forces) const {
        const double radius = radiusOf(disc, forces);
        return radius * radius - forces.segment(disc.first, disc.rows).squaredNorm();
    }
    [[nodiscard]] static double roomOf(const Barrier& disc) {
        return disc.slip * disc.slip - disc.rate.squaredNorm();
    }

    void begin(std::size_t k, double force) {
        const Law& law = laws_[k];
        Barrier& barrier = barriers_[k];
        if (!isInterval(law)) {
            barrier.slip = rate_;
            barrier.rate = Vector::Zero(law.rows);
            return;
        }
        const bool hasLow = law.low > -unbounded, hasHigh = law.high < unbounded;
        double& f = forces_[law.first];
        f = hasLow && hasHigh ? (law.low + law.high) / 2
            : hasLow          ? std::max(law.low + force, 0.0)
            : hasHigh         ? std::min(law.high - force, 0.0)
                              : 0;
        if (hasLow && f <= law.low && law.low < law.high)
            f = law.low + force;
        barrier.low = hasLow ? rate_ : 0;
        barrier.high = hasHigh ? rate_ : 0;
    }

    // The mean product of room and multiplier; size_ becomes that of forces times rates.
    double complementarity() {
        double sum = 0, most = force_;
        int count = 0;
        const auto add = [&](double product) {
            sum += product;
            ++count;
        };
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            most = std::max(most, forces_.segment(law.first, law.rows).norm());
            if (!hasRoom(k))
                continue;
            if (!isInterval(law)) {
                add(radiusOf(law, forces_) * barriers_[k].slip +
                    forces_.segment(law.first, law.rows).dot(barriers_[k].rate));
                continue;
            }
            if (law.low > -unbounded)
                add(barriers_[k].low * (forces_[law.first] - law.low));
            if (law.high < unbounded)
                add(barriers_[k].high * (law.high - forces_[law.first]));
        }
        size_ = most * rate_;
        return count > 0 ? sum / count : 0;
    }

    [[nodiscard]] Vector residual() const {
        Vector wrong = a_ * forces_ + b_;
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            if (!hasRoom(k))
                wrong.segment(law.first, law.rows).setZero();
            else if (isInterval(law))
                wrong[law.first] -= barriers_[k].low - barriers_[k].high;
            else
                wrong.segment(law.first, law.rows) -= barriers_[k].rate;
        }
        return wrong;
    }

    // The Newton step to the point of the path at t; as much of it as stays inside.
    bool step(double t) {
        Matrix change = a_;
        change.diagonal() += 1e-14 * a_.diagonal(); // redundant laws
        Vector right = -(a_ * forces_ + b_);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!hasRoom(k))
                addFixed(laws_[k], change, right);
            else if (isInterval(laws_[k]))
                addInterval(k, t, change, right);
            else
                addDisc(k, t, change, right);
        const Vector way = change.partialPivLu().solve(right);
        if (!way.allFinite())
            return false;
        const std::vector<Barrier> ways = waysOf(way, t);
        double fraction = 1;
        while (!isInside(way, ways, fraction))
            if ((fraction *= 0.8) < 1e-8)
                return false;
        forces_ += fraction * way;
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            barriers_[k].low += fraction * ways[k].low;
            barriers_[k].high += fraction * ways[k].high;
            barriers_[k].slip += fraction * ways[k].slip;
            if (laws_[k].kind == Law::Kind::disc && hasRoom(k))
                barriers_[k].rate += fraction * ways[k].rate;
        }
        target_ = fraction > 0.9 ? 0.05 : fraction > 0.5 ? 0.2 : 0.7;
        return true;
    }

    static void addFixed(const Law& law, Matrix& change, Vector& right) {
        for (Index i = law.first; i < law.first + law.rows; ++i) {
            change.row(i).setZero();
            change(i, i) = 1;
            right[i] = 0;
        }
    }

    void addInterval(std::size_t k, double t, Matrix& change, Vector& right) const {
        const Law& law = laws_[k];
        const Index i = law.first;
        if (law.low > -unbounded) {
            const double room = forces_[i] - law.low;
            change(i, i) += barriers_[k].low / room;
            right[i] += t / room;
        }
        if (law.high < unbounded) {
            const double room = law.high - forces_[i];
            change(i, i) += barriers_[k].high / room;
            right[i] -= t / room;
        }
    }

    // Maps the cone's point (r, f) to (slip, w), the scaling of Nesterov and Todd; symmetric and
    // positive definite. d(slip, w) = t (r, -f)/room - (slip, w) - scaling d(r, f).
    [[nodiscard]] Matrix scalingOf(std::size_t k) const {
        const Law& law = laws_[k];
        const Barrier& now = barriers_[k];
        const double room = std::sqrt(roomOf(law, forces_)), other = std::sqrt(roomOf(now));
        Vector point(law.rows + 1), image(law.rows + 1);
        point << radiusOf(law, forces_), forces_.segment(law.first, law.rows);
        image << now.slip, now.rate;
        const double cosine = std::sqrt((1 + point.dot(image) / room / other) / 2);
        point.tail(law.rows) *= -1;
        const Vector between = (image / other + point / room) / (2 * cosine);
        Matrix scaling = 2 * between * between.transpose();
        scaling(0, 0) -= 1;
        scaling.diagonal().tail(law.rows).array() += 1;
        return scaling * (other / room);
    }

    void addDisc(std::size_t k, double t, Matrix& change, Vector& right) const {
        const Law& law = laws_[k];
        const Matrix scaling = scalingOf(k);
        change.block(law.first, law.first, law.rows, law.rows) +=
            scaling.bottomRightCorner(law.rows, law.rows);
        if (law.normal >= 0)
            change.block(law.first, law.normal, law.rows, law.normals).colwise() +=
                law.coefficient * scaling.bottomLeftCorner(law.rows, 1).col(0);
        right.segment(law.first, law.rows) -=
            t / roomOf(law, forces_) * forces_.segment(law.first, law.rows);
    }

    // The steps of the multipliers that belong to that of the forces.
    [[nodiscard]] std::vector<Barrier> waysOf(const Vector& way, double t) const {
        std::vector<Barrier> ways(laws_.size());
        const Vector rates = a_ * (forces_ + way) + b_;
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            const Barrier& now = barriers_[k];
            if (!hasRoom(k))
                continue;
            if (!isInterval(law)) {
                const double wider =
                    law.normal < 0 ? 0
                                   : law.coefficient * way.segment(law.normal, law.normals).sum();
                const Matrix scaling = scalingOf(k);
                ways[k].rate = rates.segment(law.first, law.rows) - now.rate;
                ways[k].slip = t * radiusOf(law, forces_) / roomOf(law, forces_) - now.slip -
                               scaling(0, 0) * wider -
                               scaling.topRightCorner(1, law.rows)
                                   .row(0)
                                   .dot(way.segment(law.first, law.rows));
                continue;
            }
            const double f = forces_[law.first], step = way[law.first];
            if (law.low > -unbounded)
                ways[k].low = (t - now.low * step) / (f - law.low) - now.low;
            if (law.high < unbounded)
                ways[k].high = (t + now.high * step) / (law.high - f) - now.high;
        }
        return ways;
    }

    [[nodiscard]] bool isInside(const Vector& way, const std::vector<Barrier>& ways,
                                double fraction) const {
        constexpr double left = 0.01; // of each room
        const Vector forces = forces_ + fraction * way;
        const auto keeps = [&](double now, double change) {
            return now + fraction * change >= left * now;
        };
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            if (!hasRoom(k))
                continue;
            if (!isInterval(law)) {
                const Barrier then{.slip = barriers_[k].slip + fraction * ways[k].slip,
                                   .rate = barriers_[k].rate + fraction * ways[k].rate};
                if (!keeps(barriers_[k].slip, ways[k].slip) ||
                    !(roomOf(then) >= left * left * roomOf(barriers_[k])) ||
                    !(radiusOf(law, forces) >= left * radiusOf(law, forces_)) ||
                    !(roomOf(law, forces) >= left * left * roomOf(law, forces_)))
                    return false;
                continue;
            }
            if (!keeps(barriers_[k].low, ways[k].low) || !keeps(barriers_[k].high, ways[k].high) ||
                !(forces[law.first] - law.low >= left * (forces_[law.first] - law.low)) ||
                !(law.high - forces[law.first] >= left * (law.high - forces_[law.first])))
                return false;
        }
        return true;
    }

    // A law is at its bound if its multiplier is larger than its room, both in the row's units.
    [[nodiscard]] States states() const {
        States states(laws_.size(), State::inside);
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            const double stiff = std::max(a_(law.first, law.first), 1e-300), f = forces_[law.first];
            if (!hasRoom(k)) {
                states[k] = isInterval(law) ? State::low : State::edge;
            } else if (!isInterval(law)) {
                const double length = forces_.segment(law.first, law.rows).norm();
                if (barriers_[k].slip > stiff * (radiusOf(law, forces_) - length))
                    states[k] = State::edge;
            } else if (law.low > -unbounded && barriers_[k].low > stiff * (f - law.low)) {
                states[k] = State::low;
            } else if (law.high < unbounded && barriers_[k].high > stiff * (law.high - f)) {
                states[k] = State::high;
            }
        }
        return states;
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    Vector forces_;
    std::vector<Barrier> barriers_;
    double rate_ = 0, force_ = 0, size_ = 1; // sizes: of rates, of forces, of their products
    double target_ = 0.2;                    // the next t, as a part of the gap
};

} // namespace

Approach approach(const Matrix& a, const Vector& b, const Laws& laws) {
    return Path(a, b, laws).follow();
}

} // namespace complementarity
