// Equations with one solution, many or none: the shortest of those that err least.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include <optional>

namespace complementarity {

// But for rounding.
[[nodiscard]] bool isSymmetric(const Eigen::MatrixXd& a);

// Of one matrix, for many right sides. What a solution needs is computed when it is needed first.
class Least {
public:
    using Matrix = Eigen::MatrixXd;
    using Vector = Eigen::VectorXd;
    explicit Least(Matrix a);

    [[nodiscard]] const Matrix& matrix() const { return a_; }
    [[nodiscard]] Vector solve(const Vector& right);

private:
    using Elimination = Eigen::PartialPivLU<Matrix>;

    [[nodiscard]] std::optional<Vector> byLittleSteps(const Vector& right);

    Matrix a_;
    Vector byRows_, byColumns_; // what makes the largest number 1
    Elimination balanced_;
    bool isRegular_ = false, isSymmetric_ = false;
    double size_ = 0;                 // of the diagonal
    std::optional<Elimination> firm_; // with a little on the diagonal
    std::optional<Eigen::CompleteOrthogonalDecomposition<Matrix>> byRank_;
};

} // namespace complementarity
