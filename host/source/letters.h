// The letters of a text widget, as they are: with LF for the ends of its lines.
#pragma once

#include <QTextDocument>

namespace source {

[[nodiscard]] QString lettersOf(QTextDocument& text, int from, int to);
[[nodiscard]] QString lettersOf(QTextDocument& text); // all

} // namespace source
