// Forces that push and never pull: the linear complementarity problem of frictionless contact.
//
//     f >= 0,   w = A f + b >= 0,   f . w = 0        A symmetric, positive semidefinite
//
// This is where the convex function f.A f/2 + b.f has its minimum over f >= 0, found by the active
// set method of Lawson and Hanson (1974). When contacts are redundant (four feet of a table) A is
// singular and f is not unique; then the shortest f is taken, which shares a load evenly.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace physics {

// Empty when no f balances b.
[[nodiscard]] std::vector<double> solveComplementarity(const Eigen::MatrixXd& a,
                                                       const Eigen::VectorXd& b);

} // namespace physics
