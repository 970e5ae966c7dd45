#include "spelling/speller.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextBoundaryFinder>
#include <hunspell/hunspell.hxx>

namespace spelling {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Speller", text); }

// Neither numbers, nor names with digits, nor single letters.
bool isChecked(QStringView word) {
    bool hasLetter = false;
    for (const QChar c : word) {
        if (c.isDigit() || c == '_')
            return false;
        hasLetter |= c.isLetter();
    }
    return hasLetter && word.size() > 1 && word.size() <= Speller::longestWord;
}

// In an address: name@place, www.place, /a/path.
bool isInAddress(const QString& text, qsizetype from, qsizetype to) {
    const auto isJoint = [&](qsizetype at) {
        return at >= 0 && at < text.size() && QStringLiteral("@/\\_").contains(text[at]);
    };
    const bool isDotted = to + 1 < text.size() && text[to] == '.' && text[to + 1].isLetter();
    const bool isBehindDot = from > 1 && text[from - 1] == '.' && text[from - 2].isLetter();
    return isJoint(from - 1) || isJoint(to) || isDotted || isBehindDot;
}

} // namespace

std::vector<Word> wordsOf(const QString& text) {
    std::vector<Word> words;
    QTextBoundaryFinder finder(QTextBoundaryFinder::Word, text);
    qsizetype from = 0;
    do {
        const QTextBoundaryFinder::BoundaryReasons why = finder.boundaryReasons();
        const qsizetype at = finder.position();
        if (why.testFlag(QTextBoundaryFinder::EndOfItem) &&
            isChecked(QStringView(text).mid(from, at - from)) && !isInAddress(text, from, at))
            words.push_back({static_cast<int>(from), static_cast<int>(at)});
        if (why.testFlag(QTextBoundaryFinder::StartOfItem))
            from = at;
    } while (finder.toNextBoundary() >= 0);
    return words;
}

Speller::Speller(const Dictionary& dictionary, const QString& ownWords)
    : language_(dictionary.language), ownFile_(ownWords) {
    if (!dictionary.isThere()) {
        whyNot_ = tr("No dictionary for %1 is installed: it is in the package hunspell-%2.")
                      .arg(language_, QString(language_).replace('_', '-').toLower());
        return;
    }
    hunspell_ = std::make_unique<Hunspell>(QFile::encodeName(dictionary.affixes).constData(),
                                           QFile::encodeName(dictionary.words).constData());
    const std::string encoding = hunspell_->get_dict_encoding();
    encode_ = QStringEncoder(encoding.c_str());
    decode_ = QStringDecoder(encoding.c_str());
    if (!encode_.isValid() || !decode_.isValid()) {
        hunspell_.reset();
        whyNot_ = tr("The dictionary for %1 is in letters that cannot be read (%2).")
                      .arg(language_, QString::fromStdString(encoding));
        return;
    }
    readOwnWords();
}

Speller::~Speller() = default;

void Speller::readOwnWords() {
    QFile file(ownFile_);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
        return;
    constexpr qint64 most = 1 << 20; // LIMIT: the file's first MiB is read
    for (const QByteArray& line : file.read(most).split('\n'))
        if (const QString word = QString::fromUtf8(line).trimmed(); !word.isEmpty())
            own_.insert(word);
}

// As dictionaries spell apostrophes; "": letters that the dictionary has not.
std::string Speller::spelled(const QString& word) {
    QString plain = word;
    plain.replace(QChar(0x2019), '\'');
    const QByteArray bytes = encode_.encode(plain);
    const bool hasAll = !encode_.hasError();
    encode_.resetState();
    return hasAll ? bytes.toStdString() : std::string();
}

bool Speller::isRight(const QString& word) {
    if (!hunspell_ || own_.contains(word) || word.size() > longestWord)
        return true;
    if (const auto at = known_.constFind(word); at != known_.constEnd())
        return *at;
    if (known_.size() >= mostKnown)
        known_.clear();
    ++lookedUp_;
    const std::string bytes = spelled(word);
    const bool isRight = !bytes.empty() && hunspell_->spell(bytes);
    known_.insert(word, isRight);
    return isRight;
}

QStringList Speller::suggestions(const QString& word) {
    QStringList result;
    const std::string bytes = hunspell_ ? spelled(word) : std::string();
    if (bytes.empty())
        return result;
    for (const std::string& one : hunspell_->suggest(bytes))
        if (result.size() < mostSuggestions)
            result << QString(decode_.decode(QByteArrayView(one)));
    return result;
}

QString Speller::add(const QString& word) {
    own_.insert(word);
    QDir().mkpath(QFileInfo(ownFile_).absolutePath());
    QFile file(ownFile_);
    const QByteArray line = word.toUtf8() + '\n';
    const bool isWritten =
        file.open(QIODevice::Append) && file.write(line) == line.size() && file.flush();
    return isWritten ? QString()
                     : tr("%1 could not be written: %2").arg(ownFile_, file.errorString());
}

void Speller::ignore(const QString& word) { own_.insert(word); }

} // namespace spelling
