// The tables of the diagonally implicit methods; tests check their order conditions.
#include "integrators/diagonally_implicit.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

DiagonalTableau makeBackwardEuler() {
    return {.name = "backward-euler", .order = 1, .c = {1}, .a = {{1}}, .b = {1}};
}

DiagonalTableau makeMidpoint() {
    return {.name = "midpoint", .order = 2, .c = {0.5}, .a = {{0.5}}, .b = {1}};
}

DiagonalTableau makeTrapezoidal() {
    return {
        .name = "trapezoidal", .order = 2, .c = {0, 1}, .a = {{0}, {0.5, 0.5}}, .b = {0.5, 0.5}};
}

// The rule of dissertation 5.2.
DiagonalTableau makeOriginal() {
    DiagonalTableau t = makeTrapezoidal();
    t.name = "original";
    t.stepByNewton = true;
    return t;
}

// Bank et al. 1985 with the third-order companion of Hosea and Shampine 1996 (equation 2.2).
DiagonalTableau makeTrBdf2() {
    const double root2 = std::sqrt(2.0), c = 2 - root2, d = c / 2, w = root2 / 4;
    DiagonalTableau t{.name = "tr-bdf2", .order = 2};
    t.c = {0, c, 1};
    t.a = {{0}, {d, d}, {w, w, d}};
    t.b = t.a.back();
    t.error = {w - (1 - w) / 3, w - (3 * w + 1) / 3, d - d / 3};
    t.errorOrder = 2;
    return t;
}

// Hairer and Wanner II, table IV.6.5: five stages, L-stable, stiffly accurate; embedded order 3.
DiagonalTableau makeSdirk4() {
    DiagonalTableau t{.name = "sdirk4", .order = 4};
    t.c = {1.0 / 4, 3.0 / 4, 11.0 / 20, 1.0 / 2, 1};
    t.a = {{1.0 / 4},
           {1.0 / 2, 1.0 / 4},
           {17.0 / 50, -1.0 / 25, 1.0 / 4},
           {371.0 / 1360, -137.0 / 2720, 15.0 / 544, 1.0 / 4},
           {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12, 1.0 / 4}};
    t.b = t.a.back();
    const double embedded[] = {59.0 / 48, -17.0 / 96, 225.0 / 32, -85.0 / 12, 0};
    for (std::size_t i = 0; i < t.b.size(); ++i)
        t.error.push_back(t.b[i] - embedded[i]);
    t.errorOrder = 3;
    return t;
}

} // namespace

const DiagonalTableau* diagonalTableauNamed(const std::string& name) {
    static const std::vector<DiagonalTableau> tableaus = {makeBackwardEuler(), makeMidpoint(),
                                                          makeTrapezoidal(),   makeOriginal(),
                                                          makeTrBdf2(),        makeSdirk4()};
    const auto found = std::find_if(tableaus.begin(), tableaus.end(),
                                    [&](const auto& t) { return name == t.name; });
    return found == tableaus.end() ? nullptr : &*found;
}

} // namespace solution
