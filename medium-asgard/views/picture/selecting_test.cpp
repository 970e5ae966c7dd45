// Selecting by plain clicks and a band, and what the selected does with a plain drag.
#include "framing/framing.h"
#include "picture/selecting_testing.h"
#include "properties/element_commands.h"

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(SelectingTest, AClickSelectsAndAnotherOneWhatLiesBehind) {
    click(middle);
    EXPECT_THAT(selected(), ElementsAre(nearOne));
    click(middle);
    EXPECT_THAT(selected(), ElementsAre(farOne));
    click(middle);
    EXPECT_THAT(selected(), ElementsAre(nearOne));
    click(left);
    EXPECT_THAT(selected(), ElementsAre(leftOne));
    EXPECT_EQ(editor.document().text(), three);
}

TEST_F(SelectingTest, AClickOnNothingAndEscapeDeselect) {
    click(left);
    click(empty);
    EXPECT_THAT(selected(), IsEmpty());
    click(left);
    QTest::keyClick(&display(), Qt::Key_Escape);
    EXPECT_THAT(selected(), IsEmpty());
}

TEST_F(SelectingTest, AHandThatTremblesTurnsNoView) {
    const geometry::Quaternion before = display().camera().rotation;
    drag(left, left + QPoint(2, 1));
    EXPECT_THAT(selected(), ElementsAre(leftOne));
    EXPECT_TRUE(display().camera().rotation.isApprox(before));
}

TEST_F(SelectingTest, APlainDragTurnsTheViewAndMovesWhatIsSelected) {
    const geometry::Quaternion before = display().camera().rotation;
    drag(left, left + QPoint(30, 20));
    EXPECT_FALSE(display().camera().rotation.isApprox(before));
    EXPECT_THAT(selected(), IsEmpty());
    display().lookAlong(Vector::UnitZ());
    display().keepCamera();
    display().grab();
    left = at({-3, 0, 0});
    click(left);
    const geometry::Quaternion now = display().camera().rotation;
    drag(left, at({-3, 1, 0}));
    EXPECT_TRUE(display().camera().rotation.isApprox(now));
    EXPECT_EQ(editor.document().undoLabel().toStdString(), "Move left");
    EXPECT_NEAR(editor.document().shown().scene->bodies[2].initialPosition.y(), 1, 0.05);
    editor.document().undo();
    EXPECT_EQ(editor.document().text(), three);
}

TEST_F(SelectingTest, AllThatAreSelectedMoveTogetherByABodyOrAnArrow) {
    editor.document().select({nearOne, leftOne});
    drag(left, left + QPoint(0, -50));
    const auto place = [&](std::size_t body) {
        return editor.document().shown().scene->bodies[body].initialPosition;
    };
    const Vector up = place(2) - Vector(-3, 0, 0);
    EXPECT_GT(up.y(), 0.1);
    EXPECT_LT((place(0) - Vector(0, 0, 2) - up).norm(), 1e-9) << editor.document().text();
    EXPECT_EQ(place(1), Vector(0.2, 0, -2));
    EXPECT_EQ(editor.document().undoLabel(), "Move 2 bodies");
    EXPECT_THAT(selected(), ElementsAre(nearOne, leftOne));
    const QPoint between = at((place(0) + place(2)) / 2); // where its arrow along x begins
    drag(between + QPoint(40, 0), between + QPoint(90, 20));
    EXPECT_GT(place(2).x(), -2.9);
    EXPECT_NEAR(place(0).x(), place(2).x() + 3, 1e-9);
    EXPECT_NEAR(place(2).y(), up.y(), 1e-12);
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(editor.document().text(), three);
}

TEST_F(SelectingTest, WhatWasSelectedBehindIsMovedThroughWhatIsBefore) {
    click(middle);
    click(middle);
    drag(middle, middle + QPoint(0, 30));
    EXPECT_EQ(editor.document().undoLabel().toStdString(), "Move far");
}

TEST_F(SelectingTest, ShiftAddsAndTakesOut) {
    click(left, Qt::ShiftModifier);
    click(middle, Qt::ShiftModifier);
    EXPECT_THAT(selected(), ElementsAre(nearOne, leftOne));
    click(left, Qt::ShiftModifier);
    EXPECT_THAT(selected(), ElementsAre(nearOne));
    click(left, Qt::ControlModifier);
    EXPECT_THAT(selected(), ElementsAre(nearOne, leftOne));
    for (const auto key : {Qt::ShiftModifier, Qt::ControlModifier}) {
        click(empty, key);
        EXPECT_THAT(selected(), ElementsAre(nearOne, leftOne));
    }
}

TEST_F(SelectingTest, ShiftAddsAPathAndKeepsWhatHasAHandle) {
    editor.document().setText(three + "trajectory w -points {{0 -3 2 0} {1 3 2 0}}\n"
                                      "constrain far -pos w\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->findChild<StatusPanel*>()->show(&render::Display::trajectories);
    display().grab();
    left = at({-3, 0, 0});
    const Element path{Kind::trajectory, 0};
    click(left);
    click(at({-1, 2, 0}), Qt::ShiftModifier);
    EXPECT_THAT(selected(), ElementsAre(leftOne, path));
    click(at({3, 2, 0}), Qt::ShiftModifier); // the handle of its point
    EXPECT_THAT(selected(), ElementsAre(leftOne, path));
    ASSERT_TRUE(display().editing().marked());
    EXPECT_EQ(display().editing().marked()->kind, render::HandleKind::trajectoryPoint);
    click(at({-1, 2, 0}), Qt::ShiftModifier);
    EXPECT_THAT(selected(), ElementsAre(leftOne));
}

TEST_F(SelectingTest, CtrlAndADragSelectTheBodiesInABand) {
    drag(at({-0.6, 0.6, 0}), at({0.8, -0.6, 0}), Qt::ControlModifier);
    EXPECT_THAT(selected(), ElementsAre(nearOne, farOne));
    drag(at({-3.6, 0.6, 0}), at({-2, -0.6, 0}), Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_THAT(selected(), ElementsAre(nearOne, farOne, leftOne));
    drag(at({-2, 0.6, 0}), at({-1, -0.6, 0}), Qt::ControlModifier);
    EXPECT_THAT(selected(), IsEmpty());
    EXPECT_EQ(editor.document().text(), three);
}

TEST_F(SelectingTest, EscapeEndsABand) {
    QTest::mousePress(&display(), Qt::LeftButton, Qt::ControlModifier, at({-4, 1, 0}));
    QTest::keyClick(&display(), Qt::Key_Escape);
    QTest::mouseRelease(&display(), Qt::LeftButton, Qt::ControlModifier, at({4, -1, 0}));
    EXPECT_THAT(selected(), IsEmpty());
}

TEST_F(SelectingTest, AHandleIsSelectedWithItsElementAndKeysMoveIt) {
    viewer->findChild<StatusPanel*>()->show(&render::Display::velocityHandles);
    display().grab();
    click(at({-3, 0, 0}));
    EXPECT_THAT(selected(), ElementsAre(leftOne));
    ASSERT_TRUE(display().editing().marked());
}

TEST_F(SelectingTest, TheHintSaysWhatADragDoes) {
    const auto hintAt = [&](QPoint place) {
        QMouseEvent move(QEvent::MouseMove, place, display().mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&display(), &move);
        return display().pointing().hint().toStdString();
    };
    EXPECT_THAT(hintAt(empty), HasSubstr("Ctrl-drag selects bodies"));
    const auto comes = [&](const char* words) {
        return waitFor([&] {
            return display().pointing().hint().toStdString().find(words) != std::string::npos;
        });
    };
    (void)hintAt(left);
    EXPECT_TRUE(comes("Click selects left"));
    click(left);
    EXPECT_TRUE(comes("Drag moves left"));
    EXPECT_EQ(display().cursor().shape(), Qt::SizeAllCursor);
}

TEST_F(SelectingTest, ADragAlongAnArrowOfTheGizmoMovesAlongItsAxisOnly) {
    editor.document().select({leftOne});
    display().grab();
    const QPoint onX = display().gizmo().arrow(0)->center().toPoint();
    drag(onX, onX + QPoint(40, 30));
    const Vector place = editor.document().shown().scene->bodies[2].initialPosition;
    EXPECT_GT(place.x(), -2.9);
    EXPECT_EQ(place.y(), 0);
    EXPECT_EQ(place.z(), 0);
}

TEST_F(SelectingTest, ADragOfASquareOfTheGizmoKeepsToItsPlane) {
    editor.document().select({leftOne});
    display().lookAlong({0.6, 0.7, 1});
    display().grab();
    for (int axis = 0; axis < 3; ++axis) {
        const QPolygonF square = display().gizmo().square(axis);
        ASSERT_EQ(square.size(), 4) << axis;
        const QPoint inside = square.boundingRect().center().toPoint();
        const auto part = display().gizmo().at(inside);
        ASSERT_TRUE(part && part->isPlane && part->axis == axis) << axis;
        const Vector before = editor.document().shown().scene->bodies[2].initialPosition;
        drag(inside, inside + QPoint(30, -25));
        const Vector way = editor.document().shown().scene->bodies[2].initialPosition - before;
        EXPECT_EQ(way[axis], 0) << way.transpose();
        EXPECT_GT(way.norm(), 0.05);
        display().grab();
    }
    display().lookAlong(Vector::UnitZ()); // the planes of z are lines
    display().grab();
    EXPECT_TRUE(display().gizmo().square(0).isEmpty());
    EXPECT_FALSE(display().gizmo().square(2).isEmpty());
}

// Of a rod that lies along x: its end is the rod's, the arrow begins beside it. Of one that fills
// the picture the arrows lie on it.
TEST_F(SelectingTest, ADragThatBeginsOnTheBodyIsTheBodys) {
    editor.document().setText("shape_set rod -desc {-sub {-box {2 0.2 0.2}}}\n"
                              "shape_set s -desc {-sub {-sphere 0.5}}\nbody r rod\n"
                              "body far s -init_pos {9 0 0}\nbody wide s -init_pos {-9 0 0}\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    display().frameNow();
    display().grab();
    editor.document().select({{Kind::body, 0}});
    const auto arrow = display().gizmo().arrow(0);
    ASSERT_TRUE(arrow.has_value());
    EXPECT_GT(arrow->x1(), at({1, 0, 0}).x());
    EXPECT_TRUE(display().gizmo().at(arrow->center()));
    for (const double x : {0.3, 0.6, 0.98}) // from all sides
        for (const Vector& from : {Vector(0, 0, 1), Vector(0.4, 0.5, 1), Vector(1, 2, 1)}) {
            display().lookAlong(from);
            display().grab();
            EXPECT_FALSE(display().gizmo().at(at({x, 0, 0}))) << x << " " << from.transpose();
        }
    display().lookAlong(Vector::UnitZ());
    render::Camera near = display().camera();
    near.scale *= 40;
    display().setCamera(near);
    display().grab();
    const auto inside = display().gizmo().arrow(0);
    ASSERT_TRUE(inside.has_value());
    EXPECT_TRUE(display().rect().contains(inside->p2().toPoint()));
    EXPECT_TRUE(display().gizmo().at(inside->center()));
}

TEST_F(SelectingTest, ARingTurnsTheSelectedBodyAboutItsAxis) {
    editor.document().select({leftOne});
    display().lookAlong({0.4, 0.5, 1});
    display().grab();
    const gestures::Sight sight = display().sight();
    const Vector center(-3, 0, 0);
    const double radius =
        display().gizmo().ringRadius(2) * sight.pixelLength(center) * display().devicePixelRatioF();
    const auto onRing = [&](double degrees) { // of z, from x on
        const double angle = degrees * M_PI / 180;
        return display()
            .fromPixels(sight.pixels(center + radius * Vector(std::cos(angle), std::sin(angle), 0)))
            .toPoint();
    };
    const auto turned = [&] {
        return Vector(
            180 / M_PI *
            geometry::toRotationVector(editor.document().shown().scene->bodies[2].initialAttitude));
    };
    const double from = 110; // in front, beside the arrows
    const auto part = display().gizmo().at(onRing(from));
    ASSERT_TRUE(part && part->isRing && part->axis == 2);
    drag(onRing(from), onRing(from + 43.5)); // drawn to 45
    EXPECT_TRUE(turned().isApprox(Vector(0, 0, 45), 1e-6)) << turned().transpose();
    EXPECT_EQ(editor.document().undoLabel(), "Turn left");
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    drag(onRing(from), onRing(from + 37)); // a whole degree
    EXPECT_NEAR(turned().z(), std::round(turned().z()), 1e-6);
    EXPECT_NEAR(turned().z(), 37, 1.01);
    EXPECT_EQ(editor.document().shown().scene->bodies[2].initialPosition, center);
}

TEST_F(SelectingTest, RingsStandAroundTheCentreOfMassAndTurnTheBodyAboutIt) {
    Editor other{engineWorkshop()};
    SceneDocument& document = other.document();
    document.setText("shape_set s -desc {-sub {-pos {2 0 0} -box {1 1 1}}}\nbody b s\n", "Edit");
    ASSERT_TRUE(settle(document));
    ASSERT_TRUE(document.shown().motion);
    SceneDisplay& picture = other.openGraphicalViewer()->display();
    picture.lookAlong({0.4, 0.5, 1});
    picture.grab();
    document.select({{Kind::body, 0}});
    const Vector center(2, 0, 0);
    const gestures::Sight sight = picture.sight();
    const double radius =
        picture.gizmo().ringRadius(0) * sight.pixelLength(center) * picture.devicePixelRatioF();
    const auto onRing = [&](double degrees) {
        const double angle = degrees * M_PI / 180;
        return picture
            .fromPixels(sight.pixels(center + radius * Vector(std::cos(angle), std::sin(angle), 0)))
            .toPoint();
    };
    const auto part = picture.gizmo().at(onRing(110));
    ASSERT_TRUE(part && part->isRing && part->axis == 2);
    QTest::mousePress(&picture, Qt::LeftButton, {}, onRing(110));
    for (const double degrees : {120.0, 155.0}) {
        QMouseEvent move(QEvent::MouseMove, onRing(degrees), picture.mapToGlobal(onRing(degrees)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&picture, &move);
    }
    QTest::mouseRelease(&picture, Qt::LeftButton, {}, onRing(155));
    ASSERT_TRUE(settle(document));
    const scene::Body& body = document.shown().scene->bodies[0];
    EXPECT_NEAR(geometry::toRotationVector(body.initialAttitude).z(), M_PI / 4, 1e-6);
    EXPECT_LT((body.initialPosition + body.initialAttitude * center - center).norm(), 1e-2);
    document.undo(); // one step
    EXPECT_EQ(document.undoLabel(), "Edit");
}

TEST_F(SelectingTest, AKeyKeepsADragToAnAxisAndWithShiftAcrossIt) {
    editor.document().select({leftOne});
    display().lookAlong({0.4, 0.5, 1});
    display().grab();
    const QPoint from = at({-3, 0, 0}) + QPoint(-4, -4);
    const auto place = [&] { return editor.document().shown().scene->bodies[2].initialPosition; };
    const auto dragBy = [&](Qt::Key key, Qt::KeyboardModifiers keys) {
        QTest::mousePress(&display(), Qt::LeftButton, {}, from);
        for (const QPoint& to : {from + QPoint(8, 0), from + QPoint(30, 25)}) {
            QMouseEvent move(QEvent::MouseMove, to, display().mapToGlobal(to), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(&display(), &move);
        }
        QTest::keyClick(&display(), key, keys);
        QTest::mouseRelease(&display(), Qt::LeftButton, {}, from + QPoint(30, 25));
        ASSERT_TRUE(settle(editor.document()));
    };
    dragBy(Qt::Key_Y, {});
    EXPECT_EQ(place().x(), -3);
    EXPECT_EQ(place().z(), 0);
    EXPECT_NE(place().y(), 0);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    dragBy(Qt::Key_Y, Qt::ShiftModifier);
    EXPECT_EQ(place().y(), 0);
    EXPECT_NE(place().x(), -3);
}

TEST_F(SelectingTest, WhatIsSelectedOutOfThePictureIsToldAndAClickShowsIt) {
    editor.document().select({leftOne});
    EXPECT_FALSE(display().selecting().tag().has_value());
    const std::string away = "-init_pos {-60 0 0}";
    std::string text = three;
    text.replace(text.find("-init_pos {-3 0 0}"), 18, away);
    editor.document().setText(text, "Place");
    ASSERT_TRUE(settle(editor.document()));
    display().grab();
    const auto tag = display().selecting().tag();
    ASSERT_TRUE(tag.has_value());
    EXPECT_THAT(tag->words.toStdString(), HasSubstr("left is out of the picture"));
    EXPECT_TRUE(QRectF(display().rect()).contains(tag->box));
    EXPECT_LT(tag->box.center().x(), display().width() / 2.0);          // where it is
    EXPECT_FALSE(tag->box.contains(QRectF(display().rect()).center())); // over no other body
    EXPECT_LT(tag->end.x(), -0.9);
    click(tag->box.center().toPoint());
    EXPECT_TRUE(display().rect().contains(at({-60, 0, 0})));
    EXPECT_FALSE(display().selecting().tag().has_value());
    EXPECT_THAT(selected(), ElementsAre(leftOne));
    editor.document().select({nearOne, leftOne});
    EXPECT_FALSE(display().selecting().tag().has_value()); // one of them is seen
    // A floor is seen whose corners are all out of the picture, and what is behind the eye is not.
    editor.document().setText("shape_set f -desc {-sub {-box {900 0.1 900}}}\n"
                              "shape_set s -desc {-sub {-sphere 0.5}}\n"
                              "body floor f -fixed 1\nbody b s -init_pos {0 1 200}\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    editor.document().select({{Kind::body, 0}});
    EXPECT_FALSE(display().selecting().tag().has_value());
    editor.document().select({{Kind::body, 1}});
    EXPECT_TRUE(display().selecting().tag().has_value());
}

// A picture that takes long is of an earlier moment, and so is what is painted over it.
TEST_F(SelectingTest, WhatIsPaintedOverAPictureIsOfItsMoment) {
    std::string text = three;
    text.replace(text.find("-init_pos {-3 0 0}"), 18, "-init_pos {-3 0 0} -init_dpos {-50 0 0}");
    editor.document().setText(text, "Leave");
    ASSERT_TRUE(settle(editor.document()));
    editor.document().select({leftOne});
    display().grab();
    const Vector start = display().centerOf(2);
    viewer->playback().seek(1.5); // not drawn yet
    EXPECT_EQ(display().time(), 1.5);
    EXPECT_EQ(display().drawn().time, 0);
    EXPECT_EQ(display().centerOf(2), start);
    EXPECT_FALSE(display().selecting().tag().has_value());
    display().grab();
    EXPECT_EQ(display().drawn().time, 1.5);
    EXPECT_NEAR(display().centerOf(2).x(), -78, 1e-6);
    EXPECT_TRUE(display().selecting().tag().has_value());
}

// A pane that opens below the picture makes it flat.
TEST_F(SelectingTest, WhatWasFramedStaysInAFlatterPictureUnlessSomebodyMovesTheView) {
    editor.document().setText(three + "body high s -init_pos {0 4 0}\n"
                                      "body low s -init_pos {0 -4 0}\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->resize(viewer->size() + QSize(0, 400));
    display().grab();
    display().frameNow();
    const render::Camera framed = display().camera();
    display().grab();
    const auto areSeen = [&] {
        display().grab();
        return display().rect().contains(at({0, 4.4, 0})) &&
               display().rect().contains(at({0, -4.4, 0})) &&
               display().rect().contains(at({-3.4, 0, 0}));
    };
    EXPECT_TRUE(areSeen());
    viewer->resize(viewer->size() - QSize(0, 500));
    EXPECT_TRUE(areSeen());
    viewer->resize(viewer->size() + QSize(0, 500));
    display().grab();
    EXPECT_EQ(display().camera(), framed); // as it was
    render::Camera near = framed;
    near.scale *= 2;
    display().setCamera(near);
    viewer->resize(viewer->size() - QSize(0, 300));
    display().grab();
    EXPECT_EQ(display().camera(), near);
}

TEST_F(SelectingTest, AHiddenBodyIsNeitherSeenNorClicked) {
    const QImage before = display().grab().toImage();
    display().hide({nearOne});
    EXPECT_NE(display().grab().toImage(), before);
    click(middle);
    EXPECT_THAT(selected(), ElementsAre(farOne));
    EXPECT_EQ(editor.document().text(), three);
    display().setHidden({});
    EXPECT_TRUE(display().hidden().empty());
}

// Delete would remove what nobody sees.
TEST_F(SelectingTest, AHiddenBodyIsNotSelectedAnyMoreNorByTheBand) {
    editor.document().select({leftOne, nearOne});
    display().hide({nearOne});
    EXPECT_THAT(selected(), ElementsAre(leftOne));
    const QRectF all = display().rect();
    const auto bodies = gestures::bodiesWithin(display().drawing(), display().sight(),
                                               display().inPixels(all.topLeft()),
                                               display().inPixels(all.bottomRight()));
    EXPECT_FALSE(bodies.empty());
    EXPECT_EQ(std::ranges::find(bodies, nearOne.index), bodies.end());
}

// As a new body: the picture steps back as far as it needs, and shows all from far out of it.
TEST_F(SelectingTest, ACopyThatComesOutOfThePictureIsShown) {
    const QList<QAction*> actions = display().actions();
    const auto duplicate = std::ranges::find(actions, "Dup&licate", &QAction::text);
    ASSERT_NE(duplicate, actions.end());
    const auto copied = [&](double right) { // where the picture ends; the scale before and then
        editor.document().setText(three, "Edit");
        EXPECT_TRUE(settle(editor.document()));
        editor.document().select({leftOne});
        display().frameNow();
        render::Camera camera = display().camera();
        camera.scale *= 1.2;
        camera.center = {0, 0, 0};
        display().setCamera(camera);
        camera.center.x() =
            right - display().sight().pixelLength({0, 0, 0}) * display().sight().size.width / 2;
        display().setCamera(camera);
        display().grab();
        (*duplicate)->trigger();
        EXPECT_TRUE(settle(editor.document()));
        const gestures::Sight sight = display().sight();
        const Vector copy = editor.document().shown().scene->bodies.back().initialPosition;
        EXPECT_TRUE(render::isWithin(sight.camera, sight.size, {copy, 0.5})) << right;
        return std::pair(camera, display().camera());
    };
    const auto [first, stays] = copied(-0.2); // the copy stands at -1.9
    EXPECT_EQ(stays, first);
    const auto [second, back] = copied(-1.6); // at the edge
    EXPECT_TRUE(back.center == second.center && back.scale < second.scale);
    EXPECT_GT(back.scale, 0.8 * second.scale);
    const auto [third, framed] = copied(-9);
    EXPECT_NE(framed.center, third.center);
}

TEST_F(SelectingTest, AClickOnTheTagLeavesAViewOfTheScene) {
    editor.document().setText(three + "view near -center {3 0 0} -scale 1.5\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    display().followView("near");
    display().grab();
    editor.document().select({leftOne});
    const auto tag = display().selecting().tag();
    ASSERT_TRUE(tag.has_value());
    click(tag->box.center().toPoint());
    display().grab();
    EXPECT_EQ(display().followedView(), "");
    EXPECT_FALSE(display().selecting().tag().has_value());
}

// A view of the scene is the author's.
TEST_F(SelectingTest, ACopyLeavesAViewOfTheSceneAsItIs) {
    editor.document().setText(three + "view near -center {-3 0 0} -scale 0.5\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    display().followView("near");
    display().grab();
    const render::Camera before = display().camera();
    editor.document().select({leftOne});
    ElementCommands(editor.document()).duplicate();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(display().followedView(), "near");
    EXPECT_EQ(display().camera(), before);
}

} // namespace
} // namespace views
