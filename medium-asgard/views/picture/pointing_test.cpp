// What pointing says, at the window's foot and in the picture.
#include "frame/hint_line.h"
#include "gestures/picking.h"
#include "handles/handle_layout.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <QLabel>

#include <gmock/gmock.h>

namespace views {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string thrown = "simulator -finish 2\n"
                           "shape_set s -desc {-sub {-sphere 0.5}}\n"
                           "body ball s -init_pos {-1 0 0} -init_dpos {3 0 0}\n";

class PointingTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(thrown, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        display().lookAlong(Vector::UnitZ());
        viewer->findChild<StatusPanel*>()->show(&render::Display::velocityHandles);
        display().grab();
        for (const render::Handle& handle : display().handles().handles)
            if (handle.kind == render::HandleKind::velocity)
                head = display().fromPixels(display().sight().pixels(handle.place)).toPoint();
        empty = QPoint(8, display().height() - 8);
    }
    SceneDisplay& display() { return viewer->display(); }
    std::string hint() {
        QCoreApplication::processEvents();
        for (const QLabel* label : viewer->findChildren<QLabel*>())
            if (label->accessibleName() == "What the buttons do here")
                return label->text().toStdString();
        return "no such line";
    }
    void pointAt(QPoint place) {
        QMouseEvent move(QEvent::MouseMove, place, display().mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&display(), &move);
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
    QPoint head, empty;
};

const std::string laden = thrown + [] {
    std::string forces;
    for (int i = 0; i < 6; ++i)
        forces += "force -body ball -x 0 -y 5 -z 0\n";
    return forces;
}();

// Six forces act at one point of the ball: all have their foot there.
TEST_F(PointingTest, HandlesThatAreFoldedComeOutUnderThePointer) {
    editor.document().setText(laden, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->findChild<StatusPanel*>()->show(&render::Display::forceHandles);
    viewer->findChild<StatusPanel*>()->show(&render::Display::positionHandles);
    viewer->findChild<StatusPanel*>()->show(&render::Display::spinHandles);
    const auto folded = [&] {
        display().grab();
        return std::ranges::count(display().handles().handles, true, &render::Handle::folded);
    };
    const auto before = folded();
    ASSERT_GT(before, 0);
    ASSERT_FALSE(display().handles().crowds.empty());
    const render::Crowd crowd = display().handles().crowds.front();
    const QPoint middle = display().fromPixels(crowd.middle).toPoint();
    pointAt(middle);
    EXPECT_TRUE(waitFor([&] { return folded() == 0; }));
    // Each of them is taken now.
    for (const render::Handle& handle : display().handles().handles) {
        const auto found = gestures::handleAt(
            display().handles(), display().sight(),
            render::standOf(handle, display().sight().camera, display().sight().size), 14);
        ASSERT_TRUE(found);
        EXPECT_EQ(display().handles().handles[*found].name(), handle.name());
    }
    pointAt(empty);
    EXPECT_TRUE(waitFor([&] { return folded() == before; }));
}

TEST_F(PointingTest, AHandleSaysWhatMovesIt) {
    pointAt(head);
    EXPECT_THAT(hint(), HasSubstr("Shift-drag changes the velocity of ball"));
    EXPECT_THAT(display().pointing().words().toStdString(), HasSubstr("ball: velocity 3.0"));
    EXPECT_EQ(display().cursor().shape(), Qt::PointingHandCursor);
    display().pointing().setKeys(Qt::ShiftModifier);
    EXPECT_EQ(display().cursor().shape(), Qt::SizeAllCursor);
    pointAt(empty);
    EXPECT_THAT(hint(), HasSubstr("Drag turns the view"));
    EXPECT_EQ(display().pointing().words(), "");
    EXPECT_EQ(display().cursor().shape(), Qt::ArrowCursor);
}

TEST_F(PointingTest, ItLightsUp) {
    pointAt(empty);
    const QImage before = display().grab().toImage();
    pointAt(head);
    EXPECT_NE(display().grab().toImage().copy(QRect(head - QPoint(15, 15), QSize(30, 30))),
              before.copy(QRect(head - QPoint(15, 15), QSize(30, 30))));
}

TEST_F(PointingTest, ABodySaysWhatMovesIt) {
    pointAt(display().fromPixels(display().sight().pixels({-1, 0.3, 0})).toPoint());
    EXPECT_TRUE(waitFor([&] { return hint().find("Click selects ball") != std::string::npos; }))
        << hint();
}

TEST_F(PointingTest, AnUnshiftedDragThatBeganOnAHandleSaysWhatWouldMoveIt) {
    pointAt(head);
    QTest::mousePress(&display(), Qt::LeftButton, {}, head);
    QMouseEvent move(QEvent::MouseMove, head + QPoint(20, 5),
                     display().mapToGlobal(head + QPoint(20, 5)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&display(), &move);
    QTest::mouseRelease(&display(), Qt::LeftButton, {}, head + QPoint(20, 5));
    EXPECT_EQ(display().editing().said().toStdString(),
              "This moves the view. Shift-drag changes the velocity of ball.");
    EXPECT_EQ(editor.document().text(), thrown);
    QTest::mouseClick(&display(), Qt::LeftButton, {}, empty);
    EXPECT_EQ(display().editing().said(), "");
}

TEST_F(PointingTest, OfTheLineWholePartsAreSeenAndTheTipHasAll) {
    HintLine line;
    const QString first = "Drag moves it", second = "right button: menu";
    line.say(first + "  ·  " + second);
    const auto resize = [&](int width) {
        line.resize(width, line.heightForWidth(width));
        QCoreApplication::processEvents();
    };
    const QFontMetrics metrics = line.fontMetrics();
    resize(metrics.horizontalAdvance(line.text()) + 2);
    line.show();
    EXPECT_EQ(line.text(), first + "  ·  " + second);
    EXPECT_EQ(line.toolTip(), "");
    // Three lines have room for the first part, and not for all.
    const QString longer = "One two three four five six seven eight nine ten";
    line.say(longer + "  ·  " + second);
    resize(metrics.horizontalAdvance(longer) / 2 - 2);
    EXPECT_EQ(line.text(), longer + "  ·  …");
    EXPECT_THAT(line.toolTip().toStdString(), HasSubstr("right button: menu"));
    resize(metrics.horizontalAdvance(longer) / 5);
    EXPECT_THAT(line.text().toStdString(), testing::EndsWith("…"));
    EXPECT_TRUE(longer.startsWith(line.text().chopped(1)));
}

// A window on a screen of 750 points.
TEST_F(PointingTest, OfANarrowWindowTheWholeLineIsReadAndThePictureKeepsItsHeight) {
    viewer->resize(750, 480);
    viewer->showUsualPanes();
    display().grab();
    auto* line = viewer->findChild<HintLine*>();
    line->say(display().pointing().hint());
    EXPECT_THAT(hint(), HasSubstr("Drag turns the view"));
    ASSERT_LT(line->width(), line->fontMetrics().horizontalAdvance(line->text()));
    EXPECT_THAT(hint(), testing::EndsWith("right button: menu"));
    const QSize before = display().size();
    for (const QString words : {"Click selects it", "Click  ·  one  ·  two  ·  three  ·  "})
        for (const int times : {1, 20}) {
            line->say(words.repeated(times));
            QCoreApplication::processEvents();
            EXPECT_EQ(display().size(), before);
        }
}

TEST_F(PointingTest, WhileTheMotionPlaysTheLineSaysWhatADragThrows) {
    std::string slow = thrown;
    slow.replace(slow.find("{3 0 0}"), 7, "{0.1 0 0}");
    editor.document().setText(slow, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    display().editing().say("about this text", false);
    viewer->playback().setClock([now = 0.0]() mutable { return now += 1e-3; });
    viewer->playback().play();
    ASSERT_TRUE(waitFor([&] { return display().time() > 0.05; }));
    EXPECT_TRUE(waitFor([&] {
        const render::Drawing drawing = display().drawing();
        const Vector place = drawing.motion->at(0, drawing.time).position + Vector(0, 0.3, 0);
        pointAt(display().fromPixels(display().sight().pixels(place)).toPoint());
        for (int i = 0; i < 30; ++i) { // the pointer rests, the time goes on
            QCoreApplication::processEvents();
            QThread::msleep(5);
        }
        return hint().find("Drag throws ball") != std::string::npos;
    })) << hint();
    viewer->playback().stop();
    editor.document().setText(editor.document().text() + "\n", "Edit");
    EXPECT_EQ(display().editing().said(), ""); // it was about the text before
}

// Hint, cursor and drag ask one question.
TEST_F(PointingTest, AtTheEndOfTheMotionNoDragIsPromised) {
    viewer->playback().setClock([] { return 0.0; });
    viewer->playback().seek(1.9999);
    viewer->playback().play();
    display().throwing().setPlays(true);
    display().frameNow();
    display().grab();
    const QPoint middle = display().placeOf(5, 0.2, 0).toPoint();
    ASSERT_TRUE(display().rect().contains(middle));
    const auto isNamed = [&] { return hint().find("ball") != std::string::npos; };
    pointAt(middle);
    EXPECT_TRUE(waitFor(isNamed));
    EXPECT_THAT(hint(), Not(HasSubstr("Drag throws")));
    EXPECT_EQ(display().cursor().shape(), Qt::ArrowCursor);
    EXPECT_FALSE(display().selecting().draggedBodyAt(middle).has_value());
    viewer->playback().pause();
    editor.document().select({{editing::Kind::body, 0}});
    pointAt(middle);
    EXPECT_TRUE(waitFor([&] { return hint().find("Nothing of the motion") != std::string::npos; }))
        << hint();
    EXPECT_NE(display().cursor().shape(), Qt::SizeAllCursor);
}

TEST_F(PointingTest, OfABodyThatAJointLetsGoNowhereNoDragIsPromised) {
    editor.document().setText("simulator -finish 4\nshape_set s -desc {-sub {-box {1 1 1}}}\n"
                              "body b1 s -init_pos {-2 1 0}\n"
                              "body b2 s -init_pos {2 1 0} -init_dpos {0 1 0}\n"
                              "joint j -type fixed -body1 b1\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->playback().seek(0.24);
    display().frameNow();
    display().grab();
    const std::string before = editor.document().text();
    for (const std::size_t body : {0U, 1U}) {
        editor.document().select({{editing::Kind::body, body}});
        const double x = body == 0 ? -2 : 2;
        const QPoint place = display().placeOf(x + 0.3, body == 0 ? 1.2 : 1.44, 0).toPoint();
        pointAt(place);
        const std::string wanted = body == 0 ? "\"b1\" is held by joint \"j\"" : "Drag puts b2";
        EXPECT_TRUE(waitFor([&] { return hint().find(wanted) == 0; })) << hint();
        EXPECT_EQ(display().cursor().shape() == Qt::SizeAllCursor, body == 1);
    }
    EXPECT_EQ(editor.document().text(), before);
}

TEST_F(PointingTest, OfAnEndlessFloorNoDragIsPromised) {
    editor.document().setText(
        "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_FALSE(editor.document().hasErrors());
    display().lookAlong(Vector(0, 0.6, 1));
    display().grab();
    const QPoint middle = QRect(QPoint(), display().size()).center() + QPoint(3, 60);
    for (const bool isSelected : {false, true}) {
        if (isSelected)
            editor.document().select({{editing::Kind::body, 0}});
        pointAt(middle);
        EXPECT_TRUE(waitFor([&] { return hint().find("Click selects floor") == 0; })) << hint();
        EXPECT_THAT(hint(), Not(HasSubstr("moves it")));
        EXPECT_THAT(hint(), Not(HasSubstr("turns it")));
        const std::string before = editor.document().text();
        QTest::mousePress(&display(), Qt::LeftButton, {}, middle);
        QMouseEvent move(QEvent::MouseMove, middle + QPoint(40, 0),
                         display().mapToGlobal(middle + QPoint(40, 0)), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&display(), &move);
        QTest::mouseRelease(&display(), Qt::LeftButton, {}, middle + QPoint(40, 0));
        EXPECT_EQ(editor.document().text(), before);
    }
}

TEST_F(PointingTest, WhatIsNoLongerThereIsNotNamed) {
    pointAt(head);
    render::Camera camera = display().camera();
    camera.position += Vector(0.5, 0, 0);
    display().setCamera(camera);
    EXPECT_TRUE(waitFor([&] { return display().pointing().words().isEmpty(); }));
}

TEST_F(PointingTest, AnEmptySceneSaysHowToBegin) {
    editor.document().setText("", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(hint(), HasSubstr("the menu Create"));
}

} // namespace
} // namespace views
