// The words of one language, by Hunspell, and the user's own.
#pragma once

#include "spelling/dictionaries.h"

#include <QHash>
#include <QSet>
#include <QStringDecoder>
#include <QStringEncoder>

#include <memory>
#include <vector>

class Hunspell;

namespace spelling {

// A word of a text.
struct Word {
    int from = 0, to = 0; // letters (UTF-16)
};
// Those that are to be checked: without digits, of two letters at least, no parts of addresses.
[[nodiscard]] std::vector<Word> wordsOf(const QString& text);

class Speller {
public:
    // `ownWords`: the file of the user's words, one a line, UTF-8; it need not exist.
    Speller(const Dictionary& dictionary, const QString& ownWords);
    ~Speller();
    Speller(const Speller&) = delete;
    Speller& operator=(const Speller&) = delete;

    // Why no word can be checked, as a sentence; "": they can.
    [[nodiscard]] const QString& whyNot() const { return whyNot_; }
    [[nodiscard]] const QString& language() const { return language_; }

    [[nodiscard]] bool isRight(const QString& word);
    [[nodiscard]] QStringList suggestions(const QString& word);
    // From now on, and in the user's file; "" or why it could not be written there.
    QString add(const QString& word);
    void ignore(const QString& word); // as long as this lives

    static constexpr int mostSuggestions = 7;
    // LIMIT: longer words are taken for right.
    static constexpr int longestWord = 80;
    static constexpr int mostKnown = 50'000; // words whose answer is kept
    // Words that were looked up, for tests.
    [[nodiscard]] int lookedUp() const { return lookedUp_; }

private:
    void readOwnWords();
    [[nodiscard]] std::string spelled(const QString& word);

    QString language_, ownFile_, whyNot_;
    std::unique_ptr<Hunspell> hunspell_;
    QStringEncoder encode_;
    QStringDecoder decode_;
    QSet<QString> own_; // added and ignored ones
    QHash<QString, bool> known_;
    int lookedUp_ = 0;
};

} // namespace spelling
