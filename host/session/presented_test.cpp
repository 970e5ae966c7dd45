#include "session/presented.h"

#include "places/find.h"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QTemporaryDir>

namespace session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string memo(const std::string& body) {
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Test}</SUBJECT>\n<BODY>\n" + body +
           "</BODY>\n</CMEMO>\n";
}

std::string paragraphs(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "<PARAGRAPH>{paragraph " + std::to_string(i) + "}</PARAGRAPH>\n";
    return text;
}

class PresentedTest : public ::testing::Test {
protected:
    std::unique_ptr<OpenDocument> open(const std::string& text) {
        return std::make_unique<OpenDocument>(std::make_unique<document::Document>(text), schemas_,
                                              media_);
    }
    static void complete(const Presented& presented) {
        while (!presented.isComplete())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry::read({}), QString(), pipes_};
};

TEST_F(PresentedTest, AShortDocumentIsThereAtOnce) {
    const auto document = open(memo(paragraphs(100)));
    const Presented presented(*document, {});
    EXPECT_TRUE(presented.isComplete());
    EXPECT_EQ(presented.title(), "Test");
    EXPECT_GE(presented.pages().pages.size(), 2u);
}

// Its own pages are shown until there are others: by the same work as for a document that opens.
TEST_F(PresentedTest, PagesFollowAPresentationThatIsEdited) {
    const auto document = open(memo(paragraphs(Presented::firstSteps * 3 / 2)));
    Presented presented(*document, {});
    complete(presented);
    const std::size_t before = presented.pages().pages.size();
    const schemas::Schemas::File file = schemas_.fileOf("CMEMO", "default");
    schemas_.setText(file.name, file.path, file.text + "PARAGRAPH { font: 30pt }\n");
    document->presentAnew();
    EXPECT_FALSE(presented.isComplete());
    EXPECT_EQ(presented.pages().pages.size(), before);
    complete(presented);
    EXPECT_GT(presented.pages().pages.size(), before * 3 / 2);
    schemas_.setText(file.name, file.path, file.text);
    document->presentAnew();
    complete(presented);
    EXPECT_EQ(presented.pages().pages.size(), before);
}

TEST_F(PresentedTest, ALongOneShowsItsFirstPagesAndTheRestInSlices) {
    const auto document = open(memo(paragraphs(Presented::firstSteps * 3 / 2)));
    Presented presented(*document, {});
    std::vector<std::size_t> grown;
    QObject::connect(&presented, &Presented::grown, &presented,
                     [&] { grown.push_back(presented.pages().pages.size()); });
    int events = 0;
    QTimer other; // what a window does meanwhile
    QObject::connect(&other, &QTimer::timeout, &other, [&] { ++events; });
    other.start(0);
    EXPECT_FALSE(presented.isComplete());
    const std::size_t first = presented.pages().pages.size();
    EXPECT_GE(first, 10u);
    complete(presented);
    EXPECT_GT(events, 1);
    EXPECT_GT(presented.pages().pages.size(), first);
    EXPECT_TRUE(std::is_sorted(grown.begin(), grown.end()));
    EXPECT_LE(grown.size(), 30u); // by a quarter each time
}

TEST_F(PresentedTest, AChangeCostsItsPagesAndTheOthersStay) {
    const auto document = open(memo(paragraphs(Presented::firstSteps * 3 / 2)));
    const auto presented = document->presented({});
    complete(*presented);
    const layout::Pages before = presented->pages();
    EXPECT_GT(before.work.pages, 50u);
    const auto insert = [&](const std::string& behind, const std::string& text) {
        const std::size_t at = document->document().bytes().find(behind) + behind.size();
        EXPECT_EQ(document->document().edit({{{at, at}, text}}, "test"),
                  document::EditResult::applied);
        EXPECT_FALSE(presented->isComplete());
        EXPECT_EQ(presented->pages().pages.size(), before.pages.size()); // stay until then
        complete(*presented);
    };
    insert("{paragraph 3000", "x");
    EXPECT_LE(presented->pages().work.pages, 3u);
    EXPECT_EQ(presented->pages().work.paragraphs, 1u);
    EXPECT_EQ(presented->pages().pages.front(), before.pages.front());
    EXPECT_EQ(presented->pages().pages.back(), before.pages.back());
    EXPECT_EQ(places::findText(presented->pages(), "3000x").size(), 1u);

    insert("{paragraph 3000x}</PARAGRAPH>\n", "<PARAGRAPH>{new}</PARAGRAPH>\n");
    EXPECT_EQ(presented->pages().work.paragraphs, 1u);
    EXPECT_EQ(presented->pages().pages.front(), before.pages.front());
    Presented anew(*document, {});
    complete(anew);
    EXPECT_EQ(layout::printed(presented->pages()), layout::printed(anew.pages()));
}

TEST_F(PresentedTest, AllWhoShowAPresentationShareIt) {
    const auto document = open(memo(paragraphs(3)));
    auto one = document->presented({});
    EXPECT_EQ(document->presented({}), one);
    const auto slides = document->presented("slides");
    EXPECT_NE(slides, one);
    EXPECT_EQ(slides->page().width, 720);
    const std::weak_ptr<Presented> kept = one;
    one.reset();
    EXPECT_TRUE(kept.expired()); // nobody shows it
}

TEST_F(PresentedTest, AnotherClassHasOtherPages) {
    const auto document = open(memo(paragraphs(3)));
    const auto presented = document->presented({});
    std::string text = document->document().bytes();
    const std::size_t whole = text.size();
    for (std::size_t at = text.find("CMEMO"); at != std::string::npos; at = text.find("CMEMO", at))
        text.replace(at, 5, "REPORT");
    ASSERT_EQ(document->document().edit({{{0, whole}, text}}, "test"),
              document::EditResult::applied);
    complete(*presented);
    EXPECT_EQ(presented->page(), document->schemas().presentation("REPORT").page());
    EXPECT_EQ(presented->pages().pages.size(), 1u);
}

TEST_F(PresentedTest, WhatIsBeingMadeEndsWithItsView) {
    const auto document = open(memo(paragraphs(Presented::firstSteps * 3 / 2)));
    auto presented = document->presented({});
    EXPECT_FALSE(presented->isComplete());
    presented.reset();
    QCoreApplication::processEvents();
}

TEST_F(PresentedTest, AModelThatIsBeingMadeIsBegunAnewWhenTheDocumentChanges) {
    std::string many;
    for (int i = 0; i < 60'000; ++i)
        many += "<EMPH>{x}</EMPH>";
    const auto document = open(memo("<PARAGRAPH>" + many + "</PARAGRAPH>"));
    const Presented presented(*document, {});
    EXPECT_TRUE(presented.pages().pages.empty()); // it is not that far
    const std::size_t title = document->document().bytes().find("Test");
    EXPECT_EQ(document->document().edit({{{title, title + 4}, "Other"}}, "test"),
              document::EditResult::applied);
    complete(presented);
    EXPECT_EQ(presented.title(), "Other");
}

// --- faults --------------------------------------------------------------------------------------

TEST_F(PresentedTest, EveryFaultIsInTheOneList) {
    QTemporaryDir folder;
    const auto write = [&](const QString& name, const std::string& text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(text));
    };
    write("CMEMO.default.presentation",
          "PARAGRAPH { color: #ff0000;\n wobble: yes; font: bold }\n");
    write("REPORT.default.presentation", "PARAGRAPH { wobble: yes }\n"); // of another class
    write("a.ens", memo("<PARAGRAPH><REF TO=\"no\"></REF></PARAGRAPH>\n"
                        "<FIGURE><IMAGE FILE=\"missing.png\"></IMAGE></FIGURE>\n"
                        "<NOSUCH>{x}</NOSUCH></X>\n"
                        "<PARAGRAPH><LINK TO=\"#nowhere\">{l}</LINK></PARAGRAPH>\n"
                        "<PARAGRAPH><SLIDER OF=\"s\" NAME=\"g\"></SLIDER></PARAGRAPH>\n"
                        "<PARAGRAPH><FORMULA>{a\n \\frac{1}}</FORMULA></PARAGRAPH>\n"));
    schemas_ = schemas::Schemas::load({folder.path()});
    document::Document::Loaded loaded = document::Document::load(folder.filePath("a.ens"));
    ASSERT_TRUE(loaded.document);
    OpenDocument document(std::move(loaded.document), schemas_, media_);
    std::vector<std::string> listed;
    for (const ListedFault& fault : document.faults())
        listed.push_back((fault.file.isEmpty() ? "" : "schema ") +
                         std::to_string(fault.position.line) + ": " + fault.message.toStdString());
    EXPECT_THAT(listed, ElementsAre("schema 2: wobble: no such property",
                                    HasSubstr("5: nothing has the ID no"),
                                    HasSubstr("6: There is no picture missing.png."),
                                    HasSubstr("6: the image has no alternative text"),
                                    HasSubstr("7: <NOSUCH>"), HasSubstr("7: </X> closes nothing"),
                                    HasSubstr("8: nothing has the ID nowhere"),
                                    HasSubstr("9: no subdocument has the ID s"),
                                    "11: \\frac needs two parts; the second is missing."));
}

// A subdocument of a medium that is named by the test alone, and has no program.
std::string scripted(const std::string& text) {
    return "<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED><SCRIPT>{" + text +
           "}</SCRIPT></SCRIPTED>\n</DOCUMENT></PARAGRAPH>\n";
}

TEST_F(PresentedTest, WhyAMediumFailedIsInTheOneListWhileItHasFailed) {
    media::Registry registry;
    media::Manifest manifest;
    manifest.name = "Scripted";
    manifest.documentClass = "SCRIPTED";
    manifest.storage = "SCRIPT";
    manifest.command = {"no-such-program"};
    registry.add(manifest);
    media::LiveMedia media(registry, QString(), pipes_);
    const std::string tooLong(ipc::longestText.most + 1, 'x');
    OpenDocument document(
        std::make_unique<document::Document>(memo(scripted(tooLong) + scripted("short"))), schemas_,
        media);
    int told = 0;
    QObject::connect(&document, &OpenDocument::faultsChanged, [&] { ++told; });
    const auto listed = [&] {
        std::vector<std::string> result;
        for (const ListedFault& fault : document.faults())
            result.push_back((fault.isError ? "error " : "warning ") +
                             std::to_string(fault.position.line) + ": " +
                             fault.message.toStdString());
        return result;
    };
    const std::string longSaid = "error 5: Scripted is not started: this text has 8.0 MiB, and it "
                                 "may have 8 MiB at most. Make it shorter.";
    EXPECT_THAT(listed(), ElementsAre(longSaid));
    const std::vector<document::SubdocumentId> all = document.document().subdocuments();
    document.live(all[1])->start();
    while (document.live(all[1])->condition() != media::Condition::failed)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(told, 1);
    EXPECT_THAT(listed(), ElementsAre(longSaid, "error 9: Scripted could not be started: there is "
                                                "no program \"no-such-program\"."));
    ASSERT_EQ(document.document().editText(all[0],
                                           document.document().subdocument(all[0])->revision,
                                           {{{0, tooLong.size()}, "short"}}, "Shorten"),
              document::EditResult::applied);
    EXPECT_THAT(listed(), ElementsAre(HasSubstr("error 9: Scripted could not be started")));
}

} // namespace
} // namespace session
