// Contacts as constraints: the equations that come out, and which constraints depend on others.
#include "physics/resting.h"
#include "physics/testing.h"

#include "expression/tape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace physics {
namespace {

// "ball" (mass 2, radius 0.5) falls, and "rod" is fixed, with its upper side at y = 0.5.
scene::Scene ballOnRod() {
    scene::Scene scene = testing::ballAndRod();
    scene.bodies[0].initialPosition = {0, 1, 0};
    scene.bodies[1].fixed = true;
    scene::Force weight;
    weight.body = "ball";
    weight.kind = scene::GravitationalForce{Vector(1, -10, 0)};
    scene.forces.push_back(weight);
    return scene;
}

GapConstraint plane(const Vector& normal, double radius) {
    GapConstraint c;
    c.support = 1;
    c.normal = normal;
    c.radius = radius;
    c.supportPoint = 0.5 * normal;
    return c;
}

std::vector<double> stateOf(const EquationsOfMotion& motion) {
    std::vector<double> state;
    for (const auto& unknown : motion.set.unknowns)
        state.push_back(unknown.initial);
    return state;
}

TEST(Resting, OnAPlaneTheWeightAlongItIsAllThatIsLeftAndFolds) {
    const EquationsOfMotion motion(ballOnRod());
    expression::EquationSet set = motion.set;
    GapExpressions gaps(set, motion, 0, 0);
    const std::vector<GapConstraint> floor{plane(Vector::UnitY(), 0.5)};
    const ConstrainedRates rates = gaps.constrained(floor);
    EXPECT_EQ(print(set.graph, rates.acceleration[0]), "1");
    EXPECT_EQ(print(set.graph, rates.acceleration[1]), "0");
    EXPECT_EQ(print(set.graph, rates.acceleration[2]), "0");
    EXPECT_EQ(print(set.graph, rates.spinRate[0]), "0");
}

// It goes its way along x, at 3, and the slope of 45 degrees lets it go up by as much.
TEST(Resting, WhatIsHeldAlongAnAxisHasItsOwnRateThere) {
    scene::Scene scene = ballOnRod();
    scene.trajectories.emplace_back();
    scene.trajectories[0].name = "path";
    scene.trajectories[0].curves.push_back(
        {.from = 0, .to = 9, .control = {{0, 0, 0}, {27, 0, 0}}});
    scene.constraints.emplace_back();
    scene.constraints[0].body = "ball";
    scene.constraints[0].trajectory = "path";
    scene.constraints[0].held = scene::Held::x;
    const EquationsOfMotion motion(scene);
    const Held held = unyieldingAt(motion, 0, 1);
    EXPECT_TRUE(held.position[0]);
    EXPECT_FALSE(held.position[1] || held.attitude);
    expression::EquationSet set = motion.set;
    GapExpressions gaps(set, motion, 0, 1);
    const std::vector<GapConstraint> slope{plane(Vector(-1, 1, 0).normalized(), 0.5)};
    const ConstrainedRates rates = gaps.constrained(slope);
    EXPECT_EQ(print(set.graph, rates.acceleration[0]), "0");
    EXPECT_EQ(print(set.graph, rates.acceleration[1]), "0");
    std::vector<double> state = stateOf(motion);
    state[motion.bodies[0].unknown(dx)] = 3;
    const auto rows = gaps.rowsAt(slope, state);
    EXPECT_EQ(changeToRates(motion.bodies[0], held, rows).linear, Vector(0, 3, 0));
}

// A hold beside the centre of mass is no hinge.
TEST(Resting, WhatIsHeldBesideItsCentreDoesNotTurn) {
    scene::Scene scene = ballOnRod();
    scene.shapeSets[0].parts[0].position = {0.1, 0, 0};
    scene.trajectories.emplace_back();
    scene.trajectories[0].name = "path";
    scene.trajectories[0].curves.push_back({.from = 0, .to = 9, .control = {{0, 0, 0}}});
    scene.constraints.emplace_back();
    scene.constraints[0].body = "ball";
    scene.constraints[0].trajectory = "path";
    EXPECT_TRUE(unyieldingAt(EquationsOfMotion(scene), 0, 1).attitude);
    scene.constraints[0].held = scene::Held::velocity; // that of the centre
    EXPECT_FALSE(unyieldingAt(EquationsOfMotion(scene), 0, 1).attitude);
}

TEST(Resting, ADependentConstraintIsLeftOut) {
    const EquationsOfMotion motion(ballOnRod());
    expression::EquationSet set = motion.set;
    GapExpressions gaps(set, motion, 0, 0);
    const std::vector<GapConstraint> planes{
        plane(Vector::UnitY(), 0.5), plane(Vector::UnitY(), 0.5), plane(Vector::UnitX(), 0.5)};
    const auto rows = gaps.rowsAt(planes, stateOf(motion));
    EXPECT_THAT(independentOf(motion.bodies[0], {}, rows), ::testing::ElementsAre(0u, 2u));
}

TEST(Resting, VelocitiesChangeByTheLeastThatMakesTheRatesZero) {
    scene::Scene scene = ballOnRod();
    scene.bodies[0].initialVelocity = {3, -2, 1};
    const EquationsOfMotion motion(scene);
    expression::EquationSet set = motion.set;
    GapExpressions gaps(set, motion, 0, 0);
    const std::vector<GapConstraint> floor{plane(Vector::UnitY(), 0.5)};
    const auto rows = gaps.rowsAt(floor, stateOf(motion));
    EXPECT_EQ(rows[0].rate, -2);
    const VelocityChange change = changeToRates(motion.bodies[0], {}, rows);
    EXPECT_EQ(change.linear, Vector(0, 2, 0));
    EXPECT_EQ(change.angular, Vector(0, 0, 0));
}

// A ball that slides over the top of a round support at speed v bends down with v^2 / R.
TEST(Resting, OverARoundSupportTheConstraintBendsThePath) {
    scene::Scene scene = ballOnRod();
    scene.bodies[0].initialVelocity = {2, 0, 0};
    const EquationsOfMotion motion(scene);
    expression::EquationSet set = motion.set;
    GapExpressions gaps(set, motion, 0, 0);
    GapConstraint round;
    round.kind = GapConstraint::Kind::roundOnPoint;
    round.support = 1;
    round.radius = 1;
    const ConstrainedRates rates = gaps.constrained(std::span(&round, 1));
    std::vector<expression::Node> inputs;
    for (const auto& unknown : set.unknowns)
        inputs.push_back(unknown.symbol);
    inputs.push_back(set.time);
    std::vector<double> values = stateOf(motion), out(3);
    values.push_back(0);
    expression::Tape::Scratch scratch;
    expression::Tape(set.graph, inputs, rates.acceleration).evaluate(values, out, scratch);
    EXPECT_NEAR(out[0], 1, 1e-14);
    EXPECT_NEAR(out[1], -4, 1e-14);
}

} // namespace
} // namespace physics
