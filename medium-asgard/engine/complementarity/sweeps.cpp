#include "complementarity/sweeps.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

// The force of a disc alone, in the axes of its block, where each part of it stands alone.
class DiscAlone {
public:
    DiscAlone(const Matrix& block, const Vector& free)
        : axes_((block + block.transpose()) / 2),
          wanted_(-(axes_.eigenvectors().transpose() * free)),
          least_(1e-14 * std::max(axes_.eigenvalues().cwiseAbs().maxCoeff(), 1e-300)) {}

    // Without rate; or at the edge, with a rate against it.
    [[nodiscard]] Vector within(double radius) const {
        if (radius <= 0)
            return Vector::Zero(wanted_.size());
        if (!isOpen() && at(0).norm() <= radius)
            return axes_.eigenvectors() * at(0);
        double low = 0, high = wanted_.norm() / radius; // |f| falls as the slip grows
        for (int i = 0; i < 100 && high - low > 1e-15 * high; ++i) {
            const double middle = (low + high) / 2;
            (at(middle).norm() > radius ? low : high) = middle;
        }
        const Vector f = at(high);
        return axes_.eigenvectors() * (f * (radius / std::max(f.norm(), 1e-300)));
    }

private:
    // The force for which  (block + slip) f = wanted.
    [[nodiscard]] Vector at(double slip) const {
        Vector f = Vector::Zero(wanted_.size());
        for (Index i = 0; i < f.size(); ++i)
            if (const double stiff = std::max(0.0, axes_.eigenvalues()[i]) + slip; stiff > least_)
                f[i] = wanted_[i] / stiff;
        return f;
    }
    // Does an axis along which nothing moves want a force without end?
    [[nodiscard]] bool isOpen() const {
        for (Index i = 0; i < wanted_.size(); ++i)
            if (axes_.eigenvalues()[i] <= least_ && wanted_[i] != 0)
                return true;
        return false;
    }

    Eigen::SelfAdjointEigenSolver<Matrix> axes_;
    Vector wanted_;
    double least_; // an eigenvalue under this is 0
};

} // namespace

double sweep(const Matrix& a, const Vector& b, const Laws& laws, Vector& forces) {
    double change = 0;
    for (const Law& law : laws) {
        const Matrix block = a.block(law.first, law.first, law.rows, law.rows);
        const Vector before = forces.segment(law.first, law.rows);
        const Vector free = a.middleRows(law.first, law.rows) * forces +
                            b.segment(law.first, law.rows) - block * before;
        Vector after = before;
        if (law.kind == Law::Kind::disc)
            after = DiscAlone(block, free).within(radiusOf(law, forces));
        else if (block(0, 0) > 0)
            after[0] = std::clamp(-free[0] / block(0, 0), law.low, law.high);
        else
            after[0] = std::clamp(before[0], law.low, law.high);
        change = std::max(change, (after - before).cwiseAbs().maxCoeff());
        forces.segment(law.first, law.rows) = after;
    }
    return change;
}

States statesOf(const Matrix& a, const Vector& b, const Laws& laws, const Vector& forces) {
    const Vector rates = a * forces + b;
    States states(laws.size(), State::inside);
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const Law& law = laws[k];
        if (law.kind == Law::Kind::disc) {
            const double length = forces.segment(law.first, law.rows).norm();
            if (length >= radiusOf(law, forces) * (1 - 1e-9))
                states[k] = State::edge;
        } else if (forces[law.first] <= law.low) {
            states[k] = law.low == law.high && rates[law.first] < 0 ? State::high : State::low;
        } else if (forces[law.first] >= law.high) {
            states[k] = State::high;
        }
    }
    return states;
}

} // namespace complementarity
