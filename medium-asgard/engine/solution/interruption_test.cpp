// Who asks whether work is to end, and how often it is said that work goes on.
#include "solution/interruption.h"

#include <gtest/gtest.h>

using namespace solution;

TEST(Interruption, HoldsUntilTheNextBeginning) {
    bool ends = false;
    Options options;
    options.cancelled = [&ends] { return ends; };
    Interruption interruption(options);
    interruption.begin();
    interruption.poll(0);
    EXPECT_FALSE(interruption.isCancelled());
    ends = true;
    interruption.poll(0);
    ends = false;
    interruption.poll(0);
    EXPECT_TRUE(interruption.isCancelled());
    interruption.begin();
    EXPECT_FALSE(interruption.isCancelled());
}

TEST(Interruption, SaysEveryNowAndThenThatWorkGoesOn) {
    std::vector<double> told;
    Options options;
    options.working = [&told](double time) { told.push_back(time); };
    Interruption interruption(options);
    for (int i = 1; i <= 600; ++i)
        interruption.poll(i);
    EXPECT_EQ(told, (std::vector<double>{256, 512}));
}

TEST(Interruption, IsAskedByTheThreadThatBegan) {
    const Options options;
    Interruption interruption(options);
    interruption.begin();
    bool isOther = true;
    std::thread([&] { isOther = interruption.isCaller(); }).join();
    EXPECT_TRUE(interruption.isCaller());
    EXPECT_FALSE(isOther);
}
