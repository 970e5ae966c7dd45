// The language of text, and the signs that are typed in it.
#include "authoring/authoring.h"
#include "authoring/authoring_testing.h"
#include "document/faults.h"

#include <gtest/gtest.h>

namespace authoring {
namespace {

// A report of these blocks, written short.
class Written {
public:
    explicit Written(const std::string& body)
        : marked_(readMarks(renamed(head + body + tail, false))), document_(marked_.bytes),
          selection_(marked_.selection) {}

    template <class Command, class... Arguments>
    Written& with(Command command, Arguments... arguments) {
        take(command({document_, testGrammars()}, selection_, arguments...));
        return *this;
    }
    // Each letter as it is typed.
    Written& typing(const std::string& letters) {
        for (std::size_t i = 0; i < letters.size(); ++i) {
            with(type, std::string_view(letters).substr(i, 1));
            if (auto sign = signTyped({document_, testGrammars()}, selection_.caret))
                take(*std::move(sign));
        }
        return *this;
    }
    void undo() { document_.undo(); }
    [[nodiscard]] std::string body() const {
        const std::string all = renamed(document_.bytes(), true);
        return all.substr(head.size(), all.size() - head.size() - tail.size());
    }
    [[nodiscard]] std::string faults() const {
        std::string all;
        for (const sgml::Fault& fault : document::documentFaults(document_, testSchemas(), {}))
            all += fault.message + "\n";
        return all;
    }
    [[nodiscard]] const document::Document& document() const { return document_; }

    inline static const std::string head = "DOCUMENT REPORT\n<REPORT>\n", tail = "\n</REPORT>\n";

private:
    void take(Result result) {
        ASSERT_TRUE(std::holds_alternative<Step>(result))
            << std::get<Refusal>(result).why.toStdString();
        const Step& step = std::get<Step>(result);
        document_.edit(step.edits, step.label);
        selection_ = step.after;
    }

    Marked marked_;
    document::Document document_;
    Selection selection_;
};

TEST(LanguageTest, AParagraphTheLettersOfALineAndTheDocumentHaveIt) {
    EXPECT_EQ(Written("<P>{On|e}</P>").with(setLanguage, "de").body(), "<P LANG=\"de\">{One}</P>");
    EXPECT_EQ(Written("<P LANG=\"fr\">{On|e}</P>").with(setLanguage, "de").body(),
              "<P LANG=\"de\">{One}</P>");
    EXPECT_EQ(Written("<P>{[One|}</P>").with(setLanguage, "de").body(), "<P LANG=\"de\">{One}</P>");
    EXPECT_EQ(Written("<P>{a [word| b}</P>").with(setLanguage, "de").body(),
              "<P><T>{a }</T><T LANG=\"de\">{word}</T><T>{ b}</T></P>");
    EXPECT_EQ(Written("<P>{[a}</P>\n<L><I>{b|}</I><I>{c}</I></L>").with(setLanguage, "sv").body(),
              "<P LANG=\"sv\">{a}</P>\n<L><I LANG=\"sv\">{b}</I><I>{c}</I></L>");
    Written all("<P>{On|e}</P>");
    all.with(setDocumentLanguage, "pt-BR");
    EXPECT_TRUE(all.document().bytes().starts_with("DOCUMENT REPORT\n<REPORT LANG=\"pt-BR\">"));
    EXPECT_EQ(all.faults(), "");
}

TEST(LanguageTest, TheOneAroundIsNotSaidAgain) {
    EXPECT_EQ(Written("<S LANG=\"de\"><H>{h}</H><P LANG=\"fr\">{On|e}</P></S>")
                  .with(setLanguage, "de")
                  .body(),
              "<S LANG=\"de\"><H>{h}</H><P>{One}</P></S>");
    EXPECT_EQ(Written("<P LANG=\"de\"><T>{a }</T><T LANG=\"fr\">{[mot|}</T><T>{ b}</T></P>")
                  .with(setLanguage, "de")
                  .body(),
              "<P LANG=\"de\">{a mot b}</P>");
    EXPECT_EQ(
        Written("<P><T>{a }</T><T LANG=\"fr\">{[mot|}</T></P>").with(setLanguage, "es").body(),
        "<P><T>{a }</T><T LANG=\"es\">{mot}</T></P>");
}

TEST(LanguageTest, SignsAreTypedInTheLanguageOfTheText) {
    EXPECT_EQ(Written("<P>{|}</P>").typing("\"a\" -- -5...").body(), "<P>{“a” – −5…}</P>");
    EXPECT_EQ(Written("<P LANG=\"de\">{|}</P>").typing("\"a\"").body(), "<P LANG=\"de\">{„a“}</P>");
    EXPECT_EQ(Written("<P><T>{a }</T><T LANG=\"fr\">{|}</T></P>").typing("\"a\"").body(),
              "<P><T>{a }</T><T LANG=\"fr\">{«\u202Fa\u202F»}</T></P>");
    // The letters before it in the line count, whatever element they are in.
    EXPECT_EQ(Written("<P><E>{a}</E><T>{| b}</T></P>").typing("\"").body(),
              "<P><E>{a}</E><T>{” b}</T></P>");
    EXPECT_EQ(Written("<P>{a}</P><P>{|b}</P>").typing("\"").body(), "<P>{a}</P><P>{“b}</P>");
}

TEST(LanguageTest, NoSignIsMadeInCodeAndPreformattedText) {
    EXPECT_EQ(Written("<P><T>{a }</T><CODE>{|}</CODE></P>").typing("\"a\" --").body(),
              "<P><T>{a }</T><CODE>{\"a\" --}</CODE></P>");
    EXPECT_EQ(Written("<V>{|}</V>").typing("\"a\"...").body(), "<V>{\"a\"...}</V>");
}

TEST(LanguageTest, UndoTakesASignBackAndLeavesWhatWasTyped) {
    Written text("<P>{a|}</P>");
    text.typing("--");
    EXPECT_EQ(text.body(), "<P>{a–}</P>");
    text.undo();
    EXPECT_EQ(text.body(), "<P>{a--}</P>");
}

} // namespace
} // namespace authoring
