// The forces that keep laws of every kind.
//
// Intervals on a symmetric A are a convex problem, which convex.h solves. Discs whose radius
// follows a normal force, and an A that is not symmetric (contacts that slide, held switches), need
// not have a solution, and may have several. Here the states of a guess are tried first, so that
// what held goes on holding where it can; then those to which an interior point method leads, those
// of pivots where each disc has one row that moves, a pull to the last answer that fades, and
// sweeps where A is symmetric; of few laws at last all states. Discs and slips with levers are
// tried at the states of the guess, then at the end of a path on which the centres follow; else
// they are solved at the centres of the last answer; where that answer leads, Newton's method looks
// for one that keeps the laws at its own centres, and then the fading pull. If none comes to an
// end, friction grows from none to its own.
//
// Of answers that all but keep the laws (1e-8) the nearest counts where there is no better one:
// faces that lie on each other with a tilt leave as much. Under 1e-9 no slow way looks for a better
// one.
//
// LIMIT: of more laws than those tried one by one, a problem whose sweeps do not converge counts as
// one without solution.
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

struct Work {       // counts of the last solve, for tests and reports
    int rounds = 0; // of centres
    int steps = 0;  // of the interior point methods
    int pulls = 0;  // to the last answer
    int sweeps = 0;
    int tries = 0; // choices of states
};

// Nothing where no solution was found. `guess`: the forces and states that held before, or none.
[[nodiscard]] std::optional<Answer> solve(const Matrix& a, const Vector& b, const Laws& laws,
                                          const Answer& guess = {}, Work* work = nullptr);

// All solutions of few laws, each with other states: two of one problem with different rates are an
// indeterminate motion (Painleve's rod). None of more than six laws that are not equalities, or of
// discs with levers, or slips.
[[nodiscard]] std::vector<Answer> everySolution(const Matrix& a, const Vector& b, const Laws& laws);

} // namespace complementarity
