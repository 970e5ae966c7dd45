#include "integrators/linear_solver.h"

#include <Eigen/LU>
#include <klu.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace solution {

namespace {

constexpr std::size_t smallestSparse = 13;

} // namespace

class LinearSolver::Dense {
public:
    explicit Dense(const Pattern& pattern) : pattern_(pattern) {}

    bool factor(std::span<const double> jacobian, double shift,
                std::optional<std::complex<double>> complexShift) {
        return compute(real_, jacobian, shift) &&
               (!complexShift || compute(complex_, jacobian, *complexShift));
    }

    template <class Number, class Factors>
    static void solve(const Factors& factors, std::span<Number> x) {
        Eigen::Map<Eigen::Matrix<Number, Eigen::Dynamic, 1>> vector(
            x.data(), static_cast<Eigen::Index>(x.size()));
        vector = factors.solve(vector).eval();
    }

    Eigen::PartialPivLU<Eigen::MatrixXd> real_;
    Eigen::PartialPivLU<Eigen::MatrixXcd> complex_;

private:
    template <class Matrix, class Number>
    bool compute(Eigen::PartialPivLU<Matrix>& factors, std::span<const double> jacobian,
                 Number shift) const {
        const auto n = static_cast<Eigen::Index>(pattern_.size());
        Matrix matrix = Matrix::Identity(n, n) * shift;
        for (std::size_t column = 0; column < pattern_.size(); ++column)
            for (int k = pattern_.columnStarts[column]; k < pattern_.columnStarts[column + 1]; ++k)
                matrix(pattern_.rows[static_cast<std::size_t>(k)],
                       static_cast<Eigen::Index>(column)) -= jacobian[static_cast<std::size_t>(k)];
        if (!matrix.allFinite())
            return false;
        factors.compute(matrix);
        return factors.matrixLU().diagonal().cwiseAbs().minCoeff() > 0;
    }

    const Pattern& pattern_;
};

class LinearSolver::Sparse {
public:
    explicit Sparse(const Pattern& pattern) {
        klu_defaults(&common_);
        addDiagonal(pattern);
        symbolic_ = klu_analyze(size_, starts_.data(), rows_.data(), &common_);
        realValues_.resize(rows_.size());
        complexValues_.resize(2 * rows_.size());
    }
    ~Sparse() {
        klu_free_numeric(&real_, &common_);
        klu_z_free_numeric(&complex_, &common_);
        klu_free_symbolic(&symbolic_, &common_);
    }
    Sparse(const Sparse&) = delete;
    Sparse& operator=(const Sparse&) = delete;

    bool factor(std::span<const double> jacobian, double shift,
                std::optional<std::complex<double>> complexShift) {
        if (!symbolic_)
            return false;
        std::fill(realValues_.begin(), realValues_.end(), 0.0);
        std::fill(complexValues_.begin(), complexValues_.end(), 0.0);
        for (std::size_t k = 0; k < jacobian.size(); ++k) {
            if (!std::isfinite(jacobian[k]))
                return false;
            realValues_[places_[k]] = -jacobian[k];
            complexValues_[2 * places_[k]] = -jacobian[k];
        }
        for (const std::size_t place : diagonal_) {
            realValues_[place] += shift;
            if (complexShift) {
                complexValues_[2 * place] += complexShift->real();
                complexValues_[2 * place + 1] += complexShift->imag();
            }
        }
        return factorReal() && (!complexShift || factorComplex());
    }

    void solve(std::span<double> x) { klu_solve(symbolic_, real_, size_, 1, x.data(), &common_); }
    void solve(std::span<std::complex<double>> x) {
        klu_z_solve(symbolic_, complex_, size_, 1, reinterpret_cast<double*>(x.data()), &common_);
    }

private:
    // KLU wants every diagonal place, where the shift goes.
    void addDiagonal(const Pattern& pattern) {
        size_ = static_cast<int>(pattern.size());
        starts_.assign(1, 0);
        for (int column = 0; column < size_; ++column) {
            const auto c = static_cast<std::size_t>(column);
            bool seen = false;
            const auto add = [&](int row) {
                if (row == column)
                    diagonal_.push_back(rows_.size());
                seen = seen || row == column;
                rows_.push_back(row);
            };
            for (int k = pattern.columnStarts[c]; k < pattern.columnStarts[c + 1]; ++k) {
                const int row = pattern.rows[static_cast<std::size_t>(k)];
                if (row > column && !seen)
                    add(column);
                places_.push_back(rows_.size());
                add(row);
            }
            if (!seen)
                add(column);
            starts_.push_back(static_cast<int>(rows_.size()));
        }
    }

    static constexpr double worstCondition = 1e-14;

    bool factorReal() {
        if (real_ &&
            klu_refactor(starts_.data(), rows_.data(), realValues_.data(), symbolic_, real_,
                         &common_) &&
            klu_rcond(symbolic_, real_, &common_) && common_.rcond > worstCondition)
            return true;
        klu_free_numeric(&real_, &common_);
        real_ = klu_factor(starts_.data(), rows_.data(), realValues_.data(), symbolic_, &common_);
        return real_ != nullptr;
    }
    bool factorComplex() {
        if (complex_ &&
            klu_z_refactor(starts_.data(), rows_.data(), complexValues_.data(), symbolic_, complex_,
                           &common_) &&
            klu_z_rcond(symbolic_, complex_, &common_) && common_.rcond > worstCondition)
            return true;
        klu_z_free_numeric(&complex_, &common_);
        complex_ =
            klu_z_factor(starts_.data(), rows_.data(), complexValues_.data(), symbolic_, &common_);
        return complex_ != nullptr;
    }

    klu_common common_{};
    klu_symbolic* symbolic_ = nullptr;
    klu_numeric *real_ = nullptr, *complex_ = nullptr;
    int size_ = 0;
    std::vector<int> starts_, rows_;
    std::vector<std::size_t> places_, diagonal_; // of Jacobian entries and of the diagonal
    std::vector<double> realValues_, complexValues_;
};

LinearSolver::LinearSolver(const Pattern& pattern) {
    if (pattern.size() < smallestSparse)
        dense_ = std::make_unique<Dense>(pattern);
    else
        sparse_ = std::make_unique<Sparse>(pattern);
}

LinearSolver::~LinearSolver() = default;

bool LinearSolver::factor(std::span<const double> jacobian, double shift,
                          std::complex<double> complexShift) {
    return dense_ ? dense_->factor(jacobian, shift, complexShift)
                  : sparse_->factor(jacobian, shift, complexShift);
}

bool LinearSolver::factor(std::span<const double> jacobian, double shift) {
    return dense_ ? dense_->factor(jacobian, shift, std::nullopt)
                  : sparse_->factor(jacobian, shift, std::nullopt);
}

void LinearSolver::solve(std::span<double> x) const {
    if (dense_)
        Dense::solve(dense_->real_, x);
    else
        sparse_->solve(x);
}

void LinearSolver::solve(std::span<std::complex<double>> x) const {
    if (dense_)
        Dense::solve(dense_->complex_, x);
    else
        sparse_->solve(x);
}

} // namespace solution
