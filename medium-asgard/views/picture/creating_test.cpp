// (text, gesture, text) of the Create commands, by clicks and by keys, and of Delete.
#include "shapes/shape_names.h"
#include "viewers/editor.h"
#include "viewers/parameters_panel.h"
#include "views/test_workshop.h"

#include <QCheckBox>

#include <gmock/gmock.h>

namespace views {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string balls = "simulator -finish 2\n"
                          "shape_set ball -desc {-sub {-sphere 0.5}}\n"
                          "body b1 ball -init_pos {-1 0 0}\n"
                          "body b2 ball -init_pos {1 0 0}\n";

class CreatingTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& text) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        viewer->display().lookAlong(Vector::UnitZ());
        viewer->display().grab();
    }
    SceneDisplay& display() { return viewer->display(); }
    const std::string& text() { return editor.document().text(); }
    const scene::Scene& scene() { return *editor.document().shown().scene; }
    void click(const Vector& world) {
        QTest::mouseClick(&display(), Qt::LeftButton, {},
                          display().fromPixels(display().sight().pixels(world)).toPoint());
    }
    void key(Qt::Key which) { QTest::keyClick(&display(), which); }
    void done() { ASSERT_TRUE(settle(editor.document())) << text(); }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
};

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

TEST_F(CreatingTest, BodiesOfAFlatSceneStayInItsPlane) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {-1 0 0.25}\n");
    display().lookAlong(Vector(0.3, 0.4, 1));
    display().grab();
    display().creating().start(newBody("ball"));
    click({0.5, 1, 0.25});
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

TEST_F(CreatingTest, BodiesAttractEachOtherByOneConstant) {
    open(balls + "body sun ball -init_pos {0 4 0} -fixed 1\n");
    display().creating().start(newAttraction());
    click({0, 4, 0});
    click({1, 0, 0});
    done();
    ASSERT_EQ(scene().forces.size(), 1U); // the sun is fixed
    EXPECT_EQ(scene().forces[0].body, "b2");
    ASSERT_EQ(scene().parameters.size(), 1U);
    EXPECT_EQ(scene().parameters[0].name, "G");
    EXPECT_THAT(text(), HasSubstr("-x {G * b2.mass * sun.mass * (sun.x - b2.x) / "
                                  "hypot(sun.x - b2.x, sun.y - b2.y, sun.z - b2.z)^3}"));
    display().creating().start(attractionOfAll());
    done();
    EXPECT_EQ(scene().forces.size(), 1U + 3U); // none twice
    EXPECT_EQ(scene().parameters.size(), 1U);
    EXPECT_FALSE(editor.document().hasErrors());
}

TEST_F(CreatingTest, AParameterGOfSomethingElseIsLeftToIt) {
    open("parameter G -value 80e9\n" + balls);
    display().creating().start(attractionOfAll());
    done();
    ASSERT_EQ(scene().parameters.size(), 2U);
    EXPECT_EQ(scene().forces.size(), 2U);
    const std::string own = scene().parameters[1].name;
    EXPECT_NE(own, "G");
    EXPECT_THAT(text(), HasSubstr("-x {" + own + " * b1.mass * b2.mass * "));
}

TEST_F(CreatingTest, ASpringIsMadeByTwoClicks) {
    open(balls);
    display().creating().start(newSpring(Wanted::body));
    click({-1, 0, 0});
    click({1, 0, 0});
    done();
    EXPECT_EQ(text(), balls + "\nspring spring1 -body1 b1 -body2 b2 -stiffness 20 -rest 2\n");
}

TEST_F(CreatingTest, AnEmptySceneGetsItsFirstBodyWithAShape) {
    open("# nothing yet\n");
    display().creating().start(newBody(BasicShape::box));
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().bodies.size(), 1U);
    EXPECT_EQ(text(), "# nothing yet\n\nshape_set block1 -desc {-sub {-box {1 1 1}}}\n"
                      "body body1 block1 -init_pos {0 0 0} -restitution 0 -friction 0.3\n");
}

// Things of a room: what falls comes to rest, a ball bounces. The floor is where the grid is.
TEST_F(CreatingTest, ABallThatIsLiftedBouncesOnAFloorAtZero) {
    open("# nothing yet\n");
    display().creating().start(newBody(BasicShape::sphere));
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

TEST_F(CreatingTest, FromTheFirstMomentEverythingCanBeMade) {
    viewer = editor.openGraphicalViewer(); // nobody has opened or written anything
    display().grab();
    display().creating().start(newBody(BasicShape::sphere));
    key(Qt::Key_Return);
    done();
    EXPECT_EQ(scene().bodies.size(), 1U) << display().editing().said().toStdString();
    SceneDocument other(made.workshop());
    EXPECT_EQ(makeShape(other, "cube", {{scene::BoxShape{{1, 1, 1}}, {}, {}, {}}}, "New"), "");
    EXPECT_THAT(other.text(), StartsWith("shape_set cube"));
}

TEST_F(CreatingTest, WhatCannotBeMadeYetSaysWhy) {
    open(balls);
    editor.document().setText(balls + "\n", "Edit");
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("is being read still"));
    editor.document().setText("body\n", "Edit");
    done();
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("has errors"));
}

TEST_F(CreatingTest, GravityPointsFromTheCentreAndReturnTakesWhatIsSelected) {
    open(balls);
    display().creating().start(newWeight(display()));
    const double perUnit = display().arrowLength(false) * display().massOf(1);
    click({1.3, 0.2, 0}); // not its centre
    click({1.02, -0.8, 0});
    done();
    const auto& pulled = std::get<scene::GravitationalForce>(scene().forces.back().kind);
    EXPECT_NEAR(pulled.acceleration.y(), -0.8 / perUnit, 0.05 / perUnit);
    EXPECT_EQ(pulled.acceleration.x(), 0); // all but straight down
    EXPECT_EQ(pulled.acceleration.z(), 0);
    editor.document().undo();
    done();
    editor.document().select({{editing::Kind::body, 1}});
    display().creating().start(newWeight(display()));
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("Return: b2."));
    key(Qt::Key_Return);
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("9.81 downwards"));
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b2 -gravitational {0 -9.81 0}\n"));
    editor.document().setText(balls + "force -body b1 -gravitational {0 0 -1.6}\n", "Edit");
    done();
    editor.document().select({{editing::Kind::body, 1}});
    display().creating().start(newWeight(display()));
    key(Qt::Key_Return);
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b2 -gravitational {0 0 -1.6}\n"));
}

TEST_F(CreatingTest, AllBodiesThatCanFallGetTheirWeightAtOnce) {
    open(balls + "body floor ball -fixed 1\nforce -body b1 -gravitational {0 0 -1.6}\n");
    display().creating().start(weightForAll(usualGravity(scene())));
    done();
    ASSERT_EQ(scene().forces.size(), 2U);
    EXPECT_THAT(text(), HasSubstr("force -body b2 -gravitational {0 0 -1.6}\n"));
    display().creating().start(weightForAll(usualGravity(scene())));
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("has a weight already"));
}

TEST_F(CreatingTest, ALaterBodyFallsAsAllOthersDo) {
    const std::string weights = "force -body b1 -gravitational {0 -9.81 0}\n"
                                "force -body b2 -gravitational {0 -9.81 0}\n";
    open(balls + weights);
    display().creating().start(newBody("ball"));
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b3 -gravitational {0 -9.81 0}\n"));
    editor.document().undo(); // one step with its body
    EXPECT_EQ(text(), balls + weights);
    done();
    display().creating().start(newFloor()); // stands
    done();
    EXPECT_EQ(scene().forces.size(), 2U);
    EXPECT_EQ(scene().bodies.back().initialPosition, Vector(0, -0.5, 0)); // below the balls
    EXPECT_TRUE(scene().bodies.back().fixed);
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

TEST_F(CreatingTest, ADistanceIsMeasuredAndNothingIsWritten) {
    open(balls);
    display().creating().start(measure());
    click({-1, 0, 0});
    click({1, 0, 0});
    EXPECT_EQ(text(), balls);
    EXPECT_EQ(display().editing().said(), "The distance is 2; along x, y and z 2 0 0.");
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

TEST_F(CreatingTest, AForceIsAUnitDownwardsOrWhatASecondClickShows) {
    open(balls);
    display().creating().start(newForce(false, 1));
    click({-1, 0, 0});
    key(Qt::Key_Return);
    done();
    EXPECT_EQ(text(), balls + "\nforce -body b1 -x 0 -y -1 -z 0\n");
    EXPECT_TRUE(display().display().forceHandles);
    display().creating().start(newForce(false, 1));
    click({5, 5, 0}); // nothing there
    EXPECT_THAT(display().creating().prompt().toStdString(), StartsWith("There is no body."));
    click({1.3, 0, 0});
    click({1.3, 1, 0});
    done();
    ASSERT_EQ(scene().forces.size(), 2U);
    EXPECT_GT(scene().forces[1].offset->x(), 0.15);
    EXPECT_NEAR(scene().forces[1].offset->norm(), 0.5, 0.01); // on the surface
    EXPECT_NEAR(std::stod(std::get<scene::ComponentForce>(scene().forces[1].kind).components[1]), 1,
                0.1);
}

TEST_F(CreatingTest, WeightTorqueAndForcesByTrajectories) {
    open(balls + "trajectory T -points {{0 0 2 0} {2 2 2 0}}\n");
    display().creating().start(newWeight(display()));
    click({1, 0, 0});
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b2 -gravitational {0 -9.81 0}\n"));
    const double perUnit = display().arrowLength(false);
    display().creating().start(newWeight(display()));
    click({1, 0, 0});
    click({1, -0.8, 0}); // the head of its arrow
    done();
    const auto& weight = std::get<scene::GravitationalForce>(scene().forces.back().kind);
    EXPECT_NEAR(weight.acceleration.y(), -0.8 / (perUnit * display().massOf(1)), 0.05);
    EXPECT_NEAR(weight.acceleration.x(), 0, 0.05);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    display().creating().start(newForce(true, 1));
    click({-1, 0, 0});
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -torque 1 -body b1 -x 0 -y 0 -z 1\n"));
    display().creating().start(newTrajectoryForce(false));
    EXPECT_TRUE(display().display().trajectories);
    click({-1, 0, 0});
    click({1, 2, 0});
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b1 -trajectory T\n"));
    display().creating().start(newTrajectoryForce(true));
    click({-1, 0, 0});
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -torque 1 -body b1 -trajectory path1\n"));
}

TEST_F(CreatingTest, LinksOfAllKinds) {
    open(balls + "trajectory T -points {{0 0 2 0} {2 2 2 0}}\n");
    display().creating().start(newLink(Wanted::body));
    click({-0.7, 0, 0});
    click({1, 0, 0});
    done();
    ASSERT_EQ(scene().links.size(), 1U);
    EXPECT_NEAR(scene().links[0].first.offset->norm(), 0.5, 0.02); // on the surface
    EXPECT_EQ(std::get<scene::BodyEnd>(scene().links[0].second).body, "b2");
    EXPECT_EQ(scene().links[0].tightness, 100);
    display().creating().start(newLink(Wanted::point));
    click({1, 0, 0});
    click({1, 1, 0});
    done();
    EXPECT_NEAR(std::stod(std::get<scene::PointEnd>(scene().links[1].second).coordinates[1]), 1,
                0.05);
    display().creating().start(newLink(Wanted::trajectory));
    click({1, 0, 0});
    click({0.5, 2, 0});
    done();
    EXPECT_EQ(std::get<scene::TrajectoryEnd>(scene().links[2].second).trajectory, "T");
}

TEST_F(CreatingTest, AJointIsOnAnotherBodyOrOnTheGround) {
    open(balls);
    display().creating().start(newJoint(scene::JointType::hinge));
    click({-1.2, 0.1, 0});
    QTest::mouseMove(&display(),
                     display().fromPixels(display().sight().pixels({-1, 1, 0})).toPoint());
    display().grab(); // with the preview
    click({-0.99, 1, 0});
    done();
    ASSERT_EQ(scene().joints.size(), 1U);
    EXPECT_THAT(text(), HasSubstr("\njoint hinge1 -type hinge -body1 b1 -offset1 {0 "));
    EXPECT_FALSE(scene().joints[0].body2);
    EXPECT_NEAR(scene().joints[0].offset1->y(), 1, 0.05);
    EXPECT_TRUE(display().display().jointHandles);
    display().creating().start(newJoint(scene::JointType::ball));
    click({-1, 0, 0});
    click({0.8, 0, 0});
    done();
    EXPECT_EQ(scene().joints[1].name, "ball1");
    EXPECT_EQ(scene().joints[1].body2, "b2");
    EXPECT_NEAR(scene().joints[1].offset1->x(), 1.8, 0.05);
    EXPECT_EQ(scene().joints[1].offset1->y(), 0);
}

TEST_F(CreatingTest, ASliderHasALineAndADistanceTwoEnds) {
    open(balls);
    display().creating().start(newJoint(scene::JointType::slider));
    click({-1, 0, 0});
    click({-1, -1, 0});
    click({-1.02, 1, 0});
    done();
    EXPECT_EQ(scene().joints[0].axis, Vector(0, 1, 0));
    display().creating().start(newJoint(scene::JointType::distance));
    click({1, 0, 0});
    click({1.01, 1.5, 0});
    done();
    EXPECT_EQ(scene().joints[1].name, "rod1");
    EXPECT_FALSE(scene().joints[1].offset1);
    EXPECT_NEAR((*scene().joints[1].offset2 - Vector(1, 1.5, 0)).norm(), 0, 0.05);
    display().creating().start(newJoint(scene::JointType::fixed));
    click({1, 0, 0});
    click({-1, 0, 0});
    done();
    EXPECT_THAT(text(),
                HasSubstr("joint fixed1 -type fixed -body1 b2 -offset1 {-2 0 0} -body2 b1\n"));
}

TEST_F(CreatingTest, ARopeGoesThroughBodiesAndTheGround) {
    open(balls);
    display().creating().start(newRope());
    click({-1, 0, 0});
    click({0, 1.5, 0});
    click({1, 0, 0});
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().ropes.size(), 1U);
    EXPECT_THAT(text(), HasSubstr("\nrope rope1 -points {{b1} {"));
    EXPECT_EQ(scene().ropes[0].points[0].body, "b1");
    EXPECT_NEAR((*scene().ropes[0].points[1].place - Vector(0, 1.5, 0)).norm(), 0, 0.05);
    EXPECT_EQ(scene().ropes[0].points[2].body, "b2");
}

TEST_F(CreatingTest, ATrajectoryIsDrawnAndABodyLedByIt) {
    open(balls);
    display().creating().start(newTrajectory());
    for (const Vector& point : {Vector(-1, 0, 0), Vector(0, 0.5, 0), Vector(1, 1, 0)})
        click(point);
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().trajectories.size(), 1U);
    EXPECT_EQ(scene().trajectories[0].points.size(), 3U);
    EXPECT_EQ(scene().trajectories[0].points[1].first, 1);
    display().creating().start(attachTrajectory());
    click({-1, 0, 0});
    click({0, 0.5, 0});
    done();
    EXPECT_THAT(text(), HasSubstr("\nconstrain b1 -pos path1\n"));
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

TEST_F(CreatingTest, AParametersSliderIsItsNumberInTheText) {
    open("parameter g -value 1.0 -min 0 -max 4 -label pull -unit N ;# drag me\n" + balls);
    const std::string before = text();
    auto* panel = viewer->findChild<ParametersPanel*>();
    ASSERT_NE(panel, nullptr);
    QSlider* slider = panel->slider("g");
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->value(), 250);
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(750);
    EXPECT_THAT(text(), StartsWith("parameter g -value 3.0 -min 0 -max 4 -label pull"));
    slider->setSliderDown(false);
    done();
    EXPECT_EQ(scene().parameters[0].value, 3);
    QTest::keyClick(slider, Qt::Key_Right);
    done();
    EXPECT_NEAR(scene().parameters[0].value, 3.04, 1e-9);
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(CreatingTest, AMotorsSliderIsItsNumberInTheText) {
    open(balls + "joint pin -type hinge -body1 b1 -offset1 {0 0 0} -speed 2 ;# turns\n"
                 "joint rail -type cylindrical -body1 b2 -axis {0 1 0} -motor2 {0.5}\n"
                 "body b3 ball -init_pos {5 0 0}\n"
                 "joint free -type hinge -body1 b3 -offset1 {1 0 0} -motor {sin(t)}\n");
    auto* panel = viewer->findChild<ParametersPanel*>();
    EXPECT_EQ(panel->title(), "Motors");
    EXPECT_EQ(panel->slider("free -motor"), nullptr); // it is no number
    ASSERT_NE(panel->slider("rail -motor2"), nullptr);
    QSlider* slider = panel->slider("pin -speed");
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->value(), 750); // between -4 and 4
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(250);
    EXPECT_THAT(text(), HasSubstr("-speed -2 ;# turns"));
    slider->setSliderDown(false);
    done();
    EXPECT_EQ(scene().joints[0].coordinates[0].speed, "-2");
    EXPECT_EQ(slider->value(), 250); // its ends are as wide as they were
    panel->slider("rail -motor2")->setValue(1000);
    done();
    EXPECT_THAT(text(), HasSubstr("-motor2 {1.0}"));
    editor.document().undo();
    editor.document().undo();
    EXPECT_THAT(text(), HasSubstr("-speed 2 ;# turns"));
}

TEST_F(CreatingTest, UnderAHostASliderChangesTheTextToo) {
    open("parameter g -value 1 -min 0 -max 4\n" + balls);
    std::vector<std::string> told;
    editor.document().setHostLink(
        {[&](const text::Edit& edit, const QString&) { told.push_back(edit.text); }, [] {}, [] {}});
    QSlider* slider = viewer->findChild<ParametersPanel*>()->slider("g");
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(750);
    slider->setSliderDown(false);
    EXPECT_THAT(text(), StartsWith("parameter g -value 3 -min"));
    EXPECT_EQ(told, std::vector<std::string>{"3"});
}

TEST_F(CreatingTest, KeysOfASliderAreHeardWhileTheSceneIsRead) {
    open("parameter g -value 1.00 -min 0 -max 4\n" + balls);
    QSlider* slider = viewer->findChild<ParametersPanel*>()->slider("g");
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(slider, Qt::Key_Right);
    ASSERT_TRUE(waitFor([&] {
        return editor.document().work() == Work::none && editor.document().sceneIsCurrent() &&
               scene().parameters[0].value > 1.19;
    })) << text();
    EXPECT_NEAR(scene().parameters[0].value, 1.2, 1e-9);
}

TEST_F(CreatingTest, AKeyIsForItsSliderThoughAnotherStandsThereWhenTheTextIsRead) {
    const std::string own = "parameter g -value 1.00 -min 0 -max 4\n" + balls;
    open(own);
    auto* panel = viewer->findChild<ParametersPanel*>();
    editor.document().setText("parameter a -value 1.00 -min 0 -max 4\n" + own, "Edit");
    ASSERT_FALSE(editor.document().sceneIsCurrent());
    QTest::keyClick(panel->slider("g"), Qt::Key_Right);
    ASSERT_TRUE(waitFor([&] {
        return editor.document().sceneIsCurrent() && scene().parameters.size() == 2 &&
               scene().parameters[1].value > 1;
    })) << text();
    EXPECT_EQ(scene().parameters[0].value, 1);
    EXPECT_NEAR(scene().parameters[1].value, 1.04, 1e-9);
}

TEST_F(CreatingTest, TheKeysAloneMakeALink) {
    open(balls);
    display().setFocus();
    display().creating().start(newLink(Wanted::body));
    const auto go = [&](const Vector& to, QPointF& from) {
        const QPointF at = display().fromPixels(display().sight().pixels(to));
        while (std::abs(at.x() - from.x()) > 7) {
            key(at.x() > from.x() ? Qt::Key_Right : Qt::Key_Left);
            from.rx() += at.x() > from.x() ? 12 : -12;
        }
        key(Qt::Key_Return);
        from = QRectF(display().rect()).center();
    };
    QPointF cross = QRectF(display().rect()).center();
    go({-1, 0, 0}, cross);
    go({1, 0, 0}, cross);
    done();
    ASSERT_EQ(scene().links.size(), 1U) << text();
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
