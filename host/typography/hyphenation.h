// Where may a word be divided? libhyphen says it by patterns of the word's language, which are
// files of the system: `hyph_en_US.dic` in the folder `hyphen` of a data folder. A language without
// patterns is not hyphenated.
#pragma once

#include <QString>
#include <QStringView>

#include <vector>

namespace typography {

// Places in a text, each the letter that the next line would begin with: in words of letters alone
// that are not short, not in capitals and do not have a hyphen. `language`: as in documents, "de",
// "en-GB"; of a country without patterns those of its language count. LIMIT: words that change
// where they are divided (German "ck" of old) stay whole there.
[[nodiscard]] std::vector<int> placesInWords(QStringView text, const QString& language);

// The file of a language's patterns, or "".
[[nodiscard]] QString patternsOf(const QString& language);

} // namespace typography
