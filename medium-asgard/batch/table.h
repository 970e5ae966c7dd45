// A motion as a table of comma-separated values (RFC 4180, lines end with \n).
//
// One row per time, in the order asked; `t`, thirteen columns for each body, then the quantities.
// Numbers are written so that reading them gives the same double. After a body's motion ended in an
// error its cells are empty.
#pragma once

#include "scene/scene.h"
#include "simulation/simulation.h"

#include <cstdio>
#include <string>
#include <vector>

namespace batch {

// Either way reading a number gives the same double: seventeen digits, or as few as do.
enum class Digits { all, shortest };

struct Columns {
    bool bodies = true;                  // false: only `t` and the quantities
    std::vector<std::string> quantities; // as written
    Digits digits = Digits::all;
};

// Rows after the time that the motion reached are left out. False: the file could not be written.
[[nodiscard]] bool writeTable(std::FILE* file, const scene::Scene& scene,
                              const simulation::Motion& motion,
                              const simulation::Quantities& quantities, const Columns& columns,
                              const std::vector<double>& times);

[[nodiscard]] std::string cell(const std::string& text); // quoted where it must be
// Empty where it is not a number.
[[nodiscard]] std::string cell(double value, Digits digits = Digits::all);

} // namespace batch
