#include "source/presentation_draft.h"
#include "source/presentation_marks.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QTemporaryDir>

namespace source {
namespace {

using ::testing::ElementsAre;

class DraftTest : public ::testing::Test {
protected:
    [[nodiscard]] QString own() const { return folder_.filePath("schemas"); }
    [[nodiscard]] std::string read(const QString& path) const {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "none";
    }
    void write(const QString& path, const char* text) const {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    QTemporaryDir folder_;
    const schemas::Schemas::File builtIn_{"MEMO.default.presentation", ":/x", "A { show: no }\n"};
};

TEST_F(DraftTest, AFileOfTheProgramIsCopiedIntoTheUsersFolder) {
    PresentationDraft draft(builtIn_, own());
    EXPECT_TRUE(draft.isCopy());
    EXPECT_EQ(draft.savedText(), builtIn_.text);
    EXPECT_EQ(read(draft.path()), "none");
    ASSERT_TRUE(draft.save("B { }\n", {}));
    EXPECT_FALSE(draft.isCopy());
    EXPECT_EQ(read(own() + "/MEMO.default.presentation"), "B { }\n");
    EXPECT_EQ(PresentationDraft(builtIn_, own()).savedText(), "B { }\n");
}

TEST_F(DraftTest, WhatAnotherProgramWroteIsNotReplacedUnasked) {
    PresentationDraft draft(builtIn_, own());
    ASSERT_TRUE(draft.save("mine", {}));
    write(draft.path(), "theirs");
    EXPECT_EQ(draft.save("more", {}).refusal, files::Refusal::changed);
    EXPECT_EQ(read(draft.path()), "theirs");
    EXPECT_TRUE(draft.save("more", {.evenChanged = true}));
    EXPECT_EQ(read(draft.path()), "more");
}

TEST(PresentationMarks, SayWhatIsSelectorPropertyAndValue) {
    const std::string text = "/* c */ROW:first {font: \"a;b\" bold; x}B";
    std::vector<std::string> marked;
    for (const Mark& mark : presentationMarks(text))
        marked.push_back(std::to_string(static_cast<int>(mark.kind)) +
                         text.substr(mark.range.from, mark.range.size()));
    EXPECT_THAT(marked,
                ElementsAre("6/* c */", "1ROW:first ", "2font", "3 ", "3 bold", "2 x", "1B"));
}

// Text is typed in all places: in order, apart, inside the text.
TEST(PresentationMarks, AreSoundOfAnyText) {
    const std::string pieces[] = {"{", "}", ":", ";", "\"", "\n", "/*", "*/", "a", " "};
    for (std::size_t seed = 0; seed < 5000; ++seed) {
        std::string text;
        for (std::size_t i = seed; i > 0; i /= std::size(pieces))
            text += pieces[i % std::size(pieces)];
        std::size_t at = 0;
        for (const Mark& mark : presentationMarks(text)) {
            ASSERT_LE(at, mark.range.from) << text;
            ASSERT_LT(mark.range.from, mark.range.to) << text;
            at = mark.range.to;
        }
        ASSERT_LE(at, text.size());
    }
}

} // namespace
} // namespace source
