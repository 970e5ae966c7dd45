// Routines as bytes for this processor.
//
// Multiplication and addition stay two operations (never fused), elementary functions are the C
// library's, called one lane at a time, and branches are selected as operation.h says: the numbers
// are the tape's, bit for bit (of a NaN, that it is one). assemble_x86.cpp is the one there is, by
// asmjit; elsewhere assemble_nothing.cpp answers that there is no code.
#pragma once

#include "expression/routine.h"

#include <cstddef>
#include <vector>

namespace expression {

// The machine code of a routine: inputs, outputs (which must not overlap the inputs), constants,
// decisions and `scratch` (spills) are arrays with `lanes` entries for each index, aligned to 16
// bytes when lanes are 2.
using EntryPoint = void (*)(const double* in, double* out, const double* constants,
                            const Decision* decisions, double* scratch);

struct Target {
    unsigned lanes = 1; // 1; 2 with SSE2, 4 with AVX
    bool avx = false;
};
// The best that this processor has, for one instance and for many at once. Without a generator
// lanes are 1 too.
[[nodiscard]] Target oneAtATime();
[[nodiscard]] Target manyAtOnce();

// The operations that makeRoutine() may leave to the processor.
[[nodiscard]] Ability abilityOf(Target target);

// Empty: no code can be made here.
[[nodiscard]] std::vector<std::byte> assemble(const Routine& routine, Target target);

// The code as text: of each step of the routine its own line, then its instructions. Empty: none.
[[nodiscard]] std::string listing(const Routine& routine, Target target);

// Doubles that the code wants as scratch.
[[nodiscard]] std::size_t scratchOf(const Routine& routine, Target target);

} // namespace expression
