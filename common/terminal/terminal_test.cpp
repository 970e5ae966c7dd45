#include "terminal/terminal.h"

#include <gtest/gtest.h>

namespace terminal {
namespace {

template <class Action> std::string errorsOf(Action action) {
    testing::internal::CaptureStderr();
    action();
    return testing::internal::GetCapturedStderr();
}

template <class Action> std::string outputOf(Action action) {
    testing::internal::CaptureStdout();
    action();
    return testing::internal::GetCapturedStdout();
}

constexpr std::string_view hostile = "a\033[2J\nb";

TEST(Terminal, EveryWayOfPrintingShowsWhatATerminalWouldObey) {
    EXPECT_EQ(errorsOf([] { complain(hostile); }), "a␛[2J\n    b\n");
    EXPECT_EQ(outputOf([] { say(hostile); }), "a␛[2J\n    b\n");
    EXPECT_EQ(outputOf([] { print(hostile); }), "a␛[2J\nb");
}

TEST(Terminal, BytesOfAFormatArePassedAsTheyAre) {
    EXPECT_EQ(outputOf([] { pass(hostile); }), hostile);
}

TEST(Terminal, ProgressTakesThePlaceOfTheLineBefore) {
    EXPECT_EQ(errorsOf([] {
                  Progress progress;
                  progress.show("10 of 20");
                  progress.show("\033c\n1");
              }),
              "\r10 of 20\r␛c␊1\r        \r");
}

} // namespace
} // namespace terminal
