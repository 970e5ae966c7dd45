// The things around the pages: the outline, Back and Forward, places that are kept, pages side by
// side and on the whole screen.
#include "navigation/go_menu.h"
#include "navigation/slide_show.h"
#include "panes/outline_list.h"
#include "panes/outline_pane.h"
#include "panes/text_count_dialog.h"
#include "view/text_hand.h"
#include "view/writing.h"
#include "window/window_testing.h"

#include <QComboBox>
#include <QSpinBox>

namespace window {
namespace {

QByteArray lines(int count) {
    QByteArray all;
    for (int i = 0; i < count; ++i)
        all += paragraph("A line");
    return all;
}

class AroundTest : public WindowTest {
protected:
    void show(const QByteArray& bytes) {
        window_ = open(bytes);
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    }
    void showOutline(const QByteArray& bytes) {
        show(bytes);
        action("showOutline")->trigger();
        ASSERT_TRUE(waitFor([&] { return list().topLevelItemCount() > 0; }));
    }
    void write() { writeIn(*window_); }
    view::DocumentView& view() const { return window_->view(); }
    QScrollBar& bar() const { return *view().verticalScrollBar(); }
    document::Document& document() const { return window_->document().document(); }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    panes::OutlineList& list() const { return *window_->findChild<panes::OutlineList*>(); }
    panes::OutlinePane& pane() const { return *window_->findChild<panes::OutlinePane*>(); }
    // As they are indented.
    std::vector<std::string> listed() const {
        std::vector<std::string> result;
        for (QTreeWidgetItemIterator at(&list()); *at != nullptr; ++at) {
            int depth = 0;
            for (const QTreeWidgetItem* up = (*at)->parent(); up; up = up->parent())
                ++depth;
            result.push_back(std::string(static_cast<std::size_t>(depth), '-') +
                             (*at)->text(0).toStdString());
        }
        return result;
    }
    QTreeWidgetItem* item(const char* text) const {
        return list().findItems(text, Qt::MatchFixedString | Qt::MatchRecursive).value(0);
    }
    void choose(const char* text) const {
        list().setCurrentItem(item(text));
        list().setFocus();
    }
    std::string current() const {
        return list().currentItem() ? list().currentItem()->text(0).toStdString() : "";
    }

    navigation::SlideShow* present() const {
        action("present")->trigger();
        auto* slides = window_->findChild<navigation::SlideShow*>();
        EXPECT_TRUE(slides && waitFor([&] { return slides->isVisible() && slides->isLaidOut(); }));
        return slides;
    }

    DocumentWindow* window_ = nullptr;
};

using ::testing::ElementsAre;

TEST_F(AroundTest, TheOutlineFollowsTheDocumentAndLeadsToItsPlaces) {
    showOutline(report(section("A", lines(80)) + section("B", section("B1", lines(80)))));
    EXPECT_THAT(listed(), ElementsAre("1 A", "2 B", "-2.1 B1"));
    ASSERT_TRUE(waitFor([&] { return view().zoom() <= view().widthZoom(); }));
    constexpr int begin = 120;
    bar().setValue(begin);
    EXPECT_EQ(current(), "1 A"); // where one reads
    Q_EMIT list().itemClicked(item("2.1 B1"), 0);
    EXPECT_GT(bar().value(), begin);
    const int there = bar().value();
    EXPECT_EQ(current(), "2.1 B1");

    const std::size_t at = document().bytes().find("{B1}") + 1;
    document().edit({{{at, at + 2}, "Other"}}, "test");
    EXPECT_TRUE(waitFor([&] { return item("2.1 Other") != nullptr; }));

    action("goBack")->trigger();
    EXPECT_NEAR(bar().value(), begin, 1);
    action("goForward")->trigger();
    EXPECT_NEAR(bar().value(), there, 1);
    EXPECT_FALSE(action("goForward")->isEnabled());
}

TEST_F(AroundTest, FiguresAndTablesAreListsOfTheirOwn) {
    showOutline(report(section("A", "<TABLE><CAPTION>{Sizes}</CAPTION><ROW><CELL>{1}</CELL></ROW>"
                                    "</TABLE>\n<FIGURE>" +
                                        scripted("red").mid(11).chopped(13) +
                                        "<CAPTION>{Ball}</CAPTION></FIGURE>\n")));
    auto* kind = window_->findChild<QComboBox*>("outlineKind");
    kind->setCurrentIndex(1);
    EXPECT_THAT(listed(), ElementsAre("Figure 1: Ball"));
    kind->setCurrentIndex(2);
    EXPECT_THAT(listed(), ElementsAre("Table 1: Sizes"));
}

TEST_F(AroundTest, SectionsAreMovedByKeysAsOneStep) {
    showOutline(report(section("A") + section("B", section("B1"))));
    const std::string before = document().bytes();
    choose("2 B");
    QTest::keyClick(&list(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(document().bytes(), before); // nobody writes
    write();
    choose("2 B");
    QTest::keyClick(&list(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_THAT(listed(), ElementsAre("1 B", "-1.1 B1", "2 A"));
    EXPECT_EQ(current(), "1 B");
    EXPECT_EQ(document().steps(), 1u);
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_TRUE(waitFor([&] { return item("2 B") != nullptr; }));
    choose("2.1 B1");
    QTest::keyClick(&list(), Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_THAT(listed(), ElementsAre("1 A", "2 B", "3 B1"));
    EXPECT_EQ(current(), "3 B1");
}

TEST_F(AroundTest, ALetterMakesNoRowsOfALongOutline) {
    QByteArray body;
    for (int i = 0; i < 1000; ++i)
        body += section("S" + QByteArray::number(i));
    showOutline(report(body));
    ASSERT_TRUE(waitFor([&] { return list().rowsMade() == 1000; }));
    const std::size_t read = pane().outline().blocksRead();
    const std::size_t at = document().bytes().find("{S500}") + 1;
    document().edit({{{at, at}, "x"}}, "test");
    ASSERT_TRUE(waitFor([&] { return item("501 xS500") != nullptr; }));
    EXPECT_EQ(list().rowsMade(), 1000);
    EXPECT_EQ(pane().outline().blocksRead() - read, 1u);
    // A pane that is not seen does nothing.
    action("showOutline")->trigger();
    document().edit({{{at, at}, "y"}}, "test");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    QCoreApplication::processEvents();
    EXPECT_EQ(pane().outline().blocksRead() - read, 1u);
}

// --- back and forward ------------------------------------------------------------------------

TEST_F(AroundTest, ASearchIsOneJumpAndPlacesFollowEdits) {
    show(report(section("A", lines(60) + paragraph("needle") + lines(60) + paragraph("needle"))));
    EXPECT_FALSE(action("goBack")->isEnabled());
    bar().setValue(700);
    view().find("needle");
    view().showFound(1);
    EXPECT_GT(bar().value(), 1500);
    const std::size_t at = document().bytes().find("<SECTION");
    document().edit({{{at, at}, section("New", lines(40)).toStdString()}}, "test");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    action("goBack")->trigger();
    EXPECT_GT(bar().value(), 1200); // what came before it
    EXPECT_LT(bar().value(), 2500);
    EXPECT_FALSE(action("goBack")->isEnabled());
    EXPECT_TRUE(action("goForward")->isEnabled());
}

TEST_F(AroundTest, TheKeysGoBackWhereOneWrites) {
    show(report(section("A", lines(60)) + section("B", lines(60))));
    write();
    bar().setValue(100);
    view().goTo(document().bytes().find("{B}") + 1);
    EXPECT_GT(bar().value(), 500);
    QTest::keyClick(&view(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_NEAR(bar().value(), 100, 1);
    QTest::keyClick(&view(), Qt::Key_Right, Qt::AltModifier);
    EXPECT_GT(bar().value(), 500);
}

TEST_F(AroundTest, TheKeyGoesToAPageAlsoWhereAFigureIsActive) {
    show(memo(scripted("red")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    view().choose(nth(*window_, 0));
    window_->activateWindow();
    view().setFocus();
    ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    bool isAsked = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&isAsked] {
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
            isAsked = true;
            dialog->reject();
        }
    });
    timer.start(5);
    QTest::keyClick(&view(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return isAsked; }, 5000));
}

TEST_F(AroundTest, TheNumberThatOneTypesIsThePageThatOneSees) {
    show(memo(lines(300)));
    ASSERT_GT(view().pages().pages.size(), 4u);
    window_->activateWindow();
    view().setFocus();
    ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&timer] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            return;
        timer.stop();
        auto* number = dialog->findChild<QSpinBox*>();
        ASSERT_TRUE(number);
        number->selectAll();
        QTest::keyClicks(number, "4");
        QTest::keyClick(number, Qt::Key_Return);
    });
    timer.start(5);
    QTest::keyClick(&view(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(view().currentPage(), 3u);
    action("goBack")->trigger();
    EXPECT_EQ(view().currentPage(), 0u);
}

// --- places that are kept --------------------------------------------------------------------

TEST_F(AroundTest, ADocumentOpensWhereOneReadIt) {
    show(memo(lines(300)));
    const QString file = document().fileName();
    view().setZoom(1.5);
    bar().setValue(3000);
    const auto place = view().readingPlace();
    ASSERT_TRUE(place);
    QPointer<DocumentWindow> closed = window_;
    window_->close();
    ASSERT_TRUE(waitFor([&] { return closed.isNull(); }));
    window_ = application_.open(file);
    ASSERT_TRUE(waitFor([&] { return bar().value() > 0; }));
    EXPECT_EQ(view().zoom(), 1.5);
    EXPECT_NEAR(bar().value(), 3000, 2);
}

// --- pages -----------------------------------------------------------------------------------

TEST_F(AroundTest, TwoPagesStandSideBySide) {
    show(memo(lines(200)));
    ASSERT_GT(view().pages().pages.size(), 3u);
    const int tall = bar().maximum();
    action("twoPages")->trigger();
    const QRectF all(QPointF(), view().pages().size);
    const QRectF left = view().inViewport(0, all), right = view().inViewport(1, all);
    EXPECT_EQ(left.top(), right.top());
    EXPECT_GT(right.left(), left.right());
    EXPECT_GT(view().inViewport(2, all).top(), left.bottom());
    EXPECT_LT(bar().maximum(), tall);
    EXPECT_TRUE(QRectF(view().viewport()->rect()).contains(QPointF(right.right(), 100)));
    EXPECT_EQ(view().pagePointAt(right.center()).first, 1u);
    action("twoPages")->trigger();
    EXPECT_EQ(view().spread(), view::Spread::column);
}

TEST_F(AroundTest, APageIsSeenWhole) {
    show(memo(lines(200)));
    action("fitPage")->trigger();
    const QRectF page = view().inViewport(view().currentPage(), {{}, view().pages().size});
    EXPECT_GE(page.top(), 0);
    EXPECT_LE(page.bottom(), view().viewport()->height() + 1);
}

TEST_F(AroundTest, APresentationShowsPageByPage) {
    show(memo(lines(100) + scripted("red")));
    const QPointer<navigation::SlideShow> slides = present();
    const std::size_t count = slides->pages().pages.size();
    ASSERT_GT(count, 3u);
    const auto whole = [&] {
        return slides->inViewport(slides->page(), {{}, slides->pages().size});
    };
    const auto isWhole = [&] {
        return QRectF(slides->viewport()->rect()).adjusted(-1, -1, 1, 1).contains(whole());
    };
    EXPECT_TRUE(waitFor(isWhole));
    QTest::keyClick(slides, Qt::Key_Space);
    EXPECT_EQ(slides->page(), 1u);
    EXPECT_TRUE(isWhole());
    QTest::keyClick(slides, Qt::Key_PageDown);
    QTest::keyClick(slides, Qt::Key_Left);
    EXPECT_EQ(slides->page(), 1u);
    QTest::mouseClick(slides->viewport(), Qt::LeftButton, {}, {5, 5});
    EXPECT_EQ(slides->page(), 2u);
    QTest::keyClick(slides, Qt::Key_End);
    EXPECT_EQ(slides->page(), count - 1);
    EXPECT_TRUE(isWhole());

    // Its figures play.
    const document::SubdocumentId figure = nth(*window_, 0);
    ASSERT_TRUE(waitFor([&] { return slides->rendition(figure) != nullptr; }));
    slides->choose(figure);
    QTest::keyClick(slides, Qt::Key_Escape);
    ASSERT_TRUE(slides);
    EXPECT_FALSE(slides->chosen());
    QTest::keyClick(slides, Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return slides.isNull(); }));
    // The last slide.
    EXPECT_THAT(view().visibleSubdocuments(), ::testing::Contains(figure));
}

// The pages of a memo are sheets; what is shown in a room are slides.
TEST_F(AroundTest, APresentationShowsSlidesAndTheViewKeepsItsPages) {
    show(memo(section("One", lines(30)) + section("Two", lines(30)) + section("Three", lines(30))));
    view().goTo(document().bytes().find("Text of Two"));
    const int scrolled = bar().value();
    const double zoom = view().zoom();
    QPointer<navigation::SlideShow> slides = present();
    EXPECT_GT(slides->pages().size.width(), slides->pages().size.height());
    EXPECT_EQ(slides->presentation(), "slides");
    const auto pageOf = [&](const std::string& words) {
        const places::Carets carets(slides->pages(), document().tree());
        return carets.of(document().bytes().find(words), 0)->page;
    };
    EXPECT_GE(slides->page(), pageOf("Text of Two")); // what one read
    EXPECT_LT(slides->page(), pageOf("Text of Three"));
    const auto leave = [&] {
        QTest::keyClick(slides, Qt::Key_Escape);
        EXPECT_TRUE(waitFor([&] { return slides.isNull(); }));
    };
    leave();
    EXPECT_EQ(view().presentation(), "");
    EXPECT_EQ(view().zoom(), zoom);
    EXPECT_EQ(bar().value(), scrolled);

    slides = present();
    QTest::keyClick(slides, Qt::Key_Home);
    EXPECT_EQ(slides->page(), 0u);
    leave();
    EXPECT_LT(bar().value(), scrolled); // where the audience was
    view().setPresentation("slides");
    slides = present();
    EXPECT_EQ(slides->presentation(), "slides");
    leave();
}

// --- how much text ---------------------------------------------------------------------------

TEST_F(AroundTest, WordsAreCountedInAllAndInTheSelection) {
    show(memo(paragraph("One two three") + paragraph("four")));
    const std::size_t at = document().bytes().find("two");
    view().text().cursor().set({at, at + 9});
    action("wordCount")->trigger();
    const auto* dialog = window_->findChild<panes::TextCountDialog*>();
    ASSERT_TRUE(dialog);
    const auto says = [&](const char* name) {
        return dialog->findChild<QLabel*>(name)->text().toStdString();
    };
    EXPECT_EQ(says("selected0"), "2");
    EXPECT_EQ(says("selected1"), "9");
    EXPECT_EQ(says("all0"), "5"); // the subject is one
    EXPECT_EQ(says("all3"), "1");
}

} // namespace
} // namespace window
