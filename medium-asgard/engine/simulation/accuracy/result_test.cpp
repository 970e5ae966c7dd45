// Counts of work add up, each by itself.
#include "accuracy/result.h"

#include <gtest/gtest.h>

namespace simulation {
namespace {

TEST(WorkCounts, AddUpEachByItself) {
    WorkCounts sum{.steps = 1,
                   .rejectedSteps = 2,
                   .discardedSteps = 3,
                   .unconvergedSteps = 4,
                   .evaluations = 5,
                   .equationEvaluations = 6,
                   .factorisations = 7,
                   .pairTests = 8};
    const WorkCounts one = sum;
    sum += one;
    sum += one;
    sum -= one;
    EXPECT_EQ(sum.steps, 2u);
    EXPECT_EQ(sum.rejectedSteps, 4u);
    EXPECT_EQ(sum.discardedSteps, 6u);
    EXPECT_EQ(sum.unconvergedSteps, 8u);
    EXPECT_EQ(sum.evaluations, 10u);
    EXPECT_EQ(sum.equationEvaluations, 12u);
    EXPECT_EQ(sum.factorisations, 14u);
    EXPECT_EQ(sum.pairTests, 16u);
}

} // namespace
} // namespace simulation
