#include "collision/turning_axis.h"

#include "collision/flying_body.h"

#include <gtest/gtest.h>

namespace collision {
namespace {

// A box turns down onto the edge of a rail, next to parallel to two edges of its own face: their
// common perpendicular with it is not the normal, and along it the gap is less.
TEST(TurningAxis, OfEdgesNextToParallelKeepsTheGapThatIsThere) {
    const auto rail = flyingBox({2, 0.1, 0.042856103787596536}, {0, -0.05, -0.09288890546751147});
    auto box = flyingBox({0.4734273903403411, 0.3618294696418505, 0.5439963754071959},
                         {-0.016767191564356083, 0.19706183577410569, -0.07255305162354346},
                         {-0.092197086804615372, 0.04607714885429566, -0.50725739721049268});
    box.attitude = Quaternion(0.99241018305490092, -0.12293379878307882, 0.0030280633643720934,
                              -0.00037485725422884721);
    box.spin = {-1.9502851141078732, -0.38303016717277932, 0.096287063960612859};
    const PartPair pair{.first = partMotion(rail, 0, 0), .second = partMotion(box, 0, 0)};
    WarmStart warm;
    const Separation now = pair.separationAt(0, warm);
    ASSERT_GT(now.gap, 1e-8);
    const double closing = contactOf(pair, 0, now).closingSpeed;
    ASSERT_GT(closing, 1e-3);
    const double apart = apartFor({.pair = pair,
                                   .normal = now.normal,
                                   .t = 0,
                                   .gap = now.gap,
                                   .left = 0.05,
                                   .firstWindow = 0.05});
    EXPECT_LE(apart, 1.01 * now.gap / closing);
}

} // namespace
} // namespace collision
