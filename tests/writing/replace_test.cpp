// Finding and replacing words, as with the keyboard.
#include "view/text_hand.h"
#include "view/writing.h"
#include "writing/writing_testing.h"

#include <QCheckBox>
#include <QStatusBar>

namespace writing {
namespace {

class ReplaceTest : public WindowTest {
protected:
    void write(const QByteArray& body) {
        window_ = open(memo(body));
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        window_->activateWindow();
        view().setFocus();
        ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
        action("write")->trigger();
    }
    void replaceBy(const char* words, const char* with) {
        action("replaceWords")->trigger();
        field("find").setText(words);
        field("replaceWith").setText(with);
    }
    view::DocumentView& view() const { return window_->view(); }
    document::Document& document() const { return window_->document().document(); }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    QLineEdit& field(const char* name) const { return *window_->findChild<QLineEdit*>(name); }
    panes::FindBar& bar() const { return *window_->findChild<panes::FindBar*>(); }
    void click(const char* name) const { bar().findChild<QAbstractButton*>(name)->click(); }
    std::string body() const {
        const std::string& bytes = document().bytes();
        const std::size_t from = bytes.find("<BODY>\n") + 7;
        return bytes.substr(from, bytes.find("</BODY>") - from);
    }

    DocumentWindow* window_ = nullptr;
};

TEST_F(ReplaceTest, OneAfterTheOtherAndAllTheRestInOneStep) {
    write(paragraph("red and red") + paragraph("red {red} redder"));
    replaceBy("red", "blue");
    EXPECT_EQ(bar().says(), "1 of 5");
    click("replace");
    EXPECT_EQ(body(), (paragraph("blue and red") + paragraph("red {red} redder")).toStdString());
    EXPECT_EQ(bar().says(), "1 of 4");
    click("replace");
    EXPECT_EQ(body(), (paragraph("blue and blue") + paragraph("red {red} redder")).toStdString());
    const std::size_t steps = document().steps();
    click("replaceAll");
    EXPECT_EQ(body(),
              (paragraph("blue and blue") + paragraph("blue {blue} blueder")).toStdString());
    EXPECT_EQ(document().steps(), steps + 1);
    EXPECT_EQ(window_->statusBar()->currentMessage(), "3 replaced");
    document().undo();
    EXPECT_EQ(body(), (paragraph("blue and blue") + paragraph("red {red} redder")).toStdString());
}

TEST_F(ReplaceTest, TabGoesFromFieldToFieldAndThenToTheButtons) {
    write(paragraph("red"));
    action("replaceWords")->trigger();
    QStringList order;
    for (int i = 0; i < 8; ++i) {
        order << window_->focusWidget()->objectName();
        QTest::keyClick(window_->focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(order.join(' '), "find replaceWith findPrevious findNext matchCase wholeWords "
                               "replace replaceAll");
    // In the order of Shift+Tab too, and without the second line.
    action("write")->trigger();
    action("find")->trigger();
    QTest::keyClick(window_->focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(window_->focusWidget()->objectName(), "findPrevious");
}

TEST_F(ReplaceTest, TheBarHasTheKeyboardInAFaultyDocumentToo) {
    write(paragraph("red") + "<NOSUCH>{x}</NOSUCH>\n");
    QTest::keyClick(&view(), Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(window_->focusWidget(), "red");
    EXPECT_EQ(field("find").text(), "red");
    EXPECT_EQ(window_->focusWidget(), &field("find"));
}

TEST_F(ReplaceTest, AReplacementThatHoldsTheWordIsNotReplacedAgain) {
    write(paragraph("one one"));
    replaceBy("one", "one more");
    click("replace");
    EXPECT_EQ(body(), paragraph("one more one").toStdString());
    EXPECT_EQ(bar().says(), "2 of 2");
    click("replace");
    EXPECT_EQ(body(), paragraph("one more one more").toStdString());
}

TEST_F(ReplaceTest, CaseAndWholeWordsCountWhereTheyAreTicked) {
    write(paragraph("Red red redder"));
    replaceBy("red", "blue");
    bar().findChild<QCheckBox*>("matchCase")->setChecked(true);
    EXPECT_EQ(bar().says(), "1 of 2");
    bar().findChild<QCheckBox*>("wholeWords")->setChecked(true);
    EXPECT_EQ(bar().says(), "1 of 1");
    click("replaceAll");
    EXPECT_EQ(body(), paragraph("Red blue redder").toStdString());
}

TEST_F(ReplaceTest, WhatIsFoundIsSelectedWhereOneWrites) {
    write(paragraph("one two one"));
    replaceBy("one", "");
    bar().next(1);
    QTest::keyClick(&field("find"), Qt::Key_Escape);
    EXPECT_TRUE(view().hasFocus());
    QTest::keyClicks(&view(), "three");
    EXPECT_EQ(body(), paragraph("one two three").toStdString());
}

TEST_F(ReplaceTest, AReadingViewOnlyFinds) {
    write(paragraph("one"));
    EXPECT_TRUE(action("replaceWords")->isEnabled());
    replaceBy("one", "two");
    EXPECT_TRUE(field("replaceWith").isVisible());
    action("write")->trigger();
    EXPECT_FALSE(action("replaceWords")->isEnabled());
    EXPECT_FALSE(field("replaceWith").isVisible());
}

// Letters that are typed while the bar is open leave the view where it is, and the marks are where
// the words are then.
TEST_F(ReplaceTest, TypingKeepsThePlaceAndTheMarks) {
    QByteArray lines;
    for (int i = 0; i < 150; ++i)
        lines += paragraph(i % 50 == 10 ? "needle" : "hay");
    write(lines);
    action("replaceWords")->trigger();
    field("find").setText("needle");
    bar().next(1);
    QScrollBar& scroll = *view().verticalScrollBar();
    scroll.setValue(0);
    view().setFocus();
    const std::size_t at = document().bytes().find("hay");
    view().text().cursor().set({at, at});
    QTest::keyClicks(&view(), "needle");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    QCoreApplication::processEvents();
    EXPECT_EQ(scroll.value(), 0);
    EXPECT_EQ(bar().says(), "3 of 4");
}

} // namespace
} // namespace writing
