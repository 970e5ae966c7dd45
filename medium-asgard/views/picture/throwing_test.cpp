// Bodies that a plain drag takes out of their motion: thrown while it plays, put while it rests.
#include "picture/selecting_testing.h"

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// While the motion plays a body that is let go has the velocity of the hand.
TEST_F(SelectingTest, ABodyIsThrownWhileTheMotionPlaysAndPutWhileItRests) {
    for (const bool plays : {true, false}) {
        editor.document().setText(three, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        if (plays) // then a drag takes a body at once
            editor.document().select({});
        else
            editor.document().select({leftOne});
        viewer->playback().setClock([] { return 0.0; });
        viewer->playback().seek(0.5);
        if (plays)
            viewer->playback().play();
        display().grab();
        const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButtons buttons,
                              unsigned long long ms) {
            QMouseEvent event(type, place, display().mapToGlobal(place),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons,
                              {});
            event.setTimestamp(ms);
            QApplication::sendEvent(&display(), &event);
        };
        const QPoint from = at({-3, 0, 0}) + QPoint(5, 5);
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, 0);
        for (int i = 1; i <= 10; ++i)
            send(QEvent::MouseMove, from + QPoint(6 * i, 0), Qt::LeftButton, 20ULL * i);
        EXPECT_TRUE(display().throwing().active());
        EXPECT_FALSE(viewer->playback().isPlaying()); // the time stands still
        send(QEvent::MouseButtonRelease, from + QPoint(60, 0), {}, 205);
        ASSERT_TRUE(settle(editor.document()));
        const scene::Scene& scene = *editor.document().shown().scene;
        EXPECT_EQ(scene.simulator.start, 0.5);
        const double way = 60 * display().sight().pixelLength({-3, 0, 0});
        EXPECT_NEAR(scene.bodies[2].initialPosition.x(), -3 + way, 0.05 * way);
        EXPECT_NEAR(scene.bodies[2].initialVelocity.x(), plays ? way / 0.2 : 0, 0.15 * way / 0.2);
        EXPECT_TRUE(waitFor([&] { return viewer->playback().isPlaying() == plays; }));
        EXPECT_EQ(editor.document().undoLabel(),
                  plays ? "Throw left at 0.5 s" : "Put left Elsewhere at 0.5 s");
        EXPECT_TRUE(viewer->findChild<QAction*>("undo")->isEnabled());
        viewer->playback().stop();
    }
}

TEST_F(SelectingTest, EscapeLetsABodyInTheHandGo) {
    editor.document().select({leftOne});
    viewer->playback().seek(0.5);
    display().grab();
    const std::string before = editor.document().text();
    const QPoint from = at({-3, 0, 0}) + QPoint(5, 5);
    QTest::mousePress(&display(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 3; ++i) {
        const QPointF to = from + QPoint(10 * i, 0);
        QMouseEvent move(QEvent::MouseMove, to, display().mapToGlobal(to), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(&display(), &move);
    }
    ASSERT_TRUE(display().throwing().active());
    QTest::keyClick(&display(), Qt::Key_Escape);
    EXPECT_FALSE(display().throwing().active());
    EXPECT_EQ(viewer->playback().time(), 0.5);
    EXPECT_EQ(editor.document().text(), before);
}

// As at the start; with the keys, too.
TEST_F(SelectingTest, AllThatAreSelectedArePutElsewhereTogether) {
    editor.document().select({nearOne, leftOne});
    viewer->playback().seek(0.5);
    display().grab();
    const QPoint from = at({-3, 0, 0}) + QPoint(5, 5);
    drag(from, from + QPoint(40, 0));
    const auto places = [&](std::size_t body) {
        return editor.document().shown().scene->bodies[body].initialPosition;
    };
    EXPECT_EQ(editor.document().shown().scene->simulator.start, 0.5);
    EXPECT_GT(places(2).x(), -2.9);
    EXPECT_NEAR(places(0).x(), places(2).x() + 3, 1e-3);
    EXPECT_EQ(places(1).x(), 0.2);
    EXPECT_EQ(editor.document().undoLabel(), "Put left and 1 more Elsewhere at 0.5 s");
    editor.document().setText(three, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->playback().seek(0);
    editor.document().select({nearOne, leftOne});
    display().grab();
    QTest::keyClick(&display(), Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyRelease(&display(), Qt::Key_Shift);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_GT(places(0).x(), 0);
    EXPECT_NEAR(places(0).x(), places(2).x() + 3, 1e-6);
}

// A throw of a body that a path leads would not do what the hand asks.
TEST_F(SelectingTest, WhatAPathLeadsIsNotThrown) {
    editor.document().setText(
        three + "trajectory way -points {{0 -3 0 0} {1 -3 1 0}}\nconstrain left -pos way\n",
        "Edit");
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_FALSE(editor.document().hasErrors()) << editor.document().diagnostics()[0].message;
    viewer->playback().seek(0.5);
    EXPECT_TRUE(display().throwing().press(leftOne.index, middle));
    EXPECT_FALSE(display().throwing().active());
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("left is led"));
}

TEST_F(SelectingTest, WhatAJointHoldsIsThrownAsTheJointAllows) {
    editor.document().setText(three + "joint pin -type hinge -body1 left -offset1 {0 2 0}\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->playback().setClock([] { return 0.0; });
    viewer->playback().seek(0.5);
    viewer->playback().play();
    display().grab();
    const QPoint from = at({-3, 0, 0});
    for (int i = 0; i <= 11; ++i) {
        const auto type = i == 0    ? QEvent::MouseButtonPress
                          : i == 11 ? QEvent::MouseButtonRelease
                                    : QEvent::MouseMove;
        const QPoint place = from + QPoint(6 * std::min(i, 10), 0);
        QMouseEvent event(type, place, display().mapToGlobal(place),
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          i == 11 ? Qt::NoButton : Qt::LeftButton, {});
        event.setTimestamp(20ULL * i);
        QApplication::sendEvent(&display(), &event);
    }
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().undoLabel(), "Throw left at 0.5 s");
    const scene::Body& body = editor.document().shown().scene->bodies[leftOne.index];
    const Vector arm = body.initialPosition - Vector(-3, 2, 0);
    EXPECT_NEAR(arm.norm(), 2, 1e-6);
    EXPECT_GT(arm.x(), 0.1);
    EXPECT_GT(body.initialVelocity.x(), 0.5);
    EXPECT_NEAR(body.initialVelocity.dot(arm), 0, 1e-6);
    EXPECT_LT((body.initialVelocity - body.initialAngularVelocity.cross(arm)).norm(), 1e-6);
    EXPECT_TRUE(editor.document().diagnostics().empty()); // no joint forbids it
    viewer->playback().stop();
}

TEST_F(SelectingTest, WhatAJointHoldsFastIsNotThrown) {
    editor.document().setText(three + "joint pin -type fixed -body1 left\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->playback().seek(0.5);
    EXPECT_TRUE(display().throwing().press(leftOne.index, middle));
    EXPECT_FALSE(display().throwing().active());
    EXPECT_THAT(display().editing().said().toStdString(),
                HasSubstr("\"left\" is held by joint \"pin\": nothing lets it go anywhere"));
}

} // namespace
} // namespace views
