#include "complementarity/convex.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

using Set = std::vector<Index>;

// The state of every row while the active set changes. Rows inside are the set.
class ActiveSet {
public:
    ActiveSet(const Matrix& a, const Vector& b, const Laws& laws)
        : a_(a), b_(b), laws_(laws), states_(laws.size(), State::inside),
          forces_(Vector::Zero(b.size())) {
        for (std::size_t k = 0; k < laws.size(); ++k)
            if (const Law& law = laws[k]; law.low >= 0 || law.high <= 0) {
                states_[k] = law.low >= 0 ? State::low : State::high;
                forces_[law.first] = boundOf(k);
            }
    }

    // A rate on the wrong side by less than `part` of the largest in b is none.
    void find(double part) {
        moveInside();
        const double tolerance = part * b_.cwiseAbs().maxCoeff();
        for (Index round = 0; round < 30 * b_.size() + 30; ++round) {
            const Vector rates = a_ * forces_ + b_;
            const Index worst = mostWanted(rates, tolerance);
            if (worst < 0)
                return;
            states_[static_cast<std::size_t>(worst)] = State::inside;
            moveInside();
        }
    }

    // The ridge pulls all forces towards 0. From here on it pulls them to where they are.
    void pullHere(double ridge, const Vector& b) { b_ = b - ridge * forces_; }

    [[nodiscard]] const Vector& forces() const { return forces_; }
    [[nodiscard]] const States& states() const { return states_; }

    // The forces with which all rows inside stand at 0, as a start of shortest().
    [[nodiscard]] Vector atBounds() const {
        Vector forces = forces_;
        forces(inside()).setZero();
        return forces;
    }

    // The shortest change of the forces of the rows inside for which their rates are 0, by `of` and
    // `b`, which have no ridge; the other rows keep their bounds.
    [[nodiscard]] Vector shortest(const Matrix& of, const Vector& b, Vector forces) const {
        const Set set = inside();
        if (!set.empty()) {
            const Vector right = -wanted(of, b, forces, set);
            const Vector some =
                Eigen::CompleteOrthogonalDecomposition<Matrix>(of(set, set)).solve(right);
            forces(set) += some;
        }
        return forces;
    }

private:
    [[nodiscard]] double boundOf(std::size_t k) const {
        return states_[k] == State::low ? laws_[k].low : laws_[k].high;
    }
    [[nodiscard]] Set inside() const {
        Set set;
        for (std::size_t k = 0; k < states_.size(); ++k)
            if (states_[k] == State::inside)
                set.push_back(laws_[k].first);
        return set;
    }
    [[nodiscard]] static Vector wanted(const Matrix& of, const Vector& b, const Vector& forces,
                                       const Set& set) {
        if (forces.isZero(0))
            return b(set);
        const Vector rates = of * forces + b;
        return rates(set);
    }

    // The row at a bound whose rate is farthest on the wrong side; -1: none.
    [[nodiscard]] Index mostWanted(const Vector& rates, double tolerance) const {
        Index worst = -1;
        double most = tolerance;
        for (std::size_t k = 0; k < states_.size(); ++k) {
            const double rate = rates[laws_[k].first];
            const double wrong = states_[k] == State::low    ? -rate
                                 : states_[k] == State::high ? rate
                                                             : 0;
            if (wrong > most && laws_[k].low < laws_[k].high) {
                most = wrong;
                worst = static_cast<Index>(k);
            }
        }
        return worst;
    }

    // To the minimum over the rows inside, as far as their bounds allow; a row that gets to one
    // stays there, and the rest goes on.
    void moveInside() {
        for (;;) {
            const Set set = inside();
            if (set.empty())
                return;
            Vector to = forces_;
            to(set).setZero();
            const Vector right = -wanted(a_, b_, to, set);
            const Vector some = a_(set, set).ldlt().solve(right);
            to(set) = some;
            if (!retreat(to))
                return;
        }
    }

    // True: a row has met its bound on the way.
    bool retreat(const Vector& to) {
        double fraction = 1;
        for (std::size_t k = 0; k < states_.size(); ++k)
            if (const double bound = passed(k, to); std::isfinite(bound)) {
                const double from = forces_[laws_[k].first], way = to[laws_[k].first] - from;
                fraction = std::min(fraction, way != 0 ? (bound - from) / way : 0);
            }
        const Vector before = forces_;
        forces_ += fraction * (to - before);
        bool hasMet = false;
        const double close = 1e-14 * forces_.cwiseAbs().maxCoeff();
        for (std::size_t k = 0; k < states_.size(); ++k)
            if (const double bound = passed(k, to);
                std::isfinite(bound) && std::abs(forces_[laws_[k].first] - bound) <= close) {
                states_[k] = bound == laws_[k].low ? State::low : State::high;
                forces_[laws_[k].first] = bound;
                hasMet = true;
            }
        if (!hasMet)
            forces_ = to;
        return hasMet;
    }

    // The bound of a row inside that `to` has reached or passed; not finite: none.
    [[nodiscard]] double passed(std::size_t k, const Vector& to) const {
        const Law& law = laws_[k];
        if (states_[k] != State::inside)
            return unbounded;
        return to[law.first] <= law.low    ? law.low
               : to[law.first] >= law.high ? law.high
                                           : unbounded;
    }

    const Matrix& a_;
    Vector b_;
    const Laws& laws_;
    States states_;
    Vector forces_;
};

} // namespace

std::optional<Answer> solveConvex(const Matrix& a, const Vector& b, const Laws& laws) {
    const Index n = b.size();
    if (n == 0)
        return Answer{};
    // A little on the diagonal makes the minimum unique and close to the shortest solution.
    const double ridge = 1e-10 * std::max(a.diagonal().maxCoeff(), 1e-300);
    const Matrix firm = a + ridge * Matrix::Identity(n, n);
    ActiveSet set(firm, b, laws);
    const auto answerOf = [&](const Vector& forces) {
        return Answer{forces, a * forces + b, set.states()};
    };
    // A force that the ridge has moved across a bound has the wrong state: that of a motor a little
    // beyond its greatest couple, among joints of an arm that share a force in a way which hardly
    // shows in the rates. Pulls to where the forces are move them less and less (the proximal point
    // method; Rockafellar, SIAM Journal on Control and Optimization 14, 1976).
    constexpr int mostPulls = 6;
    std::optional<Answer> close;
    double least = 1e-7; // of a violation
    for (int pull = 0; pull < mostPulls; ++pull) {
        const States before = set.states();
        if (pull > 0)
            set.pullHere(ridge, b);
        // Without a pull towards 0, rounding gives a rate to rows that need no force, as the slack
        // side of a belt.
        set.find(pull > 0 ? 1e-9 : 1e-14);
        // Without it, on the same rows: the shortest solution to the last bits. Where rows of very
        // different masses meet, a force that is 0 has last places of the largest, which a second
        // solution takes away (iterative refinement; Higham, 2002, 12).
        Vector forces = set.atBounds();
        for (int round = 0; round < 3; ++round) {
            forces = set.shortest(a, b, forces);
            if (const Answer exact = answerOf(forces); violation(a, b, laws, exact) <= 1e-11)
                return exact;
        }
        const Answer found = answerOf(set.forces());
        if (const double faulty = violation(a, b, laws, found); faulty <= least) {
            least = faulty;
            close = found;
        }
        if (close && pull > 0 && set.states() == before)
            break;
    }
    return close;
}

} // namespace complementarity
