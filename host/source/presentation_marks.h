// Which bytes of a presentation's file are what (docs/schemas.md).
#pragma once

#include "source/marks.h"

#include <string_view>

namespace source {

// In order and apart from each other, whatever the text is. Strings have no mark.
[[nodiscard]] std::vector<Mark> presentationMarks(std::string_view text);

} // namespace source
