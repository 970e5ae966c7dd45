// The dictionaries of Hunspell that are installed.
#pragma once

#include <QString>
#include <QStringList>

namespace spelling {

struct Dictionary {
    QString language;       // "de_DE"
    QString affixes, words; // files; "": none is installed
    [[nodiscard]] bool isThere() const { return !words.isEmpty(); }
};

// DICPATH, then the system's.
[[nodiscard]] QStringList dictionaryFolders();
// For "de_AT", "de-AT.UTF-8": that, else the first one of the same language. For "" and "C" it is
// English.
[[nodiscard]] Dictionary dictionaryFor(const QString& language, const QStringList& folders);

} // namespace spelling
