#include "typography/hyphenation.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <hyphen.h>
#include <iconv.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace typography {

namespace {

constexpr qsizetype shortest = 5, longest = 60; // letters of a word that may be divided

// From UTF-8 into the signs that the patterns are written in.
class Converter {
public:
    explicit Converter(const char* to) : state_(iconv_open(to, "UTF-8")) {}
    ~Converter() {
        if (works())
            iconv_close(state_);
    }
    Converter(const Converter&) = delete;
    Converter& operator=(const Converter&) = delete;

    [[nodiscard]] bool works() const { return state_ != iconv_t(-1); }
    // Nothing: the patterns do not know some letter.
    [[nodiscard]] std::optional<std::string> converted(std::string text) const {
        std::string result(text.size() + 1, '\0');
        char *from = text.data(), *to = result.data();
        std::size_t left = text.size(), room = result.size();
        if (iconv(state_, &from, &left, &to, &room) == static_cast<std::size_t>(-1))
            return std::nullopt;
        result.resize(result.size() - room);
        return result;
    }

private:
    iconv_t state_;
};

// The patterns of a language.
class Patterns {
public:
    explicit Patterns(const QString& file)
        : dictionary_(hnj_hyphen_load(QFile::encodeName(file).constData())) {
        if (dictionary_ && !dictionary_->utf8)
            converter_ = std::make_unique<Converter>(dictionary_->cset);
    }

    // The letters of a word before which it may be divided.
    [[nodiscard]] std::vector<int> placesIn(const QString& word) const {
        if (!dictionary_ || (converter_ && !converter_->works()))
            return {};
        std::optional<std::string> bytes = word.toLower().toStdString();
        if (converter_)
            bytes = converter_->converted(std::move(*bytes));
        if (!bytes || bytes->empty())
            return {};
        const auto size = static_cast<int>(bytes->size());
        std::string marks(bytes->size() + 5, '\0');
        char** replaced = nullptr;
        int *places = nullptr, *cuts = nullptr;
        const int least = 2;
        const int failed = hnj_hyphen_hyphenate3(
            dictionary_.get(), bytes->data(), size, marks.data(), nullptr, &replaced, &places,
            &cuts, std::max<int>(dictionary_->lhmin, least),
            std::max<int>(dictionary_->rhmin, least), dictionary_->clhmin, dictionary_->crhmin);
        std::vector<int> result;
        for (int i = 0; failed == 0 && i + 1 < word.size(); ++i)
            if (marks[static_cast<std::size_t>(i)] & 1 && !(replaced && replaced[i]))
                result.push_back(i + 1);
        for (int i = 0; replaced && i < size; ++i)
            std::free(replaced[i]);
        std::free(replaced);
        std::free(places);
        std::free(cuts);
        return result;
    }

private:
    struct Free {
        void operator()(HyphenDict* of) const { hnj_hyphen_free(of); }
    };
    std::unique_ptr<HyphenDict, Free> dictionary_;
    std::unique_ptr<Converter> converter_;
};

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
    return word.size() >= shortest && word.size() <= longest &&
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
            const QString file = folder + "/hyphen/hyph_" + one + ".dic";
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
            for (const int place : of->placesIn(word.toString()))
                result.push_back(static_cast<int>(from) + place);
        i = end;
    }
    return result;
}

} // namespace typography
