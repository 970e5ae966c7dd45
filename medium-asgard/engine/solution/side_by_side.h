// Components that read nothing of each other; alike ones are stepped side by side (alike_steps.h).
//
// Alike are those with one model (component_model.h) at the time. A component is in a lane while it
// is in stride (component.h): before, and wherever something else than an ordinary step is to be
// made, it steps alone, and then comes back. A lane that is left is taken by the next component.
// The motion of each has the same bits as alone, and its counts are the same, whoever is beside it.
#pragma once

#include "stepping/component.h"

#include <functional>
#include <span>

namespace solution {

// At least one step of each, then on until it has reached `until` or ended. `goesOn` is asked
// between steps, with the time of one of them; false: that is enough.
void advanceSideBySide(std::span<Component* const> components, double until,
                       const std::function<bool(double)>& goesOn);

} // namespace solution
