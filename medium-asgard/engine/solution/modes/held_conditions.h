// The conditions that hold in a mode (component_model.h, Conditions) as a system of equations at
// one point:
//
//     A m = -b
//
// A tree of joints has conditions that read few others, and so has a stack: there, A is eliminated
// as a sparse matrix (elimination.h); where it reads most, or where A is not definite, as a dense
// one, scaled by the roots of its diagonal. Where conditions are redundant, as the four corners of
// a face or the joints of a plane mechanism in space, the shortest m is taken, or the one next to
// Mode::forces.
//
// The choice depends on the mode and on the numbers at the point alone: the same point has the
// same answer, whatever was asked before.
#pragma once

#include "equations/bound_model.h"
#include "modes/elimination.h"
#include "modes/mode.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace solution {

// A clause: that many conditions are solved for one after the other.
[[nodiscard]] std::string howEliminated(std::size_t rows, std::size_t multiplications);

class HeldConditions {
public:
    // `mode` outlives them, and says which conditions hold. Ties are not among them.
    HeldConditions(const ComponentModel::Conditions& conditions, const BoundModel& bound,
                   const Mode& mode)
        : conditions_(conditions), bound_(bound), mode_(mode) {}

    // Ways from the places of a point to its conditions, over the size of what these join.
    using Off = std::function<double()>;
    // `values`: of Conditions::matrix. False: they are not finite. Without a heap allocation where
    // the same conditions hold as before and none is redundant. `off` is asked where some are next
    // to redundant: where places are off their conditions by d, as within a step, a condition that
    // others make has a pivot of the order of d^2, which says nothing of it.
    [[nodiscard]] bool factorise(std::span<const double> values, const Off& off = {});
    // The same matrix once more, of which less counts as redundant: where conditions that are next
    // to redundant keep more than rounding.
    [[nodiscard]] bool factoriseClosely(std::span<const double> values);
    [[nodiscard]] const std::vector<std::size_t>& rows() const { return plan_.rows; }
    // Of conditions with these rates the m that keep them; 0 of others than those that hold. Of
    // several the one next to `wanted`, one for each condition; empty: the shortest. Distance and
    // length are in units of Mode::rooms.
    void solve(Eigen::Ref<Eigen::VectorXd> rates, std::span<const double> wanted = {});
    // The same of many rates, column by column: of several the shortest. left() knows none of them.
    void solveEach(Eigen::Ref<Eigen::MatrixXd> rates);
    // Conditions are not redundant.
    [[nodiscard]] bool isRegular() const {
        return way_ == Way::dense || (way_ == Way::sparse && redundancy_.kernel.cols() == 0);
    }
    // They were solved for one after the other, and none is redundant.
    [[nodiscard]] bool isEliminated() const { return way_ == Way::sparse && isRegular(); }
    // Where they are, what the last solution left of rates, by row(), scaled; the rates; a scale.
    [[nodiscard]] Eigen::VectorXd left() const;
    [[nodiscard]] const Eigen::VectorXd& right() const { return right_; }
    [[nodiscard]] double scale(std::size_t i) const { return scale_[static_cast<Eigen::Index>(i)]; }

    // How the last factorization was made: a clause; "": nothing holds.
    [[nodiscard]] std::string how() const;

private:
    struct Term { // of the matrix
        std::size_t entry = 0;
        Elimination::Place place = {};
    };
    struct Plan {
        std::vector<std::size_t> rows;
        std::vector<Term> terms;
        std::vector<Elimination::Index> entries, indices; // where it is sparse
        bool isSparse = false;
        bool isMade = false, hasContacts = false;
        bool hasFaces = false; // of which more than three points hold
    };
    enum class Way { sparse, dense, least };

    [[nodiscard]] bool holds(std::size_t row) const {
        return conditions_.isTie[row] == 0 && mode_.kept[row] == complementarity::State::inside;
    }
    void followMode();
    void takeRooms();
    void makePlan();
    [[nodiscard]] bool eliminate(std::span<const double> values);
    void findKernel(std::span<const double> values);
    [[nodiscard]] bool factoriseDense(std::span<const double> values, double none, const Off& off);
    void putMatrix(std::span<const double> values);
    void findIdle();
    [[nodiscard]] Eigen::MatrixXd leastSolutions(const Eigen::MatrixXd& right,
                                                 const Eigen::MatrixXd& wanted) const;

    const ComponentModel::Conditions& conditions_;
    const BoundModel& bound_;
    const Mode& mode_;
    Plan plan_;
    Way way_ = Way::dense;
    Elimination elimination_;
    struct Redundancy {          // of the sparse matrix
        Eigen::MatrixXd kernel;  // what redundant conditions may have
        Eigen::MatrixXd inRooms; // the same, in units of Mode::rooms
        Eigen::LDLT<Eigen::MatrixXd> normal;
        std::vector<double> values; // of the terms, then
    } redundancy_;
    struct Dense {              // where it is not eliminated as a sparse one
        Eigen::MatrixXd matrix; // scaled
        Eigen::PartialPivLU<Eigen::MatrixXd> lu;
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
        Eigen::MatrixXd idle;                                // the kernel; scaled
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> inRooms; // the same, in units of Mode::rooms
    } dense_;
    Eigen::VectorXd scale_, right_, answer_, wanted_, rooms_;
};

} // namespace solution
