#include "batch/accuracy_line.h"

#include <gtest/gtest.h>

namespace batch {
namespace {

std::string lineOf(double estimate, std::optional<double> until = {}) {
    simulation::Statistics statistics;
    statistics.errorEstimate = estimate;
    statistics.predictableUntil = until;
    statistics.movingSize = 2.4;
    return accuracyLine({.start = 1, .reached = 11, .accuracy = 1e-4}, statistics);
}

TEST(AccuracyLine, SaysSizeDurationAndWhatWasAsked) {
    EXPECT_EQ(lineOf(3e-6), "accurate to 3e-6 of 2.4 m over 10 s, asked 1e-4");
    EXPECT_EQ(lineOf(0), "accurate to rounding over 10 s, asked 1e-4");
}

TEST(AccuracyLine, SaysWhatIsNotReached) {
    EXPECT_EQ(lineOf(0.0021), "accurate to 2.1e-3 of 2.4 m only, over 10 s, asked 1e-4");
    EXPECT_EQ(lineOf(0.0021, 4), "accurate to 1e-4 of 2.4 m, as asked, only for the first 3 s of "
                                 "10 s; to 2.1e-3 after");
    EXPECT_EQ(lineOf(0.9, 4), "accurate to 1e-4 of 2.4 m, as asked, only for the first 3 s of "
                              "10 s; not predictable after that");
}

TEST(AccuracyLine, SaysThatTheErrorOfAMethodIsNotKnown) {
    ToldMotion motion{.start = 0, .reached = 1, .accuracy = 1e-4, .method = "rk4"};
    EXPECT_EQ(accuracyLine(motion, {}),
              "the error of rk4 is not estimated; only the method auto estimates its error");
    motion.fixedStep = 1e-5;
    EXPECT_EQ(accuracyLine(motion, {}), "the error of rk4 at steps of 1e-5 is not estimated; only "
                                        "the method auto estimates its error");
    motion.method = "auto";
    EXPECT_EQ(accuracyLine(motion, {}), "");
}

} // namespace
} // namespace batch
