#include "contacts/stand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace simulation {
namespace {

// By whole degrees.
Stand onPoints(const std::vector<std::pair<int, bool>>& points) {
    Stand stand;
    stand.stands = true;
    for (const auto& [angle, carries] : points) {
        stand.angles.push_back(angle * std::numbers::pi / 180);
        stand.carries.push_back(carries ? 1 : 0);
    }
    return stand;
}

std::string arcsOf(const Stand& stand) {
    std::string text;
    for (const Stand::Arc& arc : stand.arcsBeside())
        text += std::to_string(std::lround(arc.from * 180 / std::numbers::pi)) + "+" +
                std::to_string(std::lround(arc.width * 180 / std::numbers::pi)) + " ";
    return text;
}

TEST(Stand, PointsComeIntoTheArcsOverWhichItWouldTip) {
    EXPECT_EQ(arcsOf(onPoints({{0, true}, {90, true}, {180, false}, {-90, false}})), "0+90 ");
    EXPECT_EQ(arcsOf(onPoints({{0, true}, {90, false}, {180, false}, {-90, false}})),
              "-90+90 0+90 ");
    EXPECT_EQ(arcsOf(onPoints({{0, false}, {90, false}, {180, true}, {-90, true}})), "180+90 ");
    EXPECT_EQ(arcsOf(onPoints({{0, true}, {90, false}, {180, true}, {-90, false}, {22, true}})),
              "0+22 ");
}

TEST(Stand, ItTipsEarlyWhereOneOrTwoPointsCarryAndTheRimBesideHasOthers) {
    EXPECT_TRUE(onPoints({{0, true}, {90, true}, {180, false}, {-90, false}}).tipsEarly());
    EXPECT_TRUE(onPoints({{0, true}, {90, false}, {180, false}, {-90, false}}).tipsEarly());
    EXPECT_FALSE(onPoints({{0, true}, {90, true}, {180, true}, {-90, false}}).tipsEarly());
    EXPECT_TRUE(onPoints({{0, true}, {1, true}, {2, true}, {-90, false}}).tipsEarly());
    EXPECT_FALSE(onPoints({{0, true}, {1, true}, {9, true}, {-90, false}}).tipsEarly());
    EXPECT_FALSE(onPoints({{0, false}, {90, false}, {180, false}, {-90, false}}).tipsEarly());
    Stand fine = onPoints({{0, true}, {0, true}, {180, false}});
    fine.angles[1] = 1.9e-3;
    EXPECT_FALSE(fine.tipsEarly());
    fine.angles[1] = 2.1e-3;
    EXPECT_TRUE(fine.tipsEarly());
}

} // namespace
} // namespace simulation
