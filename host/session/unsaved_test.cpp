// The text of an open document goes to the journal a few times a second.
#include "media/scripted_medium.h"
#include "session/open_document.h"
#include "session/unsaved.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

namespace session {
namespace {

class UnsavedTest : public ::testing::Test {
protected:
    void type(int letters) {
        for (int i = 0; i < letters; ++i) {
            const std::size_t end = document().bytes().find("}</PARAGRAPH>");
            ASSERT_EQ(document().edit({{{end, end}, "x"}}, "Type"), document::EditResult::applied);
        }
    }
    document::Document& document() { return open_->document(); }
    // The texts that a killed program would leave.
    std::vector<std::string> left() {
        std::vector<std::string> texts;
        for (const files::LeftBehind& one :
             files::leftBehind(files::FileSystem::real(), folder()).texts)
            texts.push_back(one.kept.text);
        return texts;
    }
    std::string folder() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry{}, QString(), pipes_, media::testing::shortLimits()};
    std::unique_ptr<OpenDocument> open_ = std::make_unique<OpenDocument>(
        std::make_unique<document::Document>(
            "DOCUMENT CMEMO\n<CMEMO>\n<BODY>\n<PARAGRAPH>{a}</PARAGRAPH>\n</BODY>\n</CMEMO>\n"),
        schemas_, media_);
};

TEST_F(UnsavedTest, TheTextIsNotTakenAtEachKey) {
    Unsaved& unsaved = open_->keepUnsavedIn(folder());
    type(500);
    EXPECT_LE(unsaved.taken(), 1); // that it is modified
    ASSERT_TRUE(media::testing::waitFor([&] { return unsaved.taken() == 2; }));
    type(1);
    const std::string last = document().bytes();
    unsaved.finish(); // also of what was to be taken soon
    open_.reset();
    EXPECT_EQ(left(), std::vector<std::string>{last});
}

TEST_F(UnsavedTest, TheTextIsTakenWhileOneTypesOn) {
    Unsaved& unsaved = open_->keepUnsavedIn(folder());
    QElapsedTimer typing;
    typing.start();
    while (!typing.hasExpired(5 * Unsaved::soonMs)) { // no two keys are soonMs apart
        type(1);
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    EXPECT_GE(unsaved.taken(), 3);
}

TEST_F(UnsavedTest, TheLastKeysAreKeptWhenItGoes) {
    open_->keepUnsavedIn(folder());
    type(3);
    const std::string last = document().bytes();
    open_.reset();
    EXPECT_EQ(left(), std::vector<std::string>{last});
}

TEST_F(UnsavedTest, NothingIsLeftOfWhatWasGivenUp) {
    Unsaved& unsaved = open_->keepUnsavedIn(folder());
    type(3);
    unsaved.giveUp();
    open_.reset();
    EXPECT_TRUE(left().empty());
}

} // namespace
} // namespace session
