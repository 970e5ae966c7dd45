// A case's bodies as a tree of joints, for engines with joint coordinates: each body hangs on an
// earlier one, on the world, or is free; the joints that are left close loops.
#pragma once

#include "cases.h"

#include <optional>

namespace bench::contacts {

// The joint on which a body hangs: a slider if it has one, else its first; none: it is free.
[[nodiscard]] std::optional<std::size_t> treeJoint(const Case& scene, std::size_t body);
// All others; hinges only.
[[nodiscard]] std::vector<std::size_t> loopJoints(const Case& scene);
// A hinge that closes a loop holds its bodies together there: at a point of its axis, which
// suffices in a plane, or else at two, a metre apart.
[[nodiscard]] std::vector<Place> closingPoints(const Case& scene, const Joint& hinge);
// The rate of a body's tree joint at the start.
[[nodiscard]] double treeRate(const Case& scene, std::size_t body);

} // namespace bench::contacts
