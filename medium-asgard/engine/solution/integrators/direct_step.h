// The arithmetic of a step of DOP853 for a small system whose rates are machine code: the same bits
// as by the sums of weighted_sum.h and System::rates(), without loops and calls between them.
//
// Of up to `largest` unknowns there is a function for each number of them; its sums are straight
// code, four unknowns at a time.
//
// LIMIT: on processors that have AVX; elsewhere, and for other methods, stages are made one by one.
#pragma once

#include "dense/polynomial.h"
#include "integrators/system.h"

namespace solution {

struct Tableau;

struct DirectStep {
    static constexpr std::size_t largest = 16;

    // All stages of a step, in arrays with an entry for each unknown; lost: explicit_runge_kutta.h.
    struct Stages {
        double t, h;
        const double *start, *lost;
        double *end, *lostNext;
        double* stiffAt; // the argument of the stage that the end is compared with
        double* slopes;  // of all stages, one after the other; the first are there
    };
    // The number of evaluations that were made. Fewer than the method's stages, or `failed`: the
    // last one is not finite.
    struct Made {
        std::size_t evaluations = 0;
        bool failed = false;
    };
    using Make = Made (*)(const Stages& step, const System::Direct& rates);
    Make stages = nullptr;
    Make extension = nullptr; // those after them, of dense output
    // The error of each unknown.
    void (*errors)(double h, const double* slopes, double* error) = nullptr;
    // Coefficients of powers from 1 on, of each unknown, by those of the method's B_i(s).
    void (*dense)(double h, const double* slopes, const Tableau& tableau,
                  Coefficients* columns) = nullptr;

    // Without functions where there are none.
    [[nodiscard]] static DirectStep of(const Tableau& tableau, std::size_t size);
};

} // namespace solution
