// Texts that are one number, as in a cell of a table.
#pragma once

#include <QString>
#include <QStringView>

#include <optional>

namespace typography {

// The place of the number's point, or of one that is not written: behind its last whole digit. The
// number may have a sign before it ("±", "<", "≈", "$"), groups of digits, a power, and a unit or
// "%" behind it. Nothing: the text is something else. A comma is the point where the language has
// it so: not in English, where it divides groups of three digits.
[[nodiscard]] std::optional<qsizetype> pointOf(QStringView text, const QString& language);

// Says that there is no number: empty, a dash.
[[nodiscard]] bool isNoNumber(QStringView text);

} // namespace typography
