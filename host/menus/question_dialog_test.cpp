#include "menus/question_dialog.h"

#include <gtest/gtest.h>

namespace menus {
namespace {

TEST(QuestionDialogTest, AllLinesThatWouldChangeAreNamed) {
    const auto words = [](const std::vector<ipc::ChangedLine>& changes) {
        return QuestionDialog::whichLines(changes).toStdString();
    };
    EXPECT_EQ(words({}), "");
    EXPECT_EQ(words({{3, "a", "b"}}), "Line 3 of its text:");
    EXPECT_EQ(words({{3, "a", "b"}, {7, "c", "d"}}), "Lines 3 and 7 of its text:");
    EXPECT_EQ(words({{3, "a", "b"}, {7, "c", "d"}, {9, "", "e"}}), "Lines 3, 7 and 9 of its text:");
    EXPECT_EQ(words({{3, "a", "b"}, {3, "", "c"}}), "Line 3 of its text:"); // one more after it
}

} // namespace
} // namespace menus
