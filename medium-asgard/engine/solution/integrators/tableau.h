// The numbers that an explicit Runge-Kutta method is; what is done with them:
// explicit_runge_kutta.h.
#pragma once

#include "dense/weighted_sum.h"

#include <cstddef>
#include <string>
#include <vector>

namespace solution {

struct Tableau {
    const char* name;
    std::size_t order = 0;
    std::size_t stages = 0;                  // that make y1; stage `stages` is f at the end
    std::vector<double> c = {};              // of all stages
    std::vector<std::vector<double>> a = {}; // rows of all stages; row `stages` is b
    std::vector<double> error = {}, secondError = {}; // sums of k_0..k_{stages}; may be empty
    std::vector<std::vector<double>> dense = {};      // [stage][power - 1]: B_i(s) = sum B_ip s^p
    std::size_t stiffStage = 0;                       // compared with the stage at the end
    double stabilityLimit = 0;                        // on the negative real axis
    std::vector<std::size_t> checkStages = {};        // that show how good the ends' polynomial is

    // The same without zeros, made by finished().
    std::vector<Terms> rows = {};
    Terms errorTerms = {}, secondErrorTerms = {};
    std::vector<Terms> denseTerms = {};        // by power - 1
    std::vector<std::size_t> denseStages = {}; // that any of them has
};

[[nodiscard]] Tableau finished(Tableau table);

// Null for a name that is not in the tables: dop853, dopri5, tsit5, gbs, rk4, forward-euler.
[[nodiscard]] const Tableau* tableauNamed(const std::string& name);

} // namespace solution
