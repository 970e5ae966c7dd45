#include "views/test_workshop.h"
#include "workbench/scene_document.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <random>

namespace views {
namespace {

class DocumentTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
};

TEST_F(DocumentTest, ATextBecomesASceneAndMotion) {
    int scenes = 0;
    QObject::connect(&document, &SceneDocument::sceneChanged, [&] { ++scenes; });
    document.setText(ballScene, "Edit");
    EXPECT_EQ(document.revision(), 1);
    EXPECT_FALSE(document.sceneIsCurrent());
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(document.sceneIsCurrent());
    EXPECT_EQ(document.shown().scene->bodies.size(), 1U);
    ASSERT_NE(document.shown().motion, nullptr);
    EXPECT_EQ(document.shown().motion->finish(), 2);
    EXPECT_EQ(scenes, 1);
    EXPECT_FALSE(document.hasErrors());
}

TEST_F(DocumentTest, TheSameTextIsNotWorkedOnTwice) {
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(settle(document));
    document.setText(ballScene, "Edit");
    EXPECT_EQ(document.work(), Work::none);
    EXPECT_EQ(made.reads, 1);
    document.recompute();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.simulations, 2);
}

TEST_F(DocumentTest, AFaultyTextLeavesTheLastGoodSceneInForce) {
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(settle(document));
    const Shown good = document.shown();
    document.setText(ballScene + "body b2 bal\n", "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(document.hasErrors());
    EXPECT_EQ(document.diagnostics().front().line, 4);
    EXPECT_EQ(document.shown().scene, good.scene);
    EXPECT_EQ(document.shown().motion, good.motion);
    EXPECT_FALSE(document.sceneIsCurrent());
    EXPECT_EQ(made.simulations, 1);
}

TEST_F(DocumentTest, TheTextThatWasSetLastWins) {
    made.blocked = true;
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(waitFor([&] { return made.simulations == 1; }));
    document.setText("simulator -finish 7\n" + ballScene.substr(20), "Edit");
    ASSERT_TRUE(waitFor([&] { return made.simulations == 2; }));
    EXPECT_EQ(made.cancelled, 1);
    made.blocked = false;
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.shown().motion->finish(), 7);
}

// --- live ------------------------------------------------------------------------------------

TEST_F(DocumentTest, TheInterfaceReadsAndSimulatesNothing) {
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(settle(document));
    const int since = document.revision();
    for (int i = 0; i < 20; ++i) {
        document.preview(ballScene + "# " + std::to_string(i) + "\n", since);
        QCoreApplication::processEvents();
    }
    document.finishPreview(ballScene + "# end\n", "Edit", since);
    document.recompute();
    document.undo();
    ASSERT_TRUE(settle(document));
    document.redo();
    ASSERT_TRUE(settle(document));
    EXPECT_GE(made.reads, 2);
    EXPECT_GE(made.simulations, 2);
    EXPECT_EQ(made.onTheInterface, 0);
}

std::string ballAt(const std::string& x) {
    return "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
           "body b1 ball -init_pos {" +
           x + " 0 0} -init_dpos {1 0 0}\n";
}

TEST_F(DocumentTest, ASceneIsShownBeforeItsMotionWhichIsStaleUntilThen) {
    document.setText(ballAt("-1"), "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.motionIsStale());
    made.blocked = true;
    document.setText(ballAt("3"), "Edit");
    ASSERT_TRUE(waitFor([&] { return document.sceneIsCurrent(); }));
    EXPECT_EQ(document.work(), Work::simulating);
    EXPECT_TRUE(document.motionIsStale());
    // At the start as the scene says, later as it was.
    ASSERT_NE(document.shown().motion, nullptr);
    EXPECT_EQ(document.shown().motion->at(0, 0).position.x(), 3);
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 0);
    made.blocked = false;
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.motionIsStale());
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 4);
}

TEST_F(DocumentTest, OtherBodiesHaveNoStaleMotion) {
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(settle(document));
    made.blocked = true;
    document.setText(ballScene + "body b2 ball\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return document.sceneIsCurrent(); }));
    EXPECT_EQ(document.shown().motion, nullptr);
    EXPECT_TRUE(document.motionIsStale());
    made.blocked = false;
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.motionIsStale());
}

TEST_F(DocumentTest, InAGestureAMotionMayEndBeforeTheNextIsBegun) {
    document.setText(ballAt("0"), "Edit");
    ASSERT_TRUE(settle(document));
    document.setOverlap(std::chrono::hours(1));
    const int before = made.simulations;
    made.blocked = true;
    const int since = document.revision();
    document.preview(ballAt("1"), since);
    ASSERT_TRUE(waitFor([&] { return made.simulations == before + 1; }));
    document.preview(ballAt("2"), since);
    ASSERT_TRUE(
        waitFor([&] { return document.shown().scene->bodies[0].initialPosition.x() == 2; }));
    made.blocked = false;
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.cancelled, 0);
    EXPECT_EQ(made.simulations, before + 2);
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 3);
    // What one does otherwise ends it at once.
    made.blocked = true;
    document.preview(ballAt("4"), since);
    ASSERT_TRUE(waitFor([&] { return made.simulations == before + 3; }));
    document.finishPreview(ballAt("5"), "Edit", since);
    ASSERT_TRUE(waitFor([&] { return made.cancelled == 1; }));
    made.blocked = false;
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 6);
}

TEST_F(DocumentTest, StoppingKeepsTheMotionAndTheNextEditIsComputed) {
    document.setText(ballAt("0"), "Edit");
    ASSERT_TRUE(settle(document));
    made.blocked = true;
    document.setText(ballAt("1"), "Edit");
    ASSERT_TRUE(waitFor([&] { return document.work() == Work::simulating; }));
    document.stopComputing();
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(document.computingWasStopped());
    EXPECT_FALSE(document.motionIsStale());
    made.blocked = false;
    document.undo();
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.computingWasStopped());
    EXPECT_FALSE(document.motionIsStale());
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 1);
}

TEST_F(DocumentTest, MotionIsComputedOnlyWhenAskedForWhereThatIsWanted) {
    document.setText(ballAt("0"), "Edit");
    ASSERT_TRUE(settle(document));
    document.setLive(Live::never);
    const int before = made.simulations;
    document.setText(ballAt("1"), "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.simulations, before);
    EXPECT_TRUE(document.waitsToBeAsked());
    document.setLive(Live::always);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.simulations, before + 1);
    EXPECT_FALSE(document.motionIsStale());
}

TEST_F(DocumentTest, WhoChangesTheTextWhenToldOfAMotionIsWorkedFor) {
    bool isChanged = false;
    QObject::connect(&document, &SceneDocument::motionChanged, [&] {
        if (!document.motionIsStale() && !std::exchange(isChanged, true))
            document.setText(ballScene + "body b2 ball -init_pos {3 0 0}\n", "Edit");
    });
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(waitFor([&] { return isChanged; }));
    ASSERT_TRUE(settle(document)); // at once, were it not worked for
    EXPECT_EQ(document.shown().scene->bodies.size(), 2U);
}

TEST_F(DocumentTest, ClosingWhileComputingEndsTheComputation) {
    made.blocked = true;
    {
        SceneDocument other{made.workshop()};
        other.setText(ballScene, "Edit");
        ASSERT_TRUE(waitFor([&] { return made.simulations == 1; }));
    }
    EXPECT_EQ(made.cancelled, 1);
}

TEST_F(DocumentTest, UndoAndRedoWalkThroughTheTexts) {
    document.setText("# one\n", "Edit");
    document.setText("# one\n# two\n", "Edit");
    document.setText("# three\n", "Edit");
    EXPECT_FALSE(document.canRedo());
    document.undo();
    EXPECT_EQ(document.text(), "# one\n# two\n");
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), "");
    EXPECT_FALSE(document.canUndo());
    document.redo();
    document.redo();
    EXPECT_EQ(document.text(), "# one\n# two\n");
    document.setText("# other\n", "Edit");
    EXPECT_FALSE(document.canRedo());
}

// --- under a host, and files ------------------------------------------------------------------

// One who duplicates, takes it back and does it again goes on with the same bodies.
TEST_F(DocumentTest, UndoAndRedoSelectWhatWasSelectedIfNothingElseIs) {
    using editing::Kind;
    const std::string three = ballScene + "body b2 ball\nbody b3 ball\n";
    const auto is = [&](std::vector<editing::Element> elements) {
        ASSERT_TRUE(settle(document));
        EXPECT_EQ(document.selected(), elements);
    };
    document.setText(ballScene, "Edit");
    ASSERT_TRUE(settle(document));
    document.select({{Kind::body, 0}});
    document.setText(three, "Duplicate");
    ASSERT_TRUE(settle(document));
    document.select({{Kind::body, 1}, {Kind::body, 2}});
    document.undo();
    is({{Kind::body, 0}});
    document.select({});
    document.redo();
    is({{Kind::body, 1}, {Kind::body, 2}});
    document.select({{Kind::body, 1}, {Kind::body, 0}}); // what is there still stays selected
    document.undo();
    is({{Kind::body, 0}});
    document.select({});
    document.setText("# another\n" + ballScene, "Edit");
    is({});
}

TEST_F(DocumentTest, UnderAHostChangesGoThereAndUndoIsAskedForThere) {
    text::Edits edits;
    int undos = 0;
    document.setTextFromHost("# a b c\n");
    document.setHostLink({[&](const text::Edit& edit, const QString&) { edits.push_back(edit); },
                          [&] { ++undos; }, [] {}});
    document.setText("# a bx c\n", "Edit");
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0], (text::Edit{{5, 5}, "x"}));
    document.undo();
    EXPECT_EQ(undos, 1);
    EXPECT_EQ(document.text(), "# a bx c\n"); // until the host's answer arrives
    document.setTextFromHost("# a b c\n");
    EXPECT_EQ(document.text(), "# a b c\n");
    EXPECT_EQ(edits.size(), 1U);
}

TEST_F(DocumentTest, WhoIsToldOfAChangeSeesItInTheText) {
    document.setTextFromHost("# a\n");
    std::string seen;
    document.setHostLink(
        {[&](const text::Edit&, const QString&) { seen = document.text(); }, [] {}, [] {}});
    document.setText("# b\n", "Edit");
    EXPECT_EQ(seen, "# b\n");
}

TEST_F(DocumentTest, ARefusedChangeLeavesTheTextOfTheHost) {
    document.setTextFromHost("# a\n");
    document.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    QString why;
    QObject::connect(&document, &SceneDocument::changeRefused,
                     [&](const QString& sentence) { why = sentence; });
    document.setText("# mine\n", "Edit");
    document.didRefuse("# theirs\n", "too late");
    EXPECT_EQ(document.text(), "# theirs\n");
    EXPECT_EQ(why, "too late");
}

TEST_F(DocumentTest, AChangeIsAwaitedUntilTheHostsSessionHasReadIt) {
    SceneDocument shown{Workshop{}};
    int read = 0;
    bool isKnown = false; // to whoever waits
    QObject::connect(&shown, &SceneDocument::wasRead, [&] {
        ++read;
        isKnown = shown.sceneIsCurrent();
    });
    shown.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    shown.setTextFromHost(ballScene);
    EXPECT_TRUE(shown.isAwaited());
    Computed computed;
    computed.shown.scene = std::make_shared<const scene::Scene>(theReader().read(ballScene).scene);
    computed.text = ballScene;
    computed.current = true;
    shown.setComputed(computed);
    EXPECT_FALSE(shown.isAwaited());
    EXPECT_EQ(read, 1);
    EXPECT_TRUE(isKnown);
    shown.setText(ballScene + "# a\n", "Edit");
    EXPECT_TRUE(shown.isAwaited());
    EXPECT_EQ(read, 1);
    computed.current = false; // the text has errors
    shown.setComputed(computed);
    EXPECT_FALSE(shown.isAwaited());
    EXPECT_EQ(read, 2);
}

TEST_F(DocumentTest, WhatAnotherComputedIsShownAndNothingIsComputedHere) {
    SceneDocument shown{Workshop{}};
    int scenes = 0, motions = 0, faults = 0, asked = 0;
    QObject::connect(&shown, &SceneDocument::sceneChanged, [&] { ++scenes; });
    QObject::connect(&shown, &SceneDocument::motionChanged, [&] { ++motions; });
    QObject::connect(&shown, &SceneDocument::diagnosticsChanged, [&] { ++faults; });
    shown.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}, [&] { ++asked; }});
    shown.setTextFromHost(ballScene);
    shown.recompute();
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(made.reads, 0);
    Computed computed;
    const auto scene = std::make_shared<const scene::Scene>(theReader().read(ballScene).scene);
    computed.shown = {scene, flight(*scene)};
    computed.text = ballScene;
    computed.current = true;
    shown.setComputed(computed);
    EXPECT_TRUE(shown.sceneIsCurrent());
    EXPECT_EQ(shown.shown().motion, computed.shown.motion);
    shown.setComputed(computed); // the same again is no news
    EXPECT_EQ(scenes, 1);
    EXPECT_EQ(motions, 1);
    computed.diagnostics.push_back({scene::Severity::error, {}, 1, 1, 1, 2, "faulty", ""});
    computed.current = false;
    shown.setComputed(computed);
    EXPECT_EQ(scenes, 1);
    EXPECT_EQ(faults, 2);
    EXPECT_TRUE(shown.hasErrors());
}

// What is shown may be of an older text than the host's: elements are found again by that one.
TEST_F(DocumentTest, TheSceneThatAnotherReadBelongsToTheTextThatItWasReadFrom) {
    SceneDocument shown{Workshop{}};
    shown.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    const std::string head = "shape_set s -desc {-sub {-sphere 1}}\nbody b s\n";
    const std::string one = head + "force -body b -x 1\n";
    const std::string both = head + "force -body b -x 2\n" + "force -body b -x 1\n";
    const auto computed = [](const std::string& text, bool current) {
        Computed all;
        all.shown.scene = std::make_shared<const scene::Scene>(theReader().read(text).scene);
        all.text = text;
        all.current = current;
        return all;
    };
    shown.setTextFromHost(one);
    shown.setComputed(computed(one, true));
    shown.select({{editing::Kind::force, 0}});
    shown.setTextFromHost(both);
    shown.setComputed(computed(one, false)); // it was on its way
    EXPECT_EQ(shown.shownText(), one);
    shown.setComputed(computed(both, true));
    EXPECT_EQ(shown.shownText(), both);
    ASSERT_EQ(shown.selected().size(), 1U);
    EXPECT_EQ(shown.selected().front(), (editing::Element{editing::Kind::force, 1}));
}

TEST_F(DocumentTest, FilesAreReadAndWrittenByteForByte) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scene.al");
    const std::string text = ballScene + "# \xC3\xA4\r\n\t# no newline at the end";
    document.setText(text, "Edit");
    EXPECT_TRUE(document.isModified());
    EXPECT_EQ(document.save(path).sentence, "");
    EXPECT_FALSE(document.isModified());
    SceneDocument other{made.workshop()};
    EXPECT_EQ(other.open(path), QString());
    EXPECT_EQ(other.text(), text);
    EXPECT_EQ(other.name(), "scene.al");
    EXPECT_FALSE(other.canUndo());
}

TEST_F(DocumentTest, FilesThatCannotBeReadOrWrittenSaySo) {
    EXPECT_TRUE(document.open("/nowhere/at-all.al").contains("/nowhere/at-all.al"));
    EXPECT_TRUE(
        document.save("/nowhere/at-all.al").sentence.starts_with("at-all.al was not saved"));
    EXPECT_EQ(document.path(), QString());
}

} // namespace
} // namespace views
