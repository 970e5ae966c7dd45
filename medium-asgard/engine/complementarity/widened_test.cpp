#include "complementarity/widened.h"

#include "complementarity/centres.h"
#include "complementarity/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace complementarity {
namespace {

double sizeOf(const Vector& b) { return b.cwiseAbs().maxCoeff(); }

} // namespace

TEST(Widened, SettlesAtCoulombsLaw) {
    std::mt19937_64 random(5);
    int settled = 0;
    for (int heap = 0; heap < 40; ++heap) {
        const Heap of = randomHeap(random, 6, 12, 0.1 * (1 + heap % 9));
        Widened widened(of.a, of.b, of.laws);
        for (int problems = 0; problems < 60 && !(widened.change() < 1e-8); ++problems)
            widened.advance();
        if (!(widened.change() < 1e-8))
            continue;
        ++settled;
        EXPECT_LT(violation(of.a, of.b, of.laws, widened.answer()), 1e-5) << heap;
    }
    EXPECT_GE(settled, 38);
}

// The centres may go anywhere: no surfaces that approach, no force that pulls, friction within its
// bound, and no energy from nothing.
TEST(Widened, ABlowOnManyFacesHasAnAnswer) {
    std::mt19937_64 random(7);
    constexpr double some = 1e-6;
    int without = 0;
    for (int heap = 0; heap < 40; ++heap) {
        const Heap of = heapOfFaces(random, 8, 12, 0.1 * (1 + heap % 9));
        const auto answer = solveBesideCentres(of.a, of.b, of.laws);
        without += answer ? 0 : 1;
        if (!answer)
            continue;
        const Vector rates = of.a * answer->forces + of.b;
        const double most = answer->forces.cwiseAbs().maxCoeff();
        for (const Law& law : of.laws) {
            if (law.kind == Law::Kind::interval) {
                EXPECT_GT(answer->forces[law.first], -some * most) << heap;
                EXPECT_GT(rates[law.first], -some * sizeOf(of.b)) << heap;
                continue;
            }
            const Vector force = answer->forces.segment(law.first, law.rows);
            EXPECT_LT(force.head(2).norm(), radiusOf(law, answer->forces) + some * most) << heap;
        }
        const double energy =
            answer->forces.dot(of.b) + answer->forces.dot(of.a * answer->forces) / 2;
        EXPECT_LT(energy, some * most * sizeOf(of.b)) << heap;
    }
    EXPECT_LE(without, 1); // slips that find no end
}

// A body that two walls crush: no impulses part it from both.
TEST(Widened, NothingPartsWhatIsCrushed) {
    Laws laws;
    addUnilateral(laws);
    addUnilateral(laws);
    addFriction(laws, 2, 0, 0.5);
    Matrix a = Matrix::Identity(4, 4);
    a(0, 1) = a(1, 0) = -1;
    EXPECT_FALSE(solveBesideCentres(a, Vector::Constant(4, -1), laws).has_value());
    a(0, 1) = a(1, 0) = -0.9;
    EXPECT_TRUE(solveBesideCentres(a, Vector::Constant(4, -1), laws).has_value());
}

} // namespace complementarity
