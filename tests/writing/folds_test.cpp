// Sections are folded in one view: by pointer and keys, and unfolded by what leads into them.
#include "places/find.h"
#include "view/folds.h"
#include "view/text_hand.h"
#include "view/writing.h"
#include "writing/writing_testing.h"

#include <QClipboard>
#include <QMimeData>
#include <QPointer>
#include <QStatusBar>

namespace writing {
namespace {

class FoldsTest : public WindowTest {
protected:
    void show(const QByteArray& bytes) {
        window_ = open(bytes);
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    }
    void write() { writeIn(*window_); }
    view::DocumentView& view() const { return window_->view(); }
    session::FoldedPages& folds() const { return view().folds().pages(); }
    document::Document& document() const { return window_->document().document(); }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    [[nodiscard]] std::size_t place(const QByteArray& of) const {
        return document().bytes().find(of.toStdString());
    }
    [[nodiscard]] sgml::NodeId heading(const QByteArray& name) const {
        const sgml::Tree& tree = document().tree();
        return tree.node(tree.innermostAt(place("<HEADING>{" + name) + 10)).parent;
    }
    void fold(const QByteArray& name) {
        view().folds().toggle(heading(name));
        settle();
    }
    [[nodiscard]] bool isFolded(const QByteArray& name) const {
        return folds().isFolded(heading(name));
    }
    [[nodiscard]] bool shows(const QString& words) const {
        return !places::findText(view().pages(), words).empty();
    }
    void setCaret(std::size_t at) { view().text().cursor().set({at, at}); }
    // Where the heading's letters are, in the viewport.
    [[nodiscard]] QRectF headingRect(const QByteArray& name) const {
        const places::Carets carets(view().pages(), document().tree());
        const auto caret = carets.of(place("<HEADING>{" + name) + 10, 0);
        return view().inViewport(caret->page, carets.rectOf(*caret));
    }
    // The triangle beside it, found by the pointer's shape.
    [[nodiscard]] QPoint triangle(const QByteArray& name) {
        const QRectF line = headingRect(name);
        for (int x = 0; x < static_cast<int>(line.left()); ++x)
            if (view().folds().isOver({static_cast<double>(x), line.center().y()}))
                return QPoint(x + 4, static_cast<int>(line.center().y()));
        ADD_FAILURE() << "no triangle";
        return {};
    }

    DocumentWindow* window_ = nullptr;
};

TEST_F(FoldsTest, AClickOnTheTriangleFoldsAndUnfolds) {
    show(report(section("A") + section("B")));
    const std::string before = document().bytes();
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, triangle("A"));
    settle();
    EXPECT_TRUE(isFolded("A"));
    EXPECT_FALSE(shows("Text of A"));
    EXPECT_TRUE(shows("Text of B"));
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, triangle("A"));
    settle();
    EXPECT_TRUE(shows("Text of A"));
    EXPECT_EQ(document().bytes(), before);
    EXPECT_FALSE(document().isModified());
    EXPECT_EQ(document().steps(), 0u);
}

TEST_F(FoldsTest, AHeadingWithoutAnythingUnderItHasNoTriangle) {
    show(report("<SECTION><HEADING>{Empty}</HEADING></SECTION>\n" + section("B")));
    const QRectF line = headingRect("Empty");
    for (int x = 0; x < line.right(); ++x)
        EXPECT_FALSE(view().folds().isOver({static_cast<double>(x), line.center().y()}));
}

TEST_F(FoldsTest, TheKeyFoldsTheSectionOfTheCaretWhichGoesToTheHeading) {
    show(report(section("A", section("Inner")) + section("B")));
    write();
    setCaret(place("Text of Inner") + 3);
    action("foldSection")->trigger();
    settle();
    EXPECT_TRUE(isFolded("Inner"));
    EXPECT_FALSE(isFolded("A"));
    const std::size_t end = place("Inner}</HEADING>") + 5;
    EXPECT_EQ(view().text().cursor().selection()->caret, end);
    action("foldSection")->trigger(); // of the heading where the caret is now
    settle();
    EXPECT_FALSE(isFolded("Inner"));
    action("foldAll")->trigger();
    settle();
    EXPECT_TRUE(isFolded("A"));
    EXPECT_TRUE(isFolded("B"));
    EXPECT_FALSE(shows("Inner"));
    action("unfoldAll")->trigger();
    settle();
    EXPECT_TRUE(shows("Text of Inner"));
}

TEST_F(FoldsTest, OtherViewsAndPaperAreWhole) {
    show(report(section("A") + section("B")));
    DocumentWindow* other = application_.addWindow(window_->shared());
    fold("A");
    EXPECT_FALSE(shows("Text of A"));
    EXPECT_FALSE(places::findText(other->view().pages(), "Text of A").empty());
    const auto paper = window_->document().presented({});
    EXPECT_FALSE(places::findText(paper->pages(), "Text of A").empty());
    other->close();
}

TEST_F(FoldsTest, ASearchCountsWhatIsFoldedAndUnfoldsWhatItStepsTo) {
    show(report(section("A") + section("B") + section("C")));
    fold("A");
    fold("B");
    auto& bar = *window_->findChild<panes::FindBar*>();
    action("find")->trigger();
    bar.field().setText("Text of");
    EXPECT_EQ(bar.says(), "3 of 3"); // the one that is seen
    EXPECT_TRUE(isFolded("A"));
    EXPECT_TRUE(isFolded("B"));
    bar.next(-1);
    settle();
    EXPECT_EQ(bar.says(), "2 of 3");
    EXPECT_TRUE(isFolded("A"));
    EXPECT_FALSE(isFolded("B"));
    bar.field().setText("Text of A");
    EXPECT_EQ(bar.says(), "1, folded");
    EXPECT_TRUE(isFolded("A"));
    bar.next(1);
    settle();
    EXPECT_EQ(bar.says(), "1 of 1");
    EXPECT_FALSE(isFolded("A"));
    fold("A");
    EXPECT_EQ(bar.says(), "1, folded");
}

TEST_F(FoldsTest, AllIsReplacedAlsoInWhatIsFolded) {
    show(report(section("A") + section("B")));
    write();
    fold("A");
    action("replaceWords")->trigger();
    window_->findChild<QLineEdit*>("find")->setText("Text");
    window_->findChild<QLineEdit*>("replaceWith")->setText("Words");
    window_->findChild<QAbstractButton*>("replaceAll")->click();
    settle();
    EXPECT_TRUE(shows("Words of A"));
    EXPECT_TRUE(shows("Words of B"));
    EXPECT_EQ(document().steps(), 1u);
}

TEST_F(FoldsTest, AReferenceTheOutlineAndGoingBackUnfold) {
    show(
        report("<PARAGRAPH>{See }<REF TO=\"B\"></REF></PARAGRAPH>\n" + section("A", section("B"))));
    fold("B");
    fold("A");
    view().goToElement(heading("B"));
    EXPECT_FALSE(isFolded("A"));
    EXPECT_TRUE(isFolded("B")); // its heading is seen
    view().goTo(place("Text of B"));
    EXPECT_FALSE(isFolded("B"));
    fold("A");
    const places::Carets carets(view().pages(), document().tree());
    const auto before = carets.of(place("See ") + 4, 0);
    const QRectF at = view().inViewport(before->page, carets.rectOf(*before));
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {},
                      (at.center() + QPointF(12, 0)).toPoint());
    settle();
    EXPECT_FALSE(isFolded("A"));
}

TEST_F(FoldsTest, TheCaretAndUndoUnfold) {
    show(report(section("A") + section("B")));
    write();
    setCaret(place("Text of A") + 4);
    QTest::keyClicks(view().viewport(), "x");
    fold("A");
    setCaret(place("Text of B"));
    document().undo();
    settle();
    EXPECT_FALSE(isFolded("A"));
    EXPECT_TRUE(shows("Text of A"));
}

// A folded section is a unit behind its heading: what would change a part of it unfolds it first.
TEST_F(FoldsTest, NothingThatIsHiddenChangesUnseen) {
    show(report(section("A") + section("B")));
    write();
    const std::string before = document().bytes();
    const std::size_t end = place("A}</HEADING>") + 1, behind = place("{B}</HEADING>") + 1;
    const auto unfoldsAlone = [&](document::Selection at, const std::function<void()>& act) {
        fold("A");
        view().text().cursor().set(at);
        EXPECT_TRUE(isFolded("A"));
        act();
        settle();
        EXPECT_EQ(document().bytes(), before);
        EXPECT_FALSE(isFolded("A"));
    };
    const auto press = [&](Qt::Key key) {
        return [this, key] { QTest::keyClick(view().viewport(), key); };
    };
    unfoldsAlone({end, end}, press(Qt::Key_Delete));
    EXPECT_THAT(window_->statusBar()->currentMessage().toStdString(),
                ::testing::HasSubstr("unfolded"));
    unfoldsAlone({end, end}, press(Qt::Key_Return));
    unfoldsAlone({behind, behind}, press(Qt::Key_Backspace));
    unfoldsAlone({end, behind + 1}, press(Qt::Key_Delete));
    unfoldsAlone({end, behind}, [this] { action("cut")->trigger(); });
    QApplication::clipboard()->setText("one\n\ntwo");
    unfoldsAlone({end, end}, [this] { action("paste")->trigger(); });
    // The same key once more does it.
    setCaret(end);
    QTest::keyClick(view().viewport(), Qt::Key_Delete);
    settle();
    EXPECT_TRUE(shows("AText of A"));
}

TEST_F(FoldsTest, AHeadingIsWrittenAndAWholeSectionGoesFolded) {
    show(report(section("A") + section("B") + section("C")));
    write();
    fold("A");
    fold("B");
    setCaret(place("A}</HEADING>"));
    QTest::keyClicks(view().viewport(), "New ");
    QTest::keyClick(view().viewport(), Qt::Key_Delete);
    settle();
    EXPECT_TRUE(isFolded("New ")); // that is seen
    view().text().cursor().set({place("{B}</HEADING>") + 1, place("{C}</HEADING>") + 1});
    QTest::keyClick(view().viewport(), Qt::Key_Delete);
    settle();
    EXPECT_TRUE(isFolded("New "));
    EXPECT_THAT(document().bytes(), ::testing::Not(::testing::HasSubstr("Text of B")));
    EXPECT_TRUE(shows("Text of C"));
}

TEST_F(FoldsTest, AllIsSelectedWithWhatIsFoldedAtTheEnd) {
    show(report(section("A") + section("B")));
    write();
    fold("B");
    action("selectAll")->trigger();
    EXPECT_TRUE(isFolded("B"));
    EXPECT_THAT(view().text().copied()->text().toStdString(), ::testing::HasSubstr("Text of B"));
}

TEST_F(FoldsTest, AFigureInWhatIsFoldedIsNotShownAndItsMediumRests) {
    show(report(section("A", scripted("red")) + section("B")));
    ASSERT_EQ(view().visibleSubdocuments().size(), 1u);
    EXPECT_NE(view().rendition(nth(*window_, 0)), nullptr);
    fold("A");
    EXPECT_TRUE(view().visibleSubdocuments().empty());
    EXPECT_EQ(view().rendition(nth(*window_, 0)), nullptr);
    view().scrollTo(nth(*window_, 0));
    EXPECT_FALSE(isFolded("A"));
    EXPECT_EQ(view().visibleSubdocuments().size(), 1u);
}

TEST_F(FoldsTest, ADocumentOpensAsItWasFolded) {
    show(report(section("A") + section("B")));
    fold("A");
    const QString name = document().fileName();
    const QPointer<DocumentWindow> closed = window_;
    window_->close();
    ASSERT_TRUE(waitFor([&] { return closed.isNull(); }));
    window_ = application_.open(name);
    ASSERT_TRUE(window_);
    ASSERT_TRUE(waitFor([&] { return folds().foldsAny() && view().isLaidOut(); }));
    EXPECT_TRUE(isFolded("A"));
    EXPECT_FALSE(isFolded("B"));
    EXPECT_FALSE(document().isModified());
}

} // namespace
} // namespace writing
