// What a picture says of a motion that stops, that is computed, and that was stopped.
#include "panels/motion_notice.h"
#include "panels/time_bar.h"
#include "physics/assembly.h"
#include "surroundings/triad.h"
#include "viewers/graphical_viewer.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QToolButton>

namespace views {
namespace {

using ::testing::HasSubstr;

class MotionNoticeTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    static std::string wordsOf(QWidget& window) {
        return window.findChild<MotionNotice*>()->words().toStdString();
    }
    std::shared_ptr<PictureThread> pictures = std::make_shared<PictureThread>(false);
};

Computed stopping(Work work) {
    Computed computed;
    computed.shown.scene = std::make_shared<scene::Scene>(
        theReader().read(ballScene + "body b2 ball -init_pos {0 3 0}\n").scene);
    auto motion = std::make_shared<render::GivenMotion>(
        2,
        std::vector<render::GivenMotion::Law>(2, [](double) { return simulation::BodyState(); }));
    motion->stopped = simulation::Stop{0.5, "Stopped at t = 0.5: body \"b1\" is stuck.", {}};
    computed.shown.motion = std::move(motion);
    computed.work = work;
    computed.current = true;
    return computed;
}

class MotionNoticeOfSceneTest : public MotionNoticeTest {
protected:
    MotionNoticeOfSceneTest() { viewer.show(); }
    void take(const std::string& text) {
        document.setText(text, "Edit");
        ASSERT_TRUE(settle(document));
    }
    TestWorkshop made;
    SceneDocument document{made.workshop()};
    GraphicalViewer viewer{document, pictures, {}, 1};
};

TEST_F(MotionNoticeTest, ThePictureEndsWhereTheFirstBodyStopsAndSaysWhy) {
    SceneDocument document{Workshop{}};
    GraphicalViewer viewer(document, pictures, {}, 1);
    viewer.resize(900, 640);
    viewer.show();
    double clock = 100;
    viewer.playback().setClock([&] { return clock; });
    document.setComputed(stopping(Work::none));
    EXPECT_EQ(wordsOf(viewer), "");
    viewer.playback().play();
    clock += 1.5;
    viewer.playback().advance();
    EXPECT_EQ(viewer.playback().time(), 0.5);
    EXPECT_FALSE(viewer.playback().isPlaying());
    EXPECT_EQ(wordsOf(viewer), "Stopped at t = 0.5: body \"b1\" is stuck.");
    EXPECT_GT(viewer.times().bar().width() / 2,
              viewer.times().bar().position(0.5)); // its scale is whole
    viewer.playback().seek(2);
    EXPECT_EQ(viewer.playback().time(), 0.5);
    viewer.playback().seek(0.2);
    EXPECT_EQ(wordsOf(viewer), "");
}

// In the motion of these tests a body keeps the velocity that it starts with.
TEST_F(MotionNoticeOfSceneTest, WhatFallsThroughTheGridIsToldAndAClickAddsAFloor) {
    const std::string standing = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                                 "body a s -init_pos {0 0.5 0} -init_dpos {0 -1 0}\n"
                                 "body b s -init_pos {2 0.5 0} -init_dpos {0 -1 0}\n"
                                 "force -body a -gravitational {0 -9.81 0}\n";
    take(standing);
    EXPECT_EQ(wordsOf(viewer), "The grid holds nothing: a falls through it.");
    take(standing + "force -body b -gravitational {0 -9.81 0}\n");
    EXPECT_EQ(wordsOf(viewer), "The grid holds nothing: a and 1 more fall through it.");
    auto* add = viewer.findChild<QToolButton*>("addFloor");
    ASSERT_TRUE(add && add->isVisible());
    add->click();
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("-plane"));
    EXPECT_EQ(wordsOf(viewer), "");
}

// A ball that one has just made hangs in the air.
TEST_F(MotionNoticeOfSceneTest, WhereNothingMovesAClickAddsGravityAndShowsTheFallFromItsStart) {
    const std::string hanging = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                                "body a s -init_pos {0 3 0}\nbody b s -fixed 1\n";
    take("shape_set s -desc {-sub {-sphere 0.5}}\nbody a s -init_pos {0 3 0}\n"
         "body c s -init_pos {4 3 0} -init_dpos {-1 0 0}\n");
    EXPECT_EQ(wordsOf(viewer), ""); // in space
    take(hanging + "body c s -init_pos {4 3 0} -init_dpos {-1 0 0}\n");
    EXPECT_EQ(wordsOf(viewer), "Bodies move straight on: no force acts.");
    EXPECT_TRUE(viewer.findChild<QToolButton*>("addGravity")->isVisible());
    take(hanging + "body c s -init_pos {4 3 0}\n");
    EXPECT_EQ(wordsOf(viewer), "Nothing moves: no force acts.");
    viewer.playback().seek(1);
    auto* add = viewer.findChild<QToolButton*>("addGravity");
    ASSERT_TRUE(add && add->isVisible());
    EXPECT_FALSE(viewer.findChild<QToolButton*>("addFloor")->isVisible());
    add->click();
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("force -body a -gravitational {0 -9.81 0}\n"
                                           "force -body c -gravitational {0 -9.81 0}\n"));
    EXPECT_EQ(viewer.playback().time(), 0);
    EXPECT_EQ(wordsOf(viewer), "");
}

// The text has another start then, which one may not have meant.
TEST_F(MotionNoticeOfSceneTest, AThrowSaysThatTheMotionBeginsThereAndUndoesIt) {
    const std::string before = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                               "body a s -init_dpos {1 0 0}\n";
    take(before);
    document.setText("simulator -start 0.5 -finish 2\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                     "body a s -init_dpos {0 1 0}\n",
                     "Throw a at 0.5 s");
    EXPECT_EQ(wordsOf(viewer), "");
    Q_EMIT viewer.display().throwing().letGo(true);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(wordsOf(viewer), "The motion begins at 0.5 s now, where you let go.");
    auto* undo = viewer.findChild<QToolButton*>("undoNewStart");
    ASSERT_TRUE(undo && undo->isVisible());
    undo->click();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), before);
    EXPECT_EQ(wordsOf(viewer), "");
    EXPECT_FALSE(undo->isVisible());
}

TEST_F(MotionNoticeOfSceneTest, ATagOfABodyBelowThePictureStandsAboveTheWords) {
    take("shape_set s -desc {-sub {-sphere 0.5}}\nbody a s\nbody b s -init_pos {0.4 -60 0}\n");
    render::Camera camera = viewer.display().camera();
    camera.center = {0, 0, 0};
    camera.scale = 0.5;
    viewer.display().setCamera(camera);
    viewer.display().grab();
    document.select({{editing::Kind::body, 1}});
    const auto* notice = viewer.findChild<MotionNotice*>();
    ASSERT_TRUE(notice && notice->isVisible());
    const auto tag = viewer.display().selecting().tag();
    ASSERT_TRUE(tag.has_value());
    EXPECT_FALSE(tag->box.intersects(notice->geometry()));
    EXPECT_GT(tag->box.top(), viewer.display().height() / 2.0);
}

// Before any floor: the sentence of the fault names a button, and here it is.
TEST_F(MotionNoticeOfSceneTest, WhereBodiesOverlapAClickMovesThemApart) {
    const std::string overlapping = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                                    "body a s -init_pos {0 0.5 0}\nbody b s -init_pos {0.8 0.5 0}\n"
                                    "force -body a -gravitational {0 -9.81 0}\n";
    take(overlapping);
    auto* part = viewer.findChild<QAbstractButton*>("moveApart");
    ASSERT_NE(part, nullptr);
    EXPECT_FALSE(part->isVisible());
    Computed computed{document.shown(), document.text(), {}, {}, Work::none, true};
    scene::Diagnostic fault; // as the engine says it
    fault.severity = scene::Severity::warning;
    fault.message = "Bodies overlap; " + physics::partAdvice();
    computed.diagnostics = {fault};
    document.setComputed(computed);
    EXPECT_EQ(wordsOf(viewer), "Bodies overlap at the start.");
    Q_EMIT viewer.display().throwing().letGo(true); // a fault comes before the new start
    EXPECT_EQ(wordsOf(viewer), "Bodies overlap at the start.");
    EXPECT_TRUE(part->isVisible());
    EXPECT_EQ(part->text(), "Move Apart");
    EXPECT_FALSE(viewer.findChild<QToolButton*>("addFloor")->isVisible());
    part->click();
    ASSERT_TRUE(waitFor([&] { return document.text() != overlapping; }));
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(part->isVisible());
    EXPECT_EQ(document.undoLabel(), "Move Bodies Apart");
}

TEST_F(MotionNoticeTest, WordsLeaveTheTriadInSight) {
    SceneDocument document{Workshop{}};
    GraphicalViewer viewer(document, pictures, {}, 1);
    QWidget picture;
    const MotionNotice notice(document, viewer.playback(), picture);
    picture.show();
    document.setComputed(stopping(Work::none));
    viewer.playback().seek(0.5);
    for (const QSize size : {QSize(900, 640), QSize(240, 500), QSize(1500, 1000)}) {
        picture.resize(size);
        QCoreApplication::processEvents();
        ASSERT_FALSE(notice.isHidden());
        ASSERT_EQ(picture.size(), size);
        EXPECT_TRUE(picture.rect().contains(notice.geometry())) << size.width();
        const double scale = picture.devicePixelRatioF();
        const QSizeF device = QSizeF(size) * scale;
        for (const render::TriadEnd& end :
             render::triadOf(viewer.display().camera(),
                             {static_cast<int>(device.width()), static_cast<int>(device.height())}))
            EXPECT_FALSE(notice.geometry().contains(
                QPointF(end.place.x() / scale, end.place.y() / scale).toPoint()))
                << size.width();
    }
}

// Once it is computed the motion may go on beyond that.
TEST_F(MotionNoticeTest, WhileItIsComputedPlayingWaitsAtAStop) {
    SceneDocument document{Workshop{}};
    GraphicalViewer viewer(document, pictures, {}, 1);
    double clock = 100;
    viewer.playback().setClock([&] { return clock; });
    document.setComputed(stopping(Work::simulating));
    viewer.playback().play();
    clock += 1.5;
    viewer.playback().advance();
    EXPECT_EQ(viewer.playback().time(), 0.5);
    EXPECT_TRUE(viewer.playback().isPlaying());
    document.setComputed(stopping(Work::none));
    EXPECT_FALSE(viewer.playback().isPlaying());
}

// All of it is there while another run still tells how exact it is.
TEST_F(MotionNoticeTest, WhatIsComputedToTheEndIsBeingChecked) {
    SceneDocument document{Workshop{}};
    GraphicalViewer viewer(document, pictures, {}, 1);
    viewer.show();
    Computed computed = stopping(Work::simulating);
    computed.shown.motion = std::make_shared<render::GivenMotion>(
        2,
        std::vector<render::GivenMotion::Law>(2, [](double) { return simulation::BodyState(); }));
    document.setComputed(computed);
    ASSERT_TRUE(waitFor([&] { return !wordsOf(viewer).empty(); }));
    EXPECT_THAT(wordsOf(viewer), HasSubstr("Checking how exact the motion is"));
    EXPECT_THAT(wordsOf(viewer), testing::Not(HasSubstr("Computing")));
}

// The second beside the time is no span that is computed.
TEST_F(MotionNoticeTest, TheTimeBarIsFilledOnlyAsFarAsItIsComputed) {
    TimeBar bar;
    bar.resize(500, bar.sizeHint().height());
    bar.setRange(0, 10, 0);
    bar.setTime(0);
    const auto colorAt = [&](double time) {
        return bar.grab().toImage().pixelColor(static_cast<int>(bar.position(time)), 14);
    };
    EXPECT_EQ(colorAt(0.5), colorAt(5));
    bar.setRange(0, 10, 3);
    EXPECT_NE(colorAt(2), colorAt(5));
}

TEST_F(MotionNoticeOfSceneTest, ComputingIsSaidStoppedAndBegunAgain) {
    made.blocked = true;
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(waitFor([&] { return !wordsOf(viewer).empty(); }));
    EXPECT_THAT(wordsOf(viewer), HasSubstr("Computing the motion, "));
    viewer.findChild<QToolButton*>("stop")->click(); // of playing ends computing, too
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(wordsOf(viewer), HasSubstr("Computing was stopped"));
    made.blocked = false;
    viewer.findChild<QToolButton*>("play")->click();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.simulations, 2);
    EXPECT_TRUE(viewer.playback().isPlaying());
    EXPECT_EQ(wordsOf(viewer), "");
}

// The motion of the scene before is shown until one asks.
TEST_F(MotionNoticeOfSceneTest, PlayComputesWhatWaitsToBeAsked) {
    take(ballScene);
    document.setLive(Live::never);
    take("# other\n" + ballScene);
    ASSERT_TRUE(waitFor([&] { return !wordsOf(viewer).empty(); }));
    EXPECT_THAT(wordsOf(viewer), HasSubstr("Stale motion"));
    viewer.findChild<QToolButton*>("play")->click();
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.motionIsStale());
    EXPECT_TRUE(viewer.playback().isPlaying());
}

// A scene that cannot be read is no empty one.
TEST_F(MotionNoticeTest, ATextThatCannotBeReadIsSaidInThePicture) {
    SceneDocument document{Workshop{}};
    GraphicalViewer viewer(document, pictures, {}, 1);
    viewer.show();
    Computed unread;
    unread.shown.scene = std::make_shared<scene::Scene>();
    scene::Diagnostic fault;
    fault.line = 12;
    fault.message = "body \"b\": no option -foo";
    unread.diagnostics = {fault};
    document.setComputed(unread);
    EXPECT_EQ(wordsOf(viewer), "Line 12 of the text: body \"b\": no option -foo");
    Computed good = stopping(Work::none);
    good.shown.motion = nullptr;
    document.setComputed(good);
    EXPECT_EQ(wordsOf(viewer), "");
    good.current = false;
    good.diagnostics = {fault};
    document.setComputed(good);
    EXPECT_THAT(wordsOf(viewer), HasSubstr("shows the last good scene"));
    EXPECT_THAT(wordsOf(viewer), HasSubstr("(Ctrl+Z)")); // what one can do
}

} // namespace
} // namespace views
