// Sections that a view folds: pages without them, at the cost of what has changed.
#include "session/folded_pages.h"

#include "places/find.h"

#include <gmock/gmock.h>

#include <QCoreApplication>

namespace session {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string report(const std::string& body) {
    return "DOCUMENT REPORT\n<REPORT>\n<TITLE>{Test}</TITLE>\n" + body + "</REPORT>\n";
}

// Paragraphs of some lines, and a figure's worth of words.
std::string section(const std::string& name, int paragraphs, const std::string& inside = {}) {
    std::string text = "<SECTION ID=\"" + name + "\">\n<HEADING>{" + name + "}</HEADING>\n";
    for (int i = 0; i < paragraphs; ++i) {
        std::string words;
        for (int k = 0; k < 30; ++k)
            words += " some words";
        text += "<PARAGRAPH>{" + name + std::to_string(i) + words + "}</PARAGRAPH>\n";
    }
    return text + inside + "</SECTION>\n";
}

class FoldedPagesTest : public ::testing::Test {
protected:
    void open(const std::string& body) {
        document_ = std::make_unique<OpenDocument>(
            std::make_unique<document::Document>(report(body)), schemas_, media_);
        pages_ = std::make_unique<FoldedPages>(*document_);
        pages_->present({});
        pages_->settle();
    }
    // The element of the heading with that text.
    [[nodiscard]] sgml::NodeId heading(const std::string& text) const {
        const sgml::Tree& tree = document_->document().tree();
        return tree.node(tree.innermostAt(place("<HEADING>{" + text) + 10)).parent;
    }
    [[nodiscard]] std::size_t place(const std::string& of) const {
        return document_->document().bytes().find(of);
    }
    void fold(const std::string& name, bool isFolded = true) {
        pages_->setFolded(heading(name), isFolded);
        pages_->settle();
    }
    void edit(const std::string& old, const std::string& now) {
        const std::size_t at = place(old);
        ASSERT_EQ(document_->document().edit({{{at, at + old.size()}, now}}, "test"),
                  document::EditResult::applied);
        pages_->settle();
    }
    [[nodiscard]] bool shows(const std::string& words) const {
        return !places::findText(pages_->pages(), QString::fromStdString(words)).empty();
    }
    [[nodiscard]] std::vector<std::string> headings() const {
        std::vector<std::string> result;
        for (const layout::OutlineEntry& entry : pages_->pages().outline())
            result.push_back(entry.heading.text.toStdString());
        return result;
    }
    // As laid out from nothing.
    [[nodiscard]] std::string anew() const {
        FoldedPages other(*document_);
        other.restore(pages_->places());
        other.present({});
        other.settle();
        return layout::printed(other.pages());
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry::read({}), QString(), pipes_};
    std::unique_ptr<OpenDocument> document_;
    std::unique_ptr<FoldedPages> pages_;
};

TEST_F(FoldedPagesTest, WhileNothingIsFoldedThePagesAreThoseOfAllViews) {
    open(section("A", 3) + section("B", 3));
    EXPECT_EQ(pages_->pages().basis, pages_->whole().pages().basis);
    fold("A");
    EXPECT_NE(pages_->pages().basis, pages_->whole().pages().basis);
    EXPECT_FALSE(shows("A1 some"));
    EXPECT_TRUE(shows("B1 some"));
    EXPECT_EQ(places::findText(pages_->whole().pages(), "A1 some").size(), 1u);
    FoldedPages other(*document_); // another view
    other.present({});
    EXPECT_EQ(other.pages().basis, pages_->whole().pages().basis);
    fold("A", false);
    EXPECT_EQ(pages_->pages().basis, pages_->whole().pages().basis);
    EXPECT_FALSE(document_->document().isModified());
}

// Of many pages: nothing is laid out but the heading, which has another block.
TEST_F(FoldedPagesTest, FoldingOneSectionLaysOutWhatHasChanged) {
    std::string body;
    for (int i = 0; i < 200; ++i)
        body += section("S" + std::to_string(i), 20);
    open(body);
    const std::size_t count = pages_->pages().pages.size();
    ASSERT_GT(count, 300u);
    const layout::Pages before = pages_->pages();
    fold("S100");
    EXPECT_LE(pages_->pages().work.paragraphs, 2u);
    EXPECT_LT(pages_->pages().work.pages, count * 3 / 5); // those before stay
    EXPECT_EQ(pages_->pages().pages[count / 3], before.pages[count / 3]);
    // A letter far from there costs its page, with folds as without.
    edit("S1700", "S17x00");
    EXPECT_LE(pages_->pages().work.paragraphs, 1u);
    EXPECT_LE(pages_->pages().work.pages, 3u);
    fold("S100", false);
    EXPECT_EQ(pages_->pages().basis, pages_->whole().pages().basis);
}

TEST_F(FoldedPagesTest, FoldsFollowEditsOfTheDocument) {
    open(section("A", 3) + section("B", 3) + section("C", 3));
    fold("B");
    edit("A1", "<EMPH>x</EMPH> more words");
    edit("<SECTION ID=\"A\">", section("New", 2) + "<SECTION ID=\"A\">");
    EXPECT_TRUE(pages_->isFolded(heading("B")));
    EXPECT_FALSE(shows("B1 some"));
    EXPECT_TRUE(shows("C1 some"));
    EXPECT_THAT(headings(), ElementsAre("1  New", "2  A", "3  B", "4  C")); // as in the whole
    EXPECT_EQ(layout::printed(pages_->pages()), anew());
    edit("<HEADING>{B", "<HEADING>{Before B");
    EXPECT_TRUE(pages_->isFolded(heading("Before B")));
    document_->document().undo();
    document_->document().undo();
    pages_->settle();
    EXPECT_TRUE(pages_->isFolded(heading("B")));
    EXPECT_EQ(layout::printed(pages_->pages()), anew());
    edit("<HEADING>{B}</HEADING>", "");
    EXPECT_FALSE(pages_->foldsAny());
    EXPECT_TRUE(shows("B1 some"));
}

TEST_F(FoldedPagesTest, WhatLeadsIntoASectionUnfoldsItAndThoseAroundIt) {
    open(section("A", 2, section("B", 2, "<PARAGRAPH ID=\"p\">{deep}</PARAGRAPH>")) +
         section("C", 2));
    fold("B");
    fold("A");
    fold("C");
    EXPECT_THAT(headings(), ElementsAre("1  A", "2  C"));
    EXPECT_EQ(pages_->pages().anchor("p"), pages_->pages().anchor("A")); // its page is told
    EXPECT_FALSE(pages_->reveal(place("A}</HEADING>")));
    EXPECT_TRUE(pages_->reveal(place("B}</HEADING>")));
    EXPECT_FALSE(pages_->isFolded(heading("A")));
    EXPECT_TRUE(pages_->isFolded(heading("B")));
    EXPECT_TRUE(pages_->reveal("p"));
    pages_->settle();
    EXPECT_TRUE(shows("deep"));
    EXPECT_TRUE(pages_->isFolded(heading("C")));
    EXPECT_FALSE(pages_->reveal("nothing"));
}

TEST_F(FoldedPagesTest, WhatAnEditWouldTouchUnfoldsUnlessItGoesAsAWhole) {
    open(section("A", 1) + section("B", 1) + section("C", 1));
    fold("B");
    const std::size_t behind = place("{B}</HEADING>") + 13, hidden = place("B0 some");
    const auto isTouched = [&](text::Range range, text::Range selected = {}) {
        const bool touched = pages_->revealTouched({{range, ""}}, selected);
        EXPECT_NE(touched, pages_->isFolded(heading("B")));
        fold("B");
        return touched;
    };
    EXPECT_TRUE(isTouched({behind, behind}));            // as Return does
    EXPECT_TRUE(isTouched({behind - 11, hidden}));       // as Delete
    EXPECT_TRUE(isTouched({hidden, place("{C}") + 1}));  // as Backspace behind it
    EXPECT_FALSE(isTouched({behind - 12, behind - 11})); // a letter of the heading
    EXPECT_FALSE(isTouched({place("{C}") + 1, place("{C}") + 2}));
    EXPECT_FALSE(isTouched({place("<SECTION ID=\"B"), place("<SECTION ID=\"C")}));
    // Of one that is selected with its heading it is wanted.
    const text::Range selected{place("{B}") + 1, place("{C}") + 2};
    EXPECT_FALSE(pages_->revealTouched({{{hidden, hidden + 1}, ""}}, selected));
    EXPECT_FALSE(pages_->isFolded(heading("B")));
}

TEST_F(FoldedPagesTest, FoldsAreKeptAndBroughtBackAndStayInOtherPresentations) {
    open(section("A", 2) + section("B", 2, section("C", 1)));
    pages_->foldAll();
    pages_->settle();
    const std::vector<std::size_t> kept = pages_->places();
    EXPECT_EQ(kept.size(), 3u);
    EXPECT_FALSE(shows("B1 some"));
    FoldedPages other(*document_);
    other.present({});
    other.restore(kept);
    other.settle();
    EXPECT_EQ(layout::printed(other.pages()), layout::printed(pages_->pages()));
    pages_->present("handout");
    pages_->settle();
    EXPECT_FALSE(shows("B1 some"));
    EXPECT_THAT(headings(), ElementsAre("1  A", "2  B"));
    pages_->unfoldAll();
    EXPECT_THAT(pages_->places(), IsEmpty());
    // A place that is no heading's any more is forgotten.
    other.restore({kept[0], place("B1 some")});
    other.settle();
    EXPECT_THAT(other.places(), ElementsAre(kept[0]));
}

// A figure's size that both layouts are told of, whichever asks first.
TEST_F(FoldedPagesTest, PagesWithFoldsFollowSizesThatThePagesOfAllHaveFollowed) {
    open(section("A", 2) +
         section("B", 2,
                 "<FIGURE><DOCUMENT>\nDOCUMENT NONE\n<NONE WIDTH=\"200\" HEIGHT=\"100\"></NONE>\n"
                 "</DOCUMENT></FIGURE>"));
    fold("A");
    const auto height = [&] { return pages_->pages().subdocuments().at(0).rect.height(); };
    const double before = height();
    edit("HEIGHT=\"100\"", "HEIGHT=\"200\"");
    EXPECT_DOUBLE_EQ(height(), 2 * before);
    while (!pages_->whole().isComplete())
        QCoreApplication::processEvents();
    edit("HEIGHT=\"200\"", "HEIGHT=\"100\"");
    EXPECT_DOUBLE_EQ(height(), before);
}

// While a long document is laid out for the first time it is shown whole.
TEST_F(FoldedPagesTest, FoldsOfALongDocumentWaitForItsPages) {
    std::string body;
    for (int i = 0; i < 300; ++i)
        body += section("S" + std::to_string(i), 20);
    document_ = std::make_unique<OpenDocument>(std::make_unique<document::Document>(report(body)),
                                               schemas_, media_);
    FoldedPages pages(*document_);
    pages.restore({place("{S299}")});
    pages.present({});
    EXPECT_FALSE(pages.isComplete());
    EXPECT_FALSE(pages.pages().pages.empty());
    int completed = 0;
    QObject::connect(&pages, &FoldedPages::complete, [&] { ++completed; });
    while (!pages.isComplete())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(completed, 1);
    EXPECT_TRUE(places::findText(pages.pages(), "S29919 some").empty());
    EXPECT_LE(pages.pages().work.paragraphs, 2u); // the others are those of all views
}

} // namespace
} // namespace session
