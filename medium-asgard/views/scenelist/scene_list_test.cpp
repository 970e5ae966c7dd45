// The list of elements: what it shows, and the selection and names through it.
#include "scenelist/scene_list.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QLineEdit>

namespace views {
namespace {

using editing::Element;
using editing::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string scene = "shape_set s -desc {-sub {-sphere 0.5}} -color red\n"
                          "body a s -init_pos {1 2 0}\n"
                          "body b s -init_pos {4 2 0}\n"
                          "force -body a -gravitational {0 -9.81 0}\n"
                          "spring -body1 a -body2 b -stiffness 5\n"
                          "joint pin -type ball -body1 b\n";

class SceneListTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        document.setText(scene, "Edit");
        ASSERT_TRUE(settle(document));
        list.show();
        QTest::qWait(60);
    }
    std::vector<std::string> shown() { // the tree as lines, children with a dash
        std::vector<std::string> lines;
        for (QTreeWidgetItemIterator at(&list.tree()); *at; ++at)
            if (!(*at)->isHidden() && !((*at)->parent() && (*at)->parent()->isHidden()))
                lines.push_back(((*at)->parent() ? "- " : "") + (*at)->text(0).toStdString());
        return lines;
    }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    std::optional<Element> opened, hidden;
    std::vector<Element> removed;
    SceneList list{document,
                   {[this](const Element& element) { opened = element; },
                    [](const Element&, const QPoint&) {},
                    [this](const std::vector<Element>& elements) { removed = elements; },
                    [this](const Element& element) { return hidden == element; },
                    [this](const Element& element, bool hides) {
                        hidden = hides ? std::optional(element) : std::nullopt;
                        list.showHidden();
                    }}};
};

TEST_F(SceneListTest, HasEachElementByItsKind) {
    EXPECT_THAT(shown(),
                ElementsAre("Shapes (1)", "- s", "Bodies (2)", "- a", "- b", "Forces (1)",
                            "- weight of a", "Springs (1)", "- a – b", "Joints (1)", "- pin"));
    list.order().setCurrentIndex(1);
    Q_EMIT list.order().activated(1);
    EXPECT_THAT(shown(), ElementsAre("s", "a", "b", "weight of a", "a – b", "pin"));
}

// A blue body is seen in a selected row, which is blue.
TEST_F(SceneListTest, ARingPartsTheColourOfABodyFromItsRow) {
    const QTreeWidgetItem* item = list.itemOf({Kind::body, 0});
    ASSERT_TRUE(item);
    const QImage drawn = item->icon(0).pixmap(24, 24).toImage();
    EXPECT_EQ(drawn.pixelColor(drawn.width() / 2, drawn.height() / 2), QColor(Qt::red));
    EXPECT_EQ(drawn.pixelColor(drawn.width() / 2, 1), list.palette().color(QPalette::Base));
}

// The list follows a scene a moment later.
TEST_F(SceneListTest, AnotherOrderIsThatOfTheSceneThatHasJustCome) {
    Computed computed;
    computed.text = document.text();
    document.setComputed(computed); // a scene without elements
    list.order().setCurrentIndex(1);
    Q_EMIT list.order().activated(1);
    EXPECT_THAT(shown(), ElementsAre());
}

TEST_F(SceneListTest, FollowsTheSelectionAndSelects) {
    document.select({{Kind::body, 1}});
    EXPECT_TRUE(list.itemOf({Kind::body, 1})->isSelected());
    list.itemOf({Kind::joint, 0})->setSelected(true);
    EXPECT_THAT(document.selected(), ElementsAre(Element{Kind::body, 1}, Element{Kind::joint, 0}));
    list.tree().clearSelection();
    EXPECT_TRUE(document.selected().empty());
}

TEST_F(SceneListTest, AFilterNarrowsIt) {
    list.filter().setText("spring");
    EXPECT_THAT(shown(), ElementsAre("Springs (1)", "- a – b"));
    list.filter().setText("pin");
    EXPECT_THAT(shown(), ElementsAre("Joints (1)", "- pin"));
    list.filter().clear();
    EXPECT_EQ(shown().size(), 11U);
}

// It begins no name: one of them is meant.
TEST_F(SceneListTest, AClickOnOneOfSeveralSelectedSelectsIt) {
    document.select({{Kind::body, 0}, {Kind::body, 1}, {Kind::force, 0}});
    QTest::qWait(60);
    const QRect row = list.tree().visualItemRect(list.itemOf({Kind::body, 1}));
    QTest::mouseClick(list.tree().viewport(), Qt::LeftButton, {}, row.center());
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    EXPECT_THAT(document.selected(), ElementsAre(Element{Kind::body, 1}));
    EXPECT_EQ(list.tree().findChild<QLineEdit*>(), nullptr);
}

TEST_F(SceneListTest, ARenamedElementHasItsNameInAllOfTheText) {
    list.itemOf({Kind::body, 0})->setText(0, "ball");
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("spring -body1 ball -body2 b"));
    EXPECT_EQ(document.undoLabel(), "Rename a");
    QTest::qWait(60);
    EXPECT_EQ(list.itemOf({Kind::body, 0})->text(0), "ball");
    list.itemOf({Kind::body, 0})->setText(0, "b");
    EXPECT_THAT(list.fault().toStdString(), HasSubstr("\"b\" is the name of something else"));
    EXPECT_EQ(list.itemOf({Kind::body, 0})->text(0), "ball");
}

TEST_F(SceneListTest, KeysOpenAndRemove) {
    document.select({{Kind::body, 0}});
    list.tree().setCurrentItem(list.itemOf({Kind::body, 0}));
    QTest::keyClick(&list.tree(), Qt::Key_Return);
    EXPECT_EQ(opened, (Element{Kind::body, 0}));
    QTest::keyClick(&list.tree(), Qt::Key_Delete);
    EXPECT_THAT(removed, ElementsAre(Element{Kind::body, 0}));
}

// F, N, Shift+F and the blank mean in the list what they mean everywhere.
TEST_F(SceneListTest, LettersAreTheWindows) {
    list.tree().setCurrentItem(list.itemOf({Kind::body, 0}));
    const auto keeps = [&](int key, Qt::KeyboardModifiers with = {}) {
        QKeyEvent asked(QEvent::ShortcutOverride, key, with);
        asked.ignore();
        QCoreApplication::sendEvent(&list.tree(), &asked);
        return asked.isAccepted();
    };
    for (const int key : {Qt::Key_F, Qt::Key_N, Qt::Key_Space, Qt::Key_F4})
        EXPECT_FALSE(keeps(key)) << key;
    EXPECT_FALSE(keeps(Qt::Key_F, Qt::ShiftModifier));
    for (const int key : {Qt::Key_Down, Qt::Key_Return, Qt::Key_Delete, Qt::Key_Home})
        EXPECT_TRUE(keeps(key)) << key;
}

// As each move of a drag does.
TEST_F(SceneListTest, NumbersOfAnotherLengthLeaveTheItems) {
    list.tree().setCurrentItem(list.itemOf({Kind::joint, 0}));
    const QTreeWidgetItem* item = list.itemOf({Kind::joint, 0});
    std::string text = scene;
    text.replace(text.find("{1 2 0}"), 7, "{1.25 2.125 0}");
    document.setText(text, "Edit");
    ASSERT_TRUE(settle(document));
    QTest::qWait(60);
    EXPECT_EQ(list.itemOf({Kind::joint, 0}), item);
    EXPECT_EQ(list.tree().currentItem(), item);
}

TEST_F(SceneListTest, FoldedGroupsStayFoldedWhenTheSceneChanges) {
    list.itemOf({Kind::body, 0})->parent()->setExpanded(false);
    document.setText(scene + "body c s -init_pos {7 2 0}\n", "Edit");
    ASSERT_TRUE(settle(document));
    QTest::qWait(60);
    EXPECT_EQ(list.itemOf({Kind::body, 2})->parent()->text(0), "Bodies (3)");
    EXPECT_FALSE(list.itemOf({Kind::body, 2})->parent()->isExpanded());
}

TEST_F(SceneListTest, AnEyeBesideABodyHidesIt) {
    QTreeWidgetItem* item = list.itemOf({Kind::body, 1});
    EXPECT_EQ(item->data(1, Qt::AccessibleTextRole).toString(), "shown");
    Q_EMIT list.tree().itemClicked(item, 0);
    EXPECT_FALSE(hidden);
    Q_EMIT list.tree().itemClicked(item, 1);
    EXPECT_EQ(hidden, (Element{Kind::body, 1}));
    EXPECT_EQ(item->data(1, Qt::AccessibleTextRole).toString(), "hidden");
    Q_EMIT list.tree().itemClicked(item, 1);
    EXPECT_FALSE(hidden);
    EXPECT_TRUE(list.itemOf({Kind::force, 0})->icon(1).isNull());
}

} // namespace
} // namespace views
