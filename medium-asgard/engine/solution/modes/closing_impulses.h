// The impulses that end the rates of contacts which close, and keep the rates of all that holds.
//
//     a box lands on a corner and slides:   the corner presses with P, and its friction with mu P
//
// P are the impulses of what holds or closes, F P those of discs that slip, each against its own
// velocity (disc_friction.h). A and S are the rates of what holds or closes that impulses of 1
// give: its own, and those of the discs.
//
//     (A + S F) P = -rates     of what closes; 0 of all else
//
// P may pull. A hop presses at its end alone, by m v of its landing. A contact that closes at the
// begin of the hop instead is pulled by m v there, and pressed by 2 m v until the end. Friction
// follows the sign of P, so that its sum, too, is that of the hop: velocities behind it are the
// same to the first order in v, and places differ by about its height. Where rows are redundant, P
// is the shortest.
#pragma once

#include "modes/multipliers.h"

#include <span>
#include <vector>

namespace solution {

struct ClosingRows {
    std::vector<std::size_t> rows;     // that hold or close: normals, joints, discs that stick
    std::vector<std::size_t> closing;  // of these
    std::vector<std::size_t> slipping; // discs with normals among the rows
};

// All that holds in the mode, and the contacts that close. A contact that had no force so far
// sticks where it slips slower than it closes: its slip stays what it is.
[[nodiscard]] ClosingRows rowsToClose(const ModelFunctions& functions, const Mode& mode,
                                      const Multipliers& multipliers,
                                      std::span<const std::size_t> closing);
// At the point of the functions, once gaps are evaluated. False: no impulses close them, or they
// pull what approaches, and y is as before.
[[nodiscard]] bool close(Multipliers& multipliers, const ClosingRows& rows, std::span<double> y);

} // namespace solution
