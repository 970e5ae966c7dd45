// (text, gesture, text) of Create: bodies, places, all that needs no body; and of Delete.
#include "gestures/standing.h"
#include "picture/creating_testing.h"
#include "shapes/shape_names.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QMenu>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(CreatingTest, ABodyStandsWhereOneClicksOrAtTheOrigin) {
    open(balls);
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().creating().prompt().toStdString(), StartsWith("New Body: Click where"));
    click({0, 1, 0});
    done();
    EXPECT_THAT(text(), StartsWith(balls + "body b3 ball -init_pos {"));
    EXPECT_LT((scene().bodies[2].initialPosition - Vector(0, 1, 0)).norm(), 0.05);
    EXPECT_TRUE(display().display().positionHandles);
    display().creating().start(newBody("ball"));
    key(Qt::Key_Return);
    done();
    EXPECT_EQ(scene().bodies[3].initialPosition, Vector::Zero().eval());
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), balls);
}

const std::string block = "shape_set block -desc {-sub {-box {2 1 2}}}\n";

TEST_F(CreatingTest, ABodyRestsOnTheFaceThatIsClicked) {
    open(block + "body b1 block -init_pos {0.7 0.5 0}\n");
    display().lookAlong(Vector(0, 0.6, 1)); // on its top
    display().grab();
    display().creating().start(newBody(BasicShape::sphere));
    click({0.2, 1, 0.4});
    done();
    const Vector ball = scene().bodies[1].initialPosition;
    EXPECT_EQ(ball.y(), 1.5);
    EXPECT_NEAR(ball.x(), 0.2, 0.05);
    EXPECT_NEAR(ball.z(), 0.4, 0.05);
    EXPECT_THAT(editor.document().diagnostics(), testing::IsEmpty()); // nothing overlaps
    display().creating().start(newBody("block", scene().shapeSets[0].parts));
    click({0.72, 1, 0.02}); // beside the middle
    done();
    EXPECT_EQ(scene().bodies[2].initialPosition, Vector(0.7, 1.5, 0));
}

TEST_F(CreatingTest, BesideABodyOnAFloorANewOneStandsOnTheFloorToo) {
    open(block + "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n"
                 "body b1 block -init_pos {0 0.5 0}\n");
    display().lookAlong(Vector(0, 0.3, 1));
    display().grab();
    display().creating().start(newBody("block", scene().shapeSets[0].parts));
    click({0.1, 0.2, 1}); // low on its front
    done();
    EXPECT_EQ(scene().bodies[2].initialPosition.y(), 0.5);
    EXPECT_EQ(scene().bodies[2].initialPosition.z(), 2);
}

// A click on a ball below its middle, where no ball of that size fits over the floor.
TEST_F(CreatingTest, BesideABallOnAFloorANewOneStandsOnTheFloorToo) {
    const std::string ball = "shape_set ball -desc {-sub {-sphere 0.5}}\n";
    open(ball + "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n"
                "body b1 ball -init_pos {0 0.5 0}\n");
    display().lookAlong(Vector(0, 0.1, 1));
    display().grab();
    display().creating().start(newBody("ball", scene().shapeSets[0].parts));
    click({0.15, 0.3, std::sqrt(0.25 - 0.15 * 0.15 - 0.2 * 0.2)});
    done();
    const Vector at = scene().bodies[2].initialPosition;
    EXPECT_EQ(at.y(), 0.5);
    EXPECT_GT(at.x(), 0.1);
    EXPECT_GT(at.z(), 0.5);
    const double apart = (at - Vector(0, 0.5, 0)).norm();
    EXPECT_GT(apart, 1 - 1e-7);
    EXPECT_LT(apart, 1.01); // numbers are round along its side
}

// A foot with a pole, and a smaller ball.
TEST_F(CreatingTest, ANewBallTouchesWhatItIsPutBeside) {
    const std::string ball = "shape_set ball -desc {-sub {-sphere 0.5}}\n";
    struct Case {
        std::string text;
        Vector click;
        double least; // z
    };
    const std::string floor =
        "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n";
    const Case cases[] = {
        {ball + floor +
             "shape_set stand -desc {-sub {-cylinder {0.5 0.2} -pos {0 0.1 0}} "
             "-sub {-cylinder {0.1 2} -pos {0 1.2 0}}}\nbody b1 stand\n",
         {0.1, 0.1, std::sqrt(0.24)},
         0.8},
        {ball + floor +
             "shape_set small -desc {-sub {-sphere 0.1}}\n"
             "body b1 small -init_pos {0 0.1 0}\n",
         {0.02, 0.14, std::sqrt(0.01 - 0.0004 - 0.0016)},
         0.3},
    };
    for (const Case& one : cases) {
        open(one.text);
        display().lookAlong(Vector(0, 0.1, 1));
        display().grab();
        display().creating().start(newBody("ball", scene().shapeSets[0].parts));
        click(one.click);
        done();
        ASSERT_EQ(scene().bodies.size(), 3U) << one.text;
        const Vector at = scene().bodies[2].initialPosition;
        EXPECT_EQ(at.y(), 0.5) << one.text;
        EXPECT_GT(at.z(), one.least) << one.text;
        const auto shape = gestures::shapeOf(scene(), scene().bodies[2].name);
        const auto touching = [&](double back) {
            return gestures::isInsideOfOthers(
                scene(), *shape, {at - Vector(0, 0, back), geometry::Quaternion::Identity()}, 2);
        };
        EXPECT_FALSE(touching(0)) << one.text;
        EXPECT_TRUE(touching(0.02)) << one.text;
    }
}

// A box that is taller than the one at whose front it is put, and a ball before a wall that is
// turned and has no end.
TEST_F(CreatingTest, ANewBodyStandsOnTheFloorWhateverIsBesideIt) {
    const std::string floor =
        "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n";
    open("shape_set low -desc {-sub {-box {1 0.3 1}}}\nbody b1 low -init_pos {0 0.15 0}\n" + floor +
         "shape_set tall -desc {-sub {-box {1 2 1}}}\n");
    display().lookAlong(Vector(0, 0.3, 1));
    display().grab();
    display().creating().start(newBody("tall", scene().shapeSets[2].parts));
    click({0.1, 0.1, 0.5});
    done();
    ASSERT_EQ(scene().bodies.size(), 3U);
    EXPECT_EQ(scene().bodies[2].initialPosition.y(), 1);
    EXPECT_EQ(scene().bodies[2].initialPosition.z(), 1);
    for (const double turn : {0.3, 0.5, 0.8}) {
        const double quarter = M_PI / 2;
        open("shape_set ball -desc {-sub {-sphere 0.5}}\nshape_set wall -desc {-sub {-plane}}\n" +
             floor + "body wall wall -fixed 1 -init_rot {" +
             std::to_string(quarter * std::cos(turn)) + " 0 " +
             std::to_string(-quarter * std::sin(turn)) + "}\n");
        display().lookAlong(Vector(0, 0.3, 1));
        display().grab();
        display().creating().start(newBody("ball", scene().shapeSets[0].parts));
        click({0.1, 0.1, -0.1 * std::tan(turn)});
        done();
        ASSERT_EQ(scene().bodies.size(), 3U) << turn;
        EXPECT_NEAR(scene().bodies[2].initialPosition.y(), 0.5, 1e-4) << turn;
    }
}

// In a view from above; from the side one builds in the plane of the picture.
TEST_F(CreatingTest, ABodyStandsOnTheGridThatIsClicked) {
    open("# nothing yet\n");
    display().lookAlong(Vector(0.3, 0.5, 1));
    display().grab();
    for (const double x : {0.0, 1.6}) {
        display().creating().start(newBody(BasicShape::box));
        click({x + 0.01, 0, 0.02});
        done();
        const Vector place = scene().bodies.back().initialPosition;
        EXPECT_EQ(place.y(), 0.5) << x; // half of its height
        EXPECT_NEAR(place.x(), x, 0.05);
        EXPECT_NEAR(place.z(), 0, 0.05);
        EXPECT_NEAR(std::remainder(place.x(), 0.01), 0, 1e-9); // round numbers
        EXPECT_NEAR(std::remainder(place.z(), 0.01), 0, 1e-9);
        display().grab();
    }
    EXPECT_THAT(editor.document().diagnostics(), testing::IsEmpty());
    display().creating().start(newBody(BasicShape::sphere));
    const QPointF place = display().fromPixels(display().sight().pixels({0, 0, 1.5}));
    display().creating().click(place, true); // Ctrl holds off
    done();
    EXPECT_LT(scene().bodies.back().initialPosition.y(), 0.4);
    display().lookAlong(Vector::UnitZ());
    display().grab();
    display().creating().start(newBody(BasicShape::sphere));
    const Vector before(0.7, 0.75, 0);
    ASSERT_TRUE(display().rect().contains(
        display().fromPixels(display().sight().pixels(before)).toPoint()));
    click(before);
    done();
    EXPECT_NEAR(scene().bodies.back().initialPosition.y(), 0.75, 0.06);
}

// Its middle is drawn to a corner of the block, and then stands beside it.
TEST_F(CreatingTest, ABodyOnTheGridStandsBesideTheOthersAndNeverInside) {
    open(block + "body b1 block -init_pos {0 0.5 0}\n");
    display().lookAlong(Vector(0, 0.8, 1));
    display().grab();
    for (const Vector& place : {Vector(1, 0, 1.02), Vector(0.3, 0, 1.1), Vector(-1.2, 0, 1.1)}) {
        display().creating().start(newBody(BasicShape::box));
        click(place);
        done();
        const Vector stands = scene().bodies.back().initialPosition;
        EXPECT_EQ(stands.y(), 0.5);
        EXPECT_LT((stands - place).head<2>().norm() + std::abs(stands.z() - place.z()), 1.6);
        display().grab();
    }
    EXPECT_EQ(scene().bodies.size(), 4U);
    for (const scene::Body& one : scene().bodies)
        for (const scene::Body& other : scene().bodies) {
            const Vector apart = (one.initialPosition - other.initialPosition).cwiseAbs();
            const double x = one.shape == "block" || other.shape == "block" ? 1.5 : 1;
            EXPECT_TRUE(&one == &other || apart.x() > x - 1e-6 || apart.z() > x - 1e-6)
                << one.name << " " << other.name;
        }
}

TEST_F(CreatingTest, ABodyLiesOnASlopeAsTheSlopeIsTurned) {
    open(block + "body slope block -init_rot {0 0 0.5} -fixed 1\n");
    display().lookAlong(Vector(0, 0.6, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    click({-0.24, 0.44, 0.3}); // half of its height above the middle, across the slope
    done();
    const scene::Body& box = scene().bodies[1];
    EXPECT_NEAR(geometry::toRotationVector(box.initialAttitude).z(), 0.5, 1e-8);
}

// A wedge is a slope without being turned.
TEST_F(CreatingTest, ABodyLiesOnAnObliqueFace) {
    open("shape_set wedge -desc {-sub {-points {{-2 0 -1} {-2 0 1} {2 0 -1} {2 0 1} {2 1 -1} "
         "{2 1 1}}}}\nbody slope wedge -fixed 1\n");
    display().lookAlong(Vector(0, 0.6, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    click({0.4, 0.6, 0.2});
    done();
    const scene::Body& box = scene().bodies[1];
    EXPECT_NEAR(geometry::toRotationVector(box.initialAttitude).z(), std::atan(0.25), 1e-6);
    const Vector foot = box.initialPosition - 0.5 * (box.initialAttitude * Vector::UnitY());
    EXPECT_LE(foot.y(), 0.5 + foot.x() / 4 + 1e-9); // it touches the face
    EXPECT_GE(foot.y(), 0.5 + foot.x() / 4 - 1e-8);
    EXPECT_NEAR(std::remainder(box.initialPosition.x(), 0.01), 0, 1e-9) << text(); // round
    display().grab();
    display().creating().start(newBody(BasicShape::sphere));
    click({-1.4, 0.15, 0.2});
    done();
    EXPECT_TRUE(scene().bodies[2].initialAttitude.isApprox(geometry::Quaternion::Identity()))
        << text(); // a ball has no side to lie on
}

TEST_F(CreatingTest, BodiesOfAFlatSceneStayInItsPlane) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {-1 0 0.25}\n");
    display().lookAlong(Vector(0.3, 0.4, 1));
    display().grab();
    display().creating().start(newBody("ball"));
    const QPointF place = display().fromPixels(display().sight().pixels({0.5, 1, 0.25}));
    display().creating().click(place, true); // no matter what lies behind
    done();
    EXPECT_EQ(scene().bodies[1].initialPosition.z(), 0.25);
}

TEST_F(CreatingTest, APlaceThatIsTypedOutOfSightComesIntoThePicture) {
    open(balls);
    const Vector far(40, 0, 0);
    display().creating().start(newBody("ball"));
    QTest::keyClicks(&display(), "40 0 0");
    key(Qt::Key_Return);
    done();
    display().grab();
    const QPointF place = display().fromPixels(display().sight().pixels(far));
    EXPECT_TRUE(display().rect().contains(place.toPoint())) << place.x() << " " << place.y();
}

TEST_F(CreatingTest, AnEmptySceneGetsItsFirstBodyWithAShape) {
    open("# nothing yet\n");
    display().creating().start(newBody(BasicShape::box));
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().bodies.size(), 1U);
    EXPECT_EQ(text(), "# nothing yet\n\nshape_set block1 -desc {-sub {-box {1 1 1}}}\n"
                      "body body1 block1 -init_pos {0 0.5 0} -restitution 0 -friction 0.3 "
                      "-color steelblue\n");
}

// The grid may lie far below what hangs; a typed place is meant as it is.
TEST_F(CreatingTest, AtTheOriginABodyStandsOnTheGridBesideOthers) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {0 0.5 0}\n");
    const auto make = [&](const char* typed) {
        display().creating().start(newBody("ball", scene().shapeSets[0].parts));
        QTest::keyClicks(&display(), typed);
        key(Qt::Key_Return);
        done();
        display().grab();
        return scene().bodies.back().initialPosition;
    };
    const Vector beside = make("");
    EXPECT_EQ(beside.y(), 0.5);
    EXPECT_GE(beside.norm(), 1);
    EXPECT_EQ(make("0 0 3"), Vector(0, 0, 3));
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {0 -20 0}\n");
    EXPECT_EQ(make(""), Vector(0, 0, 0));
}

// It is a thing of a room, too, and another colour tells it from the first.
TEST_F(CreatingTest, ASecondBodyOfAShapeIsLikeTheFirst) {
    open("# nothing yet\n");
    display().creating().start(newBody(BasicShape::sphere));
    key(Qt::Key_Return);
    done();
    display().creating().start(newBody("ball1", scene().shapeSets[0].parts));
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().bodies.size(), 2U);
    EXPECT_EQ(scene().bodies[1].restitution, scene().bodies[0].restitution);
    EXPECT_EQ(scene().bodies[1].friction, scene().bodies[0].friction);
    ASSERT_TRUE(scene().bodies[1].appearance.color.has_value());
    EXPECT_NE(scene().bodies[1].appearance.color, scene().bodies[0].appearance.color);
    // The author's own colour of a shape counts.
    open("shape_set s -desc {-sub {-sphere 1}} -color red\n");
    display().creating().start(newBody("s", scene().shapeSets[0].parts));
    key(Qt::Key_Return);
    done();
    EXPECT_FALSE(scene().bodies[0].appearance.color.has_value());
}

// Things of a room: what falls comes to rest, a ball bounces. The floor is where the grid is.
TEST_F(CreatingTest, ABallThatIsLiftedBouncesOnAFloorAtZero) {
    open("# nothing yet\n");
    display().creating().start(newBody(BasicShape::sphere));
    QTest::keyClicks(&display(), "0 0 0");
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("-restitution 0.7 -friction 0.3"));
    editor.document().setText(text() + "body up ball1 -init_pos {0 3 0}\n", "Edit");
    done();
    display().creating().start(newFloor());
    done();
    EXPECT_NEAR(scene().bodies.back().initialPosition.y(), -0.5, 1e-9); // under the lowest
    const std::string lifted =
        "shape_set s -desc {-sub {-sphere 0.5}}\nbody b s -init_pos {0 3 0}\n";
    editor.document().setText(lifted, "Edit");
    done();
    display().creating().start(newFloor());
    done();
    EXPECT_EQ(scene().bodies.back().initialPosition.y(), 0);
    EXPECT_TRUE(scene().bodies.back().fixed);
}

TEST_F(CreatingTest, ACommandKeepsLettersAndLeavesTheWindowItsOwnKeys) {
    open(balls);
    const auto isTaken = [this](QEvent::Type type, Qt::Key key, Qt::KeyboardModifiers modifiers,
                                const QString& letters) {
        QKeyEvent event(type, key, modifiers, letters);
        event.ignore();
        QApplication::sendEvent(&display(), &event);
        return event.isAccepted();
    };
    const auto both = [&](Qt::Key key, Qt::KeyboardModifiers modifiers, const QString& letters) {
        return isTaken(QEvent::ShortcutOverride, key, modifiers, letters) ||
               isTaken(QEvent::KeyPress, key, modifiers, letters);
    };
    for (const bool waits : {true, false}) {
        made.readsSlowly = waits;
        if (waits)
            editor.document().setText(balls + "set a 1\n", "Edit");
        display().creating().start(newBody("ball"));
        EXPECT_EQ(display().creating().prompt().contains("is being read"), waits);
        EXPECT_TRUE(isTaken(QEvent::ShortcutOverride, Qt::Key_Space, {}, " ")) << waits;
        EXPECT_TRUE(isTaken(QEvent::ShortcutOverride, Qt::Key_F, Qt::ShiftModifier, "F")) << waits;
        EXPECT_FALSE(both(Qt::Key_S, Qt::ControlModifier, "\x13")) << waits;
        EXPECT_FALSE(both(Qt::Key_F1, {}, "")) << waits;
        EXPECT_TRUE(isTaken(QEvent::ShortcutOverride, Qt::Key_Return, {}, "\r")) << waits;
        EXPECT_TRUE(isTaken(QEvent::ShortcutOverride, Qt::Key_5, {}, "5")) << waits;
        QTest::keyClicks(&display(), "1 2"); // the sign between numbers is one of a place
        made.readsSlowly = false;
        done();
        EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("x y z = 1 2_"));
        key(Qt::Key_Escape);
    }
}

TEST_F(CreatingTest, TheMiddleOfABodyIsKnownBeforeItsMotion) {
    open(balls);
    made.blocked = true; // no motion ends
    editor.document().setText("shape_set bar -desc {-sub {-pos {2 0 0} -box {4 0.4 0.4}}}\n"
                              "body b bar -init_pos {0 3 0}\n",
                              "Edit");
    EXPECT_TRUE(waitFor(
        [this] { return editor.document().sceneIsCurrent() && scene().bodies.size() == 1; }));
    EXPECT_FALSE(editor.document().shown().motion);
    EXPECT_LT((display().centerOf(0) - Vector(2, 3, 0)).norm(), 1e-9);
    made.blocked = false;
    done();
}

TEST_F(CreatingTest, WhereThereIsNoRoomABodyStandsWhereItIsClicked) {
    open("shape_set ring -desc {-sub {-tube {4.8 5 0.4}}}\n"
         "shape_set s -desc {-sub {-cylinder {0.4 1}}}\n"
         "body fence ring -init_pos {0 0.2 0} -fixed 1\nbody b1 s -init_pos {-1 0.5 0}\n");
    display().lookAlong(Vector(0.3, 0.5, 1));
    display().grab();
    // To a cylinder a tube is full.
    display().creating().start(newBody("s", scene().shapeSets[1].parts));
    click({1, 0, 0});
    done();
    const Vector place = scene().bodies.back().initialPosition;
    EXPECT_LT((place - Vector(1, 0.5, 0)).norm(), 0.2) << place;
}

TEST_F(CreatingTest, WhatCannotBeMadeYetSaysWhy) {
    open(balls);
    editor.document().setText("body\n", "Edit");
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("is being read"));
    done();
    EXPECT_FALSE(display().creating().active());
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("has errors"));
    display().editing().say({});
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("has errors"));
}

TEST_F(CreatingTest, APlaceIsTyped) {
    open(balls);
    display().creating().start(newBody("ball"));
    QTest::keyClicks(&display(), "1.25 -2,3x");
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("x y z = 1.25 -2,3_"));
    key(Qt::Key_Backspace);
    QTest::keyClicks(&display(), "-");
    key(Qt::Key_Return);
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("is no place"));
    key(Qt::Key_Backspace);
    QTest::keyClicks(&display(), "4");
    key(Qt::Key_Return);
    done();
    EXPECT_EQ(scene().bodies.back().initialPosition, Vector(1.25, -2, 4));
}

TEST_F(CreatingTest, APlaceIsDrawnToThingsUnlessControlIsHeld) {
    open(balls);
    const auto place = [&](Qt::KeyboardModifiers keys) {
        const QPointF origin = display().placeOf(1, 0, 0);
        display().creating().start(newBody("ball"));
        QTest::mouseClick(&display(), Qt::LeftButton, keys, (origin + QPointF(4, -3)).toPoint());
        done();
        return scene().bodies.back().initialPosition;
    };
    EXPECT_EQ(place({}), Vector(1, 0, 0));
    EXPECT_NE(place(Qt::ControlModifier), Vector(1, 0, 0));
}

TEST_F(CreatingTest, APlaceIsDrawnToThingsWhereAnOrthographicPictureShowsThem) {
    open("shape_set s -desc {-sub {-sphere 0.1}}\nbody a s -init_pos {2 1 -3}\n");
    display().creating().start(newBody("s"));
    display().creating().hover(QPointF(5, 5), false); // things are where perspective has them
    display().setOrthographic(true);
    display().grab();
    QTest::mouseClick(&display(), Qt::LeftButton, {},
                      (display().placeOf(2, 1, -3) + QPointF(3, 2)).toPoint());
    done();
    EXPECT_EQ(scene().bodies.back().initialPosition.head<2>(), Vector(2, 1, 0).head<2>());
}

TEST_F(CreatingTest, AShapeOfTheLibraryIsPlacedAtOnce) {
    open("");
    for (const editing::LibraryShape& shape : editing::shapeLibrary()) {
        display().creating().start(newBody(shape));
        key(Qt::Key_Return);
        done();
        ASSERT_FALSE(editor.document().hasErrors()) << shape.name;
    }
    EXPECT_EQ(scene().bodies.size(), editing::shapeLibrary().size());
    EXPECT_EQ(scene().shapeSets.back().parts, editing::shapeLibrary().back().parts);
}

TEST_F(CreatingTest, ReturnAndEscapeAreNotLostToASwitch) {
    open(balls);
    viewer->activateWindow();
    auto* box = viewer->findChildren<QCheckBox*>().front();
    EXPECT_EQ(box->focusPolicy(), Qt::TabFocus);
    display().creating().start(newBody("ball"));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Return);
    done();
    EXPECT_EQ(scene().bodies.size(), 3U);
    display().creating().start(newBody("ball"));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Escape);
    EXPECT_FALSE(display().creating().active());
}

TEST_F(CreatingTest, LightsParametersPlotsAndViews) {
    open(balls);
    display().creating().start(newLight(false));
    click({0, 1, 0});
    done();
    EXPECT_THAT(text(), HasSubstr("lightsource light1 -pos {"));
    display().creating().start(newParameter("g", "1", "0", "2"));
    done();
    EXPECT_THAT(text(), HasSubstr("parameter g -value 1 -min 0 -max 2\n"));
    display().creating().start(newPlot("b1.y + 1"));
    done();
    EXPECT_THAT(text(), HasSubstr("plot plot1 -values {{b1.y + 1}}\n"));
    ASSERT_EQ(scene().plots.size(), 1U);
    EXPECT_EQ(scene().plots[0].values, std::vector<std::string>{"b1.y + 1"});
    render::Camera camera = display().camera();
    camera.rotation = geometry::fromRotationVector(Vector(0.3, 0.4, 0.1));
    display().setCamera(camera);
    const std::string before = text();
    display().creating().start(keptView(display().camera(), 0.01));
    done();
    ASSERT_EQ(scene().views.size(), 1U);
    display().followView("view1");
    display().grab();
    EXPECT_LT(display().camera().rotation.angularDistance(camera.rotation), 1e-3);
    EXPECT_NEAR(display().camera().scale, camera.scale, 1e-3 * camera.scale);
}

TEST_F(CreatingTest, EscapeLeavesTheTextAsItIs) {
    open(balls);
    display().creating().start(newLink(Wanted::body));
    click({-1, 0, 0});
    key(Qt::Key_Escape);
    EXPECT_FALSE(display().creating().active());
    EXPECT_EQ(text(), balls);
}

// What was clicked on is of one text: with another one the command is given up.
TEST_F(CreatingTest, AChangeOfTheTextMeanwhileEndsIt) {
    open(balls);
    display().creating().start(newForce(false, 1));
    click({1, 0, 0});
    ASSERT_TRUE(display().creating().active());
    key(Qt::Key_Delete); // not what is selected
    EXPECT_EQ(text(), balls);
    QString said;
    QObject::connect(&display().creating(), &Creating::refused,
                     [&](const QString& why) { said = why; });
    const std::string one = balls.substr(0, balls.find("body b2"));
    editor.document().setText(one, "Edit");
    done();
    EXPECT_FALSE(display().creating().active());
    EXPECT_EQ(said, "The text was changed meanwhile.");
    key(Qt::Key_Return);
    EXPECT_EQ(text(), one);
}

TEST_F(CreatingTest, DeleteTakesWhatDependsOnItAfterAsking) {
    open(balls + "force -body b1 -y 1\n");
    QString asked;
    bool answer = false;
    display().editing().setConfirm([&](const QString& question) {
        asked = question;
        return answer;
    });
    key(Qt::Key_H); // the first body
    key(Qt::Key_Delete);
    EXPECT_THAT(asked.toStdString(), HasSubstr("the force of line 5"));
    EXPECT_EQ(text(), balls + "force -body b1 -y 1\n");
    answer = true;
    key(Qt::Key_Delete);
    EXPECT_EQ(text(), "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
                      "body b2 ball -init_pos {1 0 0}\n");
}

TEST_F(CreatingTest, WhatALoopMakesIsNotDeletedAlone) {
    const std::string loop = "shape_set s -desc {-sub {-sphere 1}}\n"
                             "foreach i {1 2} {body b$i s -init_pos \"$i 0 0\"}\n";
    open(loop);
    key(Qt::Key_H);
    key(Qt::Key_Delete);
    EXPECT_EQ(display().editing().said(), "Body \"b1\" is one of 2 that line 2 makes.");
    EXPECT_EQ(text(), loop);
}

} // namespace
} // namespace views
