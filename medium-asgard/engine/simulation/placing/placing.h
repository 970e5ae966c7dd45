// The places at which bodies begin, so that the joints of a scene are closed and no two overlap.
//
// An author rounds: a coin of radius 0.1 that leans by 0.05 stands on the floor at 0.100125, and is
// written at 0.1001. Bodies that overlap by little begin where they touch, as a joint that misses
// by little begins closed. Of more the motion tells, and placed() offers places for them.
#pragma once

#include "collision/broad_phase.h"
#include "physics/assembly.h"
#include "physics/equations_of_motion.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace simulation {

// The free bodies as they stand when joints are closed and bodies have moved apart, by the smallest
// movement; `cancelled` is asked now and then.
//
// LIMIT: bodies on a joint may turn, and a face that lies on another one counts with the same
// depth at all its corners once it has tilted. Two hinged boxes, the lower one deep in a floor,
// may therefore find no room, and the answer names the overlap that is left.
[[nodiscard]] physics::Assembly placed(const scene::Scene& scene,
                                       const std::function<bool()>& cancelled = nullptr);

// That bodies overlap at the start, how deep, and what comes of it: one for each heap
// (told_heaps.h), by its deepest pair.
enum class Begin { movedApart, throughEachOther };
[[nodiscard]] std::vector<std::string>
overlapSentences(const scene::Scene& scene, const std::map<collision::Pair, double>& depths,
                 Begin begin);
// Those of a scene; and that bodies hop (hops.h).
[[nodiscard]] std::vector<std::string> startSentences(const scene::Scene& scene);

// Bodies that overlap others by little (overlaps.h), where they touch them. They are moved by the
// least way and not turned, again where that makes a new overlap, each heap by itself, so that what
// an edit does not concern stays to the last bit. A heap that finds no room stays as it is.
//
// LIMIT: a body that a joint, a gear or a rope holds, or a trajectory, is not moved: Move Apart
// finds places for the first three.
struct Touching {
    std::vector<physics::Assembly::Moved> moved;
    std::vector<std::string> notes; // of those that overlap by more than 1e-5 of the smaller body
};
// `equations`, and `shapes` by body: of the scene.
[[nodiscard]] Touching touching(const scene::Scene& scene,
                                const physics::EquationsOfMotion& equations,
                                const std::vector<geometry::Shape>& shapes);

} // namespace simulation
