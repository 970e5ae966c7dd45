#include "complementarity/together.h"

#include "complementarity/solve.h"
#include "complementarity/testing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace complementarity {
namespace {

double violationOf(const Heap& heap, const Answer& answer) {
    return violation(heap.a, heap.b, heap.laws, answer);
}

} // namespace

// Few steps lead to last places.
TEST(Together, LeadsToForcesOfFacesAtTheirCentres) {
    std::mt19937_64 random(3);
    int tried = 0, found = 0, steps = 0;
    for (int round = 0; round < 40; ++round) {
        const Heap heap = heapOfFaces(random, 8, 4, 0.1 * (1 + round % 9));
        const Approach at = approachTogether(heap.a, heap.b, heap.laws);
        ++tried;
        found += violationOf(heap, endOf(heap.a, heap.b, heap.laws, at)) <= 1e-9;
        steps += at.steps;
    }
    EXPECT_GE(found, 0.8 * tried);
    EXPECT_LE(steps, 30 * tried);
}

// A blow on one body of many at rest: all other contacts have neither a force nor a rate.
TEST(Together, LeadsPastContactsWithoutForceAndRate) {
    std::mt19937_64 random(5);
    Heap heap = heapOfFaces(random, 8, 6, 0.3);
    heap.b.tail(heap.b.size() - 7).setZero();
    heap.a.topRightCorner(7, heap.b.size() - 7).setZero();
    heap.a.bottomLeftCorner(heap.b.size() - 7, 7).setZero();
    const Approach at = approachTogether(heap.a, heap.b, heap.laws);
    EXPECT_LE(violationOf(heap, endOf(heap.a, heap.b, heap.laws, at)), 1e-9);
    EXPECT_LE(at.steps, 45);
}

// Where no force changes a rate the path has no numbers.
TEST(Together, FindsNoForcesWhereTheyChangeNoRates) {
    std::mt19937_64 random(7);
    Heap heap = heapOfFaces(random, 4, 2, 0.5);
    heap.a.setZero();
    heap.b.setConstant(-1);
    const Approach at = approachTogether(heap.a, heap.b, heap.laws);
    EXPECT_EQ(violationOf(heap, endOf(heap.a, heap.b, heap.laws, at)), unbounded);
    EXPECT_FALSE(solve(heap.a, heap.b, heap.laws));
}

TEST(Together, TakesAsManyStepsInAllUnits) {
    std::mt19937_64 random(7);
    const Heap heap = heapOfFaces(random, 6, 4, 0.5);
    const Approach at = approachTogether(heap.a, heap.b, heap.laws);
    const double larger = std::ldexp(1, 30);
    const Approach heavy = approachTogether(heap.a / larger, heap.b, heap.laws);
    EXPECT_EQ(heavy.steps, at.steps);
    EXPECT_EQ(heavy.states, at.states);
    EXPECT_EQ(heavy.forces / larger, at.forces);
}

// Forces that faces share, with their centres: the search from centre to centre is spared.
TEST(Together, SparesTheSearchForCentres) {
    std::mt19937_64 random(13);
    int tried = 0, spared = 0;
    for (int round = 0; round < 20; ++round) {
        const Heap heap = heapOfFaces(random, 8, 8, 0.1 * (1 + round % 9));
        Work work;
        const auto answer = solve(heap.a, heap.b, heap.laws, {}, &work);
        ++tried;
        spared += answer && work.rounds == 0;
        EXPECT_TRUE(!answer || violationOf(heap, *answer) <= 1e-7);
    }
    EXPECT_GE(spared, 0.7 * tried);
}

// A slip follows its normal forces on the way.
TEST(Together, FollowsSlips) {
    std::mt19937_64 random(11);
    Heap heap = heapOfFaces(random, 4, 2, 0.2);
    Law& slip = heap.laws.back();
    slip.kind = Law::Kind::slip;
    slip.velocity = (Vector(3) << 0.6, -0.4, 0.3).finished();
    slip.beside = Vector::Zero(3);
    const Approach at = approachTogether(heap.a, heap.b, heap.laws);
    EXPECT_LE(violationOf(heap, endOf(heap.a, heap.b, heap.laws, at)), 1e-9);
}

} // namespace complementarity
