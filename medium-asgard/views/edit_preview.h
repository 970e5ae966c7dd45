// An edit of the text, line by line, as a label shows it before it is made.
#pragma once

#include "editing/text_edit.h"

#include <QString>

namespace views {

[[nodiscard]] QString previewOf(const std::string& text,
                                const std::vector<editing::TextEdit>& edits);

} // namespace views
