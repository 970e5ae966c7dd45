// A table of true places, as `simulate` writes it, to compare motions with.
#pragma once

#include "accuracy/accuracy.h"
#include "batch/input.h"

namespace batch {

// Columns are found by their heads: `t`, and B.x, B.y, B.z, B.qw to B.qz of any bodies; others are
// not read. A body without places, or a row with empty cells for it, is not compared.
[[nodiscard]] std::variant<simulation::Trace, Refusal> referenceIn(const std::string& file,
                                                                   const scene::Scene& scene);

} // namespace batch
