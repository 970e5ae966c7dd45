// Which least ways of bodies, that do not turn, keep each gap from being negative?
//
//   minimise sum |w|^2   with   gap + n (w1 - w2) >= 0   for each gap, w = 0 of bodies not loose
//
// Hildreth's method, by one force after the other: a force is the multiplier of its gap, and is
// positive where the gap is closed by need. Read with accelerations for ways it is Gauss's
// principle of bodies that are all equally heavy.
#pragma once

#include "geometry/pose.h"
#include "physics/assembly.h"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace simulation {

struct LeastWays {
    std::map<std::size_t, geometry::Vector> ways; // of loose bodies at gaps
    std::vector<double> forces;                   // by gap
    bool isDone = false;                          // else they had not come to an end
};
// `roundingOf`: changes of a gap up to it are none. `isLoose`: by body.
[[nodiscard]] LeastWays leastWays(const std::vector<physics::PartGap>& gaps,
                                  const std::vector<char>& isLoose, int sweeps,
                                  const std::function<double(const physics::PartGap&)>& roundingOf);

} // namespace simulation
