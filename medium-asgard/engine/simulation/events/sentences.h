// What an author reads of bodies that meet.
#pragma once

#include "contacts/colliders.h"

#include <set>
#include <string>

namespace simulation::sentences {

[[nodiscard]] std::string quoted(const Colliders& world, std::size_t body);
[[nodiscard]] std::string bodies(const Colliders& world, const Pair& pair); // bodies "a" and "b"
[[nodiscard]] std::string capital(std::string sentence);

// Why a motion ends.
[[nodiscard]] std::string leaning(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string lost(const Colliders& world, const Pair& pair, bool bothGiveWay);
[[nodiscard]] std::string withoutEnd(const Colliders& world, const Pair& pair,
                                     bool isBetweenSeveral);
[[nodiscard]] std::string onlyEdges(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string onRim(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string throughWall(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string wideBall(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string closedMouth(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string meetsEnded(const Colliders& world, std::size_t body, std::size_t ended,
                                     double time);
[[nodiscard]] std::string missed(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string restless(const Colliders& world, std::size_t body);

[[nodiscard]] std::string unsolved(const Colliders& world, const Pair& pair);
// Those that give way between those that do not; joints that drive these.
[[nodiscard]] std::string crushed(const scene::Scene& scene, const std::set<std::size_t>& pressed,
                                  const std::set<std::size_t>& between,
                                  const std::set<std::string>& drives);
// What is noted beside a motion that goes on.
[[nodiscard]] std::string passThrough(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string overlap(const Colliders& world, const Pair& pair);
[[nodiscard]] std::string noRoom(const Colliders& world, std::size_t body,
                                 const std::set<std::size_t>& between);
[[nodiscard]] std::string noHinge(const Colliders& world, std::size_t body);

} // namespace simulation::sentences
