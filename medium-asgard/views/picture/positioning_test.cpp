// Where a picture is seen from, and the menu of what is in it.
#include "picture/keep_view.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>

namespace views {
namespace {

class PositioningTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

// Each key and back again.
TEST_F(PositioningTest, TheKeysTurnMoveRollAndScaleTheView) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const render::Camera before = viewer->display().camera();
    const auto key = [&](Qt::Key which, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(&viewer->display(), which, modifiers);
        return viewer->display().camera();
    };
    const auto turned = [&](const render::Camera& now) {
        return geometry::toRotationVector(now.rotation * before.rotation.conjugate());
    };
    EXPECT_GT(turned(key(Qt::Key_Right, Qt::AltModifier)).y(), 0.05);
    key(Qt::Key_Left, Qt::AltModifier);
    EXPECT_LT(turned(key(Qt::Key_Up, Qt::AltModifier)).x(), -0.05);
    key(Qt::Key_Down, Qt::AltModifier);
    EXPECT_GT(turned(key(Qt::Key_PageUp, Qt::AltModifier)).z(), 0.05);
    EXPECT_TRUE(key(Qt::Key_PageDown, Qt::AltModifier).rotation.isApprox(before.rotation));
    EXPECT_GT(key(Qt::Key_Up, Qt::ControlModifier).position.y(), before.position.y());
    EXPECT_TRUE(key(Qt::Key_Down, Qt::ControlModifier).position.isApprox(before.position));
    EXPECT_GT(key(Qt::Key_Plus, {}).scale, before.scale);
    EXPECT_NEAR(key(Qt::Key_Minus, {}).scale, before.scale, 1e-12);
    EXPECT_EQ(editor.document().text(), ballScene);
}

TEST_F(PositioningTest, TheHorizonIsLevelledAndTheDirectionStays) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    render::Camera camera = display.camera();
    camera.rotation = render::facing({0.3, 0.4, 1}, {0.5, 1, 0});
    camera.position = {0.2, 0.1, 0};
    display.setCamera(camera);
    const auto toward = [](const render::Camera& now) {
        return geometry::Vector(now.rotation.conjugate() * geometry::Vector::UnitZ());
    };
    ASSERT_GT(std::abs((camera.rotation * geometry::Vector::UnitY()).x()), 0.1);
    display.levelHorizon();
    const render::Camera level = display.camera();
    EXPECT_NEAR((level.rotation * geometry::Vector::UnitY()).x(), 0, 1e-12);
    EXPECT_GT((level.rotation * geometry::Vector::UnitY()).y(), 0);
    EXPECT_TRUE(toward(level).isApprox(toward(camera), 1e-12));
    EXPECT_NEAR(level.position.norm(), camera.position.norm(), 1e-12);
    EXPECT_EQ(level.scale, camera.scale);
    display.lookAlong(geometry::Vector::UnitY());
    display.levelHorizon();
    EXPECT_TRUE(display.editing().said().startsWith("Straight from above"));
}

TEST_F(PositioningTest, AViewThatIsKeptInAnOlderTextSaysSo) {
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

TEST_F(PositioningTest, AViewThatIsThereIsChangedToWhatIsSeen) {
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

TEST_F(PositioningTest, TheMenuOfWhatIsUnderThePointerDoesWhatItSays) {
    const std::string before =
        ballScene + "force -torque 1 -body b1 -x 0 -y 0 -z 1\nplot p -values {{b1.y}}\n";
    editor.document().setText(before, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.lookAlong(geometry::Vector::UnitZ());
    display.grab();
    const auto at = [&](const geometry::Vector& world) {
        return display.fromPixels(display.sight().pixels(world));
    };
    const auto choose = [&](const MenuPlace& place, const std::vector<QString>& path) {
        if (place.element)
            editor.document().select({*place.element});
        const auto menu = elementMenu(editor.document(), display, place, {[] {}, [] {}, [] {}});
        const QMenu* in = menu.get();
        QAction* found = nullptr;
        for (const QString& step : path) {
            found = nullptr;
            for (QAction* action : in->actions())
                if (action->text().remove('&') == step)
                    found = action;
            if (!found)
                return false;
            in = found->menu();
        }
        found->trigger();
        return true;
    };
    const MenuPlace onBody = menuPlaceAt(editor.document(), display, at({-0.8, 0.1, 0}));
    ASSERT_TRUE(onBody.element);
    EXPECT_EQ(onBody.element->kind, editing::Kind::body);
    // Its first click is where the menu was opened.
    ASSERT_TRUE(choose(onBody, {"New Link", "To a Point"}));
    display.creating().click(at({0, 1, 0}));
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().shown().scene->links.size(), 1U);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    // A torque by its arrow.
    render::Display shown = display.display();
    shown.torqueHandles = true;
    display.setDisplay(shown);
    display.lookAlong(geometry::Vector(1, 0, 0.3));
    display.grab();
    const auto& handles = display.handles().handles;
    const auto head =
        std::ranges::find(handles, render::HandleKind::torqueHead, &render::Handle::kind);
    ASSERT_NE(head, handles.end());
    const MenuPlace onTorque = menuPlaceAt(editor.document(), display, at(head->place));
    ASSERT_TRUE(onTorque.element);
    EXPECT_EQ(onTorque.element->kind, editing::Kind::force);
    viewer->display().editing().choose(head->kind, head->element, head->part);
    ASSERT_TRUE(choose(onTorque, {"Delete"}));
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(editor.document().shown().scene->forces.empty());
    // On the background: what is not in the picture.
    const MenuPlace nowhere = menuPlaceAt(editor.document(), display, QPointF(3, 3));
    EXPECT_FALSE(nowhere.element);
    ASSERT_TRUE(choose(nowhere, {"Plots", "plot \"p\"", "Delete"}));
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().text(), ballScene);
}

} // namespace
} // namespace views
