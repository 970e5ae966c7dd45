// Newton's iteration for all stages of a collocation method at once, each with the Jacobian of its
// own place:
//
//     sum_j (A^-1)_ij / h dz_j - J_i dz_i = f(Y_i) - sum_j (A^-1)_ij / h z_j,   Y_i = y + z_i
//
// One Jacobian for all stages makes these part into smaller systems (radau.h); but when a stiff
// direction turns within the step, the iteration then contracts only while h is below some
// (m/k)^(1/4). Here it knows no such bound, at some three times the cost of an iteration.
//
// A link that only the prediction stretches has a large sideways stiffness in the Jacobian. It
// makes Newton's corrections small, and wrong. So a correction does not count as converged while
// the residual at the Jacobian's place would move a body far within the step.
#pragma once

#include "integrators/linear_solver.h"
#include "integrators/method.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace solution {

class CoupledStages {
public:
    static constexpr std::size_t count = 3;
    using Nodes = std::array<double, count>;
    using Weights = std::array<std::array<double, count>, count>; // A^-1
    using Stages = std::array<std::vector<double>, count>;

    CoupledStages(System& system, const ErrorControl& control, const Nodes& nodes,
                  const Weights& weights);

    enum class Outcome { converged, failed, notFinite };
    // Improves z, for the step of length h from y at t, by so many corrections at least.
    [[nodiscard]] Outcome solve(double t, double h, std::span<const double> y, Stages& z,
                                bool isFixed, std::size_t leastIterations);
    // Of the last solve().
    [[nodiscard]] const MethodCounts& counts() const { return counts_; }

private:
    struct Entry { // of the matrix
        double weight = 0;
        std::size_t jacobian = none;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void addColumn(const Pattern& jacobian, std::size_t stage, std::size_t column);
    void add(std::size_t row, const Entry& entry);
    [[nodiscard]] bool linearize();
    [[nodiscard]] bool missing(double& displacement);
    [[nodiscard]] double correct(Stages& z);
    void place(std::size_t stage);

    System& system_;
    const ErrorControl& control_;
    const Nodes nodes_;
    const Weights weights_;
    Pattern pattern_{.columnStarts = {0}, .rows = {}};
    std::vector<Entry> entries_;
    std::vector<double> jacobians_, matrix_;
    std::unique_ptr<LinearSolver> solver_;

    MethodCounts counts_;
    struct Step {
        double t = 0, h = 0;
        std::span<const double> y;
        Stages* z = nullptr;
    };
    Step step_; // that is solved
    std::vector<double> at_, rates_, missing_;
};

} // namespace solution
