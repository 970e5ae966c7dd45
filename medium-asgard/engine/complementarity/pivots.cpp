#include "complementarity/pivots.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace complementarity {

namespace {

constexpr double little = 1e-12; // on the diagonal, of its numbers: rates err by that

class Pivots {
public:
    Pivots(const Matrix& a, const Vector& b, const Laws& laws, States states)
        : a_(a), b_(b), laws_(laws), states_(std::move(states)) {}

    // False: they went on without end.
    bool find() {
        constexpr int tries = 10; // of all at once without fewer that are wrong
        const Index most = 20 * b_.size() + 100;
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        int left = tries;
        for (Index round = 0; round < most; ++round) {
            solve();
            const std::vector<std::size_t> wrong = this->wrong();
            if (wrong.empty())
                return forces_.allFinite();
            if (wrong.size() < fewest) {
                fewest = wrong.size();
                left = tries;
            }
            const bool isAll = left-- > 0;
            for (std::size_t i = isAll ? 0 : wrong.size() - 1; i < wrong.size(); ++i)
                states_[wrong[i]] = next(wrong[i]);
        }
        return false;
    }

    [[nodiscard]] Answer answer() const { return {forces_, a_ * forces_ + b_, states_}; }

private:
    void solve() {
        std::vector<Index> inside;
        forces_ = Vector::Zero(b_.size());
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (states_[k] == State::inside)
                inside.push_back(laws_[k].first);
            else
                forces_[laws_[k].first] = states_[k] == State::low ? laws_[k].low : laws_[k].high;
        rates_ = a_ * forces_ + b_;
        if (!inside.empty()) {
            Matrix firm = a_(inside, inside);
            firm.diagonal() *= 1 + little;
            const Vector right = -rates_(inside);
            const Vector found = firm.partialPivLu().solve(right);
            forces_(inside) = found;
            rates_ = a_ * forces_ + b_;
        }
        noForce_ = rounding * forces_.cwiseAbs().maxCoeff();
        noRate_ = rounding * (b_.cwiseAbs() + a_.cwiseAbs() * forces_.cwiseAbs()).maxCoeff();
    }

    [[nodiscard]] State next(std::size_t k) const {
        const Law& law = laws_[k];
        const double force = forces_[law.first], rate = rates_[law.first];
        if (states_[k] == State::inside)
            return force < law.low - noForce_    ? State::low
                   : force > law.high + noForce_ ? State::high
                                                 : State::inside;
        const bool isWrong = states_[k] == State::low ? rate < -noRate_ : rate > noRate_;
        return isWrong && law.low < law.high ? State::inside : states_[k];
    }

    [[nodiscard]] std::vector<std::size_t> wrong() const {
        std::vector<std::size_t> found;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (next(k) != states_[k])
                found.push_back(k);
        return found;
    }

    static constexpr double rounding = 1e-14;
    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    States states_;
    Vector forces_, rates_;
    double noForce_ = 0, noRate_ = 0;
};

} // namespace

std::optional<Answer> solveByPivots(const Matrix& a, const Vector& b, const Laws& laws,
                                    States states) {
    Pivots pivots(a, b, laws, std::move(states));
    if (!pivots.find())
        return std::nullopt;
    return pivots.answer();
}

} // namespace complementarity
