// Conditions on a movement that are independent of each other, as those of bodies that hang
// together without a loop are. They are sparse, so the time to solve them grows with their number.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <optional>
#include <vector>

namespace physics {

class IndependentRows {
public:
    // Rows of zeros are no conditions. Columns that are held are no movements; none: none is.
    IndependentRows(const Eigen::MatrixXd& rows, const std::vector<char>& held);

    [[nodiscard]] bool are() const { return are_; } // false: nothing below may be asked
    [[nodiscard]] Eigen::Index free() const {       // movements that they leave
        return static_cast<Eigen::Index>(columns_.size() - rows_.size());
    }
    // The least movement along which the conditions change so.
    [[nodiscard]] Eigen::VectorXd least(const Eigen::VectorXd& change) const;
    // With Z of all movements that change no condition: Z (Z' cost Z)^-1 Z' by. None: there is no
    // such solution to working accuracy.
    [[nodiscard]] std::optional<Eigen::MatrixXd> cheapest(const Eigen::SparseMatrix<double>& cost,
                                                          const Eigen::MatrixXd& by) const;

private:
    Eigen::Index all_; // columns, with those that are held
    std::vector<Eigen::Index> rows_, columns_;
    Eigen::SparseMatrix<double> own_; // of these rows and columns
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> square_;
    bool are_ = false;
};

} // namespace physics
