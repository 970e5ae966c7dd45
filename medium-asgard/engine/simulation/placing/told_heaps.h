// Pairs of bodies that one sentence tells of, as one cause is one message.
//
// A stack whose boxes are all a little too near each other has one mistake. Pairs belong together
// where a free body is in both; the floor connects nothing.
#pragma once

#include "collision/broad_phase.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace simulation {

struct ToldHeap {
    collision::Pair first; // of the largest size; of equal ones the first pair
    double size = 0;
    std::vector<collision::Pair> others;
};
[[nodiscard]] std::vector<ToldHeap> toldHeaps(const scene::Scene& scene,
                                              const std::map<collision::Pair, double>& sizes);

// The bodies of all its pairs, beginning with the two of the first pair; a body that is in several
// pairs comes several times.
[[nodiscard]] std::vector<std::size_t> bodiesIn(const ToldHeap& heap);

// Fixed, or held by a trajectory at some time.
[[nodiscard]] bool isHeld(const scene::Scene& scene, std::size_t body);

// 'Bodies "a" and "b"'; first the one that is not fixed, where the fault stands.
[[nodiscard]] std::string bodiesOf(const scene::Scene& scene, const collision::Pair& pair);
// Of a length, as people write it.
[[nodiscard]] std::string lengthOf(double length);
// '2 more pairs COMPARED ("b" and "c", "c" and "d"); they '. Nothing of one pair alone, and no
// names of many.
[[nodiscard]] std::string othersOf(const scene::Scene& scene, const ToldHeap& heap,
                                   std::string_view compared);

} // namespace simulation
