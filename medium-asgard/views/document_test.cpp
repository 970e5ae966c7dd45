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
