#include "language/scene_editor.h"
#include "language/scintilla.h"
#include "surroundings/triad.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

namespace views {
namespace {

class ViewersTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }

    // Pixels of the picture that are not background, on a bare page.
    static int drawn(GraphicalViewer& viewer) {
        render::Display page = viewer.display().display();
        page.studio = page.triad = false;
        viewer.display().setDisplay(page);
        const QImage image = viewer.display().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += (image.pixel(x, y) & 0xFFFFFF) != 0xFFFFFF ? 1 : 0;
        return count;
    }
    static QPushButton* button(QWidget& window, const QString& text) {
        for (auto* b : window.findChildren<QPushButton*>())
            if (b->text().remove('&') == text)
                return b;
        return nullptr;
    }
    static void type(LanguageViewer& viewer, const std::string& text) {
        viewer.editor().setText(QString::fromStdString(text));
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

// --- graphical viewers ----------------------------------------------------------------------

TEST_F(ViewersTest, AGraphicalViewerShowsTheSceneAndItsLength) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    EXPECT_EQ(viewer->playback().finish(), 2);
    EXPECT_GT(drawn(*viewer), 300);
    EXPECT_TRUE(viewer->windowTitle().contains("Graphical Viewer"));
}

TEST_F(ViewersTest, ViewersHaveTimesAndViewpointsOfTheirOwn) {
    GraphicalViewer* one = editor.openGraphicalViewer();
    GraphicalViewer* two = editor.openGraphicalViewer();
    one->playback().seek(1.5);
    EXPECT_EQ(two->playback().time(), 0);
    EXPECT_EQ(one->display().time(), 1.5);
    render::Camera camera = one->display().camera();
    camera.scale *= 3;
    one->display().setCamera(camera);
    two->display().grab();
    EXPECT_NE(two->display().camera().scale, camera.scale);
    // A new one begins where the last one is.
    two->playback().seek(0.5);
    EXPECT_EQ(editor.openGraphicalViewer()->playback().time(), 0.5);
}

TEST_F(ViewersTest, PlayingAdvancesTimeAndMovesThePicture) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    const QImage before = viewer->display().grab().toImage();
    double now = 0;
    viewer->playback().setClock([&] { return now; });
    viewer->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
    viewer->display().setFocus();
    QTest::keyClick(&viewer->display(), Qt::Key_Space);
    EXPECT_TRUE(viewer->playback().isPlaying());
    now = 1;
    ASSERT_TRUE(waitFor([&] { return viewer->playback().time() == 1; }));
    EXPECT_NE(viewer->display().grab().toImage(), before);
    QTest::keyClick(&viewer->display(), Qt::Key_Space);
    EXPECT_FALSE(viewer->playback().isPlaying());
    QTest::keyClick(&viewer->display(), Qt::Key_Home);
    EXPECT_EQ(viewer->playback().time(), 0);
    QTest::keyClick(&viewer->display(), Qt::Key_End);
    EXPECT_EQ(viewer->playback().time(), 2);
    // On a check box the space bar is the box's own.
    const auto boxes = viewer->findChildren<QCheckBox*>();
    auto* box = *std::ranges::find_if(
        boxes, [](const QCheckBox* one) { return one->isVisible() && one->isEnabled(); });
    const bool checked = box->isChecked();
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    EXPECT_NE(box->isChecked(), checked);
    EXPECT_FALSE(viewer->playback().isPlaying());
}

TEST_F(ViewersTest, TheTimeBarsLeftEdgeIsNow) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    TimeBar& bar = viewer->timeBar();
    const double begin = bar.position(0), end = bar.position(2);
    EXPECT_GT(end - begin, 200);
    viewer->playback().seek(0.5);
    // The slider, one second long, is taken in its middle and carried on by half a second.
    const double middle = bar.position(1), y = 11;
    QTest::mousePress(&bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(middle), static_cast<int>(y)));
    EXPECT_NEAR(viewer->playback().time(), 0.5, 0.02);
    QTest::mouseMove(&bar, QPoint(static_cast<int>(bar.position(1.5)), static_cast<int>(y)));
    ASSERT_TRUE(waitFor([&] { return std::abs(viewer->playback().time() - 1) < 0.02; }));
    QTest::mouseRelease(&bar, Qt::LeftButton, {},
                        QPoint(static_cast<int>(bar.position(1.5)), static_cast<int>(y)));
    // Elsewhere in the trough: its left edge comes there.
    QTest::mouseClick(&bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(bar.position(0.25)), static_cast<int>(y)));
    EXPECT_NEAR(viewer->playback().time(), 0.25, 0.02);
}

TEST_F(ViewersTest, DraggingTurnsTheViewAndFrameAllKeepsTheDirection) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const render::Camera framed = viewer->display().camera();
    QTest::mousePress(&viewer->display(), Qt::LeftButton, {}, QPoint(200, 200));
    QTest::mouseMove(&viewer->display(), QPoint(260, 220));
    ASSERT_TRUE(
        waitFor([&] { return !viewer->display().camera().rotation.isApprox(framed.rotation); }));
    QTest::mouseRelease(&viewer->display(), Qt::LeftButton, {}, QPoint(260, 220));
    const render::Camera turned = viewer->display().camera();
    // An update of the scene leaves the user's viewpoint alone.
    editor.document().setText(ballScene + "# more\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    render::Camera nearer = turned;
    nearer.scale *= 7;
    viewer->display().setCamera(nearer);
    viewer->display().frameAll();
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    EXPECT_LT(viewer->display().camera().scale, 2 * framed.scale);
    // Another motion is framed from there, too; another scene from its best side.
    editor.document().recompute();
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    editor.document().reset(ballScene);
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(framed.rotation));
}

// Its window may have another size by then, or was told of before its first picture.
TEST_F(ViewersTest, AViewerThatOpensAgainFramesTheSceneUnlessSomebodyMovedItsView) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const std::string framing = editor.windowsState();
    render::Camera camera = viewer->display().camera();
    camera.scale *= 3;
    viewer->display().setCamera(camera);
    const std::string moved = editor.windowsState();
    const auto again = [&](const std::string& state) {
        editor.restoreWindows(state, {});
        return editor.graphicalViewers().back();
    };
    EXPECT_TRUE(again(framing)->display().framesItself());
    EXPECT_FALSE(again(moved)->display().framesItself());
    EXPECT_EQ(again(moved)->display().camera().scale, camera.scale);
}

TEST_F(ViewersTest, AFaultStandsAtItsTimeOnTheBar) {
    TimeBar bar;
    bar.resize(400, 40);
    bar.setRange(0, 10, 10);
    const QImage before = bar.grab().toImage();
    bar.setFaults({{4, true, "It stops."}, {4.01, false, "It slips."}});
    EXPECT_EQ(bar.faultsAt(bar.position(4)), "It stops.\nIt slips.");
    EXPECT_EQ(bar.faultsAt(bar.position(7)), "");
    EXPECT_NE(bar.grab().toImage(), before);
}

TEST_F(ViewersTest, AViewerThatOpensAgainIsAsOrthographicAndHidesTheSame) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().setOrthographic(true);
    viewer->display().setHidden({"b"});
    editor.restoreWindows(editor.windowsState(), {});
    SceneDisplay& again = editor.graphicalViewers().back()->display();
    EXPECT_TRUE(again.camera().orthographic);
    EXPECT_EQ(again.hidden(), std::set<std::string>{"b"});
}

TEST_F(ViewersTest, AClickOnTheTriadLooksAlongItsAxis) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.lookAlong({0.4, 0.3, 1});
    display.grab();
    const render::Size size{display.width(), display.height()};
    for (const render::TriadEnd& end : render::triadOf(display.camera(), size))
        if (end.axis == 0 && !end.against) {
            const QPointF place(end.place.x(), end.place.y());
            EXPECT_EQ(display.triadEndAt(place), "x");
            QTest::mouseClick(&display, Qt::LeftButton, Qt::NoModifier, place.toPoint());
        }
    const geometry::Vector toward =
        display.camera().rotation.conjugate() * geometry::Vector::UnitZ();
    EXPECT_LT((toward - geometry::Vector::UnitX()).norm(), 1e-9);
    EXPECT_TRUE(display.triadEndAt({300, 200}).isEmpty());
}

TEST_F(ViewersTest, FramesWhatIsThereNowFromTheSameDirection) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    display.setOrthographic(true);
    EXPECT_TRUE(display.framesItself()); // anew, in the other projection
    display.grab();
    EXPECT_TRUE(display.camera().orthographic);
    const render::Camera motion = display.camera();
    display.frameNow();
    EXPECT_TRUE(display.camera().rotation.isApprox(motion.rotation));
    EXPECT_TRUE(display.camera().orthographic);
    EXPECT_GT(display.camera().scale, motion.scale); // the ball alone, not its flight
    const geometry::Vector ball = editor.document().shown().scene->bodies[0].initialPosition;
    EXPECT_LT((display.camera().center - ball).norm(), 0.2);
    const double one = display.camera().scale;
    display.frameMotion();
    EXPECT_LT(display.camera().scale, one);
    editor.document().select({{editing::Kind::body, 0}});
    display.frameSelected();
    EXPECT_NEAR(display.camera().scale, one, 1e-9);
}

TEST_F(ViewersTest, ShiftedButtonsDoNotMoveTheView) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const render::Camera before = viewer->display().camera();
    QTest::mousePress(&viewer->display(), Qt::LeftButton, Qt::ShiftModifier, QPoint(200, 200));
    QTest::mouseMove(&viewer->display(), QPoint(260, 220));
    QTest::mouseRelease(&viewer->display(), Qt::LeftButton, Qt::ShiftModifier, QPoint(260, 220));
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(before.rotation));
}

TEST_F(ViewersTest, TheCentreOfRotationGoesToTheNearestVertexOrToMidDepth) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    const render::Size size{display.width(), display.height()};
    const Eigen::Vector2d ball = render::toPixels(display.camera(), size, {-1, 0, 0});
    display.centerAt(QPointF(ball.x() + 3, ball.y() - 2));
    EXPECT_LT((display.camera().center - geometry::Vector(-1, 0, 0)).norm(), 1e-9);
    // The picture itself stays.
    EXPECT_LT((render::toPixels(display.camera(), size, {-1, 0, 0}) - ball).norm(), 1e-6);
    display.centerAt(QPointF(ball.x() + 90, ball.y() - 60));
    EXPECT_NEAR(display.camera().center.z(), 0, 1e-6);
    EXPECT_GT((display.camera().center - geometry::Vector(-1, 0, 0)).norm(), 0.1);
}

TEST_F(ViewersTest, LookingAlongAnAxisMakesThePictureThatPlane) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    for (const geometry::Vector& axis :
         {geometry::Vector(1, 0, 0), geometry::Vector(0, 1, 0), geometry::Vector(0, 0, -1)}) {
        viewer->display().lookAlong(axis);
        const geometry::Vector seen = viewer->display().camera().rotation * axis;
        EXPECT_LT((seen - geometry::Vector(0, 0, 1)).norm(), 1e-9);
    }
}

TEST_F(ViewersTest, SwitchesOfThePanelAndTheMenuAreTheSame) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    QCheckBox* wireframe = nullptr;
    for (auto* box : viewer->findChildren<QCheckBox*>())
        if (box->text().contains("ireframe"))
            wireframe = box;
    ASSERT_NE(wireframe, nullptr);
    const int solid = drawn(*viewer);
    wireframe->click();
    EXPECT_TRUE(viewer->display().display().wireframe);
    EXPECT_LT(drawn(*viewer), solid);
}

TEST_F(ViewersTest, ASceneWithViewsOpensInItsFirst) {
    editor.document().setText(ballScene + "view top -rot {1.5708 0 0}\nview side -scale 0.2\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    EXPECT_EQ(viewer->display().followedView(), "top");
    viewer->display().grab();
    const geometry::Vector up = viewer->display().camera().rotation * geometry::Vector::UnitY();
    EXPECT_NEAR(up.z(), 1, 1e-3);
    viewer->display().followView("side");
    viewer->display().grab();
    EXPECT_NEAR(viewer->display().camera().scale, 0.2, 1e-12);
}

// --- language viewers -----------------------------------------------------------------------

TEST_F(ViewersTest, UpdateBringsAllViewsUpToDate) {
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    GraphicalViewer* picture = editor.openGraphicalViewer();
    type(*one, "simulator -finish 5\n" + ballScene.substr(20));
    EXPECT_TRUE(one->hasDraft());
    EXPECT_TRUE(one->isWindowModified());
    EXPECT_EQ(two->draft(), ballScene);
    button(*one, "Update")->click();
    EXPECT_FALSE(one->hasDraft());
    EXPECT_EQ(two->draft(), one->draft());
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(picture->playback().finish(), 5);
}

TEST_F(ViewersTest, ADraftIsKeptWhenAnotherViewUpdates) {
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    const std::string mine = ballScene + "# mine\n";
    type(*two, mine);
    type(*one, ballScene + "# theirs\n");
    one->updateDocument();
    EXPECT_EQ(two->draft(), mine);
    EXPECT_TRUE(two->hasDraft());
    button(*two, "Keep Mine")->click();
    two->updateDocument();
    EXPECT_EQ(one->draft(), mine);
    type(*one, "# dropped\n");
    one->dropDraft();
    EXPECT_EQ(one->draft(), mine);
    editor.document().undo();
    EXPECT_EQ(one->draft(), ballScene + "# theirs\n");
    EXPECT_EQ(two->draft(), ballScene + "# theirs\n");
}

TEST_F(ViewersTest, FaultsAreMarkedAtTheirWordsAndListed) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const std::string text = ballScene + "body b2 bal -init_pos {0 0 0}\n";
    type(*viewer, text);
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_EQ(viewer->messages().count(), 1);
    EXPECT_TRUE(viewer->messages().item(0)->text().startsWith("Line 4: "));
    EXPECT_TRUE(viewer->messages().isVisible());
    const auto marked = [&](std::size_t at) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 8UL,
                                              static_cast<long>(at)) != 0;
    };
    const std::size_t word = text.find("bal -init");
    EXPECT_TRUE(marked(word));
    EXPECT_FALSE(marked(word - 2));
    EXPECT_TRUE(viewer->editor().annotation(3).contains("ball"));
    // A click leads there.
    Q_EMIT viewer->messages().itemActivated(viewer->messages().item(0));
    EXPECT_EQ(viewer->editor().selectedText(), "bal");
    // Repaired, all is gone.
    type(*viewer, ballScene);
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(viewer->messages().count(), 0);
    EXPECT_TRUE(viewer->editor().annotation(3).isEmpty());
}

TEST_F(ViewersTest, FaultyTextsOfAllKindsLeaveTheWindowsAlive) {
    GraphicalViewer* picture = editor.openGraphicalViewer();
    LanguageViewer* viewer = editor.openLanguageViewer();
    const int before = drawn(*picture);
    for (const std::string& text :
         {std::string("{"), std::string("body"), std::string("error \xC3\xA4\xC3"),
          std::string("\0x", 2), std::string("while 1 {}"), std::string(5000, '[')}) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        EXPECT_TRUE(editor.document().hasErrors());
        EXPECT_GE(viewer->messages().count(), 1);
        EXPECT_EQ(drawn(*picture), before);
    }
}

TEST_F(ViewersTest, RevertGoesBackToWhatWasSaved) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_EQ(editor.document().savedText(), "");
    type(*viewer, "# something else\n");
    viewer->revert();
    EXPECT_EQ(viewer->draft(), "");
    EXPECT_EQ(editor.document().text(), "");
    editor.document().undo(); // a revert is a step like others
    EXPECT_EQ(viewer->draft(), ballScene);
}

TEST_F(ViewersTest, RevertAsksBeforeWhatWasTypedIsLost) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto revertChoosing = [&](QMessageBox::StandardButton choice) {
        bool isAsked = false;
        QTimer::singleShot(0, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            isAsked = box != nullptr;
            if (box)
                box->button(choice)->click();
        });
        button(*viewer, "Revert")->click();
        QCoreApplication::processEvents();
        return isAsked;
    };
    type(*viewer, "# something else\n");
    EXPECT_TRUE(revertChoosing(QMessageBox::No));
    EXPECT_EQ(viewer->draft(), "# something else\n");
    EXPECT_TRUE(revertChoosing(QMessageBox::Yes));
    EXPECT_EQ(viewer->draft(), "");
    editor.document().undo();
    EXPECT_FALSE(revertChoosing(QMessageBox::Yes)); // Undo brings it back
    EXPECT_EQ(editor.document().text(), "");
}

TEST_F(ViewersTest, UnderAHostRevertDropsTheDraftOnly) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, "# something else\n");
    viewer->revert();
    EXPECT_EQ(viewer->draft(), ballScene);
    EXPECT_FALSE(button(*viewer, "Save")->isVisible());
    editor.document().setTextFromHost("# from the host\n");
    EXPECT_EQ(viewer->draft(), "# from the host\n");
}

TEST_F(ViewersTest, WhatTheHostRefusesIsADraftAgain) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    const std::string mine = ballScene + "# mine\n", theirs = ballScene + "# theirs\n";
    type(*one, mine);
    one->updateDocument();
    EXPECT_EQ(two->draft(), mine); // shown at once
    editor.document().didRefuse(theirs, "the text is at revision 3");
    EXPECT_EQ(one->draft(), mine);
    EXPECT_TRUE(one->hasDraft());
    EXPECT_EQ(two->draft(), theirs);
    EXPECT_FALSE(two->hasDraft());
    const auto notice = [](LanguageViewer& viewer) {
        for (QLabel* label : viewer.findChildren<QLabel*>())
            if (label->accessibleName() == "Notice" && !label->isHidden())
                return label->text();
        return QString();
    };
    EXPECT_TRUE(notice(*one).contains("the text is at revision 3"));
    EXPECT_EQ(notice(*two), QString());
    button(*one, "Keep Mine")->click();
    one->updateDocument();
    editor.document().didAccept();
    EXPECT_EQ(notice(*one), QString());
    EXPECT_EQ(two->draft(), mine);
    // What was accepted is no draft any more, whatever is refused later.
    type(*two, ballScene);
    two->updateDocument();
    editor.document().didRefuse(mine, "no");
    EXPECT_FALSE(one->hasDraft());
    EXPECT_EQ(two->draft(), ballScene);
}

// What was typed after Update is a draft upon what the host refuses: all of it is kept.
TEST_F(ViewersTest, WhatGoesOnAfterAnUpdateKeepsWhatTheHostRefuses) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, "# one\n" + ballScene);
    viewer->updateDocument();
    type(*viewer, "# one\n" + ballScene + "# two\n");
    const std::string theirs = "simulator -finish 3" + ballScene.substr(19);
    editor.document().didRefuse(theirs, "no");
    EXPECT_EQ(viewer->draft(), "# one\n" + theirs + "# two\n");
    EXPECT_TRUE(viewer->hasDraft());
    viewer->updateDocument();
    EXPECT_EQ(editor.document().text(), "# one\n" + theirs + "# two\n");
}

// A gesture that was given up leaves no dispute behind.
TEST_F(ViewersTest, WhatIsAsItWasIsNoConflict) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto with = [](const std::string& x) {
        return ballScene.substr(0, ballScene.find("{-1 0")) + "{" + x +
               ballScene.substr(ballScene.find(" 0 0} -init_dpos"));
    };
    type(*viewer, with("7"));
    const auto conflicts = [&] {
        return static_cast<SceneEditor&>(viewer->editor()).marks(Mark::conflict).size();
    };
    const int since = editor.document().revision();
    editor.document().preview(with("-1.5"), since);
    EXPECT_EQ(conflicts(), 1U);
    editor.document().preview(with("-1.25"), since);
    EXPECT_EQ(conflicts(), 1U);
    editor.document().finishPreview(ballScene, {}, since);
    EXPECT_EQ(conflicts(), 0U);
    EXPECT_EQ(viewer->draft(), with("7"));
}

TEST_F(ViewersTest, LinesAreBrokenAsTheTextBreaksThem) {
    editor.document().setText("# one\r\n# two\r\n", "Edit");
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_EQ(viewer->editor().eolMode(), QsciScintilla::EolWindows);
    editor.document().setText("# one\n", "Edit");
    EXPECT_EQ(viewer->editor().eolMode(), QsciScintilla::EolUnix);
}

TEST_F(ViewersTest, FindGoesFromPlaceToPlaceAndRoundAgain) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_TRUE(viewer->find("ball"));
    int line = 0, column = 0, toLine = 0, toColumn = 0;
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 1);
    EXPECT_TRUE(viewer->find("ball"));
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 2);
    EXPECT_TRUE(viewer->find("ball"));
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 1);
    EXPECT_FALSE(viewer->find("not there"));
}

TEST_F(ViewersTest, ColoursFollowTheStructureOfTheText) {
    const std::string text = "# body\nforeach i {1 2} { body b$i ball -mass 3 }\nset s \"body\"\n";
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, text);
    viewer->editor().SendScintilla(QsciScintillaBase::SCI_COLOURISE, 0UL, -1L);
    const auto style = [&](const std::string& what, std::size_t from = 0) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT,
                                              text.find(what, from));
    };
    EXPECT_EQ(style("# body"), 1);
    EXPECT_EQ(style("body", 8), 2); // in the loop's body: a scene command
    EXPECT_EQ(style("foreach"), 3);
    EXPECT_EQ(style("-mass"), 4);
    EXPECT_EQ(style("3"), 5);
    EXPECT_EQ(style("$i"), 6);
    EXPECT_EQ(style("body\""), 7); // in quotes: only text
}

TEST_F(ViewersTest, LiteralPlacesThatViewsShareAreHighlighted) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto marked = [&](const std::string& what) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 10UL,
                                              static_cast<long>(ballScene.find(what))) != 0;
    };
    EXPECT_TRUE(marked("{-1 0 0}"));
    EXPECT_TRUE(marked("{1 0 0}"));
    EXPECT_FALSE(marked("-init_pos"));
    EXPECT_FALSE(marked("{-sub"));
}

// --- files and windows --------------------------------------------------------------------------

// A draft belongs to the file that it is a draft of.
TEST_F(ViewersTest, AnotherFileIsOpenedWhenItsDraftsAreSettled) {
    QTemporaryDir home;
    const QString path = home.filePath("other.al");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("# other\n");
    file.close();
    ASSERT_EQ(editor.document().save(home.filePath("scene.al")).sentence, "");
    LanguageViewer* viewer = editor.openLanguageViewer();
    SceneFiles& files = editor.beginSession();
    const auto openChoosing = [&](const QString& choice) {
        type(*viewer, ballScene + "# mine\n");
        QTimer::singleShot(0, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            QPushButton* chosen = button(*box, choice);
            ASSERT_NE(chosen, nullptr);
            chosen->click();
        });
        files.open(path);
    };
    openChoosing("Cancel");
    EXPECT_EQ(editor.document().text(), ballScene);
    EXPECT_TRUE(viewer->hasDraft());
    openChoosing("Drop the Draft");
    EXPECT_EQ(editor.document().text(), "# other\n");
    EXPECT_EQ(viewer->draft(), "# other\n");
    EXPECT_FALSE(viewer->hasDraft());
    // Whoever opens it: no draft goes into another file.
    type(*viewer, "# mine\n");
    editor.document().reset();
    EXPECT_EQ(viewer->draft(), "");
    EXPECT_FALSE(viewer->hasDraft());
}

TEST_F(ViewersTest, AClosedViewerIsForgotten) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->close();
    ASSERT_TRUE(waitFor([&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return editor.graphicalViewers().isEmpty();
    }));
    editor.document().setText(ballScene + "# on\n", "Edit");
    EXPECT_TRUE(settle(editor.document()));
}

} // namespace
} // namespace views
