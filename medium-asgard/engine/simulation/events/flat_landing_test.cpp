// Boxes that land on each other all but flat: an edge hits, and at once the edge on the other side.
// All is symmetrical about the plane y = 0, and what comes out is known by hand: elastic blows at
// the two ends of the patch in turn, for as long as there one closes.
#include "simulation/testing.h"

#include <array>
#include <cmath>

namespace simulation::testing {
namespace {

constexpr double base = 0.3; // how the first box is turned
const Vector across(std::cos(base), 0, -std::sin(base));
const Vector along(std::sin(base), 0, std::cos(base));

struct Landing {
    double tilt = 0, offset = 0, spin = 0; // at the hit
    bool isFixed = false;                  // the first
    double accuracy = 1e-4;
};

// Two unit cubes; the second flies along the first's normal and hits after half a second.
Result landing(const Landing& p) {
    SceneBuilder b(1, p.accuracy);
    scene::Body& first = b.box("first", {0, 0, 0}, {1, 1, 1});
    first.initialAttitude = geometry::fromRotationVector({0, base, 0});
    first.fixed = p.isFixed;
    scene::Body& second = b.box("second", -1.5 * across - p.offset * along, {1, 1, 1});
    second.initialAttitude = geometry::fromRotationVector({0, base + p.tilt - p.spin / 2, 0});
    second.initialVelocity = across;
    second.initialAngularVelocity = {0, p.spin, 0};
    return simulate(b.scene);
}

struct Cube { // in the plane: a cube of mass 1 has 1/6
    double velocity = 0, spin = 0, inverseMass = 1;
    void push(double impulse, double arm) {
        velocity += inverseMass * impulse;
        spin += 6 * inverseMass * impulse * arm;
    }
};

struct Expected {
    std::array<Cube, 2> cubes;
    std::size_t blows = 0;
};

Expected expected(const Landing& p) {
    Expected all{.cubes = {Cube{0, 0, p.isFixed ? 0.0 : 1.0}, Cube{1, p.spin, 1}}};
    Cube &first = all.cubes[0], &second = all.cubes[1];
    const std::array<double, 2> ends{std::max(-0.5, p.offset - 0.5), std::min(0.5, p.offset + 0.5)};
    std::size_t end = p.tilt > 0 ? 1 : 0;
    for (;; end = 1 - end) {
        const double arm = ends[end], other = arm - p.offset;
        const double closing =
            second.velocity + second.spin * arm - first.velocity - first.spin * other;
        if (closing <= 0)
            return all;
        const double impulse =
            2 * closing / (first.inverseMass * (1 + 6 * other * other) + 1 + 6 * arm * arm);
        first.push(impulse, other);
        second.push(-impulse, arm);
        ++all.blows;
    }
}

// Velocities in the plane; the rest is none.
void expectLike(const Result& result, const Expected& right, double error) {
    for (std::size_t body = 0; body < 2; ++body) {
        const BodyState end = result.motion->at(body, 1);
        const Cube& cube = right.cubes[body];
        EXPECT_LT(distance(end.velocity, cube.velocity * across), error);
        EXPECT_NEAR(end.angularVelocity.y(), cube.spin, error);
        EXPECT_LT(std::abs(end.angularVelocity.x()), 1e-12);
        EXPECT_LT(std::abs(end.angularVelocity.z()), 1e-12);
        EXPECT_LT(std::abs(end.velocity.y()), 1e-12);
        EXPECT_LT(std::abs(end.position.y()), 1e-12);
    }
}

class FlatLanding : public ::testing::TestWithParam<Landing> {};

TEST_P(FlatLanding, IsABlowAtEitherEnd) {
    for (double size = 1.3e-8; size < 1e-3; size *= 3.7)
        for (const double tilt : {size, -size}) {
            Landing p = GetParam();
            p.tilt = tilt;
            SCOPED_TRACE(tilt);
            const Result result = landing(p);
            const Expected right = expected(p);
            EXPECT_FALSE(result.motion->stop(1));
            EXPECT_EQ(result.motion->impacts().size(), right.blows);
            expectLike(result, right, 20 * size);
        }
}

// Less tilt than is resolved is none: one blow at the middle of the patch.
TEST_P(FlatLanding, IsOneBlowWhereItIsFlat) {
    for (const double tilt : {0.0, 1e-12, -1e-12, 1e-10, -1e-10, 1e-9, -1e-9}) {
        Landing p = GetParam();
        p.tilt = tilt;
        SCOPED_TRACE(tilt);
        const Result result = landing(p);
        EXPECT_FALSE(result.motion->stop(1));
        EXPECT_EQ(result.motion->impacts().size(), 1u);
        for (std::size_t body = 0; body < 2; ++body) {
            const BodyState end = result.motion->at(body, 1);
            EXPECT_LT(std::abs(end.angularVelocity.x()), 1e-12);
            EXPECT_LT(std::abs(end.angularVelocity.z()), 1e-12);
            EXPECT_LT(std::abs(end.velocity.y()), 1e-12);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cubes, FlatLanding,
    ::testing::Values(Landing{.offset = 0.2}, Landing{.offset = 0},
                      Landing{.offset = -0.3, .spin = 0.15}, Landing{.offset = 0, .spin = 0.15},
                      Landing{.offset = 0.2, .spin = -0.15}, Landing{.offset = 0.2, .spin = 1},
                      Landing{.offset = 0.2, .isFixed = true},
                      Landing{.offset = 0.2, .spin = 0.15, .isFixed = true},
                      Landing{.offset = 0, .spin = -0.15, .isFixed = true},
                      Landing{.offset = 0, .spin = 1, .isFixed = true},
                      Landing{.offset = 0.2, .spin = 1, .isFixed = true, .accuracy = 1e-7}));

} // namespace
} // namespace simulation::testing
