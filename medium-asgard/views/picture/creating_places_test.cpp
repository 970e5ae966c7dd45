// Round places and fitting sizes of what is made by clicks.
#include "picture/creating_testing.h"
#include "simulation/simulation.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QMenu>

#include <cmath>
#include <numbers>

namespace views {
namespace {

QAction* bodyNamed(const QMenu& create, const QString& name) {
    for (QAction* one : create.findChild<QMenu*>("createBody")->actions())
        if (one->text().remove('&') == name)
            return one;
    return nullptr;
}

bool isRound(double value, double step) { return std::abs(std::remainder(value, step)) < 1e-9; }

TEST_F(CreatingTest, OnAFloorPlacesAreAsRoundAsOnTheGrid) {
    open("shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n"
         "shape_set s -desc {-sub {-sphere 0.5}}\nbody b s -init_pos {0 0.5 0}\n");
    display().lookAlong(Vector(0, 0.8, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    click({1.387, 0, 0.831});
    done();
    const Vector place = scene().bodies.back().initialPosition;
    EXPECT_TRUE(isRound(place.x(), 0.05) && isRound(place.z(), 0.05)) << place.transpose();
    EXPECT_EQ(place.y(), 0.5);
}

// A click there could mean the middle of the board's lower side, seen through it.
TEST_F(CreatingTest, OnAThinBoardABodyStandsOnItsUpperSide) {
    open(
        "shape_set top -desc {-sub {-pos {0 0.5 0} -box {1 0.05 0.6}}}\nbody table top -fixed 1\n");
    display().lookAlong(Vector(0, 0.8, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::sphere));
    click({0, 0.475, 0});
    done();
    const auto& ball = std::get<scene::SphereShape>(scene().shapeSets.back().parts[0].shape);
    EXPECT_NEAR(scene().bodies.back().initialPosition.y(), 0.525 + ball.radius, 1e-9);
    EXPECT_TRUE(editor.document().diagnostics().empty()) << text(); // they do not overlap
}

TEST_F(CreatingTest, AJointOnTheGroundStandsAtARoundPlace) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\nbody c ball -init_pos {4 0 0}\n");
    const auto make = [&](const Vector& place) {
        display().creating().start(newJoint(scene::JointType::hinge));
        click({0, 0, 0});
        click(place);
        if (display().creating().active())
            key(Qt::Key_Return);
        done();
        display().grab();
        return scene().joints.back().offset1.value_or(Vector::Zero());
    };
    const Vector place = make({0.618, 1.137, 0});
    EXPECT_TRUE(isRound(place.x(), 0.05) && isRound(place.y(), 0.05)) << text();
    EXPECT_LT((place - Vector(0.618, 1.137, 0)).norm(), 0.15);
    EXPECT_EQ(make({0.02, 1.137, 0}).x(), 0); // above its middle
}

// Two rods end to end: whatever side of the seam the pointer stands on, and some pixels beside it,
// the second rod is meant, and its end.
TEST_F(CreatingTest, AJointAtTheSeamOfTwoBodiesIsAtTheEndOfTheSecond) {
    open("shape_set rod -desc {-sub {-box {2 0.1 0.1}}}\nbody b1 rod -init_pos {1 0 0}\n"
         "body b2 rod -init_pos {3 0 0}\n");
    display().frameAll();
    display().grab();
    for (const QPoint away : {QPoint(0, 0), QPoint(-5, 1), QPoint(4, 0), QPoint(2, -7)}) {
        display().creating().start(newJoint(scene::JointType::hinge));
        click({1, 0, 0});
        const QPoint place =
            display().fromPixels(display().sight().pixels({2, 0, 0})).toPoint() + away;
        display().creating().hover(place);
        EXPECT_THAT(display().creating().pointedWords().toStdString(),
                    testing::StartsWith("to b2: 2 0 0, "));
        QTest::mouseClick(&display(), Qt::LeftButton, {}, place);
        done();
        display().grab();
        EXPECT_EQ(scene().joints.back().body2, "b2") << text();
        EXPECT_EQ(scene().joints.back().offset1, Vector(1, 0, 0)) << text();
    }
}

// On a body a joint is drawn to its corners and edges, else to round numbers; Ctrl means what is
// seen, to the pixel; and beside all bodies the words name the ground.
TEST_F(CreatingTest, AJointOnABodyIsDrawnToItsThings) {
    open("shape_set s -desc {-sub {-box {1 1 0.1}}}\nbody b1 s\nbody b2 s -init_pos {3 0 0}\n");
    display().frameAll();
    display().grab();
    const double pixel = display().sight().pixelLength({3, 0, 0});
    const auto pointed = [&](const Vector& place, bool holdsOff = false) {
        display().creating().hover(display().fromPixels(display().sight().pixels(place)), holdsOff);
        return display().creating().pointedWords().toStdString();
    };
    display().creating().start(newJoint(scene::JointType::ball));
    click({0, 0, 0});
    EXPECT_THAT(pointed({2.5 + pixel, 0.5 - pixel, 0}),
                testing::MatchesRegex("to b2: 2.5 0.5 0, (a corner|the middle of an edge) of .*"));
    EXPECT_THAT(pointed({2.8, 0.5 - 2 * pixel, 0}),
                testing::MatchesRegex("to b2: 2.8[0-9]* 0.5 0, an edge of b2; .*"));
    EXPECT_THAT(pointed({3 + 2 * pixel, pixel, 0}), testing::StartsWith("to b2: 3 0 0;"));
    EXPECT_THAT(pointed({3.21, 0.21, 0}), testing::StartsWith("to b2: 3.2 0.2 0;"));
    const Vector beside(2.5 - 5 * pixel, 0.21, 0);
    EXPECT_THAT(pointed(beside), testing::StartsWith("to b2: 2.5 "));
    EXPECT_THAT(pointed(beside, true), testing::StartsWith("to the ground: 2.4"));
    EXPECT_THAT(pointed({1.61, 0.21, 0}), testing::StartsWith("to the ground: 1.6 0.2 0;"));
}

// A click on a slope under the car that was meant.
TEST_F(CreatingTest, AFixedBodyIsToldBeforeAJointAndTakesNoWheels) {
    open("shape_set s -desc {-sub {-box {1 1 1}}}\nbody post s -fixed 1\n"
         "body b s -init_pos {3 0 0}\n");
    const std::string before = text();
    display().creating().start(newJoint(scene::JointType::hinge));
    click({3, 0, 0});
    display().creating().hover(display().fromPixels(display().sight().pixels({0.3, 0.2, 0})));
    EXPECT_THAT(display().creating().pointedWords().toStdString(),
                testing::StartsWith("to post, which is fixed: "));
    key(Qt::Key_Escape);
    display().creating().start(newJoint(scene::JointType::hinge));
    click({0, 0, 0});
    click({1.5, 1, 0});
    EXPECT_THAT(display().creating().prompt().toStdString(),
                testing::StartsWith("post is fixed, as the ground is: "));
    click({3, 0, 0}); // the command goes on
    done();
    EXPECT_EQ(scene().joints.front().body2, "b");
    editor.document().setText(before, "Edit");
    done();
    display().grab();
    display().creating().start(newWheels());
    click({0.1, 0.1, 0.5});
    EXPECT_THAT(display().creating().prompt().toStdString(),
                testing::StartsWith("post is fixed and rolls nowhere: "));
    EXPECT_EQ(text(), before);
}

TEST_F(CreatingTest, ThePlaceOfAJointIsTyped) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball -init_pos {1 0 0}\n");
    display().creating().start(newJoint(scene::JointType::hinge));
    click({1, 0, 0});
    QTest::keyClicks(&display(), "0 2 0");
    EXPECT_THAT(display().creating().prompt().toStdString(), testing::HasSubstr("x y z = 0 2 0_"));
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().joints.size(), 1U);
    EXPECT_EQ(scene().joints[0].offset1, Vector(-1, 2, 0)) << text();
    EXPECT_FALSE(scene().joints[0].body2.has_value());
}

// A body that neither turns nor slides is refused at the pointer, and the command goes on.
TEST_F(CreatingTest, AGearIsMadeByTwoClicks) {
    open("shape_set large -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.4 0.1}}}\n"
         "shape_set small -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.2 0.1}}}\n"
         "body large large\nbody small small -init_pos {0.6 0 0}\n"
         "body loose small -init_pos {-0.8 0 0}\n"
         "joint one -type hinge -body1 large\njoint two -type hinge -body1 small\n");
    display().creating().start(newGear());
    click({-0.8, 0, 0});
    EXPECT_TRUE(display().creating().active());
    click({0.3, 0, 0.05});
    EXPECT_TRUE(display().creating().active());
    click({0.65, 0, 0.05});
    done();
    EXPECT_FALSE(display().creating().active());
    ASSERT_EQ(scene().gears.size(), 1U) << text();
    EXPECT_THAT(text(), testing::HasSubstr("-joint1 one -joint2 two -ratio -0.5"));
}

// A slip of the hand moves no body, and the command goes on.
TEST_F(CreatingTest, LettersAreNoCommandsWhileSomethingIsMade) {
    const std::string two =
        "shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball -init_pos {1 0 0}\n";
    open(two);
    editor.document().select({{editing::Kind::body, 0}});
    const geometry::Quaternion before = display().camera().rotation;
    const auto keep = [&] {
        QTest::keyClicks(&display(), "xzfny 2c");
        QTest::keyClick(&display(), Qt::Key_H, Qt::ShiftModifier);
        EXPECT_EQ(text(), two);
        EXPECT_TRUE(display().creating().active());
        EXPECT_EQ(display().camera().rotation.coeffs(), before.coeffs());
    };
    display().creating().start(newJoint(scene::JointType::hinge));
    keep(); // a body is asked for
    click({1, 0, 0});
    QTest::keyClicks(&display(), "x");
    EXPECT_EQ(text(), two);
    QTest::keyClicks(&display(), "0 2 0");
    key(Qt::Key_Return);
    done();
    EXPECT_EQ(scene().joints.size(), 1U);
    made.readsSlowly = true;
    editor.document().setText(two + "set a 1\n", "Edit");
    display().creating().start(newSpring(Wanted::body));
    QTest::keyClicks(&display(), "2 "); // they wait for the scene
    made.readsSlowly = false;
    done();
    EXPECT_TRUE(display().creating().active());
    EXPECT_EQ(display().camera().rotation.coeffs(), before.coeffs());
}

// The slab is seen behind the place, and is not there.
TEST_F(CreatingTest, ATypedPlaceOfAJointIsOnTheBodyThatIsThere) {
    open("shape_set wheel -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.5 0.2}}}\n"
         "shape_set slab -desc {-sub {-box {20 20 1}}}\n"
         "shape_set car -desc {-sub {-box {4 1 1}}}\n"
         "body w wheel -init_pos {1 0 3}\nbody g slab -fixed 1\n"
         "body c car -init_pos {5 0 3}\n");
    const auto make = [&](const QString& place) {
        display().creating().start(newJoint(scene::JointType::hinge));
        click({1, 0, 3});
        QTest::keyClicks(&display(), place);
        key(Qt::Key_Return);
        done();
        display().grab();
        return scene().joints.back().body2.value_or("the ground");
    };
    EXPECT_EQ(make("1 2 3"), "the ground");
    EXPECT_EQ(make("4 0 3"), "c");
    EXPECT_EQ(make("3 0.5 3"), "c"); // an edge of it
    EXPECT_EQ(make("1 2 0.5"), "g"); // its face
}

// The car's middle is 1 m nearer to the eye than the wheel's.
TEST_F(CreatingTest, AJointLiesOnTheBodyThatIsClickedFurtherBehind) {
    open("shape_set wheel -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.5 0.2}}}\n"
         "shape_set car -desc {-sub {-box {4 1 1}}}\n"
         "body c car -init_pos {0 1 0}\nbody w wheel -init_pos {1.5 0.3 -1}\n");
    display().lookAlong(Vector(0.1, -0.1, 1));
    display().grab();
    display().creating().start(newJoint(scene::JointType::hinge));
    click({-1, 1, 0});
    click({1.55, 0.1, -0.9}); // its face, beside the axis
    done();
    ASSERT_EQ(scene().joints.size(), 1U) << text();
    EXPECT_EQ(scene().joints[0].body2, "w");
    EXPECT_NEAR(scene().joints[0].offset1.value_or(Vector::Zero()).z(), -1, 0.05) << text();
}

// As large as one sees well, where the usual size is a dot or does not fit.
TEST_F(CreatingTest, ANewBodyFitsThePicture) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\n");
    QMenu menu;
    buildCreateMenu(&menu, editor.document(), display());
    QAction* box = bodyNamed(menu, "New Box");
    ASSERT_NE(box, nullptr);
    for (const double times : {1.0, 60.0, 1.0 / 2000}) {
        render::Camera camera = display().camera();
        camera.scale *= times;
        display().setCamera(camera);
        display().grab();
        box->trigger();
        key(Qt::Key_Return);
        done();
        const auto& part = scene().shapeSets.back().parts.front();
        const double edge = std::get<scene::BoxShape>(part.shape).edges.x();
        const double narrow = display().sight().pixelLength(camera.center) *
                              std::min(display().sight().size.width, display().sight().size.height);
        EXPECT_GE(edge, narrow / 12) << times;
        EXPECT_LE(edge, narrow / 3) << times;
    }
}

// Further behind, or nearer, as large as it is seen well there, whatever is selected.
TEST_F(CreatingTest, ANewBodyFitsThePlaceThatIsPointedAt) {
    open("shape_set ball -desc {-sub {-sphere 0.02}}\nbody b ball -init_pos {0 0.02 0}\n"
         "body far ball -init_pos {0 0.02 -3}\n");
    editor.document().select({{editing::Kind::body, 0}});
    QMenu menu;
    buildCreateMenu(&menu, editor.document(), display());
    render::Camera camera;
    camera.rotation = render::facing({0, 0.4, 1}, Vector::UnitY());
    camera.scale = 5; // the eye is 1 m away
    for (const double z : {0.3, -2.0}) {
        const Vector place(0.15, 0, z);
        display().setCamera(camera);
        display().grab();
        bodyNamed(menu, "New Box")->trigger();
        click(place);
        done();
        const gestures::Sight sight = display().sight();
        const auto& part = scene().shapeSets.back().parts.front();
        const double edge = std::get<scene::BoxShape>(part.shape).edges.x();
        const double narrow =
            sight.pixelLength(place) * std::min(sight.size.width, sight.size.height);
        EXPECT_NEAR(scene().bodies.back().initialPosition.z(), z, edge) << text();
        EXPECT_GE(edge, narrow / 12) << z;
        EXPECT_LE(edge, narrow / 3) << z;
    }
}

TEST_F(CreatingTest, ADistanceIsMeasuredAndNothingIsWritten) {
    open(balls);
    display().creating().start(measure());
    click({-1, 0, 0});
    click({1, 0, 0});
    EXPECT_EQ(text(), balls);
    EXPECT_EQ(display().editing().said(), "The distance is 2 m; along x, y and z 2 0 0 m.");
    // Seen until Escape.
    display().editing().say({});
    const QImage measured = display().grab().toImage();
    EXPECT_TRUE(display().creating().forgetMeasured());
    EXPECT_NE(display().grab().toImage(), measured);
    EXPECT_FALSE(display().creating().forgetMeasured());
}

// Its letter begins it.
TEST_F(CreatingTest, NoTwoEntriesOfAMenuHaveTheSameLetter) {
    open("");
    QMenu menu;
    buildCreateMenu(&menu, editor.document(), display());
    QList<QMenu*> menus = menu.findChildren<QMenu*>();
    menus.push_back(&menu);
    for (const QMenu* one : menus) {
        QString letters;
        for (const QAction* action : one->actions()) {
            const auto at = action->text().indexOf('&');
            const QString letter = at < 0 ? QString() : action->text().mid(at + 1, 1).toLower();
            EXPECT_FALSE(!letter.isEmpty() && letters.contains(letter))
                << one->title().toStdString() << ": " << action->text().toStdString();
            letters += letter;
        }
    }
}

TEST_F(CreatingTest, ABodyThatIsTypedPartlyOutOfSightComesIntoThePicture) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\n");
    display().frameNow();
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    QTest::keyClicks(&display(), "0 0.5 0");
    key(Qt::Key_Return);
    done();
    display().grab();
    EXPECT_TRUE(display().rect().contains(
        display().fromPixels(display().sight().pixels({0.5, 1, 0})).toPoint()));
}

const std::string car =
    "simulator -finish 1\nshape_set slab -desc {-sub {-box {10 0.5 3}}}\n"
    "shape_set hull -desc {-sub {-box {2 0.5 1.2}}}\n"
    "body ramp slab -init_rot {0 0 -0.2} -fixed 1 -friction 0.5 -restitution 0\n"
    "body car hull -init_pos {-2.840865068 1.086041281 0} -init_rot {0 0 -0.2} -restitution 0\n"
    "force -body car -gravitational {0 -9.81 0}\n"; // it lies on the ramp

TEST_F(CreatingTest, OnASlopeAPlaceIsRoundAcrossIt) {
    open(car);
    display().lookAlong(Vector(0, 0.8, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    click(scene().bodies[0].initialAttitude * Vector(2.137, 0.25, 0.831));
    done();
    const scene::Body& box = scene().bodies.back();
    EXPECT_TRUE(isRound(box.initialPosition.z(), 0.05)) << box.initialPosition.transpose();
    EXPECT_TRUE(isRound(box.initialPosition.x(), 0.01)) << box.initialPosition.transpose();
    EXPECT_TRUE(box.initialAttitude.isApprox(scene().bodies[0].initialAttitude));
}

// Two clicks. It stands on its wheels, falls as the box does, and rolls: no wheel slips.
TEST_F(CreatingTest, TwoAxlesMakeACarOfABox) {
    open(car);
    display().lookAlong(Vector(0.3, 0.4, 1));
    display().grab();
    for (const double along : {-0.7, 0.7}) {
        display().creating().start(newWheels());
        const scene::Body& box = scene().bodies[1];
        click(box.initialPosition + box.initialAttitude * Vector(along, -0.12, 0.6));
        done();
        display().grab();
    }
    ASSERT_EQ(scene().bodies.size(), 6U) << text();
    ASSERT_EQ(scene().joints.size(), 4U);
    EXPECT_EQ(scene().forces.size(), 5U);
    EXPECT_EQ(editor.document().selected().front(), (editing::Element{editing::Kind::body, 4}));
    EXPECT_EQ(editor.document().undoLabel(), "New Wheels");
    const Vector down = scene().bodies[0].initialAttitude * Vector::UnitX();
    const auto result = simulation::simulate(scene(), {});
    const simulation::Motion& motion = *result.motion;
    ASSERT_EQ(motion.computed(), 1) << text();

    const Vector way = motion.at(1, 1).position - motion.at(1, 0).position;
    EXPECT_GT(way.dot(down), 0.6); // 0.97 without wheels to be turned
    EXPECT_NEAR(way.dot(down), way.norm(), 1e-3);
    for (std::size_t wheel = 2; wheel < 6; ++wheel)
        EXPECT_NEAR(-motion.at(wheel, 1).angularVelocity.z() * 0.3,
                    motion.at(wheel, 1).velocity.dot(down), 1e-3);
}

// Velocities of both, so that the middle of their mass rests, and the missing forces alone.
TEST_F(CreatingTest, AnOrbitIsMadeByTwoClicks) {
    open("simulator -finish 8\nshape_set s -desc {-sub {-sphere 0.3}}\n"
         "body sun s -mass 4\nbody earth s -init_pos {2 0 0} -mass 1\n");
    const auto make = [&] {
        display().creating().start(newOrbit());
        click({0, 0, 0});
        click({0, 0, 0}); // refused, and the command goes on
        EXPECT_TRUE(display().creating().active());
        click({2, 0, 0});
        done();
        display().grab();
    };
    make();
    ASSERT_EQ(scene().forces.size(), 2U) << text();
    const auto result = simulation::simulate(scene(), {});
    const simulation::Motion& motion = *result.motion;
    const double speed = std::sqrt(5 / 2.0);                               // G (M + m) / d
    EXPECT_NEAR(scene().bodies[1].initialVelocity.y(), 0.8 * speed, 1e-5); // in the picture
    EXPECT_NEAR(scene().bodies[0].initialVelocity.y(), -0.2 * speed, 1e-5);
    for (const double time : {1.0, 3.0, 6.0})
        EXPECT_NEAR((motion.at(1, time).position - motion.at(0, time).position).norm(), 2, 1e-3);
    const double period = 2 * std::numbers::pi * 2 / speed;
    EXPECT_LT((motion.at(1, period).position - Vector(2, 0, 0)).norm(), 1e-2);
    EXPECT_EQ(editor.document().selected().front(), (editing::Element{editing::Kind::body, 1}));
    const std::string before = text();
    make();
    EXPECT_EQ(text(), before);
    EXPECT_THAT(display().editing().said().toStdString(), testing::HasSubstr("already"));
}

} // namespace
} // namespace views
