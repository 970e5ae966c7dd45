// The values of a scene that users choose from: what an author shows in plots and parameters, and
// the motion of each body.
#pragma once

#include "ipc/messages.h"
#include "scene/scene.h"

namespace service {

// LIMIT: of many bodies the first ones. Any other expression may be asked for.
inline constexpr std::size_t mostBodiesOffered = 100;

[[nodiscard]] ipc::ValueOffers offeredValues(const scene::Scene& scene);

} // namespace service
