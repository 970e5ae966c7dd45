// A component's equations in each of the forms that they take on their way to the processor:
//
//     equations, graph (what is shared is one node), derivatives, tape, registers, machine code
//
// so that an author sees what is computed, and who works on the engine in which phase it goes
// wrong.
#pragma once

#include "equations/bound_model.h"
#include "expression/equations.h"

#include <span>
#include <string>

namespace solution {

// The unknowns are those that the model was bound to.
[[nodiscard]] std::string phasesText(const expression::EquationSet& set,
                                     std::span<const std::size_t> unknowns,
                                     const BoundModel& bound);

} // namespace solution
