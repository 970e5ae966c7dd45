// (text, gesture, text) by pointer and keys in a graphical viewer.
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QPushButton>

#include <cmath>

namespace views {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;

class PictureEditingTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    // Seen along z, with these kinds of handles.
    void open(const std::string& text, const std::vector<bool render::Display::*>& kinds = {
                                           &render::Display::positionHandles}) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        render::Display shown = viewer->display().display();
        for (bool render::Display::*kind : kinds)
            shown.*kind = true;
        viewer->display().setDisplay(shown);
        viewer->display().lookAlong(Vector::UnitZ());
        viewer->display().grab();
    }
    SceneDisplay& display() { return viewer->display(); }
    const std::string& text() { return editor.document().text(); }
    const scene::Scene& scene() { return *editor.document().shown().scene; }

    QPoint pixels(const Vector& world) {
        return display().fromPixels(display().sight().pixels(world)).toPoint();
    }
    const render::Handle& handle(render::HandleKind kind, std::size_t part = 0) {
        for (const render::Handle& one : display().handles().handles)
            if (one.kind == kind && one.part == part)
                return one;
        throw std::runtime_error("no such handle");
    }
    void press(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mousePress(&display(), button, Qt::ShiftModifier, at);
    }
    void moveTo(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
        QMouseEvent move(QEvent::MouseMove, at, display().mapToGlobal(at), Qt::NoButton, button,
                         Qt::ShiftModifier);
        QApplication::sendEvent(&display(), &move);
    }
    void release(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseRelease(&display(), button, Qt::ShiftModifier, at);
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
        press(from, button);
        moveTo(to, button);
        release(to, button);
        ASSERT_TRUE(settle(editor.document()));
    }
    void key(int which, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&display(), static_cast<Qt::Key>(which), modifiers);
    }

    void mark(std::size_t part) { // of the only element that has handles
        display().setFocus();
        for (int i = 0; i < 20; ++i) {
            key(Qt::Key_H);
            if (display().editing().marked() && display().editing().marked()->part == part)
                return;
        }
        FAIL() << part;
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
};

const std::string ball = "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n";

TEST_F(PictureEditingTest, AHandleChangesItsNumbersAndNothingElseInOneStep) {
    const std::string before = "shape_set ball -desc {-sub {-sphere 0.5}}   ;# a ball\n"
                               "body b1 ball -init_pos {-1   0 0} -init_dpos {1 0 0}\n";
    open(before);
    const QPoint start = pixels({-1, 0, 0});
    drag(start, start + QPoint(50, 0));
    EXPECT_EQ(text().substr(0, before.find("-1 ")), before.substr(0, before.find("-1 ")));
    EXPECT_NE(text().find("   0 0} -init_dpos {1 0 0}\n"), std::string::npos);
    const double x = scene().bodies[0].initialPosition.x();
    EXPECT_GT(x, -0.9);
    editor.document().undo();
    EXPECT_EQ(text(), before);
    editor.document().redo();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), x);
}

TEST_F(PictureEditingTest, WhatIsSaidFadesOnceThereWasTimeToReadIt) {
    open(ballScene);
    EXPECT_GT(Said::readingTime("A longer sentence takes longer."),
              Said::readingTime("A short one."));
    Said::setPace(0);
    display().editing().say("That cannot be.");
    EXPECT_EQ(display().editing().said(), "That cannot be.");
    EXPECT_TRUE(waitFor([&] { return display().editing().said().isEmpty(); }));
    Said::setPace(1000);
}

TEST_F(PictureEditingTest, WhatIsSaidAgainWhileItFadesIsSeenAgain) {
    Said said;
    double seen = 1;
    bool isAgain = false;
    QObject::connect(&said, &Said::changed, [&] {
        seen = said.opacity();
        if (seen == 1 || std::exchange(isAgain, true))
            return;
        Said::setPace(1000);
        said.say("That cannot be.", false);
    });
    Said::setPace(0);
    said.say("That cannot be.", false);
    EXPECT_TRUE(waitFor([&] { return isAgain; }));
    EXPECT_EQ(said.text(), "That cannot be.");
    EXPECT_EQ(seen, 1);
}

// As while the view is turned: the pictures are many, and the last one is what is looked at.
TEST_F(PictureEditingTest, PicturesAreCoarseWhileAHandleIsDraggedAndThenFine) {
    open(ball + "body b1 ball\n");
    const QPoint start = pixels({0, 0, 0});
    press(start);
    // Looked at as soon as the display has heard of what is new: before it may draw the fine one.
    QImage coarse;
    const auto look = [&] { coarse = display().grab().toImage(); };
    QObject::connect(&editor.document(), &SceneDocument::sceneChanged, &display(), look);
    QObject::connect(&editor.document(), &SceneDocument::motionChanged, &display(), look);
    moveTo(start + QPoint(10, 0));
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_FALSE(coarse.isNull());
    EXPECT_TRUE(waitFor([&] { return display().grab().toImage() != coarse; }));
    EXPECT_TRUE(display().editing().dragging());
}

// Another process may change the text while one is asked.
TEST_F(PictureEditingTest, WhatWasChangedWhileOneWasAskedIsNotCutInto) {
    open(ballScene + "force -body b1 -x 1 -y 0 -z 0\n");
    const std::string other = "# " + std::string(100, '-') + "\n" + text();
    display().editing().setConfirm([&](const QString&) {
        editor.document().setText(other, "Elsewhere");
        return true;
    });
    display().editing().remove({{editing::Kind::body, 0}});
    EXPECT_EQ(text(), other);
    EXPECT_EQ(display().editing().said(), "The text was changed meanwhile: nothing is deleted.");
}

TEST_F(PictureEditingTest, WhatIsHeldWhileTheTextIsChangedElsewhereIsLetGoWithAWord) {
    open(ballScene);
    const QPoint start = pixels({-1, 0, 0});
    press(start);
    moveTo(start + QPoint(30, 0));
    EXPECT_NE(display().words(), "");
    const std::string other = text() + "# other\n";
    editor.document().setText(other, "Elsewhere");
    moveTo(start + QPoint(60, 0));
    EXPECT_FALSE(display().editing().dragging());
    EXPECT_EQ(display().words(), "");
    EXPECT_EQ(display().editing().said(), SceneDocument::overtaken());
    release(start + QPoint(60, 0));
    EXPECT_EQ(text(), other);
}

TEST_F(PictureEditingTest, TheTextFollowsWhileTheHandleMovesAndEscapeBringsItBack) {
    open(ballScene);
    const QPoint start = pixels({-1, 0, 0});
    press(start);
    moveTo(start + QPoint(40, 30));
    EXPECT_NE(text(), ballScene);
    EXPECT_TRUE(display().words().startsWith("b1: position "));
    key(Qt::Key_Z); // away from the viewer
    EXPECT_EQ(text().find("{-1 0 0}"), std::string::npos);
    key(Qt::Key_Escape);
    EXPECT_EQ(text(), ballScene);
    EXPECT_EQ(display().words(), "");
}

TEST_F(PictureEditingTest, UndoWhereThereIsNothingToUndoMovesNothing) {
    open(ballScene);
    mark(0);
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_X, Qt::ControlModifier);
    EXPECT_FALSE(display().editing().dragging());
    EXPECT_EQ(text(), ballScene);
}

TEST_F(PictureEditingTest, WhileTheTextHasErrorsNothingIsDraggedAndItIsSaid) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\n");
    const std::string wrong = text() + "body b2 nothing\n";
    editor.document().setText(wrong, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    drag(pixels({-1, 0, 0}), pixels({0, 0, 0}));
    EXPECT_EQ(text(), wrong);
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("The text has errors"));
}

TEST_F(PictureEditingTest, WhatAnExpressionMakesStaysAndSaysWhy) {
    const std::string before = "shape_set ball -desc {-sub {-sphere 0.5}}\n"
                               "body b1 ball -init_pos [list [expr {1 - 2}] 0 0]\n";
    open(before);
    const QPoint start = pixels({-1, 0, 0});
    press(start);
    moveTo(start + QPoint(50, 0));
    EXPECT_EQ(display().words(), "-init_pos of body \"b1\" is computed by [expr {1 - 2}].");
    release(start + QPoint(50, 0));
    EXPECT_EQ(text(), before);
    // Up is another number, which is written out.
    drag(start, start + QPoint(0, -50));
    EXPECT_GT(scene().bodies[0].initialPosition.y(), 0.1);
    EXPECT_THAT(text(), HasSubstr("[list [expr {1 - 2}] 0"));
}

TEST_F(PictureEditingTest, ABodyItselfIsMovedAndTurned) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\nbody b2 ball -init_pos {1 0 0}\n", {});
    const QPoint start = pixels({1, 0.2, 0});
    drag(start, start + QPoint(0, -40));
    EXPECT_EQ(scene().bodies[0].initialPosition, Vector(-1, 0, 0));
    EXPECT_EQ(scene().bodies[1].initialPosition.x(), 1);
    EXPECT_GT(scene().bodies[1].initialPosition.y(), 0.1);
    const QPoint on = pixels({-1, 0, 0});
    drag(on, on + QPoint(20, 0), Qt::MiddleButton);
    // What was in front has gone right: about y.
    const Vector turned = geometry::toRotationVector(scene().bodies[0].initialAttitude);
    EXPECT_GT(turned.y(), 0.1);
    EXPECT_LT(std::abs(turned.x()) + std::abs(turned.z()), 0.05);
    EXPECT_THAT(text(), HasSubstr("body b1 ball -init_pos {-1 0 0} -init_rot {"));
}

TEST_F(PictureEditingTest, AnOrientationIsDraggedOnASphereInTheTextsOwnForm) {
    open(ball + "body b1 ball -init_rot {1 0 0 0}\n", {&render::Display::orientationHandles});
    const render::Handle x = handle(render::HandleKind::orientation, 0);
    const double reach = (x.place - x.base).norm();
    drag(pixels(x.place), pixels({0, reach, 0}));
    // A quarter turn about z, as the four numbers that stood there.
    EXPECT_THAT(text(), HasSubstr("-init_rot {0.7"));
    const Vector turned = geometry::toRotationVector(scene().bodies[0].initialAttitude);
    EXPECT_NEAR(turned.z(), M_PI / 2, 0.15); // to pixels
}

TEST_F(PictureEditingTest, VelocitiesHaveTheirOwnScales) {
    open(ball + "body b1 ball -init_dpos {1 0 0} -init_drot {0 2 0}\n",
         {&render::Display::velocityHandles, &render::Display::spinHandles});
    const render::Handle head = handle(render::HandleKind::velocity);
    drag(pixels(head.place), pixels(head.place + head.perUnit * Vector(0, 0.5, 0)));
    EXPECT_NEAR(scene().bodies[0].initialVelocity.y(), 0.5, 0.02);
    const render::Handle spin = handle(render::HandleKind::spin);
    EXPECT_EQ(spin.label, "2 rad/s");
    drag(pixels(spin.place), pixels(1.5 * spin.place));
    EXPECT_NEAR(scene().bodies[0].initialAngularVelocity.y(), 3, 0.1);
}

TEST_F(PictureEditingTest, ForcesAreDraggedByHeadAndBase) {
    open(ball + "body b1 ball -mass 2\n"
                "force -body b1 -x 0 -y {-10 * b1.mass} -z 0 -offset {0.5 0 0}\n",
         {&render::Display::forceHandles});
    const render::Handle head = handle(render::HandleKind::forceHead);
    drag(pixels(head.place), pixels(head.base + 0.5 * (head.place - head.base)));
    EXPECT_THAT(text(), HasSubstr(" * b1.mass} -z 0 -offset {0.5 0 0}"));
    const std::string y = std::get<scene::ComponentForce>(scene().forces[0].kind).components[1];
    EXPECT_NEAR(std::stod(y), -5, 0.2);
    const render::Handle base = handle(render::HandleKind::forceBase);
    drag(pixels(base.place), pixels({0.5, 0.4, 0}));
    EXPECT_NEAR(scene().forces[0].offset->y(), 0.4, 0.02);
}

// One number of the list changes, and neither passes the other.
TEST_F(PictureEditingTest, LimitsOfASliderAreDragged) {
    open(ball + "body b1 ball\n"
                "joint rail -type slider -body1 b1 -axis {1 0 0} -limits {-2 1.5}\n",
         {&render::Display::jointHandles});
    drag(pixels({1.5, 0, 0}), pixels({2.5, 0, 0}));
    EXPECT_NEAR(*scene().joints[0].coordinates[0].upper, 2.5, 0.05) << text();
    EXPECT_EQ(scene().joints[0].coordinates[0].lower, -2);
    drag(pixels({-2, 0, 0}), pixels({2.9, 0, 0}));
    EXPECT_LT(*scene().joints[0].coordinates[0].lower, *scene().joints[0].coordinates[0].upper);
}

// By whole degrees, drawn to each 15. A side without a limit keeps none.
TEST_F(PictureEditingTest, LimitsOfAHingeAreDragged) {
    open(ball + "body b1 ball\n"
                "joint pin -type hinge -body1 b1 -offset1 {-1 0 0} -limits {{} 1}\n",
         {&render::Display::jointHandles});
    const render::Handle upper = handle(render::HandleKind::jointLimit, 1);
    const double reach = (upper.place - Vector(-1, 0, 0)).norm();
    drag(pixels(upper.place), pixels(Vector(-1, 0, 0) + 3 * reach * Vector(0.01, 1, 0)));
    EXPECT_NEAR(*scene().joints[0].coordinates[0].upper, M_PI / 2, 1e-5) << text();
    EXPECT_FALSE(scene().joints[0].coordinates[0].lower);
}

TEST_F(PictureEditingTest, WhatChangesOnItsOwnHasNoHandle) {
    open(ball + "body b1 ball\nforce -body b1 -x 0 -y {sin(t)} -z 0\n",
         {&render::Display::forceHandles});
    for (const render::Handle& one : display().handles().handles)
        EXPECT_EQ(one.movable, one.kind == render::HandleKind::forceBase);
}

// A ball of radius 0.5 at the origin, seen along z.
TEST_F(PictureEditingTest, TheEndOfALinkFollowsTheSurfaceUntilItIsFreed) {
    open(ball + "body b1 ball\n"
                "link -body1 b1 -offset1 {0 0 0.5} -x 2 -y 0 -z 0 -tightness 10\n",
         {&render::Display::linkHandles});
    drag(pixels({0, 0, 0.5}), pixels({0.3, 0, 0.4}));
    const Vector on = *scene().links[0].first.offset;
    EXPECT_NEAR(on.norm(), 0.5, 0.01);
    EXPECT_GT(on.x(), 0.2);
    press(pixels(on));
    QTest::keyPress(&display(), Qt::Key_A);
    moveTo(pixels({1.2, 0, on.z()}));
    QTest::keyRelease(&display(), Qt::Key_A);
    release(pixels({1.2, 0, on.z()}));
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_NEAR(scene().links[0].first.offset->x(), 1.2, 0.05);
    EXPECT_NEAR(scene().links[0].first.offset->z(), on.z(), 0.02);
    // The other end is a point in space.
    drag(pixels({2, 0, 0}), pixels({2, 1, 0}));
    EXPECT_THAT(text(), HasSubstr(" -x 2 -y "));
}

TEST_F(PictureEditingTest, LightsAreMovedAndShineElsewhere) {
    open(ball + "body b1 ball\nlightsource sun -pos {-2 2 0} -direction {1 -1 0}\n",
         {&render::Display::lightHandles});
    display().frameAll();
    render::Camera camera = display().camera();
    camera.scale *= 0.4;
    display().setCamera(camera);
    display().lookAlong(Vector::UnitZ());
    drag(pixels({-2, 2, 0}), pixels({-1, 2, 0}));
    EXPECT_NEAR(scene().lights[0].position->x(), -1, 0.1);
    EXPECT_EQ(*scene().lights[0].direction, Vector(1, -1, 0));
    const render::Handle head = handle(render::HandleKind::lightDirection);
    drag(pixels(head.place), pixels(head.base + Vector(0, -1, 0)));
    EXPECT_LT(scene().lights[0].direction->y(), -1.5);
}

// Its points along x, a second apart.
TEST_F(PictureEditingTest, PointsOfATrajectoryAreMovedDrawnOutAndRemoved) {
    open(ball + "body b1 ball\n"
                "trajectory T -points {{0 -1 0 0} {1 0 0 0} {2 1 0 0}} ;# along x\n",
         {&render::Display::trajectories});
    const std::string before = text();
    drag(pixels({1, 0, 0}), pixels({1, 0.5, 0}));
    EXPECT_NEAR(scene().trajectories[0].points[2].second.y(), 0.5, 0.02);
    EXPECT_EQ(scene().trajectories[0].points[2].first, 2);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    // To the left of the middle one: before it in time.
    drag(pixels({0, 0, 0}), pixels({-0.4, 0.3, 0}), Qt::MiddleButton);
    ASSERT_EQ(scene().trajectories[0].points.size(), 4U) << text();
    EXPECT_EQ(scene().trajectories[0].points[1].first, 0.5);
    EXPECT_NEAR(scene().trajectories[0].points[1].second.x(), -0.4, 0.02);
    drag(pixels({1, 0, 0}), pixels({1.4, 0, 0}), Qt::MiddleButton); // beyond the end
    ASSERT_EQ(scene().trajectories[0].points.size(), 5U) << text();
    EXPECT_EQ(scene().trajectories[0].points[4].first, 3);
    editor.document().undo();
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(text(), before);
    drag(pixels({0, 0, 0}), pixels({0, 0, 0}), Qt::RightButton);
    EXPECT_THAT(text(), HasSubstr("trajectory T -points {{0 -1 0 0} {2 1 0 0}} ;# along x\n"));
    drag(pixels({1, 0, 0}), pixels({1, 0, 0}), Qt::RightButton); // the last two go with it
    EXPECT_EQ(text(), ball + "body b1 ball\n");
}

const std::string curves = ball + "trajectory T -bezier {{0 1 {-1 0 0} {-0.5 0 0.5} {-0.5 0 0.5} "
                                  "{0 0 0}} {1 2 {0 0 0} {0.5 0 0} {0.5 0 0} {1 0 0}}}\n";

// Where one curve ends as the next begins there is one point: handles, fields and text count alike.
TEST_F(PictureEditingTest, ExactValuesOfCurvesAreThoseOfTheHandle) {
    open(curves, {&render::Display::trajectories});
    const auto enter = [&](std::size_t part, const char* x) {
        mark(part);
        key(Qt::Key_Return);
        ValueEntry* entry = display().editing().entry();
        ASSERT_NE(entry, nullptr);
        entry->fields()[0]->selectAll();
        QTest::keyClicks(entry->fields()[0], x);
        QTest::keyClick(entry->fields()[0], Qt::Key_Return);
        ASSERT_TRUE(settle(editor.document()));
        display().grab();
    };
    enter(5, "0.75"); // the second tangent behind the joint
    EXPECT_THAT(text(), HasSubstr("{1 2 {0 0 0} {0.5 0 0} {0.75 0 0} {1 0 0}}"));
    enter(3, "0.25"); // the joint, in both curves and with their tangents
    EXPECT_THAT(text(), HasSubstr("{-0.25 0 0.5} {0.25 0 0}} {1 2 {0.25 0 0} {0.75 0 0} "));
    EXPECT_FALSE(editor.document().hasErrors());
}

// What cannot be taken out says why; it is not the trajectory that goes then.
TEST_F(PictureEditingTest, ATangentIsNotDeleted) {
    open(curves, {&render::Display::trajectories});
    mark(1);
    key(Qt::Key_Delete);
    EXPECT_EQ(text(), curves);
    EXPECT_EQ(display().editing().said(), "A tangent goes with its point.");
}

// As a wheel whose rim is pushed sideways: about the line of sight, here -z.
TEST_F(PictureEditingTest, TheRightButtonRollsABody) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\n", {});
    const QPoint on = pixels({-1, 0, 0});
    press(on, Qt::RightButton);
    moveTo(on + QPoint(60, 25), Qt::RightButton);
    EXPECT_TRUE(display().words().startsWith("b1: rotation "));
    release(on + QPoint(60, 25), Qt::RightButton);
    ASSERT_TRUE(settle(editor.document()));
    const Vector turned = geometry::toRotationVector(scene().bodies[0].initialAttitude);
    EXPECT_NEAR(turned.z(), -1.5 * 60 / render::pixelsPerUnit(display().sight().size), 0.02);
    EXPECT_LT(std::abs(turned.x()) + std::abs(turned.y()), 1e-3);
    EXPECT_EQ(editor.document().undoLabel(), "Turn b1");
}

TEST_F(PictureEditingTest, WhatALoopMakesIsOfferedWithTheChangeOfTheTextAsItWasDragged) {
    const std::string before =
        ball + "for {set i 0} {$i < 3} {incr i} {\n  body b$i ball -init_pos \"[expr {$i * 0.5}] "
               "0 0\"\n}\n";
    open(before);
    const QPoint start = pixels({1, 0, 0});
    drag(start, pixels({1.4, 0, 0}));
    EXPECT_EQ(text(), before);
    ValueEntry* entry = display().editing().entry();
    ASSERT_NE(entry, nullptr);
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("is one of 3 that line 4 makes"));
    QPushButton* step = nullptr;
    const QString becomes = "The step: 0.5 becomes ";
    for (auto* button : entry->findChildren<QPushButton*>())
        if (button->text().startsWith(becomes))
            step = button;
    ASSERT_NE(step, nullptr);
    EXPECT_NEAR(step->text().section('\n', 0, 0).mid(becomes.size()).toDouble(), 0.7, 0.015);
    QString shown;
    for (auto* label : entry->findChildren<QLabel*>())
        shown += label->text();
    EXPECT_THAT(shown.toStdString(), HasSubstr("$i * 0."));
    step->click();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_NEAR(scene().bodies[2].initialPosition.x(), 1.4, 0.03);
    EXPECT_NEAR(scene().bodies[1].initialPosition.x(), 0.7, 0.02);
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), 0);
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(PictureEditingTest, TheKeysMoveTheMarkedHandleInOneStep) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\nbody b2 ball -init_pos {1 0 0}\n");
    const std::string before = text();
    key(Qt::Key_H);
    key(Qt::Key_H);
    ASSERT_TRUE(display().editing().marked());
    EXPECT_EQ(display().editing().marked()->element, 1U);
    for (int i = 0; i < 3; ++i) {
        QKeyEvent up(QEvent::KeyPress, Qt::Key_Up, Qt::ShiftModifier);
        QApplication::sendEvent(&display(), &up);
    }
    QTest::keyRelease(&display(), Qt::Key_Shift);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_GT(scene().bodies[1].initialPosition.y(), 0.05);
    EXPECT_EQ(scene().bodies[0].initialPosition.y(), 0);
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(PictureEditingTest, TheExactValueIsTypedWhereTheTextStands) {
    open(ball + "set h 2\nbody b1 ball -init_pos \"0 $h 1.50\" ;# here\n");
    QTest::mouseDClick(&display(), Qt::LeftButton, {}, pixels({0, 2, 1.5}));
    ValueEntry* entry = display().editing().entry();
    ASSERT_NE(entry, nullptr);
    ASSERT_EQ(entry->fields().size(), 3U);
    EXPECT_EQ(entry->fields()[1]->text(), "2");
    EXPECT_EQ(entry->fields()[2]->text(), "1.50");
    entry->fields()[1]->selectAll();
    QTest::keyClicks(entry->fields()[1], "0.3333333333333333");
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("set h "));
    QTest::keyClick(entry->fields()[1], Qt::Key_Return);
    EXPECT_EQ(text(), ball + "set h 0.3333333333333333\n"
                             "body b1 ball -init_pos \"0 $h 1.50\" ;# here\n");
}

TEST_F(PictureEditingTest, AnEntryThatCannotBeChangedSaysWhyAndOffersWhatCan) {
    open(ball + "foreach i {1 2} {\n  body b$i ball -init_pos \"$i 0 0\"\n}\n");
    key(Qt::Key_H);
    key(Qt::Key_Return);
    ValueEntry* entry = display().editing().entry();
    ASSERT_NE(entry, nullptr);
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("is one of 2 that line 4 makes"));
    entry->fields()[1]->selectAll();
    QTest::keyClicks(entry->fields()[1], "0.5");
    QPushButton* only = nullptr;
    for (auto* button : entry->findChildren<QPushButton*>())
        if (button->text() == "Only b1")
            only = button;
    ASSERT_NE(only, nullptr);
    only->click();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(scene().bodies[0].initialPosition, Vector(1, 0.5, 0));
    EXPECT_EQ(scene().bodies[1].initialPosition, Vector(2, 0, 0));
}

} // namespace
} // namespace views
