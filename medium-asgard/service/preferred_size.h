// How large a picture of a scene would like to be in a text.
#pragma once

#include "ipc/messages.h"
#include "motion/motion.h"
#include "scene/scene.h"

namespace service {

// As wide as the column up to a limit; as high as what is seen needs, between a flat strip and a
// square. Sizes at scale 1.
[[nodiscard]] ipc::PreferredSize preferredSize(const scene::Scene* scene,
                                               const simulation::MotionPointer& motion,
                                               double availableWidth,
                                               std::optional<double> availableHeight);

} // namespace service
