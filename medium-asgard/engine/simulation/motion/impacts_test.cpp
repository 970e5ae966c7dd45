// The list of impacts is in order, and what was taken of a record stays as it is.
#include "motion/impacts.h"

#include "motion/impact_order.h"

#include <gtest/gtest.h>

namespace simulation {
namespace {

Impact impactAt(double time, std::size_t first = 0) {
    return {.time = time,
            .first = first,
            .second = 3,
            .point = Vector(7, 8, 9),
            .normal = Vector::UnitY(),
            .impulse = -time};
}

std::vector<double> timesOf(const Impacts& impacts) {
    std::vector<double> times;
    for (const Impact& impact : impacts)
        times.push_back(impact.time);
    return times;
}
using Times = std::vector<double>;

TEST(Impacts, OfAPairAreFoundSinceATime) {
    ImpactRecord record;
    record.add(impactAt(2, 1), 2);
    EXPECT_TRUE(record.haveMet({1, 3}, 1.9));
    EXPECT_FALSE(record.haveMet({1, 3}, 2));
    EXPECT_FALSE(record.haveMet({0, 3}, 0));
}

// One that counts later waits among those that are found meanwhile.
TEST(Impacts, AreInOrderOfTime) {
    ImpactRecord record;
    record.add(impactAt(1), 1);
    record.add(impactAt(4.5), 1);
    for (int i = 2; i < 7; ++i)
        record.add(impactAt(i), i);
    const Impacts all = record.upTo(10);
    EXPECT_EQ(timesOf(all), (Times{1, 2, 3, 4, 4.5, 5, 6}));
    EXPECT_EQ(timesOf(record.upTo(5)), (Times{1, 2, 3, 4, 4.5, 5}));
    EXPECT_EQ(timesOf(record.upTo(3.5)), (Times{1, 2, 3, 3.5}));
    EXPECT_TRUE(all.isStrictlyOrdered());
}

TEST(Impacts, StayAsTheyWereTaken) {
    ImpactRecord record;
    record.add(impactAt(1), 1);
    const Impacts taken = record.upTo(1e9), copy = taken;
    record.add(impactAt(2), 2);
    EXPECT_EQ(copy.size(), 1u);
    EXPECT_EQ(taken.all().back().time, 1);
    EXPECT_EQ(record.upTo(1e9).size(), 2u);
}

// At one instant the least body comes first.
TEST(Impacts, ArePutInOrder) {
    ImpactRecord record;
    record.add(impactAt(1, 1), 1);
    record.add(impactAt(1, 0), 1);
    Impacts impacts = record.upTo(2);
    EXPECT_FALSE(impacts.isStrictlyOrdered());
    EXPECT_EQ(impacts.all()[0].first, 1u);
    putInOrder(impacts, [](std::size_t body) { return body == 3; });
    EXPECT_EQ(impacts.all()[0].first, 0u);
    EXPECT_EQ(impacts.size(), 2u);
}

} // namespace
} // namespace simulation
