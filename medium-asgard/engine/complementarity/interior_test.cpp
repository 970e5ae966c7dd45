#include "complementarity/interior.h"
#include "complementarity/testing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace complementarity {
namespace {

double violationOf(const Heap& heap, const Approach& at) {
    const Answer answer{at.forces, heap.a * at.forces + heap.b, at.states};
    return violation(heap.a, heap.b, heap.laws, answer);
}

// A few bodies with many contacts share their loads in many ways. Of friction along such normals
// as no bodies have, some have no forces.
TEST(Interior, LeadsToForcesThatManyContactsShare) {
    std::mt19937_64 random(3);
    int tried = 0, found = 0, steps = 0;
    for (int round = 0; round < 50; ++round)
        for (const double friction : {0.1, 0.3, 0.8}) {
            const Heap heap = randomHeap(random, 4, 24, friction);
            const Approach at = approach(heap.a, heap.b, heap.laws);
            ++tried;
            found += violationOf(heap, at) <= 1e-5;
            steps += at.steps;
        }
    EXPECT_GE(found, 0.95 * tried);
    EXPECT_LE(steps, 20 * tried);
}

// Masses are as they are, or a billion times as large: no number has a size of its own.
TEST(Interior, TakesAsManyStepsInAllUnits) {
    std::mt19937_64 random(5);
    const Heap heap = randomHeap(random, 6, 12, 0.5);
    const Approach at = approach(heap.a, heap.b, heap.laws);
    const double larger = std::ldexp(1, 30);
    const Approach heavy = approach(heap.a / larger, heap.b, heap.laws);
    EXPECT_EQ(heavy.steps, at.steps);
    EXPECT_EQ(heavy.states, at.states);
    EXPECT_EQ(heavy.forces / larger, at.forces);
}

TEST(Interior, KeepsForcesOfIntervalsBetweenTheirEnds) {
    Laws laws;
    addInterval(laws, -2, 3);
    addInterval(laws, -2, 3);
    addInterval(laws, -2, 3);
    addEquality(laws);
    const Approach at =
        approach(Matrix::Identity(4, 4), (Vector(4) << 5, -5, 1, 7).finished(), laws);
    EXPECT_EQ(at.states, (States{State::low, State::high, State::inside, State::inside}));
    EXPECT_LE((at.forces - (Vector(4) << -2, 3, -1, -7).finished()).cwiseAbs().maxCoeff(), 1e-8);
}

} // namespace
} // namespace complementarity
