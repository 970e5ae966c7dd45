// The places of a variable's name in a script's text.
//
// Seen as text, so that a use inside of quotes, expressions and lists counts: callers want to be
// sure that there is none. Computed names (eval, upvar, names put together) do not show.
#pragma once

#include "editing/origin.h"

namespace editing {

// Offsets of the name as a whole word, not in comments and not as an option ("-x").
[[nodiscard]] std::vector<std::size_t> usesOf(const std::string& name, scene::Range where,
                                              const Origins& origins);
// Whether it stands in `where`, but not in any of those ranges.
[[nodiscard]] bool isUsedIn(const std::string& name, scene::Range where,
                            const std::vector<scene::Range>& except, const Origins& origins);
// Whether a command there may read or write variables that its text does not name.
[[nodiscard]] bool hidesUses(scene::Range where, const Origins& origins);
// Whether a number that comes through a variable or a parameter is read for those of the word's
// numbers alone (`all`) that come from it too.
[[nodiscard]] bool isOnlyIn(scene::Range word, const std::vector<Origin>& all, const Origin& origin,
                            const Origins& origins);

// Whether the parameter that it comes through, if it does, may have that value.
[[nodiscard]] bool mayBecome(const Origin& origin, double value, const Origins& origins);
// Whether it may be evaluated once more, or not at all: what it computes depends on nothing that it
// changes, and changes nothing.
[[nodiscard]] bool isPure(scene::Range where, const Origins& origins);

} // namespace editing
