// On which branches do equations go on from given values? The mode as text.
#include "modes/mode.h"
#include "modes/testing.h"

#include <gtest/gtest.h>

using namespace solution;
using namespace solution::testing;

// Friction of at most 2 against a pull: it holds as long as the pull is less.
TEST(Mode, FrictionHoldsOrGivesWay) {
    EXPECT_EQ(Equations(Rates{{"v", "1-2*sign(v)"}}).modeAt({0}), "0: slides");
    EXPECT_EQ(Equations(Rates{{"v", "1-2*sign(v)"}}).ratesAt({0}), std::vector<double>{0});
    EXPECT_EQ(Equations(Rates{{"v", "3-2*sign(v)"}}).modeAt({0}), "0: +");
    EXPECT_EQ(Equations(Rates{{"v", "-3-2*sign(v)"}}).modeAt({0}), "0: -");
    EXPECT_EQ(Equations(Rates{{"v", "1-2*sign(v)"}}).modeAt({0.5}), "0: +");
}

TEST(Mode, TwoAreHeldAtOnce) {
    Equations two(Rates{{"u", "0.5*v-sign(u)"}, {"v", "0.5-sign(v)"}});
    EXPECT_EQ(two.modeAt({0, 0}), "0: slides, 1: slides");
    EXPECT_TRUE(two->sliding());
    EXPECT_EQ(two.modeAt({0, -1}), "0: slides, 1: -");
}

TEST(Mode, StairsAreOnAWholeNumber) {
    EXPECT_EQ(Equations(Rates{{"x", "floor(x)"}}).modeAt({2.5}), "0: floor 2");
    EXPECT_EQ(Equations(Rates{{"x", "1-ceil(x)"}}).modeAt({-2.5}), "0: ceil -2");
}

TEST(Mode, OfABranchThatIsNotTakenNothingIsAsked) {
    Equations guarded(Rates{{"x", "t>1 ? sign(x) : 2"}});
    EXPECT_EQ(guarded.modeAt({1}, 0).find("slides"), std::string::npos);
    EXPECT_FALSE(guarded->sliding());
}

TEST(Mode, IsAValueThatIsCopiedComparedAndTakenBack) {
    Equations two(Rates{{"u", "0.5*v-sign(u)"}, {"v", "0.5-sign(v)"}});
    (void)two.modeAt({0, 0});
    const Mode held = two->mode();
    (void)two.modeAt({1, 0});
    EXPECT_NE(two->mode(), held);
    (void)two.modeAt({0, 0});
    EXPECT_EQ(two->mode(), held);
    Mode changed = held;
    changed.coincident[0].push_back({1, -1});
    EXPECT_NE(changed, held);
    EXPECT_TRUE(changed.isCoincident(1));
    EXPECT_EQ(print(changed), "0: slides with -1, 1: slides");
    changed.release();
    EXPECT_FALSE(changed.isHeld());
    changed = held;
    EXPECT_EQ(changed, held);
}
