// Forces of friction that last.
//
// Redundant forces may hold a disc in many ways, of which an answer of the laws has one at the
// edge. Forces within it last: those of the same laws with less friction there.
#pragma once

#include "complementarity/laws.h"

namespace solution {

// Of w = A f + b with these laws. The answer stays as it is where less friction does not do.
void holdWithin(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                const complementarity::Laws& laws, complementarity::Answer& answer);

} // namespace solution
