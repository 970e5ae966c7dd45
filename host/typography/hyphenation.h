// Where may a word be divided? Patterns of its language say it, which are files of the system:
// `hyph_en_US.dic` in the folder `hyphen` of a data folder. A language without patterns is not
// hyphenated.
#pragma once

#include <QString>
#include <QStringView>

#include <vector>

namespace typography {

// Places in a text, each the letter that the next line would begin with: in words of letters alone
// that are not short, not in capitals and do not have a hyphen. `language`: as in documents, "de",
// "en-GB"; for a country without patterns those of its language count.
[[nodiscard]] std::vector<int> placesInWords(QStringView text, const QString& language);

// The file of a language's patterns, or "".
[[nodiscard]] QString patternsOf(const QString& language);

} // namespace typography
