// Impulses of what touches at one instant, worked out by hand: a bar of mass 1, 2 long, that falls
// onto what cannot give way.
#include "events/cluster_impulses.h"

#include "events/last_hops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace simulation {
namespace {

constexpr double inertia = 1.0 / 3; // about its centre

class Bar : public ::testing::Test {
protected:
    // It lies along x, with its ends over two corners of one patch.
    explicit Bar(double restitution = 1) {
        bodies.resize(2);
        bodies[0].inverseMass = 1;
        bodies[0].inverseInertia = Matrix(Vector(0, 1 / inertia, 1 / inertia).asDiagonal());
        bodies[0].velocity = {0, -1, 0};
        cluster.bodies = {5, 2};
        physics::ImpactContact contact{.first = 0, .second = 1, .restitution = restitution};
        contact.normal = Vector::UnitY();
        cluster.contacts = {contact};
        cluster.radii = {{0, 0}};
        for (const double end : {-1, 1}) {
            contact.point = {end, 0, 0};
            cluster.corners.push_back(contact);
            cluster.contactOf.push_back(0);
        }
    }
    using Matrix = geometry::Matrix;
    [[nodiscard]] double end(const physics::ImpactResult& result, double x) const {
        return (result.bodies[0].velocity + result.bodies[0].angularVelocity.cross(Vector(x, 0, 0)))
            .y();
    }
    ImpactCluster cluster;
    std::vector<physics::ImpactBody> bodies;
};

TEST_F(Bar, ThatFallsFlatBouncesFlat) {
    const auto result = resolve(cluster, bodies);
    EXPECT_EQ(result.bodies[0].velocity, Vector(0, 1, 0));
    EXPECT_EQ(result.bodies[0].angularVelocity, Vector(0, 0, 0));
    ASSERT_EQ(result.impulses.size(), 1u);
    EXPECT_EQ(result.impulses[0].impulse, 2);
}

// One end comes at 4, the other at 0.5: the blow is at the first.
TEST_F(Bar, OfWhichOneEndIsMuchFasterIsHitThere) {
    bodies[0].velocity = {0, -2.25, 0};
    bodies[0].angularVelocity = {0, 0, -1.75};
    aimAtFastest(cluster, bodies);
    EXPECT_EQ(cluster.contacts[0].point, Vector(1, 0, 0));
    bodies[0].angularVelocity = {0, 0, -0.5}; // 2.75 and 1.75: together
    cluster.contacts[0].point = {0, 0, 0};
    aimAtFastest(cluster, bodies);
    EXPECT_EQ(cluster.contacts[0].point, Vector(0, 0, 0));
}

TEST_F(Bar, WithoutBounceLiesDown) {
    cluster.contacts[0].restitution = 0;
    bodies[0].angularVelocity = {0, 0, 0.5};
    const auto result = resolve(cluster, bodies);
    EXPECT_NEAR(end(result, -1), 0, 1e-15);
    EXPECT_NEAR(end(result, 1), 0, 1e-15);
    double sum = 0; // of impulses by contact: all that it came with
    for (const auto& given : result.impulses)
        sum += given.impulse;
    EXPECT_NEAR(sum, 1, 1e-15);
}

// The centre's blow leaves one end sinking in: then the ends take part, and become contacts.
TEST_F(Bar, ThatTurnsSinksInNowhere) {
    bodies[0].angularVelocity = {0, 0, 3};
    const auto result = resolve(cluster, bodies);
    EXPECT_GE(end(result, -1), -1e-12);
    EXPECT_GE(end(result, 1), -1e-12);
    EXPECT_GT(cluster.contacts.size(), 1u);
    const double before = 0.5 * (1 + inertia * 9);
    const double after = 0.5 * (result.bodies[0].velocity.squaredNorm() +
                                inertia * result.bodies[0].angularVelocity.squaredNorm());
    EXPECT_NEAR(after, before, 1e-12); // elastic
}

TEST_F(Bar, SinksInWhereItsPointApproachesByMoreThanRounding) {
    EXPECT_TRUE(sinksIn(cluster.corners[0], bodies));
    bodies[0].velocity = {1, -1e-10, 0};
    EXPECT_FALSE(sinksIn(cluster.corners[0], bodies));
    EXPECT_DOUBLE_EQ(closingAt(cluster.corners[0], bodies).rate, -1e-10);
}

// The coarsest of: the height of the run, of what the search may miss, of the footing, of places.
TEST(LastHops, AreLowerThanTheCoarsestScale) {
    EXPECT_DOUBLE_EQ(lastHopHeight(1e-7, 2, 1), 2e-7);
    EXPECT_DOUBLE_EQ(lastHopHeight(1e-12, 2, 1), 2 * resolution::leastHop);
    EXPECT_DOUBLE_EQ(lastHopHeight(1e-7, 2, 1, 1e-6), 4e-6);
    EXPECT_DOUBLE_EQ(lastHopHeight(1e-9, 1, 1e6), 1e6 * resolution::ofMotion);
}

} // namespace
} // namespace simulation
