// Copies by the viewer's commands.
#include "properties/element_commands.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QClipboard>

namespace views {
namespace {

using editing::Element;
using editing::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string withWeight = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                               "body a s -init_pos {1 2 0} -mass 2\nbody b s -init_pos {4 2 0}\n"
                               "force -body a -y {-9.81 * a.mass}\n";

class CopiesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    TestWorkshop made;
    SceneDocument document{made.workshop()};
    ElementCommands commands{document};
};

TEST_F(CopiesTest, CopyPasteAndDuplicate) {
    document.setText(withWeight, "Edit");
    ASSERT_TRUE(settle(document));
    document.select({{Kind::body, 0}});
    commands.copy();
    EXPECT_THAT(QGuiApplication::clipboard()->text().toStdString(), HasSubstr("body a s"));
    commands.duplicate();
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("body a2 s -init_pos {2.1 2 0} -mass 2\n"));
    EXPECT_EQ(document.undoLabel(), "Duplicate");
    EXPECT_THAT(document.selected(), ElementsAre(Element{Kind::body, 2}));
    commands.paste();
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("body a3 s -init_pos {5.4 2 0} -mass 2\n"));
    EXPECT_EQ(document.text().find("{3.2 2 0}"), std::string::npos); // inside of b
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), withWeight);
}

TEST_F(CopiesTest, IntoAnotherScene) {
    document.setText(withWeight, "Edit");
    ASSERT_TRUE(settle(document));
    document.select({{Kind::body, 0}});
    commands.copy();
    document.setText("", "Edit");
    ASSERT_TRUE(settle(document));
    commands.paste();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.shown().scene->bodies.size(), 1U);
    EXPECT_EQ(document.shown().scene->forces.size(), 1U);
}

// From another window they keep their places, unless bodies are there.
TEST_F(CopiesTest, CopiesStandInNoOtherBody) {
    const std::string shape = "shape_set s -desc {-sub {-sphere 0.5}}\n";
    const auto pasted = [&](const std::string& there) {
        document.setText(shape + "body a s -init_pos {1 2 0}\n", "Edit");
        EXPECT_TRUE(settle(document));
        document.select({{Kind::body, 0}});
        commands.copy();
        document.setText(there, "Edit");
        EXPECT_TRUE(settle(document));
        commands.paste();
        EXPECT_TRUE(settle(document));
        return document.shown().scene->bodies.back().initialPosition.x();
    };
    EXPECT_EQ(pasted(shape + "body f s -init_pos {1.9 3 0}\n"), 1);
    EXPECT_EQ(pasted(shape + "body f s -init_pos {1.4 2 0}\n"), 3); // at 2 it is inside still
    EXPECT_EQ(pasted("shape_set wall -desc {-sub {-box {1 9 9}}}\nbody f wall -init_pos {1 0 0}\n"),
              2);
    document.setText(shape + "shape_set plane -desc {-sub {-plane}}\nbody ground plane -fixed 1\n"
                             "body a s -init_pos {0 0.5 0}\nbody b s -init_pos {1 0.5 0}\n",
                     "Edit");
    ASSERT_TRUE(settle(document));
    document.select({{Kind::body, 2}});
    commands.duplicate(); // on the floor, beside both
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("body b2 s -init_pos {2.1 0.5 0}\n"));
}

TEST_F(CopiesTest, OtherTextOnTheClipboardIsRefused) {
    QString said;
    QObject::connect(&commands, &ElementCommands::refused, [&](const QString& why) { said = why; });
    document.setText(withWeight, "Edit");
    ASSERT_TRUE(settle(document));
    QGuiApplication::clipboard()->setText("Dear Ann,");
    commands.paste();
    EXPECT_EQ(said, "The clipboard holds no commands of a scene.");
    EXPECT_EQ(document.text(), withWeight);
}

} // namespace
} // namespace views
