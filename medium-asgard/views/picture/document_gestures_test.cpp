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
    document.setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
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

} // namespace
} // namespace views
