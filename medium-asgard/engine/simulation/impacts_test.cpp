// The list of impacts: those on lines take their place among the others, and what was taken of a
// record stays as it is.
#include "simulation/impacts.h"

#include "simulation/impact_order.h"

#include <gtest/gtest.h>

#include <array>

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

std::shared_ptr<const ImpactLine> line() {
    return std::make_shared<ImpactLine>(
        ImpactLine{.axis = 1, .ofPair = {impactAt(0, 0), impactAt(0, 1)}});
}

std::vector<double> timesOf(const Impacts& impacts) {
    std::vector<double> times;
    for (const Impact& impact : impacts)
        times.push_back(impact.time);
    return times;
}
using Times = std::vector<double>;

TEST(Impacts, OnALineAreWrittenOut) {
    ImpactRecord record;
    record.add(line(), std::array{LineImpact{.time = 2, .impulse = 5, .place = 4, .pair = 1}});
    const Impacts impacts = record.upTo(10);
    ASSERT_EQ(impacts.size(), 1u);
    const Impact& impact = impacts.all()[0];
    EXPECT_EQ(impact.time, 2);
    EXPECT_EQ(impact.impulse, 5);
    EXPECT_EQ(impact.first, 1u);
    EXPECT_EQ(impact.second, 3u);
    EXPECT_EQ(impact.point, Vector(7, 4, 9));
    EXPECT_EQ(impact.normal, Vector::UnitY());
    EXPECT_TRUE(record.haveMet({1, 3}, 1.9));
    EXPECT_FALSE(record.haveMet({1, 3}, 2));
    EXPECT_FALSE(record.haveMet({0, 3}, 0));
    EXPECT_TRUE(record.hasOnLineAt(2));
    EXPECT_FALSE(record.hasOnLineAt(1));
}

// One that counts later waits among those that are found meanwhile.
TEST(Impacts, AreInOrderOfTime) {
    ImpactRecord record;
    const auto first = line();
    record.add(impactAt(1), 1);
    record.add(impactAt(4.5), 1);
    std::vector<LineImpact> onLine;
    for (int i = 2; i < 7; ++i)
        onLine.push_back({.time = double(i), .impulse = 1, .place = 0, .pair = 0});
    record.add(first, onLine);
    record.add(impactAt(7), 7);
    record.add(line(), std::array{LineImpact{.time = 8, .impulse = 1, .place = 0, .pair = 0}});
    record.add(impactAt(9), 9);
    const Impacts all = record.upTo(10), some = record.upTo(5);
    EXPECT_EQ(timesOf(all), (Times{1, 2, 3, 4, 4.5, 5, 6, 7, 8, 9}));
    EXPECT_EQ(timesOf(some), (Times{1, 2, 3, 4, 4.5, 5}));
    EXPECT_EQ(timesOf(record.upTo(3.5)), (Times{1, 2, 3, 3.5}));
    EXPECT_TRUE(all.isStrictlyOrdered());
    std::size_t count = 0;
    all.forEachPair([&](std::size_t, std::size_t, std::size_t times) { count += times; });
    EXPECT_EQ(count, all.size());
}

TEST(Impacts, StayAsTheyWereTaken) {
    ImpactRecord record;
    const auto one = line();
    for (int i = 0; i < 3000; ++i) {
        record.add(one,
                   std::array{LineImpact{.time = double(i), .impulse = 1, .place = 0, .pair = 0}});
        if (i % 700 == 0) {
            const Impacts taken = record.upTo(1e9), copy = taken;
            record.add(
                one, std::array{LineImpact{.time = i + 0.5, .impulse = 1, .place = 0, .pair = 1}});
            ASSERT_EQ(copy.all().size(), taken.size());
            ASSERT_EQ(copy.all().back().time, i);
        }
    }
    EXPECT_EQ(record.upTo(1e9).size(), 3005u);
}

// At one instant the least body comes first, on a line or not.
TEST(Impacts, ArePutInOrder) {
    ImpactRecord record;
    record.add(line(), std::array{LineImpact{.time = 1, .impulse = 1, .place = 0, .pair = 1}});
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
