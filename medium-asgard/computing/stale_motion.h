// The motion of an older scene, shown until that of the new one is computed.
//
// At the start bodies stand and move as the new scene says, so that what is dragged follows the
// hand; later they are where they were before. A scene that starts later than the old motion, as a
// throw makes it, begins there.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <memory>

namespace computing {

// None: the scenes have other bodies, and the motion says nothing of the new ones.
[[nodiscard]] simulation::MotionPointer staleMotion(const scene::Scene& before,
                                                    const simulation::MotionPointer& motion,
                                                    std::shared_ptr<const scene::Scene> now);

} // namespace computing
