// Steps of undo of a text.
#include "workbench/history.h"

#include "text/difference.h"

#include <gtest/gtest.h>

namespace views {
namespace {

TEST(HistoryTest, StepsGoBackAndForthAndANewOneForgetsWhatWasUndone) {
    History history;
    std::string text = "a";
    const auto change = [&](const std::string& to, const char* label) {
        history.add(text, text::difference(text, to), label, {});
        text = to;
    };
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(history.undone(text, {}).text, "a");
    change("ab", "First");
    change("xab", "Second");
    EXPECT_EQ(history.undoLabel(), "Second");
    text = history.undone(text, {}).text;
    EXPECT_EQ(text, "ab");
    EXPECT_EQ(history.redoLabel(), "Second");
    text = history.undone(text, {}).text;
    EXPECT_EQ(text, "a");
    text = history.redone(text, {}).text;
    EXPECT_EQ(text, "ab");
    change("abc", "Third");
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.redone(text, {}).text, "abc");
    text = history.undone(text, {}).text;
    EXPECT_EQ(text, "ab");
    history.clear();
    EXPECT_FALSE(history.canUndo() || history.canRedo());
}

} // namespace
} // namespace views
