#include "complementarity/least.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace complementarity {

namespace {

double inverseSize(double largest) {
    return largest > 0 && std::isfinite(largest) ? 1 / largest : 1;
}

} // namespace

bool isSymmetric(const Eigen::MatrixXd& a) {
    constexpr double rounding = 1e-12;
    return (a - a.transpose()).cwiseAbs().maxCoeff() <= rounding * a.cwiseAbs().maxCoeff();
}

// Rows of edges have numbers of any size, the largest those of discs that hardly press: beside
// them all others would look like rounding, and the rank too small. So each row is divided by its
// largest number, which changes no solution.
Least::Least(Matrix a) : a_(std::move(a)) {
    constexpr double noPivot = 1e-11; // of the largest
    if (a_.size() == 0)
        return;
    byRows_ = a_.cwiseAbs().rowwise().maxCoeff().unaryExpr(&inverseSize);
    Matrix balanced = byRows_.asDiagonal() * a_;
    byColumns_ = balanced.cwiseAbs().colwise().maxCoeff().transpose().unaryExpr(&inverseSize);
    balanced *= byColumns_.asDiagonal();
    balanced_.compute(balanced);
    const auto pivots = balanced_.matrixLU().diagonal().cwiseAbs();
    isRegular_ = pivots.minCoeff() > noPivot * pivots.maxCoeff();
    if (isRegular_)
        return;
    isSymmetric_ = isSymmetric(a_);
    size_ = a_.diagonal().cwiseAbs().maxCoeff();
}

Eigen::VectorXd Least::solve(const Vector& right) {
    constexpr Eigen::Index many = 60;
    if (right.size() == 0)
        return right;
    if (isRegular_)
        return byColumns_.cwiseProduct(balanced_.solve(byRows_.cwiseProduct(right)));
    if (isSymmetric_ && !byRank_ && right.size() >= many)
        if (auto found = byLittleSteps(right))
            return *found;
    if (!byRank_)
        byRank_.emplace(isSymmetric_ ? a_ : Matrix(byRows_.asDiagonal() * a_));
    return byRank_->solve(isSymmetric_ ? right : Vector(byRows_.cwiseProduct(right)));
}

// Of a large matrix a decomposition that finds its rank takes many times as long as elimination.
// With a little on its diagonal it has an inverse, and steps from 0 on lead to the shortest
// solution as fast as that little is small beside its numbers (the proximal point method;
// Rockafellar, SIAM Journal on Control and Optimization 14, 1976). Nothing: they do not.
std::optional<Eigen::VectorXd> Least::byLittleSteps(const Vector& right) {
    constexpr double little = 1e-6, rounding = 1e-14, less = 0.5;
    constexpr int most = 40, patience = 5; // steps, and those since the error was twice as large
    if (!firm_) {
        Matrix firm = a_;
        firm.diagonal().array() += little * size_;
        firm_.emplace(firm);
    }
    const double none = rounding * right.cwiseAbs().maxCoeff();
    Vector x = Vector::Zero(right.size());
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0, inVain = 0; step < most && inVain < patience; ++step, ++inVain) {
        const Vector left = right - a_ * x;
        const double error = left.cwiseAbs().maxCoeff();
        if (!std::isfinite(error))
            return std::nullopt;
        const double scale = size_ * x.cwiseAbs().maxCoeff();
        if (error <= std::max(none, rounding * scale))
            return x;
        if (error < less * least) {
            least = error;
            inVain = 0;
        }
        x += firm_->solve(left);
    }
    return std::nullopt;
}

} // namespace complementarity
