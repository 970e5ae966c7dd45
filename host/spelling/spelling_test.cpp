// Words against a small dictionary, and the one of the system where there is one.
#include "spelling/speller.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QTemporaryDir>

namespace spelling {
namespace {

using ::testing::ElementsAre;

class SpellingTest : public ::testing::Test {
protected:
    void install(const QString& name, const QByteArray& words,
                 const QByteArray& affixes = "SET UTF-8\nTRY esianrtolcdugmphbyfvkwz\n") {
        write(name + ".aff", affixes);
        write(name + ".dic", words);
    }
    void write(const QString& name, const QByteArray& bytes) {
        QFile file(folder_.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    [[nodiscard]] Dictionary dictionary(const QString& language) const {
        return dictionaryFor(language, {folder_.path()});
    }
    [[nodiscard]] QString own() const { return folder_.filePath("own/words"); }
    static std::vector<std::string> words(const QString& text) {
        std::vector<std::string> result;
        for (const Word& word : wordsOf(text))
            result.push_back(text.mid(word.from, word.to - word.from).toStdString());
        return result;
    }

    QTemporaryDir folder_;
};

TEST_F(SpellingTest, WordsAreWhatIsWrittenInLetters) {
    EXPECT_THAT(words("The cat's 3 m2, x and e\u0301te\u0301."),
                ElementsAre("The", "cat's", "and", "e\u0301te\u0301"));
    EXPECT_THAT(words("at me@home.org or www.home.org, see /usr/bin or file_name. End.Of"),
                ElementsAre("at", "or", "see", "or"));
    EXPECT_THAT(words(""), ElementsAre());
}

TEST_F(SpellingTest, ADictionaryIsFoundByLanguage) {
    install("en_GB", "1\ncolour\n");
    install("de_DE", "1\nFarbe\n");
    EXPECT_EQ(dictionary("de_DE.UTF-8").language, "de_DE");
    EXPECT_EQ(dictionary("de-AT").language, "de_DE");
    EXPECT_EQ(dictionary("C").language, "en_GB");
    EXPECT_FALSE(dictionary("fr_FR").isThere());
    Speller none(dictionary("fr_FR"), own());
    EXPECT_THAT(none.whyNot().toStdString(), ::testing::HasSubstr("hunspell-fr-fr"));
    EXPECT_TRUE(none.isRight("xyz"));
}

TEST_F(SpellingTest, WordsAreRightOrHaveSuggestions) {
    install("en_US", "3\nmotion\ndon't\nforce\n");
    Speller speller(dictionary("en_US"), own());
    EXPECT_EQ(speller.whyNot(), "");
    EXPECT_TRUE(speller.isRight("motion"));
    EXPECT_TRUE(speller.isRight("Motion")); // at the start of a sentence
    EXPECT_TRUE(speller.isRight(QString("don\u2019t")));
    EXPECT_FALSE(speller.isRight("motoin"));
    EXPECT_EQ(speller.suggestions("motoin").value(0), "motion");
    const int lookedUp = speller.lookedUp();
    EXPECT_FALSE(speller.isRight("motoin"));
    EXPECT_EQ(speller.lookedUp(), lookedUp);
}

TEST_F(SpellingTest, OldDictionariesHaveLettersOfTheirOwn) {
    install("de_DE", "1\nM\xfche\n", "SET ISO8859-1\n");
    Speller speller(dictionary("de_DE"), own());
    EXPECT_EQ(speller.whyNot(), "");
    EXPECT_TRUE(speller.isRight(QString("M\u00FChe")));
    EXPECT_FALSE(speller.isRight(QString("Mu\u4F60")));
}

TEST_F(SpellingTest, TheUsersWordsAreKept) {
    install("en_US", "1\nmotion\n");
    {
        Speller speller(dictionary("en_US"), own());
        EXPECT_FALSE(speller.isRight("Asgard"));
        EXPECT_EQ(speller.add("Asgard"), "");
        speller.ignore("hammr");
        EXPECT_TRUE(speller.isRight("Asgard"));
        EXPECT_TRUE(speller.isRight("hammr"));
    }
    Speller again(dictionary("en_US"), own());
    EXPECT_TRUE(again.isRight("Asgard"));
    EXPECT_FALSE(again.isRight("hammr"));
    Speller nowhere(dictionary("en_US"), "/proc/no/such/file");
    EXPECT_NE(nowhere.add("x"), "");
}

} // namespace
} // namespace spelling
