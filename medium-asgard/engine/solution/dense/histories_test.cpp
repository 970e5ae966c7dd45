// What a step is kept in, and that nothing of it is lost.
#include "dense/dense_output.h"
#include "dense/histories.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace solution;

// A place, its velocity, and another unknown, whose numbers take all of a double.
struct Columns {
    double h = 0.3;
    Coefficients place{0.1, h * 0.7, 0.11, 1.0 / 3, -1.0 / 7, 1.0 / 90};
    Coefficients velocity{0.7}, other{0.9, -1.0 / 3, 0.2, 1.0 / 70};
    Columns() { differentiate(place, velocity, h); }
};

TEST(Histories, KeepAVelocityInItsPlace) {
    const Columns columns;
    History history(3);
    ASSERT_TRUE(history.takePairs({{0, 1}}));
    ASSERT_TRUE(History::tells(columns.place, columns.velocity, columns.h));
    const std::array<const Coefficients*, 3> all = {&columns.place, &columns.velocity,
                                                    &columns.other};
    history.append({.origin = 1, .until = 1.3, .scale = columns.h, .coefficients = 6, .others = 4},
                   all);
    EXPECT_EQ(history.row(0).size(), 10U);
    for (std::size_t c = 0; c < all.size(); ++c) {
        const CoefficientList read = history.piece(0, c).coefficients;
        for (std::size_t k = 0; k < maximumCoefficients; ++k)
            EXPECT_EQ(k < read.size() ? read[k] : 0, (*all[c])[k]) << c << ", " << k;
    }
}

TEST(Histories, KeepAVelocityByItselfThatIsNotTheDerivative) {
    Columns columns;
    columns.velocity[3] = std::nextafter(columns.velocity[3], 1);
    EXPECT_FALSE(History::tells(columns.place, columns.velocity, columns.h));
    History history(2);
    EXPECT_FALSE(history.takePairs({{0, 1}, {1, 0}}));
    EXPECT_TRUE(history.takePairs({{0, 1}}));
    EXPECT_FALSE(history.takePairs({{1, 0}}));
}

} // namespace
