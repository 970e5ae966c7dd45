// Which steps are believed?
#include "modes/testing.h"
#include "oversight/oversight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

using namespace solution;
using namespace solution::testing;

namespace {

// A step of x in which nothing happens, from `from` to `to`.
struct Still {
    double from, to, x;
    bool isImplicit = false;
    bool isWatched = true;

    std::optional<double> verdictOf(const Rates& rates) {
        Equations equations(rates);
        (void)equations.modeAt({x}, from);
        Oversight oversight(
            {.start = 0, .tolerance = 1e-6, .isWatched = isWatched, .isFixed = false});
        ErrorControl control({UnknownScale{}}, 1e-6);
        const std::vector<double> y = {x};
        control.observe(y);
        control.prepare(y, to - from);
        const Coefficients columns[] = {{x}};
        const std::optional<Violation> found;
        const ReviewedStep step{{columns, from, to - from, to}, found, false, isImplicit, 1e-12};
        return oversight.verdict(step, *equations, control, evaluations);
    }
    std::size_t evaluations = 0;
};

} // namespace

TEST(Oversight, AStepThatTheRatesAgreeWithIsBelieved) {
    EXPECT_FALSE((Still{50, 70, 1}.verdictOf({{"x", "0*x"}})));
    EXPECT_FALSE((Still{50, 70, 1}.verdictOf({{"x", "exp(-((t-90)/0.01)^2)"}})));
}

// However narrow the push and long the step.
TEST(Oversight, APushWithinAStepIsLookedAtInItsMiddle) {
    for (const char* const width : {"1", "0.01", "1e-6"}) {
        const std::string rate = std::string("exp(-((t-60)/") + width + ")^2)";
        const auto at = Still{50, 70, 1}.verdictOf({{"x", rate}});
        ASSERT_TRUE(at) << width;
        EXPECT_NEAR(*at, 60, 4) << width; // or where it begins to show
    }
    const auto at = Still{50, 70, 1, true}.verdictOf({{"x", "exp(-((t-60)/0.01)^2)"}});
    ASSERT_TRUE(at);
    EXPECT_NEAR(*at, 60, 0.1);
}

TEST(Oversight, EquationsThatCannotPeakCostNoEvaluation) {
    Still step{50, 70, 1};
    EXPECT_FALSE(step.verdictOf({{"x", "sin(t)-x"}}));
    EXPECT_EQ(step.evaluations, 0u);
}

TEST(Oversight, NothingIsWatchedWhereItWasNotAskedFor) {
    Still step{50, 70, 1, false, false};
    EXPECT_FALSE(step.verdictOf({{"x", "exp(-((t-60)/0.01)^2)"}}));
}

// The polynomial crosses x = 0 at 60, and the rates there lead back to x > 0.
TEST(Oversight, ACrossingThatTheRatesContradictIsNotBelieved) {
    Equations equations(Rates{{"x", "x>0 ? 1 : 2"}});
    (void)equations.modeAt({1}, 50);
    Oversight oversight({.start = 0, .tolerance = 1e-6, .isWatched = true, .isFixed = false});
    ErrorControl control({UnknownScale{}}, 1e-6);
    const Coefficients down[] = {{1, -2}};
    const std::optional<Violation> found = Violation{.time = 60, .watches = {0}};
    std::size_t evaluations = 0;
    const ReviewedStep step{{down, 50, 20, 60}, found, false, false, 1e-12};
    for (int k = 0; k < 16; ++k)
        EXPECT_EQ(oversight.verdict(step, *equations, control, evaluations), 50);
    EXPECT_FALSE(oversight.verdict(step, *equations, control, evaluations)); // it lost patience
}
