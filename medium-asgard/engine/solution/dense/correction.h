// The terms of a step's polynomial from the start of the step before: of one step (dense_output.h),
// and of several side by side (dense_formulas.h).
#pragma once

namespace solution {

// The terms that place, velocity and acceleration at the start of the step before add to a quintic,
// and value and slope there to a cubic. With r = ratio:
//
//     s^3 (1-s)^3 (c0 + c1 (s+r) + c2 (s+r)^2)        s^2 (1-s)^2 (c0 + c1 (s+r))
//
// The whole is about the error of the polynomial without it. The error that is left with it, local
// errors h^9 and h^6, is guessed from how the terms fall: each by the root of what every second one
// does, since one alone may pass through 0; of a cubic's two terms the last is taken.
template <class Real> struct CorrectionOf {
    Real terms[3];
    Real whole, left;           // at most, in units of the value
    Real wholeSlope, leftSlope; // at most, times h
};

// The basis that all corrections of a step have in common: with u = s(1-s) at s = -r, w = u^3 or
// u^2 and its derivatives.
template <class Real> struct CorrectionBasisOf {
    Real ratio, reach;
    Real cube, cubeSlope, cubeBend; // 1/w, w', w'' of u^3
    Real square, squareSlope;       // 1/w, w' of u^2
};

} // namespace solution
