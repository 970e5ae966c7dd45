// Where would a reader stumble over the end of a line?
//
// Unicode's rules (UAX 14) say where a line may end. Of these places some tear what is read as one:
// a number, a number and its unit, a word that names and its number, a day and its month. Others
// are worse than a blank, such as the place behind a hyphen.
#pragma once

#include <QStringView>

namespace typography {

// Costs as Knuth and Plass count them: 0 for a blank, `never` for a place where no line ends.
inline constexpr int never = 10'000;
inline constexpr int atHyphen = 50; // one that is written, or that the end of a line brings

// Of a place between two letters of a text where Unicode's rules let a line end; `at` is the letter
// that the next line would begin with. Reads a few words around it.
[[nodiscard]] int costOfBreak(QStringView text, qsizetype at);

} // namespace typography
