// Texts that a gesture shows on its way are no steps of undo, and much may come between them.
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <random>

namespace views {
namespace {

class DocumentGesturesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
};

const std::string two = "parameter g -value 2\nshape_set s -desc {-sub {-sphere 1}}\n"
                        "body b s -init_pos {1 0 0}\n";

TEST_F(DocumentGesturesTest, AGestureIsOneStepHoweverManyTextsItMade) {
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
TEST_F(DocumentGesturesTest, UndoDuringAGestureTakesTheGestureBack) {
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

TEST_F(DocumentGesturesTest, AChangeDuringAGestureIsAStepOfItsOwn) {
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
TEST_F(DocumentGesturesTest, AGestureThatNeverEndsStopsNoOther) {
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

// Two hands that took hold of something in the same text are two all the same.
TEST_F(DocumentGesturesTest, AnotherHandEndsAGestureAndIsNotTakenForIt) {
    document.setText(two, "Edit");
    const int since = document.revision();
    const int one = 0, other = 0;
    document.preview(two + "# one\n", since, &one);
    document.preview(two + "# other\n", since, &other); // made of a text that is no more
    EXPECT_EQ(document.text(), two + "# one\n");
    document.finishPreview(two + "# other\n", "Other", since, &other);
    document.preview(two + "# one two\n", since, &one); // it was not ended by that
    document.finishPreview(two + "# one two\n", "One", since, &one);
    EXPECT_EQ(document.text(), two + "# one two\n");
    EXPECT_EQ(document.undoLabel(), "One");
    document.undo();
    EXPECT_EQ(document.text(), two);
}

// A press without a move ends in nothing, whatever the text became in between.
TEST_F(DocumentGesturesTest, AGestureThatDidNothingTakesNothingBack) {
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

TEST_F(DocumentGesturesTest, RandomGesturesAndUndosWalkThroughTheTexts) {
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

TEST_F(DocumentGesturesTest, UnderAHostChangesGoThereAndUndoIsAskedForThere) {
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

TEST_F(DocumentGesturesTest, WhoIsToldOfAChangeSeesItInTheText) {
    document.setTextFromHost("# a\n");
    std::string seen;
    document.setHostLink(
        {[&](const TextEdit&, const QString&) { seen = document.text(); }, [] {}, [] {}});
    document.setText("# b\n", "Edit");
    EXPECT_EQ(seen, "# b\n");
}

TEST_F(DocumentGesturesTest, ARefusedChangeLeavesTheTextOfTheHost) {
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

TEST_F(DocumentGesturesTest, WhatAnotherComputedIsShownAndNothingIsComputedHere) {
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

TEST_F(DocumentGesturesTest, FilesAreReadAndWrittenByteForByte) {
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

TEST_F(DocumentGesturesTest, FilesThatCannotBeReadOrWrittenSaySo) {
    EXPECT_TRUE(document.open("/nowhere/at-all.al").contains("/nowhere/at-all.al"));
    EXPECT_TRUE(document.save("/nowhere/at-all.al").contains("/nowhere/at-all.al"));
    EXPECT_EQ(document.path(), QString());
}

} // namespace
} // namespace views
