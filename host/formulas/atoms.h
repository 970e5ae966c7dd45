// The atoms of a list as what they are between their neighbours.
#pragma once

#include "formulas/formula.h"

namespace formulas {

// One for each child that is neither space nor style. A binary operator with nothing on one side is
// an ordinary sign (The TeXbook, Appendix G, rules 5 and 6). `afterOrdinary`: something stands
// before the list.
[[nodiscard]] std::vector<Atom> atomsOf(const Formula& formula, NodeId list,
                                        bool afterOrdinary = false);

} // namespace formulas
