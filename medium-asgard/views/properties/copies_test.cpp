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
    EXPECT_THAT(document.text(), HasSubstr("body a3 s -init_pos {3.2 2 0} -mass 2\n"));
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
