#include "session/file_follower.h"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace session {
namespace {

using ::testing::HasSubstr;
using State = FileFollower::State;

const std::string before =
    "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Test}</SUBJECT>\n<BODY>\n<PARAGRAPH>{one two three}"
    "</PARAGRAPH>\n<PARAGRAPH>{four five six}</PARAGRAPH>\n</BODY>\n</CMEMO>\n";

std::string with(const std::string& text, const std::string& words, const std::string& others) {
    std::string result = text;
    return result.replace(result.find(words), words.size(), others);
}

class FileFollowerTest : public ::testing::Test {
protected:
    void SetUp() override {
        write(before);
        document_ = document::Document::load(name_).document;
        ASSERT_TRUE(document_);
        file_ = std::make_unique<FileFollower>(
            *document_, FileFollower::Waits{.soon = 1, .again = 20, .patience = 60'000});
        QObject::connect(file_.get(), &FileFollower::told,
                         [this](const QString& sentence) { told_ = sentence.toStdString(); });
    }
    void write(const std::string& text, const QString& to = {}) const {
        QFile file(to.isEmpty() ? name_ : to);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text.data(), static_cast<qint64>(text.size()));
    }
    static void waitFor(const std::function<bool()>& done) {
        while (!done())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    void type(const std::string& words, const std::string& others) const {
        const std::size_t at = document_->bytes().find(words);
        ASSERT_EQ(document_->edit({{{at, at + words.size()}, others}}, "Edit"),
                  document::EditResult::applied);
    }

    QTemporaryDir folder_;
    QString name_ = folder_.filePath("a.ens");
    std::unique_ptr<document::Document> document_;
    std::unique_ptr<FileFollower> file_;
    std::string told_;
};

TEST_F(FileFollowerTest, WhatAnotherProgramWritesIsReadAndIsSaved) {
    const std::string theirs = with(before, "two", "2");
    write(theirs);
    waitFor([&] { return document_->bytes() == theirs; });
    EXPECT_FALSE(document_->isModified());
    EXPECT_THAT(told_, HasSubstr("a.ens was changed by another program"));
    EXPECT_EQ(file_->state(), State::quiet);
    document_->undo(); // the text from before can be had back, and saved without a question
    EXPECT_EQ(document_->bytes(), before);
    EXPECT_TRUE(document_->isModified());
    EXPECT_TRUE(document_->save());
}

TEST_F(FileFollowerTest, AFileThatIsReplacedIsFollowedAgainAndAgain) {
    for (const std::string word : {"2", "zwei", "deux"}) {
        const std::string theirs = with(before, "two", word);
        write(theirs, name_ + ".new");
        ASSERT_EQ(std::rename(qPrintable(name_ + ".new"), qPrintable(name_)), 0);
        waitFor([&] { return document_->bytes() == theirs; });
        EXPECT_FALSE(document_->isModified());
    }
}

TEST_F(FileFollowerTest, EditsThatAreNotSavedAreMerged) {
    type("two", "2");
    write(with(before, "five", "5"));
    waitFor([&] { return document_->bytes() == with(with(before, "two", "2"), "five", "5"); });
    EXPECT_TRUE(document_->isModified());
    EXPECT_THAT(told_, HasSubstr("beside yours"));
    EXPECT_TRUE(document_->save());
    EXPECT_FALSE(document_->isModified());
}

TEST_F(FileFollowerTest, WhereBothChangedSomethingSomebodyChooses) {
    type("two", "2");
    const std::string mine = document_->bytes();
    write(with(with(before, "two", "zwei"), "five", "5"));
    waitFor([&] { return file_->state() == State::disputed; });
    EXPECT_EQ(document_->bytes(), mine);
    EXPECT_THAT(file_->sentence().toStdString(), HasSubstr("also where you changed it"));
    EXPECT_EQ(file_->choices(),
              (std::vector<FileFollower::Choice>{
                  {.line = 5, .mine = "one 2 three", .theirs = "one zwei three"}}));
    write(with(with(before, "two", "drei"), "five", "5")); // and again
    waitFor([&] { return file_->choices().front().theirs == "one drei three"; });
    EXPECT_EQ(document_->save().refusal, files::Refusal::changed);
    file_->keepMine();
    EXPECT_EQ(document_->bytes(), with(mine, "five", "5"));
    EXPECT_EQ(file_->state(), State::quiet);
    EXPECT_TRUE(document_->save());
}

TEST_F(FileFollowerTest, TheirTextIsTakenWhereBothChangedSomething) {
    type("two", "2");
    type("five", "5");
    write(with(before, "two", "zwei"));
    waitFor([&] { return file_->state() == State::disputed; });
    file_->takeTheirs();
    EXPECT_EQ(document_->bytes(), with(with(before, "two", "zwei"), "five", "5"));
    EXPECT_TRUE(document_->isModified());
    document_->undo();
    EXPECT_EQ(document_->bytes(), with(with(before, "two", "2"), "five", "5"));
}

// Far apart they are two choices. If the words are the same, the tags are shown.
TEST_F(FileFollowerTest, EachPlaceIsAChoiceOfItsOwn) {
    type("two", "2");
    type("<PARAGRAPH>{four", "<PARAGRAPH ID=\"a\">{four");
    write(with(with(before, "two", ""), "<PARAGRAPH>{four", "<PARAGRAPH ID=\"b\">{four"));
    waitFor([&] { return file_->state() == State::disputed; });
    ASSERT_EQ(file_->choices().size(), 2u);
    EXPECT_EQ(file_->choices()[0].mine, "one 2 three");
    EXPECT_EQ(file_->choices()[0].theirs, "one three");
    EXPECT_EQ(file_->choices()[1].line, 6);
    EXPECT_EQ(file_->choices()[1].theirs, "<PARAGRAPH ID=\"b\">{four five six}");
}

TEST_F(FileFollowerTest, OfALongTextAChoiceShowsTheWordsNearIt) {
    std::string longer;
    for (int i = 0; i < 60; ++i)
        longer += " w" + std::to_string(i);
    file_.reset();
    write(with(before, " two ", longer + " two" + longer + " "));
    document_ = document::Document::load(name_).document;
    file_ = std::make_unique<FileFollower>(*document_, FileFollower::Waits{.soon = 1});
    const std::string all = document_->bytes();
    type("two", "2");
    write(with(all, "two", "zwei"));
    waitFor([&] { return file_->state() == State::disputed; });
    ASSERT_EQ(file_->choices().size(), 1u);
    const std::string shown = file_->choices()[0].theirs.toStdString();
    EXPECT_THAT(shown, HasSubstr("w58 w59 zwei w0 w1"));
    EXPECT_THAT(shown, ::testing::StartsWith("\u2026 w"));
    EXPECT_THAT(shown, ::testing::EndsWith(" \u2026"));
    EXPECT_LT(shown.size(), 200u);
}

TEST_F(FileFollowerTest, AHalfWrittenFileIsWaitedFor) {
    const std::string theirs = with(before, "two", "2");
    write(theirs.substr(0, theirs.size() / 2));
    const int looks = file_->looks();
    waitFor([&] { return file_->looks() >= looks + 3; });
    EXPECT_EQ(document_->bytes(), before);
    EXPECT_EQ(file_->state(), State::quiet);
    write(theirs);
    waitFor([&] { return document_->bytes() == theirs; });
}

TEST_F(FileFollowerTest, AFileThatStaysBrokenIsAskedAbout) {
    file_ = std::make_unique<FileFollower>(
        *document_, FileFollower::Waits{.soon = 1, .again = 1, .patience = 5});
    write(before.substr(0, before.size() / 2));
    waitFor([&] { return file_->state() == State::damaged; });
    EXPECT_EQ(document_->bytes(), before);
    file_->keepMine();
    EXPECT_EQ(document_->bytes(), before);
    EXPECT_TRUE(document_->isModified());
    EXPECT_TRUE(document_->save());
}

TEST_F(FileFollowerTest, AFileThatGoesLeavesItsTextUnsaved) {
    ASSERT_TRUE(QFile::remove(name_));
    waitFor([&] { return file_->state() == State::lost; });
    EXPECT_EQ(document_->bytes(), before);
    EXPECT_TRUE(document_->isModified());
    EXPECT_THAT(file_->sentence().toStdString(), HasSubstr("a.ens was removed"));
    const std::string theirs = with(before, "two", "2");
    write(theirs); // and comes back
    waitFor([&] { return document_->bytes() == theirs; });
    EXPECT_FALSE(document_->isModified());
    ASSERT_TRUE(QFile::remove(name_));
    waitFor([&] { return file_->state() == State::lost; });
    EXPECT_TRUE(document_->save());
    waitFor([&] { return file_->state() == State::quiet; });
    EXPECT_FALSE(document_->isModified());
}

} // namespace
} // namespace session
