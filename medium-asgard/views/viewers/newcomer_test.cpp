// What a new user stumbled over in the windows.
#include "frame/manual.h"
#include "frame/manual_window.h"
#include "language/scene_editor.h"
#include "shapes/shape_editor.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "views/test_workshop.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>

namespace views {
namespace {

using geometry::Vector;

class NewcomerTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& text) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }
    static QAction* action(QWidget& window, const QString& beginsWith) {
        for (QAction* one : window.findChildren<QAction*>())
            if (one->text().remove('&').startsWith(beginsWith))
                return one;
        return nullptr;
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

TEST_F(NewcomerTest, FrameAllShowsTheHandlesToo) {
    open("simulator -finish 1\nshape_set s -desc {-sub {-sphere 0.5}}\n"
         "body a s -init_dpos {0.4 0 0}\nbody b s -init_dpos {0 9 0} -init_pos {20 0 0}\n"
         "body c s -init_dpos {0 0.1 0} -init_pos {-2 0 0}\n");
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.frameAll();
    display.grab();
    const double alone = display.camera().scale;
    viewer->findChild<StatusPanel*>()->show(&render::Display::lightHandles);
    viewer->findChild<StatusPanel*>()->show(&render::Display::spinHandles);
    viewer->findChild<StatusPanel*>()->show(&render::Display::velocityHandles);
    display.grab();
    EXPECT_EQ(display.camera().scale, alone); // a switch moves nothing
    display.frameAll();
    display.grab();
    ASSERT_FALSE(display.handles().handles.empty());
    for (const render::Handle& handle : display.handles().handles) {
        const QPointF place = display.fromPixels(display.sight().pixels(handle.place));
        EXPECT_TRUE(QRectF(display.rect()).contains(place)) << place.x() << " " << place.y();
    }
}

// Gravity without a floor takes bodies far off within seconds: what one works on stays in sight.
TEST_F(NewcomerTest, ThePictureStaysWhileOneEdits) {
    const std::string three = "simulator -finish 10\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                              "body a s\nbody b s -init_pos {2 0 0}\n";
    open(three);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.frameAll();
    display.grab();
    const render::Camera before = display.camera();
    open(three + "body c s -init_pos {1 0 0} -init_dpos {0 -50 0}\n");
    display.grab();
    EXPECT_EQ(display.camera(), before);
    open(three + "body c s -init_pos {9 0 0}\n"); // it steps back as far as this one needs
    display.grab();
    EXPECT_LT(display.camera().scale, before.scale);
    const QPointF place = display.fromPixels(display.sight().pixels({9, 0, 0}));
    EXPECT_TRUE(QRectF(display.rect()).contains(place));
    EXPECT_EQ(display.camera().rotation.coeffs(), before.rotation.coeffs());
    // Another scene is framed anew, all of its motion.
    editor.document().reset("simulator -finish 10\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                            "body a s -init_dpos {50 0 0}\n");
    ASSERT_TRUE(settle(editor.document()));
    display.grab();
    EXPECT_LT(display.camera().scale, before.scale / 10);
}

// In a view of the reader's own, too; a body that was out of it stays out.
TEST_F(NewcomerTest, ThePictureStepsBackFromABodyThatGrows) {
    const auto scene = [](double radius, double beside) {
        return "shape_set s -desc {-sub {-sphere " + std::to_string(radius) +
               "}}\nshape_set t -desc {-sub {-sphere " + std::to_string(beside) +
               "}}\nbody a s\nbody b t -init_pos {40 0 0}\n";
    };
    open(scene(0.5, 0.5));
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    display.lookAlong(Vector::UnitZ());
    editor.document().select({{editing::Kind::body, 0}});
    display.frameSelected();
    display.grab();
    const render::Camera before = display.camera();
    open(scene(0.3, 1));
    display.grab();
    EXPECT_EQ(display.camera(), before);
    open(scene(4, 1));
    display.grab();
    EXPECT_LT(display.camera().scale, before.scale / 4);
    EXPECT_GT(display.camera().scale, before.scale / 20);
    EXPECT_TRUE(
        display.rect().contains(display.fromPixels(display.sight().pixels({0, 4, 0})).toPoint()));
    EXPECT_FALSE(
        display.rect().contains(display.fromPixels(display.sight().pixels({40, 0, 0})).toPoint()));
}

// Along the row two balls are as wide as one: there they are seen larger, and from the side again
// both are in the picture. A view of the reader's own keeps its scale.
TEST_F(NewcomerTest, AKeyThatTurnsTheWholeSceneKeepsAllOfItInSight) {
    open("shape_set s -desc {-sub {-sphere 0.5}}\nbody a s\nbody b s -init_pos {40 0 0}\n");
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    const auto seenAlong = [&display](const Vector& toward) {
        display.lookAlong(toward);
        display.grab();
        return display.camera();
    };
    const render::Camera side = seenAlong(Vector::UnitZ());
    EXPECT_GT(seenAlong(Vector::UnitX()).scale, 2 * side.scale);
    EXPECT_EQ(seenAlong(Vector::UnitZ()), side);
    render::Camera own = side;
    own.scale *= 3;
    display.setCamera(own);
    EXPECT_EQ(seenAlong(Vector::UnitX()).scale, own.scale);
    EXPECT_EQ(seenAlong(Vector::UnitZ()).scale, own.scale);
}

TEST_F(NewcomerTest, PlayingSaysWhyNothingMoves) {
    open("shape_set s -desc {-sub {-sphere 0.5}}\nbody a s -init_pos {0 1 0} -fixed 1\n");
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->playback().play();
    EXPECT_TRUE(viewer->display().editing().said().contains("every body is fixed"));
    viewer->playback().stop();
    open(ballScene); // it flies
    viewer->display().editing().say({});
    viewer->playback().play();
    EXPECT_EQ(viewer->display().editing().said(), "");
}

TEST_F(NewcomerTest, ARefusalGoesWithTheNextChange) {
    open(ballScene);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().editing().say("That cannot be.");
    open("# other\n" + ballScene);
    EXPECT_EQ(viewer->display().editing().said(), "");
}

TEST_F(NewcomerTest, EscapeLeavesAFullScreen) {
    open(ballScene);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->showFullScreen();
    ASSERT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
    QTest::keyClick(&viewer->display(), Qt::Key_Escape);
    EXPECT_FALSE(viewer->isFullScreen());
}

TEST_F(NewcomerTest, PlayingComputesAStaleMotion) {
    open(ballScene);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    editor.document().setLive(Live::never);
    editor.document().setText("# other\n" + ballScene + "body b2 ball -init_pos {0 3 0}\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return editor.document().waitsToBeAsked(); }));
    viewer->playback().play();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(editor.document().motionIsStale());
}

TEST_F(NewcomerTest, ANewSceneIsSeenFromItsStart) {
    open(ballScene);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->playback().seek(1.5);
    render::Camera far = viewer->display().camera();
    far.center = Vector(1000, 0, 0);
    viewer->display().setCamera(far);
    editor.document().reset();
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_EQ(viewer->playback().time(), 0);
    EXPECT_LT(viewer->display().camera().center.norm(), 10);
}

TEST_F(NewcomerTest, ANewSceneHasNoPaneOfPlotsThatItDoesNotHave) {
    const std::string plotted = ballScene + "plot p -values {b1.x}\n";
    open(plotted);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    const auto isShownAfter = [&](const std::string& text) {
        viewer->panes().show("plots");
        editor.document().reset(text);
        EXPECT_TRUE(settle(editor.document()));
        return viewer->panes().isShown("plots");
    };
    EXPECT_FALSE(isShownAfter(ballScene));
    EXPECT_TRUE(isShownAfter(plotted));
    open(ballScene); // an edit closes nothing
    EXPECT_TRUE(viewer->panes().isShown("plots"));
}

TEST_F(NewcomerTest, UndoIsNamedInEveryWindow) {
    open(ballScene);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    EXPECT_EQ(action(*viewer, "Undo")->text(), "&Undo Edit");
    const int since = editor.document().revision();
    editor.document().preview(ballScene + "# a", since);
    editor.document().finishPreview(ballScene + "# a", "Drag", since);
    EXPECT_EQ(action(*viewer, "Undo")->text(), "&Undo Drag");
    EXPECT_EQ(action(*editor.openShapeEditor(), "Undo")->text(), "&Undo Drag");
}

TEST_F(NewcomerTest, TheEndingOfAnExportsNameSaysWhatItIs) {
    open(ballScene);
    const QTemporaryDir folder;
    editor.beginSession().exports().write(folder.filePath("a.CSV"), ExportFormat::png);
    EXPECT_TRUE(waitFor([&] { return QFileInfo(folder.filePath("a.CSV")).size() > 100; }));
    EXPECT_EQ(formatOf("now.png", ExportFormat::table), ExportFormat::png);
    EXPECT_EQ(formatOf("film", ExportFormat::film), ExportFormat::film);
}

TEST_F(NewcomerTest, ADoubleClickOnANumberTakesAllOfIt) {
    open("shape_set s -desc {-sub {-sphere 0.5}}\nbody b s -init_pos {-12.25 3e-2 0}\n");
    LanguageViewer* viewer = editor.openLanguageViewer();
    auto& text = static_cast<SceneEditor&>(viewer->editor());
    for (const char* number : {"-12.25", "3e-2", "0.5"}) {
        const std::size_t at = text.bytes().find(number) + 2;
        QTest::mouseDClick(text.viewport(), Qt::LeftButton, {},
                           text.rectOf(at).center() + QPoint(2, 0));
        const scene::Range taken = text.selection();
        EXPECT_EQ(text.bytes().substr(taken.from, taken.to - taken.from), number);
    }
}

// With its keys and what they undo.
TEST_F(NewcomerTest, TheMenuOfTheTextIsItsEditMenu) {
    open(ballScene);
    QWidget* text = editor.openLanguageViewer()->editor().viewport();
    const QPoint place = text->rect().center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, text->mapToGlobal(place));
    QApplication::sendEvent(text, &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_TRUE(menu);
    EXPECT_TRUE(std::ranges::any_of(menu->actions(), [](const QAction* one) {
        return one->text().remove('&').startsWith("Find Next");
    }));
    menu->close();
}

TEST_F(NewcomerTest, WhatIsSelectedElsewhereIsShownFromTheBeginningOfItsLine) {
    open("shape_set s -desc {-sub {-sphere 0.5}}\nbody b s" + std::string(300, ' ') +
         "-init_pos {1 2 3}\n");
    LanguageViewer* viewer = editor.openLanguageViewer();
    auto& text = static_cast<SceneEditor&>(viewer->editor());
    text.grab();
    editor.document().select({{editing::Kind::body, 0}});
    text.grab();
    EXPECT_EQ(text.SendScintilla(QsciScintillaBase::SCI_GETXOFFSET), 0);
}

TEST_F(NewcomerTest, TakingTheScenesWordsLosesNone) {
    const std::string line = "parameter push -value 0.35 -min 0 -max 1\n";
    open(line);
    LanguageViewer* viewer = editor.openLanguageViewer();
    viewer->editor().setText("parameter push -value 0.0.777min 0 -max 1 ;# mine\n");
    editor.document().setText("parameter push -value 0.577 -min 0 -max 1\n", "Drag");
    action(*viewer, "Take the Scene's")->trigger();
    EXPECT_EQ(viewer->draft(), "parameter push -value 0.577 -min 0 -max 1 ;# mine\n");
}

TEST_F(NewcomerTest, ADragOfASliderLeavesTheKeysToThePicture) {
    open("parameter push -value 0.35 -min 0 -max 1\n" + ballScene);
    int sliders = 0;
    for (const QSlider* slider : editor.openGraphicalViewer()->findChildren<QSlider*>())
        if (slider->accessibleName() == "push") {
            EXPECT_EQ(slider->focusPolicy(), Qt::TabFocus);
            ++sliders;
        }
    EXPECT_EQ(sliders, 1);
}

TEST_F(NewcomerTest, UnderADocumentSavingADraftUpdatesTheScene) {
    HostLink link;
    link.changed = [](const text::Edit&, const QString&) {};
    editor.document().setHostLink(link);
    const auto keys = action(*editor.openLanguageViewer(), "Update")->shortcuts();
    EXPECT_TRUE(keys.contains(QKeySequence(QKeySequence::Save)));
}

TEST_F(NewcomerTest, ANewWindowLiesWhereItIsSeenAndHidesNothingWhole) {
    open(ballScene);
    GraphicalViewer* first = editor.openGraphicalViewer();
    first->move(60, 50);
    first->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(first, longestWait));
    const GraphicalViewer* second = editor.openGraphicalViewer();
    EXPECT_NE(second->pos(), first->pos());
    EXPECT_GE(second->pos().y(), second->screen()->availableGeometry().top());
    EXPECT_NE(second->pos(), QPoint(0, 0));
}

TEST_F(NewcomerTest, TheManualThatIsOpenStaysAsLargeAsItWasMade) {
    open(ballScene);
    showManual();
    for (QWidget* window : QApplication::topLevelWidgets())
        if (auto* manual = qobject_cast<ManualWindow*>(window)) {
            const QSize large = manual->screen()->availableGeometry().size() + QSize(50, 50);
            manual->resize(large);
            showManual();
            EXPECT_EQ(manual->size(), large);
            manual->close();
        }
}

// As where everything is twice as large. No window of this process is active under a document.
TEST_F(NewcomerTest, ANewWindowIsNotLargerThanItsScreen) {
    open(ballScene);
    showManual();
    QList<QMainWindow*> all{editor.openGraphicalViewer(), editor.openLanguageViewer(),
                            editor.openShapeEditor()};
    for (QWidget* window : QApplication::topLevelWidgets())
        if (auto* manual = qobject_cast<ManualWindow*>(window))
            all << manual;
    EXPECT_EQ(all.size(), 4);
    for (const QMainWindow* window : all) {
        EXPECT_LE(window->minimumSizeHint().width(), 700) << window->windowTitle().toStdString();
        EXPECT_LE(window->minimumSizeHint().height(), 450) << window->windowTitle().toStdString();
        const QSize room = window->screen()->availableGeometry().size();
        EXPECT_LT(window->width(), room.width()) << window->windowTitle().toStdString();
        EXPECT_LT(window->height(), room.height()) << window->windowTitle().toStdString();
    }
}

} // namespace
} // namespace views
