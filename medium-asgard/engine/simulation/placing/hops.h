// Which bodies would hop for ever on those that they seem to stand on?
//
// A stack that is written with its boxes a millionth too high hops, unseen, and every hop is
// computed. A narrow gap closes under the weights where bodies that cannot follow stop it: the
// floor, and in turn all that stands on it. Gauss's principle (least_ways.h) over all contacts and
// narrow gaps at rest tells which of them would bear: two boxes that fall together do not meet.
//
// Bodies that trajectories move at the start do so here, and those that hang together by joints,
// gears and ropes move as these and their -speed and -position let them: a stack may ride on a
// lift, or on a platform that is joined to one.
//
// LIMIT: how these bodies gather speed is not read. Bodies count as equally heavy, without friction
// and turning. A box that friction holds on a slope a hair above another one is told to hop. Bodies
// with a spring, a link, or a force other than a weight are left out: no hop of theirs is told, nor
// one on them. The search for what bears ends after a thousand sweeps, and of very tall stacks the
// last forces may then be wrong.
#pragma once

#include "geometry/shape.h"
#include "physics/equations_of_motion.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace simulation {

// `equations`, and `shapes` by body: of the scene.
[[nodiscard]] std::vector<std::string> hopSentences(const scene::Scene& scene,
                                                    const physics::EquationsOfMotion& equations,
                                                    const std::vector<geometry::Shape>& shapes);

} // namespace simulation
