#include "views/scene_document.h"
#include "views/test_workshop.h"

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
    document.setSlow({.overlap = std::chrono::hours(1)});
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

TEST_F(DocumentTest, ASlowScenesMotionWaitsToBeAsked) {
    document.setSlow({std::chrono::milliseconds(0), std::chrono::milliseconds(20)});
    document.setText(ballAt("0"), "Edit"); // takes longer than no time
    ASSERT_TRUE(settle(document));
    made.blocked = true;
    document.setText(ballAt("1"), "Edit"); // an attempt, which is given up
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(document.waitsToBeAsked());
    EXPECT_EQ(document.shown().scene->bodies[0].initialPosition.x(), 1);
    const int before = made.simulations;
    document.setText(ballAt("2"), "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(made.simulations, before);
    EXPECT_TRUE(document.waitsToBeAsked());
    EXPECT_EQ(document.shown().motion->at(0, 0).position.x(), 2);
    made.blocked = false;
    document.recompute();
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(document.motionIsStale());
    EXPECT_EQ(document.shown().motion->at(0, 1).position.x(), 3);
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
    EXPECT_NE(document.work(), Work::none);
    ASSERT_TRUE(settle(document));
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

// --- gestures: texts that are no steps of undo, and what comes between them

const std::string two = "parameter g -value 2\nshape_set s -desc {-sub {-sphere 1}}\n"
                        "body b s -init_pos {1 0 0}\n";

TEST_F(DocumentTest, AGestureIsOneStepHoweverManyTextsItMade) {
    document.setText(two, "Edit");
    const int since = document.revision();
    document.preview(two + "# 1\n", since);
    document.preview(two + "# 12\n", since);
    EXPECT_TRUE(document.isPreview());
    document.finishPreview(two + "# 12\n", "Drag", since);
    EXPECT_FALSE(document.isPreview());
    EXPECT_EQ(document.undoLabel(), "Drag");
    document.undo();
    EXPECT_EQ(document.text(), two);
    document.redo();
    EXPECT_EQ(document.text(), two + "# 12\n");
}

// Undo while a hand still holds something: what it did so far is a step, and is taken back.
TEST_F(DocumentTest, UndoDuringAGestureTakesTheGestureBack) {
    const std::string moved = "parameter g -value 2\nshape_set s -desc {-sub {-sphere 1}}\n"
                              "body b s -init_pos {10 0 0}\n";
    const std::string dragged = "parameter g -value 1.25" + moved.substr(20);
    document.setText(two, "Edit");
    document.setText(moved, "Move b");
    const int since = document.revision();
    document.preview(dragged, since);
    document.undo();
    EXPECT_EQ(document.text(), moved);
    document.preview(dragged, since); // the hand goes on, and is not heard
    document.finishPreview(dragged, "Change g", since);
    EXPECT_EQ(document.text(), moved);
    EXPECT_EQ(document.undoLabel(), "Move b");
    document.undo();
    EXPECT_EQ(document.text(), two);
    document.redo();
    document.redo();
    EXPECT_EQ(document.text(), dragged);
    EXPECT_FALSE(document.canRedo());
}

TEST_F(DocumentTest, AChangeDuringAGestureIsAStepOfItsOwn) {
    document.setText(two, "Edit");
    const int since = document.revision();
    document.preview(two + "# dragged\n", since);
    document.setText(two + "# dragged\n# set\n", "Set");
    document.finishPreview(two + "# dragged further\n", "Drag", since);
    EXPECT_EQ(document.text(), two + "# dragged\n# set\n");
    document.undo();
    EXPECT_EQ(document.text(), two + "# dragged\n");
    document.undo();
    EXPECT_EQ(document.text(), two);
    document.redo();
    document.redo();
    EXPECT_EQ(document.text(), two + "# dragged\n# set\n");
}

// A window that was closed while one dragged in it: the next gesture is another one.
TEST_F(DocumentTest, AGestureThatNeverEndsStopsNoOther) {
    document.setText(two, "Edit");
    document.preview(two + "# lost\n", document.revision());
    const int since = document.revision();
    document.preview(two + "# lost\n# next\n", since);
    document.finishPreview(two + "# lost\n# next\n", "Next", since);
    EXPECT_EQ(document.text(), two + "# lost\n# next\n");
    EXPECT_EQ(document.undoLabel(), "Next");
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), two);
}

// A press without a move ends in nothing, whatever the text became in between.
TEST_F(DocumentTest, AGestureThatDidNothingTakesNothingBack) {
    document.setText(two, "Edit");
    const int since = document.revision();
    document.setText(two + "# theirs\n", "Set");
    document.finishPreview(two, "Drag", since);
    EXPECT_EQ(document.text(), two + "# theirs\n");
    EXPECT_EQ(document.undoLabel(), "Set");
    document.setHostLink({[](const TextEdit&, const QString&) {}, [] {}, [] {}});
    const int later = document.revision();
    document.setTextFromHost(two + "# the host's\n");
    document.finishPreview(two, "Drag", later);
    EXPECT_EQ(document.text(), two + "# the host's\n");
}

TEST_F(DocumentTest, RandomGesturesAndUndosWalkThroughTheTexts) {
    std::mt19937 random(5);
    std::vector<std::string> steps{""}; // what undo walks through
    std::size_t at = 0;
    int since = -1; // of a gesture that goes on
    const auto step = [&](const std::string& text) {
        if (text == steps[at])
            return;
        steps.resize(at + 1);
        steps.push_back(text);
        ++at;
    };
    for (int k = 0; k < 500; ++k) {
        std::string text = document.text();
        text.insert(random() % (text.size() + 1), "# " + std::to_string(k) + "\n");
        if (text.size() > 200)
            text.erase(random() % 100, 50);
        switch (random() % 5) {
        case 0:
            if (since < 0)
                since = document.revision();
            document.preview(text, since);
            break;
        case 1: // the hand lets go
            if (since >= 0 && document.isPreview())
                step(document.text());
            if (since >= 0)
                document.finishPreview(document.text(), "Drag", since);
            since = -1;
            break;
        case 2:
            if (document.isPreview())
                step(document.text());
            document.setText(text, "Set");
            step(text);
            break;
        case 3:
            if (document.isPreview())
                step(document.text());
            document.undo();
            at -= at > 0 ? 1 : 0;
            break;
        default:
            if (document.isPreview())
                step(document.text());
            document.redo();
            at += at + 1 < steps.size() ? 1 : 0;
        }
        if (!document.isPreview()) {
            ASSERT_EQ(document.text(), steps[at]) << k;
        }
    }
}

TEST_F(DocumentTest, UnderAHostChangesGoThereAndUndoIsAskedForThere) {
    std::vector<TextEdit> edits;
    int undos = 0;
    document.setTextFromHost("# a b c\n");
    document.setHostLink({[&](const TextEdit& edit, const QString&) { edits.push_back(edit); },
                          [&] { ++undos; }, [] {}});
    document.setText("# a bx c\n", "Edit");
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].from, 5U);
    EXPECT_EQ(edits[0].to, 5U);
    EXPECT_EQ(edits[0].text, "x");
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
        {[&](const TextEdit&, const QString&) { seen = document.text(); }, [] {}, [] {}});
    document.setText("# b\n", "Edit");
    EXPECT_EQ(seen, "# b\n");
}

TEST_F(DocumentTest, ARefusedChangeLeavesTheTextOfTheHost) {
    document.setTextFromHost("# a\n");
    document.setHostLink({[](const TextEdit&, const QString&) {}, [] {}, [] {}});
    QString why;
    QObject::connect(&document, &SceneDocument::changeRefused,
                     [&](const QString& sentence) { why = sentence; });
    document.setText("# mine\n", "Edit");
    document.didRefuse("# theirs\n", "too late");
    EXPECT_EQ(document.text(), "# theirs\n");
    EXPECT_EQ(why, "too late");
}

TEST_F(DocumentTest, WhatAnotherComputedIsShownAndNothingIsComputedHere) {
    SceneDocument shown{Workshop{}};
    int scenes = 0, motions = 0, faults = 0, asked = 0;
    QObject::connect(&shown, &SceneDocument::sceneChanged, [&] { ++scenes; });
    QObject::connect(&shown, &SceneDocument::motionChanged, [&] { ++motions; });
    QObject::connect(&shown, &SceneDocument::diagnosticsChanged, [&] { ++faults; });
    shown.setHostLink({[](const TextEdit&, const QString&) {}, [] {}, [] {}, [&] { ++asked; }});
    shown.setTextFromHost(ballScene);
    shown.recompute();
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(made.reads, 0);
    Computed computed;
    const auto scene = std::make_shared<const scene::Scene>(theReader().read(ballScene).scene);
    computed.shown = {scene, flight(*scene)};
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

TEST_F(DocumentTest, FilesAreReadAndWrittenByteForByte) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scene.al");
    const std::string text = ballScene + "# \xC3\xA4\r\n\t# no newline at the end";
    document.setText(text, "Edit");
    EXPECT_TRUE(document.isModified());
    EXPECT_EQ(document.save(path), QString());
    EXPECT_FALSE(document.isModified());
    SceneDocument other{made.workshop()};
    EXPECT_EQ(other.open(path), QString());
    EXPECT_EQ(other.text(), text);
    EXPECT_EQ(other.name(), "scene.al");
    EXPECT_FALSE(other.canUndo());
}

TEST_F(DocumentTest, FilesThatCannotBeReadOrWrittenSaySo) {
    EXPECT_TRUE(document.open("/nowhere/at-all.al").contains("/nowhere/at-all.al"));
    EXPECT_TRUE(document.save("/nowhere/at-all.al").contains("/nowhere/at-all.al"));
    EXPECT_EQ(document.path(), QString());
}

// --- edits ----------------------------------------------------------------------------------

TEST(EditBetween, IsTheSmallestAndKeepsCharactersWhole) {
    const auto edit = [](const std::string& a, const std::string& b) {
        const TextEdit e = editBetween(a, b);
        return std::to_string(e.from) + "-" + std::to_string(e.to) + ":" + e.text;
    };
    EXPECT_EQ(edit("abc", "abc"), "3-3:");
    EXPECT_EQ(edit("abc", "abXc"), "2-2:X");
    EXPECT_EQ(edit("aaa", "aa"), "2-3:");
    EXPECT_EQ(edit("", "new"), "0-0:new");
    // a-umlaut (C3 A4) to o-umlaut (C3 B6): the common first byte belongs to the character.
    EXPECT_EQ(edit("x\xC3\xA4y", "x\xC3\xB6y"), "1-3:\xC3\xB6");
    // ... and a common last byte too (C3 A4 to C2 A4).
    EXPECT_EQ(edit("x\xC3\xA4y", "x\xC2\xA4y"), "1-3:\xC2\xA4");
}

TEST(EditBetween, AppliedGivesTheOtherText) {
    std::mt19937 random(6);
    const auto text = [&] {
        std::string s;
        for (unsigned i = random() % 12; i > 0; --i)
            s += std::string(random() % 3 == 0 ? "\xC3\xA4" : random() % 2 == 0 ? "a" : "b");
        return s;
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string before = text(), after = text();
        const TextEdit e = editBetween(before, after);
        ASSERT_EQ(before.substr(0, e.from) + e.text + before.substr(e.to), after);
    }
}

} // namespace
} // namespace views
