// Which numbers of a loop or of a procedure's calls would give one of its elements a value.
//
// A loop computes its elements from few numbers: the elements of a foreach's list, the start and
// the step of a for, the arguments of a procedure's calls, and the numbers in [expr {...}]. A value
// that depends on one of them linearly says what that number would have to be; the expression is
// then worked out with it as Tcl does. An offer must come out as it says: the values worked out for
// the present text must equal those of the scene, for all elements of the command; with the new
// number they must be the wanted values; and nothing else may read the number, so that names, the
// number of elements and everything else stay.
//
// LIMIT: loops and procedures at the top of the script, the element's command directly in them;
// a foreach over one list that is written out; calls with literal arguments.
#pragma once

#include "editing/overrides.h"

namespace editing {

[[nodiscard]] std::vector<Offer> loopOffers(const Making& making, const Wish& wish,
                                            const Origins& origins);

} // namespace editing
