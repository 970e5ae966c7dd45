// Which ropes of a motion are not as ropes over wheels would be?
#pragma once

#include "dense/histories.h"
#include "run/problem.h"

#include <string>
#include <vector>

namespace simulation {

// Of a rope that would lift off a wheel beside another wheel, and of one that leaves the plane of
// its wheel: sentences, at the first time.
void addRopeNotes(const Problem& problem, const solution::Histories& histories, double until,
                  std::vector<std::string>& notes);

} // namespace simulation
