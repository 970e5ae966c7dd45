// Selecting and copying text in the reading view.
#include "clipboard/copying.h"
#include "places/carets.h"
#include "view/text_hand.h"
#include "writing/writing_testing.h"

#include <QClipboard>
#include <QMimeData>
#include <QSignalSpy>

namespace writing {
namespace {

class SelectionTest : public WindowTest {
protected:
    void show(const QByteArray& body, QSize size = {900, 1000}) {
        window_ = open(memo(body), size);
        window_->view().setFocus();
        ASSERT_TRUE(waitFor([&] { return window_->view().isLaidOut(); }));
    }
    view::DocumentView& view() const { return window_->view(); }
    document::Document& document() const { return window_->document().document(); }
    std::size_t placeBefore(const std::string& words) const {
        return document().bytes().find(words);
    }
    // The middle of the line that the words are on, at their beginning, in the viewport.
    QPoint pointBefore(const std::string& words) const {
        const places::Carets carets(view().pages(), document().tree());
        const places::Caret caret = carets.of(placeBefore(words), 0).value();
        return view().inViewport(caret.page, carets.rectOf(caret)).center().toPoint();
    }
    void clickBefore(const std::string& words, Qt::KeyboardModifiers modifiers = {}) const {
        // Clicks close to each other in time would be double ones.
        QTest::mousePress(view().viewport(), Qt::LeftButton, modifiers, pointBefore(words));
        QTest::mouseRelease(view().viewport(), Qt::LeftButton, modifiers, pointBefore(words));
    }
    void drag(QPoint from, QPoint to) const {
        QTest::mousePress(view().viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(view().viewport(), (from + to) / 2);
        QTest::mouseMove(view().viewport(), to);
        QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, to);
    }
    std::string selected() const {
        const text::Range all = view().text().cursor().interval();
        return document().bytes().substr(all.from, all.size());
    }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }

    DocumentWindow* window_ = nullptr;
};

TEST_F(SelectionTest, ADragSelectsAndCopyOffersTextHtmlAndOurOwnBytes) {
    show(paragraph("One two three") + paragraph("Four five"));
    EXPECT_FALSE(action("copy")->isEnabled());
    drag(pointBefore("two"), pointBefore(" five"));
    EXPECT_EQ(selected(), "two three}</TEXT></PARAGRAPH>\n<PARAGRAPH><TEXT>{Four");
    ASSERT_TRUE(action("copy")->isEnabled());
    action("copy")->trigger();
    const QMimeData* copy = QApplication::clipboard()->mimeData();
    EXPECT_EQ(copy->text(), "two three\n\nFour");
    EXPECT_THAT(copy->html().toStdString(), ::testing::HasSubstr("<p>two three</p>\n<p>Four</p>"));
    EXPECT_EQ(copy->data(view::fragmentFormat),
              "<BODY><PARAGRAPH><TEXT>{two three}</TEXT></PARAGRAPH>\n"
              "<PARAGRAPH><TEXT>{Four}</TEXT></PARAGRAPH></BODY>");
    drag(pointBefore("five"), pointBefore("Four")); // backwards
    EXPECT_EQ(selected(), "Four ");
}

TEST_F(SelectionTest, TwoClicksSelectAWordAndThreeAParagraph) {
    show(paragraph("One two three") + paragraph("Four five"));
    const QPoint at = pointBefore("wo three");
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(selected(), "two");
    QTest::mousePress(view().viewport(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(selected(), "One two three");
}

TEST_F(SelectionTest, ADragAfterTwoClicksSelectsWholeWords) {
    show(paragraph("One two three four"));
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, pointBefore("wo three"));
    const QPoint from = pointBefore("wo three"), to = pointBefore("our");
    QTest::mousePress(view().viewport(), Qt::LeftButton, {}, {1, 1}); // no third one
    QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, {1, 1});
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, from);
    view().text().pressTwice(QMouseEvent(QEvent::MouseButtonDblClick, from, from, Qt::LeftButton,
                                         Qt::LeftButton, Qt::NoModifier));
    view().text().drag(to);
    view().text().release();
    EXPECT_EQ(selected(), "two three four");
}

TEST_F(SelectionTest, ShiftGoesOnByClickAndByKey) {
    show(paragraph("One two three") + paragraph("Four five"));
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(selected(), ""); // nobody has clicked yet
    clickBefore("two");
    EXPECT_EQ(selected(), "");
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(selected(), "t");
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier | Qt::ControlModifier);
    EXPECT_EQ(selected(), "two ");
    QTest::keyClick(&view(), Qt::Key_End, Qt::ShiftModifier);
    EXPECT_EQ(selected(), "two three");
    clickBefore(" five", Qt::ShiftModifier);
    EXPECT_EQ(selected(), "two three}</TEXT></PARAGRAPH>\n<PARAGRAPH><TEXT>{Four");
}

TEST_F(SelectionTest, ASelectionStaysOnItsWordsWhateverHappensBefore) {
    show(paragraph("One two three"));
    drag(pointBefore("two"), pointBefore(" three"));
    ASSERT_EQ(selected(), "two");
    document().edit({{{placeBefore("One"), placeBefore("One")}, "New words. "}}, "Elsewhere");
    EXPECT_EQ(selected(), "two");
    document().undo();
    EXPECT_EQ(selected(), "two");
    view().setPresentation("slides");
    EXPECT_EQ(selected(), "two");
}

TEST_F(SelectionTest, AllIsSelectedFromTheFirstWordToTheLast) {
    show(paragraph("One") + paragraph("last"));
    action("selectAll")->trigger();
    action("copy")->trigger();
    const QString text = QApplication::clipboard()->text();
    EXPECT_TRUE(text.startsWith("Memorandum") || text.contains("Test")) << text.toStdString();
    EXPECT_TRUE(text.endsWith("One\n\nlast")) << text.toStdString();
}

TEST_F(SelectionTest, AllIsSelectedWhereTheLastPageHasAFootnote) {
    show("<PARAGRAPH><TEXT>{One}</TEXT><FOOTNOTE><TEXT>{A note}</TEXT></FOOTNOTE>"
         "<TEXT>{, and last}</TEXT></PARAGRAPH>\n");
    action("selectAll")->trigger();
    action("copy")->trigger();
    EXPECT_THAT(QApplication::clipboard()->text().toStdString(),
                ::testing::HasSubstr(", and last"));
}

TEST_F(SelectionTest, ACopyAcrossSectionsIsPastedWithItsStructure) {
    show("<SECTION><HEADING>{A}</HEADING>\n<LIST><ITEM>{one}</ITEM><ITEM>{two}</ITEM>"
         "<ITEM>{three}</ITEM></LIST>\n</SECTION>\n"
         "<SECTION><HEADING>{B}</HEADING>\n<PARAGRAPH>{half of it}</PARAGRAPH></SECTION>\n");
    view().text().cursor().set({placeBefore("two"), placeBefore(" of it")});
    action("copy")->trigger();
    show("<PARAGRAPH>{}</PARAGRAPH>\n");
    writeIn(*window_);
    view().text().cursor().set({placeBefore("}</PARAGRAPH>"), placeBefore("}</PARAGRAPH>")});
    action("paste")->trigger();
    EXPECT_THAT(
        document().bytes(),
        ::testing::HasSubstr("<BODY>\n<LIST>\n<ITEM>{two}</ITEM>\n<ITEM>{three}</ITEM>\n</LIST>\n"
                             "<SECTION>\n<HEADING>{B}</HEADING>\n<PARAGRAPH>{half}</PARAGRAPH>\n"
                             "</SECTION>"));
}

TEST_F(SelectionTest, AFigureGetsItsPressesAndIsCopied) {
    show(paragraph("One two") + scripted("colour 20A040") + paragraph("three"));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    drag(pointBefore("One"), pointBefore(" two"));
    ASSERT_TRUE(action("copy")->isEnabled());
    click(*window_, 0);
    EXPECT_EQ(view().chosen(), nth(*window_, 0));
    EXPECT_EQ(selected(), "One");
    action("copy")->trigger();
    EXPECT_THAT(QApplication::clipboard()->mimeData()->data(view::fragmentFormat).toStdString(),
                ::testing::HasSubstr("<SCRIPT>{colour 20A040}</SCRIPT>"));
    EXPECT_FALSE(action("selectAll")->isEnabled());
}

TEST_F(SelectionTest, AClickFollowsALinkAndADragSelectsIt) {
    show("<PARAGRAPH><TEXT>{See }</TEXT><LINK TO=\"no page\">{this link}</LINK></PARAGRAPH>");
    const QSignalSpy followed(&view(), &view::DocumentView::linkActivated);
    drag(pointBefore("his link"), pointBefore("nk}"));
    EXPECT_EQ(selected(), "his li");
    EXPECT_EQ(followed.count(), 0);
    clickBefore("his link");
    EXPECT_EQ(followed.count(), 1);
}

TEST_F(SelectionTest, WhatIsSelectedHasTheThemesColour) {
    show(paragraph("MMMM MMMM"));
    QPalette palette = view().palette();
    palette.setColor(QPalette::Highlight, Qt::red);
    view().setPalette(palette);
    const auto reds = [&] {
        const QImage image = view().viewport()->grab().toImage();
        int count = 0;
        for (int x = 0; x < image.width(); ++x) {
            const QColor color = image.pixelColor(x, pointBefore("MMMM").y());
            count += color.red() > color.green() + 40 ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(reds(), 0);
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, pointBefore("MMM MM"));
    EXPECT_GT(reds(), 20);
    clickBefore(" MMMM");
    EXPECT_EQ(reds(), 0);
}

TEST_F(SelectionTest, ADragBelowTheViewScrollsIt) {
    QByteArray body;
    for (int i = 0; i < 100; ++i)
        body += paragraph("Line " + QByteArray::number(i));
    show(body, {900, 500});
    QTest::mousePress(view().viewport(), Qt::LeftButton, {}, pointBefore("Line 0"));
    const QPoint below(200, view().viewport()->height() + 60);
    QTest::mouseMove(view().viewport(), below);
    EXPECT_TRUE(waitFor([&] { return selected().find("Line 60") != std::string::npos; }));
    QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, below);
    EXPECT_FALSE(view().text().isDragging());
}

} // namespace
} // namespace writing
