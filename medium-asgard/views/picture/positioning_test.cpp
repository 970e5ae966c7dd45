// Where a picture is seen from, and the menu of what is in it.
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

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

// An edit moves no grid, however far the new motion leads; framing puts it below all of it.
TEST_F(PositioningTest, TheGroundStaysWhereItIsUntilOneFramesAnew) {
    const auto sinking = [](const std::string& speed) {
        return "simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.3}}\n"
               "body b s -init_dpos {0 -" +
               speed + " 0}\n";
    };
    SceneDocument& document = editor.document();
    document.setText(sinking("1"), "Edit");
    ASSERT_TRUE(settle(document));
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    display.grab();
    ASSERT_TRUE(display.ground().has_value());
    const double before = display.ground()->height;
    EXPECT_LT(before, -2.3);
    document.setText(sinking("4") + "body beside s -init_pos {1 0 0} -init_dpos {0 -4 0}\n",
                     "Edit");
    ASSERT_TRUE(settle(document));
    display.grab();
    ASSERT_TRUE(display.ground().has_value());
    EXPECT_EQ(display.ground()->height, before);
    display.frameAll();
    display.grab();
    EXPECT_TRUE(waitFor([&] { return display.ground() && display.ground()->height < -8; }));
}

// A first body that is put across the grid of an empty scene leaves the grid at 0.
TEST_F(PositioningTest, TheGridOfAnEmptySceneStaysUnderTheFirstBody) {
    SceneDocument& document = editor.document();
    document.setText("simulator -finish 2\n", "Edit");
    ASSERT_TRUE(settle(document));
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    display.lookAlong(geometry::Vector::UnitZ());
    display.grab();
    ASSERT_TRUE(display.ground().has_value());
    EXPECT_EQ(display.ground()->height, 0);
    document.setText("simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.3}}\nbody b s\n",
                     "Edit");
    ASSERT_TRUE(settle(document));
    display.grab();
    ASSERT_TRUE(waitFor([&] { return display.ground().has_value(); }));
    EXPECT_EQ(display.ground()->height, 0);
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
