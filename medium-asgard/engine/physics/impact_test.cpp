#include "physics/impact.h"

#include "collision/broad_phase.h"
#include "collision/flying_body.h"
#include "collision/time_of_impact.h"
#include "geometry/mass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace physics {
namespace {

using collision::FlyingBody;
using collision::flyingBox;
using collision::flyingSphere;
using geometry::Quaternion;

// A world of bodies in free flight, moved from impact to impact: what the simulation does, without
// equations. Spin stays constant in flight: for spheres and cubes it does.
class World {
public:
    struct Member {
        FlyingBody body;
        double mass = 1; // infinity: fixed
        Matrix inertia = Matrix::Identity();
        double restitution = 1;
    };

    void add(const FlyingBody& body, double mass, double restitution = 1) {
        const auto m = geometry::scaledToMass(geometry::massProperties(body.form, 1), mass);
        members_.push_back({body, mass, m.inertia, restitution});
    }
    void addFixed(const FlyingBody& body) {
        members_.push_back({body, std::numeric_limits<double>::infinity(), Matrix::Identity(), 1});
    }
    [[nodiscard]] const FlyingBody& body(std::size_t i) const { return members_[i].body; }

    // Runs to the time; returns the number of impulses.
    std::size_t run(double until) {
        std::size_t count = 0;
        while (const auto t = nextHit(until))
            count += impactAt(*t);
        for (Member& m : members_)
            m.body.moveTo(until);
        now_ = until;
        return count;
    }
    [[nodiscard]] double energy() const {
        double sum = 0;
        for (const Member& m : members_)
            if (std::isfinite(m.mass))
                sum += m.mass * m.body.velocity.squaredNorm() / 2 +
                       m.body.spin.dot(worldInertia(m) * m.body.spin) / 2;
        return sum;
    }

private:
    static Matrix worldInertia(const Member& m) {
        const Matrix r = m.body.attitude.toRotationMatrix();
        return r * m.inertia * r.transpose();
    }
    [[nodiscard]] bool mayMeet(std::size_t i, std::size_t j) const {
        return std::isfinite(members_[i].mass) || std::isfinite(members_[j].mass);
    }

    std::optional<double> nextHit(double until) {
        std::optional<double> first;
        for (std::size_t i = 0; i < members_.size(); ++i)
            for (std::size_t j = i + 1; j < members_.size(); ++j) {
                if (!mayMeet(i, j))
                    continue;
                const auto e = collision::timeOfImpact(members_[i].body, members_[j].body,
                                                       {now_, first.value_or(until)});
                if (e.hit && !e.hit->pressing)
                    first = e.hit->time;
            }
        return first;
    }

    std::size_t impactAt(double t) {
        std::vector<ImpactBody> bodies;
        for (Member& m : members_) {
            m.body.moveTo(t);
            ImpactBody b;
            b.inverseMass = 1 / m.mass;
            if (std::isfinite(m.mass))
                b.inverseInertia = worldInertia(m).inverse();
            b.centre = m.body.position;
            b.velocity = m.body.velocity;
            b.angularVelocity = m.body.spin;
            bodies.push_back(b);
        }
        now_ = t;
        std::vector<ImpactContact> contacts;
        for (std::size_t i = 0; i < members_.size(); ++i)
            for (std::size_t j = i + 1; j < members_.size(); ++j)
                if (mayMeet(i, j))
                    for (const auto& c :
                         collision::contactsAt(members_[i].body, members_[j].body, t, 1e-11))
                        contacts.push_back(
                            {i, j, c.point, c.normal,
                             std::min(members_[i].restitution, members_[j].restitution)});
        const ImpactResult result = resolveImpact(bodies, contacts);
        EXPECT_TRUE(result.settled);
        EXPECT_FALSE(result.impulses.empty()) << "a hit without an impulse at " << t;
        for (std::size_t i = 0; i < members_.size(); ++i) {
            members_[i].body.velocity = result.bodies[i].velocity;
            members_[i].body.spin = result.bodies[i].angularVelocity;
        }
        return result.impulses.size();
    }

    std::vector<Member> members_;
    double now_ = 0;
};

// Scenes of the reference set are named by their numbers.

// Galperin: the number of impacts of masses 1 and 100^n with a wall is the first n + 1 digits of
// pi.
TEST(Impact, CountsTheDigitsOfPi) { // d04
    for (const auto& [mass, count] :
         {std::pair{1.0, 3u}, {100.0, 31u}, {1e4, 314u}, {1e6, 3141u}}) {
        World world;
        world.addFixed(flyingBox({1, 4, 4}, {-0.5, 0, 0}));
        world.add(flyingSphere(0.5, {2, 0, 0}), 1);
        world.add(flyingSphere(0.5, {5, 0, 0}, {-1, 0, 0}), mass);
        const double before = world.energy();
        EXPECT_EQ(world.run(1000), count);
        EXPECT_NEAR(world.energy(), before, 1e-11 * before);
    }
}

TEST(Impact, PassesAlongARowOfTouchingSpheres) { // d03
    World world;
    world.add(flyingSphere(0.5, {-3, 0, 0}, {2, 0, 0}), 1);
    for (int i = 0; i < 4; ++i)
        world.add(flyingSphere(0.5, {static_cast<double>(i), 0, 0}), 1);
    EXPECT_EQ(world.run(2), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT(world.body(i).velocity.norm(), 1e-15);
    EXPECT_NEAR(world.body(4).position.x(), 5, 1e-14);
    EXPECT_NEAR(world.body(0).position.x(), -1, 1e-14);
}

TEST(Impact, OfASymmetricPinchIsSymmetric) { // d12b
    World world;
    world.add(flyingSphere(0.5, {-2, 0, 0}, {1, 0, 0}), 1);
    world.add(flyingSphere(0.5, {0, 0, 0}), 1);
    world.add(flyingSphere(0.5, {2, 0, 0}, {-1, 0, 0}), 1);
    EXPECT_EQ(world.run(3), 2u);
    EXPECT_LT((world.body(0).velocity - Vector(-1, 0, 0)).norm(), 1e-15);
    EXPECT_LT(world.body(1).velocity.norm(), 1e-15);
    EXPECT_LT((world.body(2).velocity - Vector(1, 0, 0)).norm(), 1e-15);
}

TEST(Impact, InACornerReversesBothComponents) { // d12c
    World world;
    world.addFixed(flyingBox({1, 10, 10}, {-0.5, 4, 0}));
    world.addFixed(flyingBox({10, 1, 10}, {4, -0.5, 0}));
    world.add(flyingSphere(0.5, {3.5, 2.5, 0}, {-3, -2, 0.25}), 1);
    EXPECT_EQ(world.run(3), 2u);
    EXPECT_LT((world.body(2).position - Vector(6.5, 4.5, 0.75)).norm(), 1e-14);
    EXPECT_LT((world.body(2).velocity - Vector(3, 2, 0.25)).norm(), 1e-14);
}

TEST(Impact, OfAGlancingSphereLeavesItsSpin) {
    World world;
    auto a = flyingSphere(0.5, {-3, 0.6, 0}, {2, 0, 0});
    a.spin = {1, 2, 3};
    world.add(a, 1);
    world.add(flyingSphere(0.5, {0, 0, 0}), 3);
    EXPECT_EQ(world.run(3), 1u);
    EXPECT_EQ(world.body(0).spin, Vector(1, 2, 3));
    EXPECT_EQ(world.body(1).spin, Vector(0, 0, 0));
}

TEST(Impact, OfASphereOnTheCornerOfABox) { // d07: impulse and velocities
    World world;
    world.add(flyingSphere(0.3, {4.05, 2.47, -1.73}, {-3, -2, 1}), 0.5);
    auto box = flyingBox({2, 1, 1.5}, {0, 0, 0});
    box.attitude = Quaternion(0.8, 0, 0.6, 0);
    world.add(box, 3);
    EXPECT_EQ(world.run(1), 1u);
    EXPECT_LT((world.body(0).velocity -
               Vector(2.2293585527009716, 0.26358347479849226, -0.03526629842539176))
                  .norm(),
              1e-12);
    EXPECT_LT((world.body(1).velocity -
               Vector(-0.8715597587834952, -0.3772639124664154, 0.17254438307089862))
                  .norm(),
              1e-12);
}

TEST(Impact, OfACubeOnItsCorner) { // d08
    World world;
    world.addFixed(flyingBox({100, 2, 100}, {0, -1, 0}));
    auto cube = flyingBox({1, 1, 1}, {0, 1.5, 0});
    cube.attitude = Quaternion(0.8, 0.36, 0.48, 0);
    cube.acceleration = {0, -10, 0};
    world.add(cube, 1);
    EXPECT_EQ(world.run(0.5), 1u);
    EXPECT_LT((world.body(1).velocity - Vector(0, 0.39969756114570215, 0)).norm(), 1e-12);
    EXPECT_LT((world.body(1).spin - Vector(-7.6459717465823145, 0, -1.892054025425454)).norm(),
              1e-12);
}

TEST(Impact, OfABoxLandingFlatMakesNoSpin) { // d08b
    World world;
    world.addFixed(flyingBox({100, 2, 100}, {0, -1, 0}));
    auto box = flyingBox({2, 1, 1.5}, {0, 1.75, 0});
    box.acceleration = {0, -10, 0};
    world.add(box, 3);
    EXPECT_EQ(world.run(0.95), 1u);
    EXPECT_LT(world.body(1).spin.norm(), 1e-13);
    EXPECT_LT((world.body(1).position - Vector(0, 1.7375, 0)).norm(), 1e-13);
}

TEST(Impact, OfARodOnASphere) { // d11
    World world;
    auto rod = flyingBox({2, 0.1, 0.1}, {0, 0, 0});
    rod.spin = {0, 0, 3};
    world.add(rod, 1);
    world.add(flyingSphere(0.2, {0.5, 0.5, 0}), 0.3);
    EXPECT_EQ(world.run(0.6), 1u);
    EXPECT_NEAR(world.body(0).spin.z(), 1.607837360047142, 1e-12);
    EXPECT_LT((world.body(1).position - Vector(0.05758033883919826, 1.4800703477333834, 0)).norm(),
              1e-12);
}

TEST(Impact, BouncesAThousandTimesWithoutDrift) { // d05
    World world;
    world.addFixed(flyingBox({4000, 1, 4000}, {0, -0.5, 0}));
    auto ball = flyingSphere(0.5, {0, 5.5, 0});
    ball.acceleration = {0, -10, 0};
    world.add(ball, 1);
    EXPECT_EQ(world.run(2000), 1000u);
    EXPECT_LT((world.body(1).position - Vector(0, 5.5, 0)).norm(), 1e-8);
}

// Sinai's billiard: round-off may grow as the motion's own sensitivity lets it, and no faster.
TEST(Impact, InABilliardErrsByNoMoreThanItsSensitivity) { // d13
    World world;
    world.add(flyingSphere(0.25, {-1.5, 0.375, 0}, {0.8125, 0.5, 0}), 1);
    world.addFixed(flyingSphere(1, {0, 0, 0}));
    for (double x : {-2.5, 2.5})
        world.addFixed(flyingBox({1, 6, 4}, {x, 0, 0}));
    for (double y : {-2.5, 2.5})
        world.addFixed(flyingBox({6, 1, 4}, {0, y, 0}));
    world.run(1.01);
    EXPECT_LT(
        (world.body(0).position - Vector(-1.053867769201994463, 1.1012278237358780639, 0)).norm(),
        1e-14);
    world.run(5.01);
    EXPECT_LT(
        (world.body(0).position - Vector(-1.7185538483723527075, 1.0474800556774191909, 0)).norm(),
        1e-12);
    world.run(8.01);
    EXPECT_LT((world.body(0).position - Vector(-0.051470867612528376957, 1.3874436290896630489, 0))
                  .norm(),
              1e-10);
}

// Momentum, angular momentum and, at restitution 1, energy.
TEST(Impact, ConservesWhatItMustToRoundOff) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector(normal(random), normal(random), normal(random)); };
    for (int trial = 0; trial < 1000; ++trial) {
        std::vector<ImpactBody> bodies(4);
        for (ImpactBody& b : bodies) {
            Matrix half;
            half << vector(), vector(), vector();
            b.inverseMass = std::exp(normal(random));
            b.inverseInertia = half * half.transpose() + 0.1 * Matrix::Identity();
            b.centre = vector();
            b.velocity = vector();
            b.angularVelocity = vector();
        }
        std::vector<ImpactContact> contacts;
        const bool elastic = trial % 2;
        for (std::size_t i = 0; i < 1 + random() % 5; ++i)
            contacts.push_back({random() % 2, 2 + random() % 2, vector(), vector().normalized(),
                                elastic ? 1.0 : 0.3});
        const auto sum = [](const std::vector<ImpactBody>& all) {
            Vector p = Vector::Zero(), l = Vector::Zero();
            double e = 0;
            for (const ImpactBody& b : all) {
                const Vector momentum = b.velocity / b.inverseMass;
                const Vector spin = b.inverseInertia.inverse() * b.angularVelocity;
                p += momentum;
                l += spin + b.centre.cross(momentum);
                e += (momentum.dot(b.velocity) + spin.dot(b.angularVelocity)) / 2;
            }
            return std::tuple(p, l, e);
        };
        const auto result = resolveImpact(bodies, contacts);
        const auto [p0, l0, e0] = sum(bodies);
        const auto [p1, l1, e1] = sum(result.bodies);
        EXPECT_LT((p1 - p0).norm(), 1e-11 * std::sqrt(e0));
        EXPECT_LT((l1 - l0).norm(), 1e-11 * (1 + l0.norm() + e0));
        if (elastic)
            EXPECT_NEAR(e1, e0, 1e-10 * e0);
        else
            EXPECT_LE(e1, e0 * (1 + 1e-12));
        for (const ImpulseGiven& j : result.impulses)
            EXPECT_GT(j.impulse, 0);
    }
}

TEST(Impact, BodiesThatCannotGiveWayPassThroughEachOther) {
    std::vector<ImpactBody> bodies(2);
    bodies[0].velocity = {-1, 0, 0};
    const auto result =
        resolveImpact(bodies, std::vector<ImpactContact>{{0, 1, Vector::Zero(), {1, 0, 0}, 1}});
    EXPECT_TRUE(result.impulses.empty());
    EXPECT_EQ(result.unyielding, std::vector<std::size_t>{0});
    EXPECT_EQ(result.bodies[0].velocity, Vector(-1, 0, 0));
}

TEST(Impact, WithAHeldAttitudeTurnsNothing) {
    std::vector<ImpactBody> bodies(2);
    bodies[0].inverseMass = 1; // free to move, its attitude held
    bodies[0].velocity = {-1, 0, 0};
    const auto result =
        resolveImpact(bodies, std::vector<ImpactContact>{{0, 1, {0, 5, 0}, {1, 0, 0}, 0.5}});
    ASSERT_EQ(result.impulses.size(), 1u);
    EXPECT_DOUBLE_EQ(result.impulses[0].impulse, 1.5);
    EXPECT_EQ(result.bodies[0].angularVelocity, Vector(0, 0, 0));
}

// j (1 + 0.6^2) = 2 * 5: the bead's part of the blow that is across its rail goes into the rail.
TEST(Impact, OfWhatIsHeldAlongAxesChangesTheOthersOnly) {
    std::vector<ImpactBody> bodies(2);
    bodies[0].inverseMass = bodies[1].inverseMass = 1;
    bodies[0].moves = {1, 0, 0};
    bodies[0].inverseInertia = Matrix::Identity();
    const Vector direction(0.6, 0.8, 0);
    bodies[1].velocity = 5 * direction;
    const auto result =
        resolveImpact(bodies, std::vector<ImpactContact>{{0, 1, Vector::Zero(), direction, 1}});
    ASSERT_EQ(result.impulses.size(), 1u);
    EXPECT_NEAR(result.impulses[0].impulse, 10 / 1.36, 1e-14);
    EXPECT_NEAR(result.bodies[0].velocity.x(), 6 / 1.36, 1e-14);
    EXPECT_EQ(result.bodies[0].velocity.y(), 0);
}

// A lossy ball between two fixed walls that touch it: rounds would go on forever.
TEST(Impact, EndsWhenLossyBouncingWouldNot) {
    struct Case {
        double restitution;
        std::size_t bounces; // of one contact, at most
    };
    for (const auto& [restitution, bounces] : {Case{0.2, 5}, Case{0.5, 10}, Case{0.9, 50}}) {
        std::vector<ImpactBody> bodies(4);
        bodies[0].inverseMass = bodies[1].inverseMass = 1;
        bodies[0].velocity = {1, 0, 0};
        const std::vector<ImpactContact> contacts{{1, 0, Vector::Zero(), {1, 0, 0}, restitution},
                                                  {1, 2, Vector::Zero(), {-1, 0, 0}, restitution},
                                                  {0, 3, Vector::Zero(), {1, 0, 0}, restitution}};
        const auto result = resolveImpact(bodies, contacts);
        EXPECT_TRUE(result.settled);
        EXPECT_FALSE(result.jammed);
        EXPECT_GE(result.bodies[1].velocity.x() - result.bodies[0].velocity.x(), -1e-12);
        EXPECT_LE(result.bodies[1].velocity.x(), 1e-12);
        EXPECT_LE(result.impulses.size(), 3 * (bounces + 3)) << restitution; // a few without
    }
}

// A bar that lies with one end on the floor is hit at the other: that end is thrown up first, and
// presses the resting one down, which then bounces; whatever an integration left that one of speed.
TEST(Impact, WhatRestsTakesPartAfterTheBlow) {
    for (const double left : {0.0, -1e-11, 1e-11, -1e-8}) {
        std::vector<ImpactBody> bodies(2);
        bodies[0].inverseMass = 1;
        bodies[0].inverseInertia = 2 * Matrix::Identity(); // A = ((3, -1), (-1, 3))
        bodies[0].velocity = {0, (left - 1) / 2, 0};
        bodies[0].angularVelocity = {0, 0, (-1 - left) / 2};
        std::vector<ImpactContact> ends;
        for (const double x : {-1.0, 1.0})
            ends.push_back({.first = 0,
                            .second = 1,
                            .point = {x, 0, 0},
                            .normal = {0, 1, 0},
                            .restitution = 0.5,
                            .isResting = x < 0});
        const ImpactBody bar = resolveImpact(bodies, ends).bodies[0];
        EXPECT_NEAR(bar.velocity.y() - bar.angularVelocity.z(), 0.25, 1e-7) << left;
        EXPECT_NEAR(bar.velocity.y() + bar.angularVelocity.z(), 0.25, 1e-7) << left;
    }
}

// The first of a row is pushed onto it: they move as one, each hit once.
TEST(Impact, WhatIsPressedTogetherMovesAsOne) {
    std::vector<ImpactBody> bodies(4);
    std::vector<ImpactContact> contacts;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].inverseMass = 1;
        bodies[i].centre = {static_cast<double>(i), 0, 0};
        if (i > 0)
            contacts.push_back({.first = i - 1,
                                .second = i,
                                .point = {static_cast<double>(i) - 0.5, 0, 0},
                                .normal = {-1, 0, 0},
                                .restitution = 0,
                                .isPressed = true});
    }
    bodies[0].velocity = {1e-3, 0, 0};
    const ImpactResult result = resolveImpact(bodies, contacts);
    for (const ImpactBody& body : result.bodies)
        EXPECT_NEAR(body.velocity.x(), 0.25e-3, 1e-17);
    EXPECT_EQ(result.impulses.size(), contacts.size());
}

// A rod of 3 kg, 0.25 kg m2, on a hinge half a metre above its centre, and a ball of 1 kg that hits
// it 0.8 m below the hinge: with I = 1 about the hinge  j = (1 + e) 2 / (1 + 0.8^2).
TEST(Impact, PassesThroughAHinge) {
    ImpactBody rod{.inverseMass = 1 / 3.0, .inverseInertia = 4 * Matrix::Identity()};
    rod.centre = {0, -0.5, 0};
    ImpactBody ball{.inverseMass = 1, .inverseInertia = Matrix::Identity()};
    ball.centre = {-0.1, -0.8, 0};
    ball.velocity = {2, 0, 0};
    std::vector<ImpactRow> hinge;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector n = Vector::Unit(axis);
        hinge.push_back({{{.body = 0, .linear = n, .angular = Vector(0, 0.5, 0).cross(n)}}});
        if (axis < 2) // about z it turns; said twice, which changes nothing
            for (int times = 0; times < 2; ++times)
                hinge.push_back({{{.body = 0, .linear = Vector::Zero(), .angular = n}}});
    }
    for (const double e : {0.0, 0.5, 1.0}) {
        const ImpactContact contact{
            .first = 0, .second = 1, .point = {0, -0.8, 0}, .normal = {1, 0, 0}, .restitution = e};
        const ImpactResult result = resolveImpact({rod, ball}, std::span(&contact, 1), hinge);
        const double j = (1 + e) * 2 / 1.64;
        EXPECT_TRUE(result.settled);
        EXPECT_NEAR(result.bodies[1].velocity.x(), 2 - j, 1e-14);
        EXPECT_NEAR(result.bodies[0].angularVelocity.z(), 0.8 * j, 1e-14);
        EXPECT_NEAR(result.bodies[0].velocity.x(), 0.5 * 0.8 * j, 1e-14);
    }
}

// The hinge of a body that is hit at the hinge takes the blow: nothing moves.
TEST(Impact, AtAHingeMovesNothing) {
    const ImpactBody rod{.inverseMass = 1, .inverseInertia = Matrix::Identity()};
    ImpactBody ball = rod;
    ball.centre = {-1, 0, 0};
    ball.velocity = {2, 0, 0};
    std::vector<ImpactRow> pin;
    for (int axis = 0; axis < 3; ++axis)
        pin.push_back({{{.body = 0, .linear = Vector::Unit(axis), .angular = Vector::Zero()}}});
    const ImpactContact contact{
        .first = 0, .second = 1, .point = {0, 0, 0}, .normal = {1, 0, 0}, .restitution = 1};
    const ImpactResult result = resolveImpact({rod, ball}, std::span(&contact, 1), pin);
    EXPECT_NEAR(result.bodies[1].velocity.x(), -2, 1e-14);
    EXPECT_LT(result.bodies[0].velocity.norm(), 1e-14);
}

// A body on its stop is a wall to what drives it there, and free the other way.
TEST(Impact, KnowsAStop) {
    const ImpactBody block{.inverseMass = 0.5, .inverseInertia = Matrix::Identity()};
    ImpactBody ball{.inverseMass = 1, .inverseInertia = Matrix::Identity()};
    ball.centre = {-1, 0, 0};
    ball.velocity = {3, 0, 0};
    const ImpactContact contact{
        .first = 0, .second = 1, .point = {0, 0, 0}, .normal = {1, 0, 0}, .restitution = 0.5};
    for (const double way : {-1.0, 1.0}) {
        const ImpactRow stop{.parts = {{.body = 0, .linear = {way, 0, 0}}}, .isStop = true};
        const ImpactResult result =
            resolveImpact({block, ball}, std::span(&contact, 1), std::span(&stop, 1));
        EXPECT_TRUE(result.settled);
        EXPECT_NEAR(result.bodies[0].velocity.x(), way < 0 ? 0 : 1.5, 1e-14);
        EXPECT_NEAR(result.bodies[1].velocity.x(), way < 0 ? -1.5 : 0, 1e-14);
    }
}

// A rod whose left end rests and whose right end hits: each end's impulse drives the other one in.
TEST(Impact, WithoutBounceReachesAllContactsAtOnce) {
    ImpactBody rod{.inverseMass = 1, .inverseInertia = 3 * Matrix::Identity()}; // of length 2
    rod.velocity = {0, -1, 0};
    rod.angularVelocity = {0, 0, -1};
    const ImpactBody floor{.inverseMass = 0, .inverseInertia = Matrix::Zero()};
    std::vector<ImpactContact> ends;
    for (const double x : {-1.0, 1.0})
        ends.push_back({.first = 0,
                        .second = 1,
                        .point = {x, 0, 0},
                        .normal = {0, 1, 0},
                        .restitution = 0,
                        .isResting = x < 0});
    const ImpactResult result = resolveImpact({rod, floor}, ends, {});
    EXPECT_TRUE(result.settled);
    EXPECT_EQ(std::ranges::count_if(result.impulses,
                                    [](const auto& given) { return given.impulse > 1e-14; }),
              2);
    EXPECT_LT(result.bodies[0].velocity.norm(), 1e-15);
    EXPECT_LT(result.bodies[0].angularVelocity.norm(), 1e-15);
}

// Two blocks on a taut rope; the blow drives one of them away from the other, which it pulls along.
TEST(Impact, PullsAlongByATautRope) {
    const ImpactBody block{.inverseMass = 1, .inverseInertia = Matrix::Identity()};
    ImpactBody ball = block, other = block;
    ball.centre = {-1, 0, 0};
    ball.velocity = {3, 0, 0};
    const ImpactContact contact{
        .first = 0, .second = 1, .point = {0, 0, 0}, .normal = {1, 0, 0}, .restitution = 0};
    for (const double side : {-1.0, 1.0}) { // where the other block is
        other.centre = {side, 5, 0};
        const ImpactRow rope{
            .parts = {{.body = 0, .linear = {side, 0, 0}}, {.body = 2, .linear = {-side, 0, 0}}},
            .isStop = true};
        const ImpactResult result =
            resolveImpact({block, ball, other}, std::span(&contact, 1), std::span(&rope, 1));
        EXPECT_NEAR(result.bodies[0].velocity.x(), side < 0 ? 1 : 1.5, 1e-14);
        EXPECT_NEAR(result.bodies[1].velocity.x(), side < 0 ? 1 : 1.5, 1e-14);
        EXPECT_NEAR(result.bodies[2].velocity.x(), side < 0 ? 1 : 0, 1e-14);
    }
}

// Those of a square plate have the couple mu N r, r the mean distance of the square's points.
TEST(Impact, CornersOfAPatchShareItsFriction) {
    constexpr double mu = 0.1, side = 1, high = 0.2, mass = 1, fall = 1;
    constexpr double about = mass * side * side / 6; // its normal
    std::vector<ImpactBody> bodies(2);
    bodies[0].inverseMass = 1 / mass;
    bodies[0].inverseInertia = Vector(1.9 / about, 1 / about, 1.9 / about).asDiagonal();
    bodies[0].velocity = {0, -fall, 0};
    bodies[0].angularVelocity = {0, 1, 0};
    std::vector<ImpactContact> corners;
    for (const double x : {-side / 2, side / 2})
        for (const double z : {-side / 2, side / 2})
            corners.push_back({.first = 0,
                               .second = 1,
                               .point = {x, -high / 2, z},
                               .normal = Vector::UnitY(),
                               .restitution = 0,
                               .friction = mu,
                               .patch = 1});
    const ImpactResult turned = resolveImpact(bodies, corners);
    const double reach = side * (std::sqrt(2) + std::asinh(1)) / 6;
    EXPECT_NEAR(turned.bodies[0].velocity.norm(), 0, 1e-14);
    EXPECT_NEAR(turned.bodies[0].angularVelocity.y(), 1 - mu * mass * fall * reach / about, 1e-12);
    bodies[0].velocity = {1, -fall, 0};
    bodies[0].angularVelocity.setZero();
    const ImpactResult slid = resolveImpact(bodies, corners);
    EXPECT_NEAR(slid.bodies[0].velocity.x(), 1 - mu * fall, 1e-12);
    EXPECT_NEAR(slid.bodies[0].angularVelocity.norm(), 0, 1e-12);
}

} // namespace
} // namespace physics
