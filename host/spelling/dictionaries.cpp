#include "spelling/dictionaries.h"

#include <QDir>

namespace spelling {

namespace {

// "de-AT.UTF-8@euro" as "de_AT".
QString plainName(const QString& language) {
    QString name = language.section('.', 0, 0).section('@', 0, 0);
    name.replace('-', '_');
    return name.isEmpty() || name == "C" || name == "POSIX" ? QStringLiteral("en_US") : name;
}

Dictionary dictionaryIn(const QDir& folder, const QString& name) {
    const QString affixes = folder.filePath(name + ".aff"), words = folder.filePath(name + ".dic");
    return QFileInfo(affixes).isFile() && QFileInfo(words).isFile()
               ? Dictionary{name, affixes, words}
               : Dictionary{};
}

} // namespace

QStringList dictionaryFolders() {
    QStringList folders = qEnvironmentVariable("DICPATH").split(':', Qt::SkipEmptyParts);
    folders << QStringLiteral("/usr/share/hunspell") << QStringLiteral("/usr/share/myspell/dicts");
    return folders;
}

Dictionary dictionaryFor(const QString& language, const QStringList& folders) {
    const QString name = plainName(language);
    for (const QString& folder : folders)
        if (Dictionary found = dictionaryIn(QDir(folder), name); found.isThere())
            return found;
    const QString anyRegion = name.section('_', 0, 0);
    for (const QString& folder : folders)
        for (const QString& file : QDir(folder).entryList(
                 {anyRegion + ".dic", anyRegion + "_*.dic"}, QDir::Files, QDir::Name))
            if (Dictionary found = dictionaryIn(QDir(folder), file.chopped(4)); found.isThere())
                return found;
    return {name, {}, {}};
}

} // namespace spelling
