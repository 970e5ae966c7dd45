// What physics says of every motion, checked on motions computed here by the classical Runge-Kutta
// method with small steps; and the dissertation's printed equations beside ours
// (docs/numerics.md, "Differences from the dissertation").
#include "physics/equations_of_motion.h"
#include "physics/scene_quantities.h"

#include "expression/tape.h"
#include "physics/testing.h"

#include <gtest/gtest.h>

namespace physics {
namespace {

using testing::ballAndRod;

using State = std::vector<double>;

class Moving {
public:
    explicit Moving(const scene::Scene& scene) : motion(scene) {
        if (!motion.faults.empty())
            throw std::invalid_argument(motion.faults.front());
        motion.scope->setSceneNodes(sceneNodes(motion, scene));
        std::vector<Node> rates;
        for (const expression::Unknown& unknown : motion.set.unknowns) {
            inputs_.push_back(unknown.symbol);
            rates.push_back(unknown.phases.front().derivative);
            state.push_back(unknown.initial);
        }
        inputs_.push_back(motion.set.time);
        tape_ = expression::Tape(motion.set.graph, inputs_, rates);
    }

    void advance(double until, int steps) {
        const double h = (until - time) / steps;
        for (int i = 0; i < steps; ++i) {
            const State k1 = rate(state, time), k2 = rate(moved(k1, h / 2), time + h / 2),
                        k3 = rate(moved(k2, h / 2), time + h / 2),
                        k4 = rate(moved(k3, h), time + h);
            for (std::size_t j = 0; j < state.size(); ++j)
                state[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
            time += h;
        }
    }

    double value(std::string_view text) {
        expression::Graph g = motion.set.graph;
        const auto made = motion.scope->parse(g, text, scene::Reading::quantities);
        const Node node = std::get<Node>(made);
        double out = 0;
        State in = state;
        in.push_back(time);
        expression::Tape(g, inputs_, std::span(&node, 1))
            .evaluate(in, std::span(&out, 1), scratch_);
        return out;
    }

    Vector vector(const std::string& name, const std::array<const char*, 3>& parts) {
        return {value(name + parts[0]), value(name + parts[1]), value(name + parts[2])};
    }
    [[nodiscard]] Quaternion attitude() const { // of the first body
        return Quaternion(state[qw], state[qx], state[qy], state[qz]).normalized();
    }
    Vector momentum() { return vector("scene.p", {"x", "y", "z"}); }
    Vector angularMomentum() { return vector("scene.l", {"x", "y", "z"}); }

    EquationsOfMotion motion;
    State state;
    double time = 0;

private:
    State rate(const State& at, double t) {
        State in = at, out(at.size());
        in.push_back(t);
        tape_.evaluate(in, out, scratch_);
        return out;
    }
    State moved(const State& rates, double h) const {
        State result = state;
        for (std::size_t j = 0; j < result.size(); ++j)
            result[j] += h * rates[j];
        return result;
    }

    std::vector<Node> inputs_;
    expression::Tape tape_;
    expression::Tape::Scratch scratch_;
};

// A box with three different moments, tumbling.
scene::Scene tumblingBox() {
    scene::Scene scene;
    scene.shapeSets = {testing::box("box1", {1, 2, 3})};
    scene.bodies = {testing::body("box", "box1", 6)};
    scene.bodies[0].initialAttitude = geometry::fromRotationVector({0.4, -1.1, 0.3});
    scene.bodies[0].initialAngularVelocity = {1, 2, -1.5};
    return scene;
}

scene::Link linkTo(const std::string& second) {
    scene::Link link;
    link.first = {"rod", Vector(1, 0.5, 0)};
    link.second = scene::BodyEnd{second, Vector(0, 0.5, 0)};
    link.tightness = 40;
    return link;
}

scene::Scene linkedBodies() {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].initialPosition = {-1, -1, 0.2};
    scene.bodies[1].initialVelocity = {0.5, 0, 1};
    scene.bodies[1].initialAngularVelocity = {0.3, 1, 2};
    scene.bodies[0].initialAngularVelocity = {0, 2, -1};
    scene.links = {linkTo("ball")};
    return scene;
}

// Row 4: Euler's equations with the full tensor, instead of a torque over a moment about each axis.
TEST(Conservation, AFreeTumblingBoxKeepsEnergyAndAngularMomentumInTheWorld) {
    Moving run(tumblingBox());
    const double energy = run.value("scene.energy");
    const Vector momentum = run.angularMomentum(), spin = run.vector("box.w", {"x", "y", "z"});
    run.advance(10, 20'000);
    EXPECT_NEAR(run.value("scene.energy"), energy, 1e-10 * energy);
    EXPECT_LT((run.angularMomentum() - momentum).norm(), 1e-10 * momentum.norm());
    // "torque over moment" would keep the spin itself
    EXPECT_GT((run.vector("box.w", {"x", "y", "z"}) - spin).norm(), 0.5);
}

// Products of inertia: the same box with its axes turned inside the body is the same motion.
TEST(Conservation, AnInertiaWithProductsMovesLikeItsPrincipalAxes) {
    scene::Scene plain = tumblingBox(), turned = plain;
    const Vector inside(0.3, 0.8, -0.5);
    turned.shapeSets[0].parts[0].rotation = inside;
    turned.bodies[0].initialAttitude =
        plain.bodies[0].initialAttitude * geometry::fromRotationVector(inside).conjugate();
    Moving a(plain), b(turned);
    ASSERT_FALSE(b.motion.bodies[0].mass.isPrincipal());
    a.advance(3, 6000);
    b.advance(3, 6000);
    for (const char* name : {"box.wx", "box.wy", "box.wz"})
        EXPECT_NEAR(a.value(name), b.value(name), 1e-10);
    EXPECT_LT((b.attitude() * geometry::fromRotationVector(inside)).angularDistance(a.attitude()),
              1e-7);
}

// Row 1: with the printed sign, F = -k x + c v, a link would feed energy in.
TEST(Conservation, ALinkTakesEnergyAwayAndKeepsMomentum) {
    Moving run(linkedBodies());
    const Vector momentum = run.momentum();
    double energy = run.value("scene.energy");
    for (int i = 1; i <= 20; ++i) {
        run.advance(0.2 * i, 400);
        const double now = run.value("scene.energy");
        EXPECT_LT(now, energy) << run.time;
        energy = now;
    }
    EXPECT_LT((run.momentum() - momentum).norm(), 1e-12);
}

// The spring pulls along d; the damper pushes along v, which need not lie along d, so that only
// without it is the pair of forces free of a couple.
TEST(Conservation, ALinkWithoutDampingKeepsEnergyAndAngularMomentum) {
    scene::Scene scene = linkedBodies();
    scene.links[0].damping = 0;
    Moving run(scene);
    const double energy = run.value("scene.energy");
    const Vector angular = run.angularMomentum();
    run.advance(5, 20'000);
    EXPECT_NEAR(run.value("scene.energy"), energy, 1e-9 * energy);
    EXPECT_LT((run.angularMomentum() - angular).norm(), 1e-9);
}

// Critical damping to a point: x(t) = (1 + w t) exp(-w t) for w = sqrt(k/m).
TEST(Conservation, ACriticalLinkReturnsWithoutOvershoot) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {1, 0, 0};
    scene::Link link;
    link.first = {"ball", std::nullopt};
    link.second = scene::PointEnd{{"0", "0", "0"}};
    link.tightness = 50;
    scene.links = {link};
    Moving run(scene);
    run.advance(1, 2000);
    EXPECT_NEAR(run.value("ball.x"), 6 * std::exp(-5.), 1e-10);
}

// The velocity of a point that moves with another body is its rate along the motion.
TEST(Conservation, APointThatReadsABodyMovesWithIt) {
    scene::Scene scene = linkedBodies();
    scene::Link link;
    link.first = {"ball", Vector(0.2, 0.1, 0)};
    link.second = scene::PointEnd{{"rod.px(1,0,0) + sin(t)", "rod.py(1,0,0)", "rod.pz(1,0,0)*t"}};
    link.tightness = 3;
    scene.links.push_back(link);
    Moving run(scene);
    run.advance(0.7, 300);
    const auto extension = [&](int i) {
        State in = run.state;
        return testing::valueOf(
            run.motion, run.motion.links[1].extension[static_cast<std::size_t>(i)], in, run.time);
    };
    const Vector before(extension(0), extension(1), extension(2));
    Vector speed;
    for (int i = 0; i < 3; ++i)
        speed[i] =
            testing::valueOf(run.motion, run.motion.links[1].speed[static_cast<std::size_t>(i)],
                             run.state, run.time);
    const double h = 1e-4;
    run.advance(run.time + h, 1);
    const Vector after(extension(0), extension(1), extension(2));
    EXPECT_LT(((after - before) / h - speed).norm(), 1e-2);
}

// Row 2: F = (0 1 0) at the arm (1 0 0) turns from x to y, counter-clockwise: d x F, not F x d.
TEST(Printed, ATorqueIsArmCrossForce) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "0", "1", "0")};
    scene.forces[0].offset = Vector(0.5, 0, 0);
    Moving run(scene);
    run.advance(0.1, 100);
    EXPECT_NEAR(run.value("ball.wz"), 0.1 * 0.5 / (0.4 * 2 * 0.25), 1e-4);
    // so the point where it acts runs ahead of the centre; with F x d it would fall behind
    EXPECT_GT(run.value("ball.pdy(0.5, 0, 0)"), run.value("ball.dy"));
}

// Row 3: a couple far from the centre makes no net force, and turns about the centre.
TEST(Printed, ACoupleOffTheCentreMakesNoForce) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("rod", "1", "2", "3")};
    scene.forces[0].couple = true;
    scene.forces[0].offset = Vector(3, 0, 0);
    Moving run(scene);
    run.advance(2, 4000);
    EXPECT_EQ(run.momentum(), Vector(0, 0, 0));
    EXPECT_LT((run.angularMomentum() - Vector(2, 4, 6)).norm(), 1e-10);
}

// Far from the origin a link sees the same extension, to the resolution of the places themselves.
TEST(Conservation, ALinkFarFromTheOriginSeesTheSameExtension) {
    scene::Scene near = ballAndRod();
    near.bodies[1].initialAttitude = geometry::fromRotationVector({0.1, 0.2, 0.3});
    near.bodies[0].initialPosition = {0.5, 0.25, 0}; // exact in binary, also far away
    near.links = {linkTo("ball"), linkTo("ball")};
    near.links[1].second =
        scene::PointEnd{{"ball.px(0.1, 0.2, 0.3)", "ball.y - 0.1", "ball.pz(0.1, 0.2, 0.3)"}};
    scene::Scene far = near;
    for (scene::Body& body : far.bodies)
        body.initialPosition += Vector(1 << 20, -(1 << 20), 1 << 20);
    const Moving a(near), b(far);
    for (const std::size_t link : {0u, 1u})
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(testing::valueOf(a.motion, a.motion.links[link].extension[i], a.state, 0),
                      testing::valueOf(b.motion, b.motion.links[link].extension[i], b.state, 0));
}

// A rotation matrix stays a rotation when the quaternion's length has drifted.
TEST(Rotation, OfAQuaternionOfAnyLengthStretchesNothing) {
    Moving run(tumblingBox());
    const double place = run.value("box.px(1, 2, 3)");
    for (std::size_t i = qw; i < w1; ++i)
        run.state[i] *= 1.5;
    EXPECT_NEAR(run.value("box.px(1, 2, 3)"), place, 1e-14);
}

TEST(Quantities, EnergyAndMomentumAreThoseOfWhatMovesFreely) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialVelocity = {3, 0, 0};
    scene.bodies[0].initialPosition = {0, 5, 0};
    scene.bodies[1].initialVelocity = {0, 1, 0};
    scene::Force weight;
    weight.body = "ball";
    weight.kind = scene::GravitationalForce{{0, -10, 0}};
    scene.forces = {weight};
    Moving run(scene);
    EXPECT_NEAR(run.value("scene.energy"), 0.5 * 2 * 9 + 2 * 10 * 5 + 0.5 * 3, 1e-13);
    EXPECT_NEAR(run.value("scene.px"), 6, 1e-15);
    EXPECT_NEAR(run.value("scene.lz"), -5 * 6, 1e-13);

    scene.trajectories.resize(1);
    scene.trajectories[0].name = "path";
    scene.trajectories[0].curves = {{1, 2, {Vector(0, 0, 0)}}};
    scene.constraints.resize(1);
    scene.constraints[0].body = "rod";
    scene.constraints[0].held = scene::Held::x;
    scene.constraints[0].trajectory = "path";
    Moving held(scene);
    EXPECT_NEAR(held.value("scene.py"), 3, 1e-15);
    held.time = 1.5;
    EXPECT_NEAR(held.value("scene.py"), 0, 1e-15);
    EXPECT_NEAR(held.value("scene.energy"), 0.5 * 2 * 9 + 2 * 10 * 5, 1e-13);
}

} // namespace
} // namespace physics
