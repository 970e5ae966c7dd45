// Faults of text and motion in one list, and where they lead.
#include "faults/fault_list.h"

#include "faults/close_joints.h"
#include "physics/assembly.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QPaintEvent>
#include <QThreadPool>

namespace views {
namespace {

using editing::Element;
using editing::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class FaultListTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& text) {
        document.setText(text, "Edit");
        ASSERT_TRUE(settle(document));
        list.show();
    }
    void click(int index) { Q_EMIT list.list().itemClicked(list.list().topLevelItem(index), 0); }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    std::optional<double> sought;
    int texts = 0;
    FaultList list{document, {[this](double time) { sought = time; }, [this] { ++texts; }}};
};

TEST_F(FaultListTest, SaysThatThereIsNone) {
    open(ballScene);
    EXPECT_EQ(list.summary(), "No faults");
    EXPECT_EQ(list.list().topLevelItemCount(), 0);
}

TEST_F(FaultListTest, HasTheFaultsOfTheTextWithTheirLines) {
    open(ballScene + "body b2 bell\n");
    ASSERT_EQ(list.list().topLevelItemCount(), 1);
    EXPECT_THAT(list.list().topLevelItem(0)->text(0).toStdString(), HasSubstr("bell"));
    EXPECT_EQ(list.list().topLevelItem(0)->text(1), "4");
    EXPECT_THAT(list.summary().toStdString(), HasSubstr("1 error"));
    document.undo();
    ASSERT_TRUE(settle(document));
}

TEST_F(FaultListTest, TheSameFaultsKeepTheirPlaceInTheList) {
    open(ballScene + "body b2 bell\nbody b3 bell\n");
    ASSERT_EQ(list.list().topLevelItemCount(), 2);
    QTreeWidgetItem* second = list.list().topLevelItem(1);
    list.list().setCurrentItem(second);
    Q_EMIT document.workChanged();
    ASSERT_EQ(list.list().topLevelItemCount(), 2);
    EXPECT_EQ(list.list().currentItem(), second);
    document.undo();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(list.list().topLevelItemCount(), 0);
}

// Of an item that is gone no number stays on the screen.
TEST_F(FaultListTest, AListThatChangesIsPaintedWhole) {
    struct Painted : QObject {
        QRegion region;
        bool eventFilter(QObject* /*watched*/, QEvent* event) override {
            if (event->type() == QEvent::Paint)
                region += static_cast<QPaintEvent*>(event)->region();
            return false;
        }
    } painted;
    open(ballScene + "body b2 bell\n");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&list, longestWait));
    QWidget* viewport = list.list().viewport();
    QTest::qWait(50);
    viewport->installEventFilter(&painted);
    document.undo();
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(list.summary(), "No faults");
    EXPECT_TRUE(
        waitFor([&] { return QRegion(viewport->rect()).subtracted(painted.region).isEmpty(); }));
}

TEST_F(FaultListTest, OffersToCloseAJointThatItsBodiesMiss) {
    const std::string text = ballScene +
                             "body arm ball -init_pos {3 0.5 0} -mass 1\n"
                             "joint pin -type ball -body1 arm -offset1 {0 0 0} -offset2 {3 0 0}\n";
    open(text);
    auto* offer = list.findChild<CloseJoints*>();
    ASSERT_NE(offer, nullptr);
    EXPECT_FALSE(offer->isVisibleTo(&list));
    Computed computed{document.shown(), document.text(), {}, {}, Work::none, true};
    scene::Diagnostic fault; // as the engine says it: the test's workshop computes no motion
    fault.message =
        "joint \"pin\": its bodies miss each other by 0.5 at the start; " + physics::closeAdvice();
    computed.diagnostics = {fault};
    document.setComputed(computed);
    ASSERT_TRUE(offer->isVisibleTo(&list));
    EXPECT_EQ(offer->text(), "Close It");
    // While it is found out, windows go on; a text that changes meanwhile stays.
    offer->click();
    EXPECT_EQ(offer->text(), "Stop Moving");
    EXPECT_EQ(document.text(), text);
    document.setText("# before\n" + text, "Edit");
    EXPECT_THAT(offer->reason().toStdString(), HasSubstr("changed meanwhile"));
    EXPECT_EQ(document.text(), "# before\n" + text);
    document.undo();
    ASSERT_TRUE(settle(document));
    computed.shown = document.shown();
    document.setComputed(computed);
    ASSERT_TRUE(offer->isVisibleTo(&list));
    offer->click();
    ASSERT_TRUE(waitFor([&] { return document.text() != text; }));
    EXPECT_EQ(offer->reason(), "");
    EXPECT_THAT(document.text(), HasSubstr("body arm ball -init_pos {3 0 0}"));
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(offer->isVisibleTo(&list));
    document.undo();
    EXPECT_EQ(document.text(), text);
    // A double click closes it, as one click does.
    ASSERT_TRUE(settle(document));
    computed.shown = document.shown();
    document.setComputed(computed);
    const QPoint middle = offer->rect().center();
    QTest::mouseClick(offer, Qt::LeftButton, {}, middle);
    QTest::mouseDClick(offer, Qt::LeftButton, {}, middle); // the second press alone
    QTest::mouseRelease(offer, Qt::LeftButton, {}, middle);
    EXPECT_EQ(offer->reason(), "");
    ASSERT_TRUE(waitFor([&] { return document.text() != text; }));
    document.undo();
    EXPECT_EQ(document.text(), text);
    // A second click ends the search: nothing comes of it.
    ASSERT_TRUE(settle(document));
    computed.shown = document.shown();
    document.setComputed(computed);
    offer->click();
    offer->click();
    EXPECT_EQ(offer->text(), "Close It");
    EXPECT_THAT(offer->reason().toStdString(), HasSubstr("Stopped"));
    ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(longestWait));
    QCoreApplication::processEvents();
    EXPECT_EQ(document.text(), text);
}

TEST_F(FaultListTest, AClickSelectsTheElementAndGoesToTheTime) {
    open(ballScene);
    Computed computed{document.shown(), document.text(), {}, {}, Work::none, true};
    scene::Diagnostic fault;
    fault.message = "body \"b1\" stops at t = 1.5";
    fault.range = document.shown().scene->bodies[0].source.command;
    fault.line = 3;
    fault.time = 1.5;
    computed.diagnostics = {fault};
    document.setComputed(computed);
    ASSERT_EQ(list.list().topLevelItemCount(), 1);
    EXPECT_EQ(list.list().topLevelItem(0)->text(2), "1.5 s");
    click(0);
    EXPECT_THAT(document.selected(), ElementsAre(Element{Kind::body, 0}));
    EXPECT_EQ(sought, 1.5);
    EXPECT_EQ(texts, 0);
    Q_EMIT list.list().itemActivated(list.list().topLevelItem(0), 0);
    EXPECT_EQ(texts, 1);
}

} // namespace
} // namespace views
