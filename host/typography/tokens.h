// Words that are read as one with the number beside them.
#pragma once

#include <QStringView>

namespace typography {

[[nodiscard]] bool isDigit(QChar sign); // 0 to 9
[[nodiscard]] bool isDash(QChar sign);  // longer than a hyphen
// A sign that stands between two amounts: + = <.
[[nodiscard]] bool isOperator(QChar sign);

// "kg", "m/s", "N·m": its first unit is known.
[[nodiscard]] bool isUnit(QStringView word);
// "March", "Sept.", "März", "mars"
[[nodiscard]] bool isMonth(QStringView word);
// "Figure", "Fig.", "No.", "Abbildung", "page", "§": what it names is the number behind it.
[[nodiscard]] bool namesANumber(QStringView word);
// "Dr.": goes with the name behind it.
[[nodiscard]] bool isTitle(QStringView word);

// Without brackets, quotes and signs of a sentence at its end or its beginning.
[[nodiscard]] QStringView withoutEnd(QStringView word);
[[nodiscard]] QStringView withoutBeginning(QStringView word);

} // namespace typography
