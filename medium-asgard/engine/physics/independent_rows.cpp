#include "physics/independent_rows.h"

#include <Eigen/SparseLU>

namespace physics {

namespace {

constexpr double independent = 1e-10; // of the largest pivot
constexpr double solved = 1e-8;

} // namespace

IndependentRows::IndependentRows(const Eigen::MatrixXd& rows, const std::vector<char>& held)
    : all_(rows.cols()) {
    for (Eigen::Index c = 0; c < all_; ++c)
        if (held.empty() || held[static_cast<std::size_t>(c)] == 0)
            columns_.push_back(c);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
        const std::size_t before = entries.size();
        for (std::size_t k = 0; k < columns_.size(); ++k)
            if (const double entry = rows(r, columns_[k]); entry != 0)
                entries.emplace_back(static_cast<int>(rows_.size()), static_cast<int>(k), entry);
        if (entries.size() > before)
            rows_.push_back(r);
    }
    if (rows_.size() > columns_.size())
        return;
    own_.resize(static_cast<Eigen::Index>(rows_.size()),
                static_cast<Eigen::Index>(columns_.size()));
    own_.setFromTriplets(entries.begin(), entries.end());
    are_ = rows_.empty();
    if (are_)
        return;
    square_.compute(own_ * Eigen::SparseMatrix<double>(own_.transpose()));
    are_ = square_.info() == Eigen::Success &&
           square_.vectorD().minCoeff() > independent * square_.vectorD().maxCoeff();
}

Eigen::VectorXd IndependentRows::least(const Eigen::VectorXd& change) const {
    Eigen::VectorXd movement = Eigen::VectorXd::Zero(all_);
    if (!rows_.empty()) {
        const Eigen::VectorXd wanted = change(rows_);
        movement(columns_) = own_.transpose() * square_.solve(wanted);
    }
    return movement;
}

// With l for each condition: cost v + own' l = by, own v = 0.
std::optional<Eigen::MatrixXd> IndependentRows::cheapest(const Eigen::SparseMatrix<double>& cost,
                                                         const Eigen::MatrixXd& by) const {
    const auto count = static_cast<int>(columns_.size());
    const auto size = static_cast<Eigen::Index>(columns_.size() + rows_.size());
    std::vector<int> place(static_cast<std::size_t>(all_), -1);
    for (int k = 0; k < count; ++k)
        place[static_cast<std::size_t>(columns_[static_cast<std::size_t>(k)])] = k;
    std::vector<Eigen::Triplet<double>> entries;
    using Entry = Eigen::SparseMatrix<double>::InnerIterator;
    for (int c = 0; c < cost.outerSize(); ++c)
        for (Entry entry(cost, c); entry; ++entry) {
            const int row = place[static_cast<std::size_t>(entry.row())];
            const int column = place[static_cast<std::size_t>(entry.col())];
            if (row >= 0 && column >= 0)
                entries.emplace_back(row, column, entry.value());
        }
    for (int c = 0; c < own_.outerSize(); ++c)
        for (Entry entry(own_, c); entry; ++entry) {
            const int row = count + static_cast<int>(entry.row());
            entries.emplace_back(row, c, entry.value());
            entries.emplace_back(c, row, entry.value());
        }
    Eigen::SparseMatrix<double> whole(size, size);
    whole.setFromTriplets(entries.begin(), entries.end());
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(size, by.cols());
    wanted.topRows(count) = by(columns_, Eigen::all);
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.compute(whole);
    if (solver.info() != Eigen::Success)
        return std::nullopt;
    const Eigen::MatrixXd found = solver.solve(wanted);
    if (!((whole * found - wanted).norm() <= solved * wanted.norm()))
        return std::nullopt;
    Eigen::MatrixXd movements = Eigen::MatrixXd::Zero(all_, by.cols());
    movements(columns_, Eigen::all) = found.topRows(count);
    return movements;
}

} // namespace physics
