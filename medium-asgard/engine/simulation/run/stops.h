// Why did a motion end, in an author's words?
//
// The solver says which unknowns ended and by what sign; here the force or link to blame is found,
// and what an author can do about it is said. Motion in closed form that goes over 1e100 ends here:
// the solver has no end for it.
#pragma once

#include "run/run.h"

namespace simulation {

// Joints of these bodies that contradict each other, where nothing is held and nothing driven,
// stand in a singular position: they can move on in several ways.
[[nodiscard]] bool areSingular(const scene::Scene& scene, const std::vector<std::size_t>& bodies);

// The joints of these bodies that have a -speed or a -position.
[[nodiscard]] std::vector<const scene::Joint*> drivenOf(const scene::Scene& scene,
                                                        const std::vector<std::size_t>& bodies);

// By body, of what is known up to a time.
[[nodiscard]] std::map<std::size_t, Stop> stopsOf(const Problem& problem,
                                                  const solution::Histories& histories,
                                                  const ContactLog& contacts, double until);

} // namespace simulation
