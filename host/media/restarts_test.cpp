#include "media/restarts.h"

#include <gtest/gtest.h>

namespace media {
namespace {

constexpr qint64 second = 1000, minute = 60 * second, hour = 60 * minute;

TEST(Restarts, ThreeInAMinute) {
    Restarts restarts(3, 10);
    EXPECT_EQ(restarts.told(0), "");
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(restarts.mayTry(i * second));
    EXPECT_FALSE(restarts.mayTry(59 * second));
    EXPECT_EQ(restarts.told(59 * second), "It was started again 3 times within a minute.");
    EXPECT_TRUE(restarts.mayTry(minute)); // the first of them is a minute ago
    EXPECT_FALSE(restarts.mayTry(minute));
}

// A process that dies every half minute is not started for ever.
TEST(Restarts, TenInAnHour) {
    Restarts restarts(3, 10);
    int tried = 0;
    for (qint64 now = 0; now < hour; now += 30 * second)
        tried += restarts.mayTry(now);
    EXPECT_EQ(tried, 10);
    EXPECT_EQ(restarts.told(hour - second), "It was started again 10 times within an hour.");
    EXPECT_TRUE(restarts.mayTry(hour));
    restarts.forget();
    EXPECT_TRUE(restarts.mayTry(hour));
    EXPECT_FALSE(Restarts(0, 10).mayTry(0));
}

} // namespace
} // namespace media
