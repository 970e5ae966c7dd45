// (text, gesture, text) of forces, links, joints, ropes and trajectories.
#include "picture/creating_testing.h"

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

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
    EXPECT_THAT(editor.document().selected(), testing::IsEmpty());
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

// Whatever its type it is read as it was made, and its motion is computed.
TEST_F(CreatingTest, JointsOfAllTypesAreMadeByClicks) {
    using scene::JointType;
    for (const JointType type : {JointType::fixed, JointType::hinge, JointType::slider,
                                 JointType::cylindrical, JointType::universal, JointType::ball,
                                 JointType::planar, JointType::distance, JointType::screw}) {
        open(balls);
        display().creating().start(newJoint(type));
        click({-1, 0, 0});
        click({1, 0, 0});
        if (display().creating().active()) // where it slides to
            click({2.5, 0, 0});
        done();
        EXPECT_FALSE(display().creating().active());
        EXPECT_TRUE(editor.document().diagnostics().empty()) << text();
        ASSERT_EQ(scene().joints.size(), 1U) << text();
        const scene::Joint& made = scene().joints[0];
        EXPECT_EQ(made.type, type);
        EXPECT_EQ(made.body2, "b2");
        const bool slides =
            type == JointType::slider || type == JointType::cylindrical || type == JointType::screw;
        if (slides) {
            EXPECT_EQ(made.axis, Vector::UnitX()) << text();
        }
        if (type == JointType::universal) {
            EXPECT_EQ(made.axis.dot(made.axis2.value_or(made.axis)), 0) << text();
            EXPECT_EQ(made.axis.y(), 0);
        }
        EXPECT_EQ(made.pitch > 0, type == JointType::screw);
    }
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

// Numbers that are typed for an arrow are its value, however long it is drawn.
TEST_F(CreatingTest, TheValueOfAForceIsTyped) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball -init_pos {1 2 0} -mass 3\n");
    const auto typed = [&](const Recipe& recipe, const QString& value) {
        display().creating().start(recipe);
        click({1, 2, 0});
        QTest::keyClicks(&display(), value);
        key(Qt::Key_Return);
        done();
        display().grab();
        return text().substr(text().rfind("force"));
    };
    EXPECT_EQ(typed(newWeight(display()), "0 -1.62 0"),
              "force -body b -gravitational {0 -1.62 0}\n");
    EXPECT_EQ(typed(newForce(false, display().arrowLength(false)), "0.1 0 -250"),
              "force -body b -x 0.1 -y 0 -z -250\n");
    EXPECT_EQ(typed(newForce(true, display().arrowLength(true)), "0 0 7"),
              "force -torque 1 -body b -x 0 -y 0 -z 7\n");
}

} // namespace
} // namespace views
