// Values of subdocuments in a document, by the medium that does as it is told.
#include "exports/text_export.h"
#include "media/scripted_medium.h"
#include "places/find.h"
#include "session/presented.h"

#include <gmock/gmock.h>

namespace session {
namespace {

using media::testing::waitFor;
using ::testing::HasSubstr;

std::string value(const std::string& of, const std::string& expression,
                  const std::string& more = {}) {
    return "<PARAGRAPH><TEXT>{now }</TEXT><VALUE OF=\"" + of + "\" EXPRESSION=\"" + expression +
           "\"" + more + "></VALUE><TEXT>{ m}</TEXT></PARAGRAPH>\n";
}

std::string figure(const std::string& id, const std::string& text, const std::string& more = {}) {
    return "<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED ID=\"" + id +
           "\" WIDTH=\"100\" HEIGHT=\"50\"" + more + "><SCRIPT>{" + text +
           "}</SCRIPT></SCRIPTED>\n</DOCUMENT></PARAGRAPH>\n";
}

class ValuesTest : public ::testing::Test {
protected:
    void open(const std::string& body) {
        document_ = std::make_unique<OpenDocument>(
            std::make_unique<document::Document>("DOCUMENT CMEMO\n<CMEMO>\n<BODY>\n" + body +
                                                 "</BODY>\n</CMEMO>\n"),
            schemas_, media_);
        presented_ = document_->presented({});
    }
    Values& values() { return document_->values(); }
    media::LiveSubdocument& live(std::size_t n) {
        return *document_->live(document_->document().subdocuments().at(n));
    }
    void settle() {
        bool isSettled = false;
        QObject::connect(&values(), &Values::settled, &values(), [&] { isSettled = true; });
        values().settle();
        EXPECT_FALSE(isSettled); // never inside the call
        EXPECT_TRUE(waitFor([&] { return isSettled && presented_->isUpToDate(); }));
        values().disconnect(SIGNAL(settled()));
    }
    // The text of the pages.
    bool shows(const std::string& words) {
        return !places::findText(presented_->pages(), QString::fromStdString(words)).empty();
    }
    bool comesToShow(const std::string& words) {
        return waitFor([&] { return presented_->isUpToDate() && shows(words); });
    }
    void edit(const std::string& from, const std::string& to) {
        const std::size_t at = document_->document().bytes().find(from);
        ASSERT_NE(at, std::string::npos);
        EXPECT_EQ(document_->document().edit({{{at, at + from.size()}, to}}, "test"),
                  document::EditResult::applied);
    }
    std::string fault() {
        const std::vector<ListedFault> faults = document_->valueFaults();
        return faults.empty() ? std::string()
                              : std::to_string(faults[0].position.line) + ": " +
                                    faults[0].message.toStdString();
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry::read({QStringLiteral(SOURCE_DIR "/tests/media")}),
                            QString(), pipes_, media::testing::shortLimits()};
    std::unique_ptr<OpenDocument> document_;
    std::shared_ptr<Presented> presented_;
};

TEST_F(ValuesTest, TheMediumTellsTheNumberThatStandsInTheText) {
    open(value("swing", "height", " FORMAT=\"2 decimals\"") +
         value("swing", "height", " TIME=\"3 s\"") +
         "<PARAGRAPH><FORMULA>{h = \\value[1 decimal, at 4 s]{swing}{height}}</FORMULA>"
         "</PARAGRAPH>\n" +
         figure("swing", "duration 10\nvalue height 1.5 2", " POSTER=\"1\""));
    EXPECT_TRUE(shows("now \u2026 m")); // at first nobody knows it
    settle();
    EXPECT_TRUE(shows("now 7.50 m"));
    EXPECT_EQ(fault(), "");
    const auto model = presented_->model();
    EXPECT_THAT(exports::exportText(document_->document(), *model), HasSubstr("h = 9.5"));
    EXPECT_TRUE(comesToShow("now 3.50 m")); // at the time of its poster
}

TEST_F(ValuesTest, ADocumentWithoutAnyIsSettledToo) {
    open("<PARAGRAPH>{a}</PARAGRAPH>\n");
    settle();
    settle(); // again
}

TEST_F(ValuesTest, ItFollowsTheTimeAndItsTextAndRestsWithoutProcess) {
    open(value("a", "x", " FORMAT=\"1 decimal\"") + figure("a", "duration 8\nvalue x 1 1"));
    settle();
    ASSERT_TRUE(comesToShow("now 1.0 m"));
    live(0).seek(4);
    ASSERT_TRUE(comesToShow("now 5.0 m"));
    edit("x 1 1", "x 2 1");
    ASSERT_TRUE(comesToShow("now 6.0 m"));
    live(0).makeStill();
    edit("x 2 1", "x 3 1"); // a process starts for it
    ASSERT_TRUE(comesToShow("now 7.0 m"));
    settle();
    EXPECT_EQ(fault(), "");
}

// A medium that is never heard to compute: its motion is another one at once.
TEST_F(ValuesTest, AValueAtAFixedTimeFollowsASlider) {
    open(value("a", "x", " TIME=\"3 s\" FORMAT=\"1 decimal\"") +
         figure("a", "duration 8\nslider\nvalue x 1 1"));
    settle();
    ASSERT_TRUE(comesToShow("now 4.0 m"));
    live(0).startAgain();
    ASSERT_TRUE(waitFor([&] { return live(0).condition() == media::Condition::live; }));
    for (const char* words : {"now 5.0 m", "now 6.0 m"}) {
        live(0).invoke("slide", nullptr);
        ASSERT_TRUE(comesToShow(words));
    }
    EXPECT_EQ(fault(), "");
}

TEST_F(ValuesTest, WhatTheMediumDoesNotKnowIsAFaultAtItsPlace) {
    open(value("a", "y") + value("b", "x") + value("a", "x", " FORMAT=\"0.0\"") +
         "<PARAGRAPH><FORMULA>{\\value{c}{x}}</FORMULA></PARAGRAPH>\n" +
         figure("a", "value x 1 0"));
    settle();
    EXPECT_TRUE(shows("now [y] m"));
    EXPECT_TRUE(shows("now [x] m"));
    std::string all;
    for (const ListedFault& one : document_->faults())
        all += std::to_string(one.position.line) + ": " + one.message.toStdString() + "\n";
    EXPECT_THAT(all, HasSubstr("4: there is no number here: there is no value \"y\""));
    EXPECT_THAT(all, HasSubstr("5: no subdocument has the ID b"));
    EXPECT_THAT(all, HasSubstr("6: FORMAT wants"));
    EXPECT_THAT(all, HasSubstr("7: there is no number here: no subdocument has the ID c"));
    edit("value x 1 0", "value x 1 0\nvalue y 5 0");
    EXPECT_TRUE(comesToShow("now 5.00 m"));
}

TEST_F(ValuesTest, ANumberOfAnOlderTextIsMarked) {
    open(value("a", "x") + figure("a", "value x 1 0"));
    settle();
    ASSERT_TRUE(comesToShow("now 1.00 m"));
    const auto isMarked = [&] {
        for (const auto& block : presented_->model()->blocks)
            for (const model::Run& run : block->runs)
                if (run.value)
                    return run.style == run.value->looks.outdated;
        return false;
    };
    EXPECT_FALSE(isMarked());
    edit("value x 1 0", "value x 2 0\nnonsense");
    EXPECT_TRUE(waitFor([&] { return presented_->isUpToDate() && isMarked(); }));
    EXPECT_TRUE(shows("now 1.00 m"));
    edit("nonsense", "");
    EXPECT_TRUE(comesToShow("now 2.00 m"));
    EXPECT_TRUE(waitFor([&] { return presented_->isUpToDate() && !isMarked(); }));
}

TEST_F(ValuesTest, AMediumThatStopsLeavesWhatItSaid) {
    open(value("a", "x") + value("b", "x") + figure("a", "value x 1 0") +
         figure("b", "behave exit"));
    settle();
    EXPECT_TRUE(comesToShow("now 1.00 m"));
    EXPECT_THAT(fault(), HasSubstr("5: there is no number here: Scripted"));
    live(0).edit({{{0, 0}, "behave exit\n"}}, {}); // its text in the document is as it was
    ASSERT_TRUE(waitFor([&] { return live(0).condition() == media::Condition::failed; }));
    EXPECT_TRUE(shows("now 1.00 m"));
}

// Counts of the work, not times: the paragraph with the number and its page, and nothing else.
TEST_F(ValuesTest, AChangeLaysOutItsParagraphAlone) {
    std::string text;
    for (int i = 0; i < 400; ++i)
        text += "<PARAGRAPH>{paragraph " + std::to_string(i) + "}</PARAGRAPH>\n";
    open(text + value("a", "x") + text + figure("a", "duration 100\nvalue x 1 1"));
    settle();
    ASSERT_TRUE(comesToShow("now 1.00 m"));
    const layout::Pages before = presented_->pages();
    ASSERT_GT(before.pages.size(), 20u);
    live(0).seek(50);
    ASSERT_TRUE(comesToShow("now 51.0 m"));
    const layout::Pages now = presented_->pages();
    EXPECT_EQ(now.work.paragraphs, 1u);
    EXPECT_LE(now.work.pages, 2u);
    std::size_t different = 0;
    for (std::size_t i = 0; i < now.pages.size(); ++i)
        different += now.pages[i] != before.pages[i] ? 1 : 0;
    EXPECT_EQ(different, 1u);
}

TEST_F(ValuesTest, WhilePlayingNumbersChangeAFewTimesASecond) {
    open(value("a", "x", " FORMAT=\"3 decimals\"") + figure("a", "duration 100\nvalue x 0 1"));
    settle();
    int changes = 0;
    QObject::connect(&values(), &Values::changed, &values(), [&] { ++changes; });
    live(0).play();
    ASSERT_TRUE(waitFor([&] { return live(0).time() && live(0).time()->time > 1; }));
    EXPECT_GE(changes, 2);
    EXPECT_LE(changes, static_cast<int>(1000 * live(0).time()->time / Values::betweenMs) + 2);
    live(0).pause();
    ASSERT_TRUE(waitFor([&] { return !live(0).time()->playing; }));
    const std::string last = model::written(live(0).time()->time, {3, true}, "");
    EXPECT_TRUE(comesToShow("now " + last + " m")); // the last one always
}

TEST_F(ValuesTest, FewProcessesStartForNumbersAlone) {
    std::string body;
    for (int i = 0; i < 6; ++i) {
        const std::string id = "f" + std::to_string(i);
        body += value(id, "x") + figure(id, "value x " + std::to_string(i) + " 0");
    }
    open(body);
    media_.setMostLive(2);
    std::size_t most = 0;
    const auto count = [&] {
        std::size_t live = 0;
        for (std::size_t i = 0; i < 6; ++i)
            live += this->live(i).hasProcess() ? 1 : 0;
        most = std::max(most, live);
    };
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, count);
    timer.start(1);
    settle();
    EXPECT_LE(most, 2u);
    for (int i = 0; i < 6; ++i)
        EXPECT_TRUE(shows("now " + std::to_string(i) + ".00 m")) << i;
}

} // namespace
} // namespace session
