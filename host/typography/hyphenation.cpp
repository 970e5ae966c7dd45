#include "typography/hyphenation.h"

#include "typography/patterns.h"

#include <QFile>
#include <QStandardPaths>

#include <algorithm>
#include <map>
#include <memory>

namespace typography {

namespace {

constexpr qsizetype shortest = 5, longestDivided = 60; // letters of a word that may be divided

// Null: there are none.
const Patterns* patterns(const QString& language) {
    static auto& known = *new std::map<QString, std::unique_ptr<Patterns>>;
    const auto [place, isNew] = known.try_emplace(language);
    if (const QString file = isNew ? patternsOf(language) : QString(); !file.isEmpty())
        place->second = std::make_unique<Patterns>(file);
    return place->second.get();
}

bool mayBeDivided(QStringView word) {
    const auto isSmall = [](QChar letter) { return letter.isLower() || letter.isMark(); };
    // Letters beyond the first plane are counted otherwise by patterns.
    const auto isPlain = [](QChar letter) { return !letter.isSurrogate() && !letter.isMark(); };
    return word.size() >= shortest && word.size() <= longestDivided &&
           std::ranges::any_of(word, isSmall) && std::ranges::all_of(word, isPlain);
}

bool isOfWord(QChar letter) { return letter.isLetter() || letter.isMark(); }

} // namespace

QString patternsOf(const QString& language) {
    QString name = language;
    name.replace('-', '_');
    const QString own = name.section('_', 0, 0).toLower();
    if (own.isEmpty())
        return {};
    const QString country = name.section('_', 1, 1).toUpper();
    QStringList names{own + '_' + country, own + '_' + own.toUpper(), own};
    if (own == "en")
        names.insert(1, "en_US");
    for (const QString& one : names)
        for (const QString& folder :
             QStandardPaths::standardLocations(QStandardPaths::GenericDataLocation)) {
            QString file = folder + "/hyphen/hyph_" + one + ".dic";
            if (QFile::exists(file))
                return file;
        }
    return {};
}

std::vector<int> placesInWords(QStringView text, const QString& language) {
    const Patterns* of = language.isEmpty() ? nullptr : patterns(language);
    std::vector<int> result;
    for (qsizetype i = 0; of && i < text.size();) {
        if (text[i].isSpace()) {
            ++i;
            continue;
        }
        // All of what stands between blanks: in an address or a name of a program nothing is.
        qsizetype end = i;
        while (end < text.size() && !text[end].isSpace())
            ++end;
        qsizetype from = i, to = end;
        while (from < to && !isOfWord(text[from]))
            ++from;
        while (to > from && !isOfWord(text[to - 1]))
            --to;
        const QStringView word = text.sliced(from, to - from);
        if (std::ranges::all_of(word, isOfWord) && mayBeDivided(word))
            for (const int place : of->placesIn(word.toString().toLower()))
                result.push_back(static_cast<int>(from) + place);
        i = end;
    }
    return result;
}

} // namespace typography
