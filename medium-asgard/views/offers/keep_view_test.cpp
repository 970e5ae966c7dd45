// Keeping what is seen as a view of the text.
#include "offers/keep_view.h"

#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>

namespace views {
namespace {

class KeepViewTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

TEST_F(KeepViewTest, AViewThatIsKeptInAnOlderTextSaysSo) {
    editor.document().setText(ballScene + "view side -rot {0 1 0}\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const std::string other = editor.document().text() + "# other\n";
    QTimer::singleShot(50, viewer, [&] {
        auto* dialog = viewer->findChild<KeepViewDialog*>();
        ASSERT_NE(dialog, nullptr);
        editor.document().setText(other, "Elsewhere");
        dialog->accept();
    });
    for (QAction* action : viewer->findChildren<QAction*>())
        if (action->text().remove('&') == "Keep This View")
            action->trigger();
    EXPECT_TRUE(viewer->display().editing().said().startsWith("The text was changed meanwhile"));
    EXPECT_EQ(editor.document().text(), other);
}

TEST_F(KeepViewTest, AViewThatIsThereIsChangedToWhatIsSeen) {
    const std::string views = "view side -rot {0 1 0} -scale 0.5 ;# mine\n"
                              "view eye -eye {0 0 9} -look {0 0 0}\n"
                              "view led -rot {{0.1 * t} 0 0}\n";
    editor.document().setText(ballScene + views, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    EXPECT_EQ(display.lastView(), "side");
    render::Camera camera = display.camera();
    camera.rotation = geometry::fromRotationVector({0, 0.25, 0});
    camera.position = {0.125, 0, 0};
    camera.scale = 0.75;
    display.setCamera(camera);
    const Eigen::Vector2d seen = display.sight().pixels({-1, 0.3, 0.4});
    for (const char* name : {"side", "eye"}) {
        KeepViewDialog dialog(editor.document(), display.sight(), name, viewer);
        EXPECT_EQ(dialog.name(), name);
        EXPECT_FALSE(dialog.wantsNew());
        ASSERT_TRUE(dialog.answer().possible()) << dialog.answer().reason;
        editor.document().setText(text::applied(editor.document().text(), dialog.answer().edits),
                                  "Keep");
        ASSERT_TRUE(settle(editor.document()));
        display.followView(name);
        display.grab();
        EXPECT_LT((display.sight().pixels({-1, 0.3, 0.4}) - seen).norm(), 1) << name;
    }
    const std::string& text = editor.document().text();
    EXPECT_NE(text.find("view side -rot {0 0.25 0} -scale 0.75 "), std::string::npos) << text;
    EXPECT_NE(text.find(";# mine\nview eye -eye {"), std::string::npos);
    // What an expression gives stays, and says so.
    KeepViewDialog dialog(editor.document(), display.sight(), "led", viewer);
    EXPECT_FALSE(dialog.answer().possible());
    dialog.views().setCurrentIndex(dialog.views().count() - 1);
    EXPECT_TRUE(dialog.wantsNew());
}

} // namespace
} // namespace views
