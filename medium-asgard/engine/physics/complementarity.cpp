#include "physics/complementarity.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>

namespace physics {

namespace {

using Index = Eigen::Index;
using Set = std::vector<Index>;

Eigen::MatrixXd block(const Eigen::MatrixXd& a, const Set& set) { return a(set, set); }

// The unconstrained minimum over the set; zero elsewhere.
Eigen::VectorXd minimumOver(const Set& set, const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(b.size());
    if (!set.empty()) {
        const Eigen::VectorXd right = -b(set);
        const Eigen::VectorXd some = block(a, set).ldlt().solve(right);
        f(set) = some;
    }
    return f;
}

// From `from` towards `to`, as far as f >= 0 allows; what gets to zero leaves the set.
Eigen::VectorXd retreat(const Eigen::VectorXd& from, const Eigen::VectorXd& to, Set& set) {
    double fraction = 1;
    for (Index i : set)
        if (to[i] <= 0)
            fraction = std::min(fraction, from[i] / (from[i] - to[i]));
    Eigen::VectorXd f = from + fraction * (to - from);
    std::erase_if(set, [&](Index i) { return to[i] <= 0 && f[i] <= 1e-14 * f.maxCoeff(); });
    for (Index i = 0; i < f.size(); ++i)
        if (std::find(set.begin(), set.end(), i) == set.end())
            f[i] = 0;
    return f;
}

// The set of contacts that push. `a` is positive definite.
Set findPushing(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::VectorXd& f) {
    Set set;
    f = Eigen::VectorXd::Zero(b.size());
    const double tolerance = 1e-14 * b.cwiseAbs().maxCoeff();
    for (Index round = 0; round < 30 * b.size() + 30; ++round) {
        const Eigen::VectorXd w = a * f + b;
        Index worst = -1;
        for (Index i = 0; i < w.size(); ++i)
            if (w[i] < -tolerance && std::find(set.begin(), set.end(), i) == set.end() &&
                (worst < 0 || w[i] < w[worst]))
                worst = i;
        if (worst < 0)
            break;
        set.push_back(worst);
        for (;;) {
            const Eigen::VectorXd to = minimumOver(set, a, b);
            if (std::all_of(set.begin(), set.end(), [&](Index i) { return to[i] > 0; })) {
                f = to;
                break;
            }
            const std::size_t before = set.size();
            f = retreat(f, to, set);
            if (set.size() == before || set.empty())
                break;
        }
    }
    std::sort(set.begin(), set.end());
    return set;
}

bool solves(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& f,
            double tolerance) {
    const double scale = b.cwiseAbs().maxCoeff();
    return f.minCoeff() >= 0 && (a * f + b).minCoeff() >= -tolerance * scale;
}

} // namespace

std::vector<double> solveComplementarity(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    const Index n = b.size();
    if (n == 0 || b.minCoeff() >= 0)
        return std::vector<double>(static_cast<std::size_t>(n), 0.0);
    // A little on the diagonal makes the minimum unique and close to the shortest solution.
    const double ridge = 1e-10 * a.diagonal().maxCoeff();
    if (!(ridge > 0))
        return {};
    Eigen::VectorXd f;
    const Set set = findPushing(a + ridge * Eigen::MatrixXd::Identity(n, n), b, f);

    // Without it, on the contacts that push: the shortest solution to the last bits.
    if (!set.empty()) {
        Eigen::VectorXd exact = Eigen::VectorXd::Zero(n);
        const Eigen::VectorXd right = -b(set);
        const Eigen::VectorXd some =
            Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(block(a, set)).solve(right);
        exact(set) = some;
        if (solves(a, b, exact, 1e-11))
            f = exact;
    }
    if (!solves(a, b, f, 1e-7))
        return {};
    return {f.data(), f.data() + n};
}

} // namespace physics
