// A new table whose columns all have the same width.
#pragma once

#include "authoring/authoring.h"

namespace authoring {

// `columnWidth`: in points; 0: as wide as their content wants, as insertTable() makes them.
[[nodiscard]] Result insertTable(const Manuscript& manuscript, Selection selection,
                                 const NewTable& table, double columnWidth);

} // namespace authoring
