#include "media/value_watch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace media {
namespace {

TEST(ValueWatch, AReportOfAnOlderSetIsNotOneOfTheNewer) {
    ValueWatch watch;
    EXPECT_FALSE(watch.forNextProcess());
    const ValueWatch::Commands first = watch.watch({"a"});
    EXPECT_FALSE(first.end);
    ASSERT_TRUE(first.begin);
    const ValueWatch::Commands second = watch.watch({"b"});
    ASSERT_TRUE(second.end && second.begin);
    EXPECT_EQ(second.end->id, first.begin->id);
    EXPECT_NE(second.begin->id, first.begin->id);
    EXPECT_EQ(watch.told({first.begin->id, 0, {1}, {}}), ValueWatch::Heard::old);
    EXPECT_TRUE(watch.values().values.empty());
    EXPECT_EQ(watch.told({second.begin->id, 0, {2}, {}}), ValueWatch::Heard::taken);
    EXPECT_EQ(watch.values().values, std::vector<double>{2});
}

TEST(ValueWatch, TheNextProcessIsAskedTheSame) {
    ValueWatch watch;
    const auto begin = watch.watch({"a", "b"}).begin;
    EXPECT_FALSE(watch.watch({"a", "b"}).begin); // it is known already
    ASSERT_TRUE(watch.forNextProcess());
    EXPECT_EQ(watch.forNextProcess()->id, begin->id);
    EXPECT_EQ(watch.forNextProcess()->expressions, begin->expressions);
    const auto none = watch.watch({});
    EXPECT_TRUE(none.end);
    EXPECT_FALSE(none.begin);
    EXPECT_FALSE(watch.forNextProcess());
}

TEST(ValueWatch, AReportHasAValueForEachExpressionAndAFaultForEachOrNone) {
    ValueWatch watch;
    const ipc::Integer id = watch.watch({"a", "b"}).begin->id;
    EXPECT_EQ(watch.told({id, 0, {1}, {}}), ValueWatch::Heard::faulty);
    EXPECT_EQ(watch.told({id, 0, {1, 2}, {"no"}}), ValueWatch::Heard::faulty);
    EXPECT_EQ(watch.told({id, 0, {1, std::nan("")}, {"", "no"}}), ValueWatch::Heard::taken);
    EXPECT_EQ(watch.values().faults.at(1), "no");
}

TEST(ValueWatch, ManyExpressionsAreNoFlood) {
    ValueWatch watch;
    EXPECT_EQ(watch.watch(std::vector<std::string>(1000, "x")).begin->expressions.size(),
              ValueWatch::most);
}

} // namespace
} // namespace media
