// Commands, keys and clicks of Create that come before the scene that they mean is there.
#include "picture/creating_testing.h"

#include <QKeyEvent>
#include <QMenu>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

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

TEST_F(CreatingTest, ACommandAndItsKeysWaitForAScene) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {-100 0 0}\n"
         "body b2 ball -init_pos {100 0 0}\n");
    made.readsSlowly = true;
    editor.document().reset();
    display().creating().start(newBody(BasicShape::sphere));
    QTest::keyClicks(&display(), "0 1 0");
    click({0, 0, 0}); // on what is not seen yet
    EXPECT_THAT(display().creating().prompt().toStdString(), StartsWith("The click came before"));
    key(Qt::Key_Return);
    made.readsSlowly = false;
    done();
    ASSERT_EQ(scene().bodies.size(), 1U);
    EXPECT_EQ(scene().bodies[0].initialPosition, Vector(0, 1, 0));
    display().grab(); // seen as in a scene that was new all the while
    EXPECT_LT(display().sight().pixelLength({0, 1, 0}), 0.02);
    made.readsSlowly = true;
    editor.document().reset();
    display().creating().start(newBody(BasicShape::sphere));
    key(Qt::Key_Escape);
    key(Qt::Key_Return);
    made.readsSlowly = false;
    done();
    EXPECT_EQ(text(), "");
}

// A hand that clicks and types at once is not too quick for a picture that takes long.
TEST_F(CreatingTest, KeysWaitBehindAClickWhosePictureIsNotThere) {
    open(balls);
    WindowPicture::setPatience(std::chrono::milliseconds(0));
    editor.document().setText(balls + "body b3 ball -init_pos {0 2 0}\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return editor.document().sceneIsCurrent(); }));
    display().creating().start(newJoint(scene::JointType::hinge));
    click({-1, 0, 0});
    QTest::keyClicks(&display(), "-1 2 0");
    key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return text().find("joint hinge1") != std::string::npos; }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    done();
    EXPECT_THAT(text(), HasSubstr("-body1 b1 -offset1 {0 2 0}"));
}

// The first picture frames the scene, and the view stays from then on. The second one, which was to
// frame it, too, is drawn meanwhile: another one comes in its place.
TEST_F(CreatingTest, TheNewestPictureComesThoughTheViewIsToStay) {
    open(balls);
    WindowPicture::setPatience(std::chrono::milliseconds(0));
    SceneDisplay& other = editor.openGraphicalViewer()->display();
    other.resize(400, 300);
    other.bringUpToDate();
    other.keepCamera(); // nothing is seen yet
    QThread::msleep(20);
    other.setTime(0.5, false);
    other.bringUpToDate();
    EXPECT_TRUE(waitFor([&] {
        other.bringUpToDate();
        return other.showsNewest();
    }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    done();
}

// The next command waits its turn, too.
TEST_F(CreatingTest, ACommandWaitsBehindAClickWhosePictureIsNotThere) {
    open(balls);
    WindowPicture::setPatience(std::chrono::milliseconds(0));
    editor.document().setText(balls + "body b3 ball -init_pos {0 2 0}\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return editor.document().sceneIsCurrent(); }));
    display().creating().start(newBody("ball"));
    click({0, -3, 0});
    display().creating().start(newBody("ball"));
    QTest::keyClicks(&display(), "5 5 0");
    key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return text().find("{5 5 0}") != std::string::npos; }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    done();
    EXPECT_EQ(scene().bodies.size(), 5U);
}

TEST_F(CreatingTest, ACommandWaitsForTheSceneAndForNoMotion) {
    open(balls);
    made.blocked = true; // no motion ends
    editor.document().setText(balls + "set a 1\n", "Edit");
    QTest::qWait(200); // read, and shown without its motion
    made.readsSlowly = true;
    editor.document().setText(balls + "set a 2\n", "Edit");
    display().creating().start(newBody("ball"));
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("is being read"));
    made.readsSlowly = false;
    EXPECT_TRUE(QTest::qWaitFor([this] {
        return editor.document().sceneIsCurrent() &&
               !display().creating().prompt().contains("is being read");
    }));
    made.blocked = false;
    done();
}

TEST_F(CreatingTest, TheMenuOfABodyMeansThisBodyWhenItsCommandHasWaited) {
    open(balls);
    display().editing().say({});
    const QPointF place = display().placeOf(1, 0.2, 0);
    made.readsSlowly = true;
    editor.document().setText(balls.substr(0, balls.find("body b1")) +
                                  "body b0 ball -init_pos {0 3 0}\n" +
                                  balls.substr(balls.find("body b1")),
                              "Edit");
    const auto menu = elementMenu(editor.document(), display(),
                                  menuPlaceAt(editor.document(), display(), place), {});
    QAction* gravity = nullptr;
    for (const QMenu* one : menu->findChildren<QMenu*>())
        for (QAction* action : one->actions())
            if (action->text() == "&Gravity")
                gravity = action;
    ASSERT_TRUE(gravity);
    gravity->trigger();
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("is being read"));
    made.readsSlowly = false;
    done();
    EXPECT_THAT(display().creating().prompt().toStdString(), HasSubstr("9.81 downwards"));
    key(Qt::Key_Return);
    done();
    EXPECT_THAT(text(), HasSubstr("force -body b2 -gravitational {0 -9.81 0}"));
}

TEST_F(CreatingTest, AClickBeforeItsSceneIsSeenCountsWhenItIs) {
    open(balls);
    display().lookAlong(Vector(0.3, 0.5, 1));
    display().grab();
    ASSERT_TRUE(display().ground());
    const double grid = display().ground()->height; // which no edit moves
    WindowPicture::setPatience({});
    editor.document().setText("# nothing yet\n", "Edit");
    done();
    display().creating().start(newBody(BasicShape::box));
    click({0.01, 0, 0.02});
    EXPECT_TRUE(waitFor([this] { return !display().creating().active(); }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    done();
    ASSERT_EQ(scene().bodies.size(), 1U);
    EXPECT_NEAR(scene().bodies[0].initialPosition.y(), grid + 0.5, 1e-9); // on the grid
}

TEST_F(CreatingTest, ClicksBeforeTheirSceneIsSeenCountInTheirOrder) {
    open(balls);
    WindowPicture::setPatience({});
    editor.document().setText(balls + "set a 1\n", "Edit");
    done();
    display().creating().start(newSpring(Wanted::body));
    click({-1, 0, 0});
    click({1, 0, 0});
    EXPECT_TRUE(waitFor([this] { return !display().creating().active(); }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    done();
    EXPECT_THAT(text(), HasSubstr("-body1 b1 -body2 b2"));
}

TEST_F(CreatingTest, ArrowsThatWaitedMoveInTheNewView) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b1 ball -init_pos {-100 0 0}\n"
         "body b2 ball -init_pos {100 0 0}\n");
    made.readsSlowly = true;
    editor.document().reset(balls);
    display().creating().start(newBody("ball"));
    key(Qt::Key_Right);
    key(Qt::Key_Return);
    made.readsSlowly = false;
    done();
    ASSERT_TRUE(waitFor([this] { return !display().creating().active(); }));
    done();
    ASSERT_EQ(scene().bodies.size(), 3U);
    const Vector place = scene().bodies.back().initialPosition;
    EXPECT_GT(place.norm(), 0.01);
    EXPECT_LT(place.norm(), 2);
}

// Until the host's session has read a change of a window, a command waits as it does alone.
TEST_F(CreatingTest, UnderAHostACommandWaitsForTheHost) {
    Editor hosted{Workshop{}};
    SceneDocument& document = hosted.document();
    document.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    const auto read = [&document] {
        Computed computed;
        computed.shown.scene =
            std::make_shared<const scene::Scene>(theReader().read(document.text()).scene);
        computed.text = document.text();
        computed.current = true;
        document.setComputed(computed);
    };
    document.setTextFromHost(balls);
    read();
    SceneDisplay& picture = hosted.openGraphicalViewer()->display();
    picture.grab();
    document.setText(balls + "set a 1\n", "Edit");
    EXPECT_TRUE(document.isAwaited());
    picture.creating().start(newBody("ball"));
    EXPECT_THAT(picture.creating().prompt().toStdString(), HasSubstr("is being read"));
    QTest::keyClick(&picture, Qt::Key_Return);
    EXPECT_EQ(document.text(), balls + "set a 1\n");
    read();
    EXPECT_THAT(document.text(), HasSubstr("body b3 ball -init_pos {0 0 0}"));
}

} // namespace
} // namespace views
