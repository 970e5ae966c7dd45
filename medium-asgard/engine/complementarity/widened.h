// Coulomb's law as a fixed point of convex problems.
//
// The least of  f'Af/2 + b'f  among forces that the laws allow is a convex problem, which always
// has an end. There a disc that slips parts its surfaces, too, by the coefficient times the slip.
// With that taken off the normal rates, for slips that the answer itself has, it is Coulomb's law.
// A solution exists wherever bodies can part (Acary, Cadoux, Lemarechal and Malick, A formulation
// of the linear discrete Coulomb friction problem via convex optimization, ZAMM 91, 2011). Ten to
// forty problems lead there from nothing as a rule, also in a wall of bricks, whose forces are not
// unique. LIMIT: of 200 random heaps with friction up to 0.9 five did not settle in 60.
#pragma once

#include "complementarity/fixed_point.h"
#include "complementarity/laws.h"

namespace complementarity {

// Of discs without levers and intervals, on a symmetric A.
class Widened {
public:
    // The slips of the first problem, one for each law; none: 0.
    Widened(const Matrix& a, const Vector& b, const Laws& laws, const Vector& slips = {});

    // One problem more, with the slips that the last answers lead to.
    void advance();
    [[nodiscard]] const Answer& answer() const { return answer_; }
    // Of the next problem.
    [[nodiscard]] const Vector& slips() const { return slips_.at(); }
    // Of slips by the last problem, over the largest of b; no number where it has no end.
    [[nodiscard]] double change() const { return change_; }

private:
    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    FixedPoint slips_;
    Answer answer_;
    double change_ = unbounded;
};

} // namespace complementarity
