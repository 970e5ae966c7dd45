// How one comes from reading to writing: what a view for reading says to somebody who writes in it,
// and how a document opens in which one wrote.
#include "writing/writing_testing.h"

#include <QPushButton>

namespace writing {
namespace {

class ReadingTest : public WritingTest {
protected:
    void read(const QByteArray& body) {
        window_ = open(memo(body));
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        window_->activateWindow();
        view().setFocus();
        ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    }
    [[nodiscard]] QWidget& bar() const { return *window_->findChild<QWidget*>("readingBar"); }
    [[nodiscard]] QPoint pointIn(const std::string& words) const {
        const std::size_t at = document().bytes().find(words);
        const places::Carets carets(view().pages(), document().tree());
        const std::optional<places::Caret> caret = carets.of(at, 0);
        return caret ? view().inViewport(caret->page, carets.rectOf(*caret)).center().toPoint()
                     : QPoint();
    }
    void button(const char* name) const {
        QTest::mouseClick(window_->findChild<QPushButton*>(name), Qt::LeftButton);
    }
    void openAgain() {
        const QString file = document().fileName();
        QPointer<DocumentWindow> closed = window_;
        window_->close();
        ASSERT_TRUE(waitFor([&] { return closed.isNull(); }));
        window_ = application_.open(file);
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    }
};

TEST_F(ReadingTest, WhoTypesLearnsHowOneBeginsToWrite) {
    read(paragraph("One two."));
    EXPECT_FALSE(bar().isVisible());
    press(Qt::Key_Down);
    press(Qt::Key_C, Qt::ControlModifier);
    EXPECT_FALSE(bar().isVisible());
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, pointIn("two"));
    type("x");
    ASSERT_TRUE(bar().isVisible());
    button("beginWriting");
    EXPECT_TRUE(view().isWriting());
    EXPECT_TRUE(view().hasFocus());
    EXPECT_FALSE(bar().isVisible());
    type("x");
    EXPECT_EQ(body(), "<PARAGRAPH><TEXT>{One xtwo.}</TEXT></PARAGRAPH>\n");
}

TEST_F(ReadingTest, WhoClicksTwiceInTheTextDoesToo) {
    read(paragraph("One two."));
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, pointIn("two"));
    EXPECT_TRUE(bar().isVisible());
    EXPECT_TRUE(view().text().cursor().selects()); // as before
}

TEST_F(ReadingTest, WhoKeepsReadingIsAskedOnce) {
    read(paragraph("One two."));
    type("x");
    button("keepReading");
    EXPECT_FALSE(view().isWriting());
    type("y");
    EXPECT_FALSE(bar().isVisible());
}

TEST_F(ReadingTest, ADocumentOpensForWritingWhereOneWrote) {
    write(paragraph("One two.") + paragraph("Three."));
    goTo("ree.");
    openAgain();
    ASSERT_TRUE(waitFor([&] { return view().isWriting(); }));
    type("x");
    EXPECT_THAT(body(), ::testing::HasSubstr("Thxree."));
    document().undo();
    action("write")->trigger(); // reading again
    openAgain();
    QTest::qWait(50);
    EXPECT_FALSE(view().isWriting());
}

} // namespace
} // namespace writing
