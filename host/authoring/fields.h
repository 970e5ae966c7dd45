// The lines of a form: what is one line only, such as a title or a name, and what is empty. Enter
// and Tab lead from one to the next.
#pragma once

#include "authoring/authoring.h"

namespace authoring {

// From the end of what is one line only to the line behind it, if that is empty.
[[nodiscard]] std::optional<Step> goToEmptyLine(const Manuscript& manuscript, Selection selection);
// From the end of any line to the line behind it.
[[nodiscard]] std::optional<Step> goToNextLine(const Manuscript& manuscript, Selection selection);

} // namespace authoring
