// The restitution that goes along when a body is fixed or let loose.
//
// `body box block -restitution 0 -friction 0.3` stays where it falls. Fixed, it is a table: it
// never falls, and its 0 would only deaden what falls on it, as of two bodies the smaller counts.
// So the 0 goes with -fixed 1, and what meets a fixed body bounces as it does itself. A body with
// friction that is let loose gets it back; the others are ideal ones, which lose nothing.
#pragma once

#include "element_edits/property_edit.h"

namespace editing {

// The answer that fixes these bodies, or lets them loose, with the change of how they bounce. Where
// that cannot be written (a loop makes it) it stays as it is.
[[nodiscard]] Answer withBounce(const Properties& properties, const scene::Scene& scene,
                                const std::vector<Element>& bodies, bool fixed, Answer answer);

} // namespace editing
