// An edit of the text, line by line, as a label shows it before it is made.
#pragma once

#include "text/edit.h"

#include <QString>

namespace views {

[[nodiscard]] QString previewOf(const std::string& text, const text::Edits& edits);

} // namespace views
