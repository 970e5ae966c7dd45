// The engine's facade: a scene in, motion out.
//
// simulate() is the whole of it for batch use. Interactive use calls it on a worker thread with an
// Observer: progress publishes partial motion, cancelled() is polled at least every few
// milliseconds. The same scene and options give the same bits, whatever the thread, the observer
// or the machine's load.
#pragma once

#include "accuracy/result.h"
#include "run/options.h"
#include "run/quantities.h"
#include "scene/scene.h"

namespace simulation {

[[nodiscard]] Result simulate(const scene::Scene& scene, const Options& options = {},
                              const Observer& observer = {});

} // namespace simulation
