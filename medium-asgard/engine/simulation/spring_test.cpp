// Springs against closed forms: along one line, through the point where they have no length, with
// damping, between two bodies, and as a bungee.
#include "simulation/testing.h"

#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double accuracies[] = {1e-4, 1e-7, 1e-10};

scene::Link spring(const std::string& body, const Vector& anchor, double stiffness,
                   std::optional<double> rest, double damping = 0, bool isPullOnly = false) {
    scene::Link made;
    made.name = "s";
    made.first = {body, Vector::Zero()};
    made.second = scene::PointEnd{
        {std::to_string(anchor.x()), std::to_string(anchor.y()), std::to_string(anchor.z())}};
    made.tightness = stiffness;
    made.damping = damping;
    made.spring = scene::SpringLaw{rest, isPullOnly};
    return made;
}

// A ball of 1 kg on a spring to the origin.
SceneBuilder ballOnSpring(const Vector& place, const Vector& velocity, double stiffness,
                          std::optional<double> rest, double damping, double finish,
                          double accuracy) {
    SceneBuilder b(finish, accuracy);
    scene::Body& ball = b.ball("b", place);
    ball.mass = 1;
    ball.initialVelocity = velocity;
    b.scene.links.push_back(spring("b", Vector::Zero(), stiffness, rest, damping));
    return b;
}

template <class Place> void expectPlaces(const Result& result, const Place& place, double within) {
    ASSERT_TRUE(result.motion);
    ASSERT_FALSE(result.motion->stop(0)) << result.motion->stop(0)->sentence;
    for (int i = 0; i <= 50; ++i) {
        const double t = result.motion->finish() * i / 50;
        EXPECT_LT((result.motion->at(0, t).position - place(t)).norm(), within) << t;
    }
}

// x'' = -k (|x| - L) sign x from x = 3 L: arcs of 1 + 2 cos 2 t, one after another.
TEST(Spring, SwingsThroughThePointWhereItHasNoLength) {
    const double t1 = pi / 3;
    for (const double accuracy : accuracies) {
        const Result result =
            simulate(ballOnSpring({3, 0, 0}, {0, 0, 0}, 4, 1, 0, 10, accuracy).scene);
        const auto place = [&](double t) {
            const double arcs = std::floor((t + t1) / (2 * t1));
            const double x = 1 + 2 * std::cos(2 * (t - arcs * 2 * t1));
            return Vector(std::fmod(arcs, 2) == 0 ? x : -x, 0, 0);
        };
        expectPlaces(result, place, 10 * accuracy);
    }
}

TEST(Spring, LeavesThePointWhereItHasNoLength) {
    const Vector way(0.6, 0.8, 0);
    for (const double accuracy : accuracies) {
        const Result result =
            simulate(ballOnSpring({0, 0, 0}, 0.5 * way, 4, 1, 0, 2.8, accuracy).scene);
        const auto place = [&](double t) {
            return Vector((1 - std::cos(2 * t) + 0.25 * std::sin(2 * t)) * way);
        };
        expectPlaces(result, place, 100 * accuracy);
    }
    const Result atRest = simulate(ballOnSpring({0, 0, 0}, {0, 0, 0}, 4, 1, 2, 3, 1e-6).scene);
    expectPlaces(
        atRest, [](double) { return Vector(0, 0, 0); }, 1e-300);
}

TEST(Spring, WithoutLengthAtRestMovesOnAnEllipse) {
    for (const double accuracy : accuracies) {
        const Result result =
            simulate(ballOnSpring({1, 0, 0}, {0, 1, 0.5}, 9, 0, 0, 10, accuracy).scene);
        const auto place = [](double t) {
            return Vector(std::cos(3 * t), std::sin(3 * t) / 3, std::sin(3 * t) / 6);
        };
        expectPlaces(result, place, 10 * accuracy);
    }
}

TEST(Spring, IsDampedAlongItsLineAlone) {
    const double w = std::sqrt(4 - 0.0625); // m 1, c 0.5, k 4
    for (const double accuracy : accuracies) {
        const Result result =
            simulate(ballOnSpring({0, 1.5, 0}, {0, 0, 0}, 4, 1, 0.5, 10, accuracy).scene);
        const auto place = [&](double t) {
            return Vector(
                0, 1 + 0.5 * std::exp(-0.25 * t) * (std::cos(w * t) + 0.25 / w * std::sin(w * t)),
                0);
        };
        expectPlaces(result, place, 10 * accuracy);
    }
    // On a circle the length does not change: K (l - L) = v²/l keeps it there.
    const Result circle = simulate(ballOnSpring({2, 0, 0}, {0, 2, 0}, 2, 1, 5, 10, 1e-9).scene);
    expectPlaces(
        circle, [](double t) { return Vector(2 * std::cos(t), 2 * std::sin(t), 0); }, 1e-7);
}

// Its length at the start, by default; bodies that it joins may collide, and here they pass.
TEST(Spring, BetweenTwoBodiesHasTheirLengthAtTheStart) {
    SceneBuilder b(10, 1e-9);
    b.scene.simulator.collisions = false;
    b.ball("a", {0, 0, 0}).mass = 1;
    scene::Body& other = b.ball("c", {0, 2, 0});
    other.mass = 3;
    other.initialVelocity = {0, 0.4, 0};
    scene::Link joined = spring("a", Vector::Zero(), 12, std::nullopt);
    joined.second = scene::BodyEnd{"c", std::nullopt};
    b.scene.links.push_back(joined);
    const Result result = simulate(b.scene);
    for (double t = 0; t <= 10; t += 0.5) {
        const double between =
            (result.motion->at(1, t).position - result.motion->at(0, t).position).y();
        EXPECT_NEAR(between, 2 + 0.1 * std::sin(4 * t), 1e-7);
    }
}

TEST(Spring, HasTheLengthThatTrajectoriesGiveItAtTheStart) {
    SceneBuilder b(5, 1e-9);
    b.ball("b", {0, 1, 0}).mass = 1;
    b.ball("hand", {0, 0, 7}).mass = 1;
    b.hold("hand", 0, 5, {{0, 3, 0}});
    scene::Link joined = spring("b", Vector::Zero(), 12, std::nullopt);
    joined.second = scene::BodyEnd{"hand", std::nullopt};
    b.scene.links.push_back(joined);
    expectPlaces(
        simulate(b.scene), [](double) { return Vector(0, 1, 0); }, 1e-12);
}

// Free fall by 5, an arc on the cord, and up again to where it began.
TEST(Spring, ThatOnlyPullsLetsFallFreely) {
    const double w = std::sqrt(40.0), swing = 10 / w;
    const double delta = std::atan2(swing, 0.25), period = 2 + (2 * pi - 2 * delta) / w;
    for (const double accuracy : accuracies) {
        SceneBuilder b(2 * period, accuracy);
        b.ball("b", {0, 0, 0}).mass = 1;
        b.weight("b", {0, -10, 0});
        b.scene.links.push_back(spring("b", Vector::Zero(), 40, 5, 0, true));
        const auto place = [&](double t) {
            t = std::fmod(t, period);
            if (t > period / 2)
                t = period - t;
            const double s = t - 1;
            return Vector(
                0, t < 1 ? -5 * t * t : -5.25 + std::hypot(swing, 0.25) * std::cos(w * s + delta),
                0);
        };
        expectPlaces(simulate(b.scene), place, 50 * accuracy);
    }
}

TEST(Spring, TellsItsLengthAndForce) {
    SceneBuilder b = ballOnSpring({1.5, 0, 0}, {0, 0, 0}, 4, 1, 0.5, 2, 1e-9);
    b.ball("c", {9, 0, 0}).mass = 1;
    b.force("c", "2*s.length", "0", "0");
    const Result result = simulate(b.scene);
    std::vector<std::string> faults;
    const Quantities read(b.scene, {}, result.motion,
                          {"s.length", "s.force", "b.x", "b.dx", "scene.energy"}, faults);
    EXPECT_TRUE(faults.empty());
    const auto values = read.at(1.3);
    EXPECT_NEAR(values[0], values[2], 1e-14);
    EXPECT_NEAR(values[1], 4 * (values[2] - 1) + 0.5 * values[3], 1e-13);
    EXPECT_NEAR(result.motion->at(1, 0.01).velocity.x(), 2 * 1.5 * 0.01, 1e-4);
    // Nothing is damped of what a swing in a plane has.
    b = ballOnSpring({1.5, 0, 0}, {0, 1, 0.3}, 4, 1, 0, 10, 1e-10);
    const Result swing = simulate(b.scene);
    const Quantities energy(b.scene, {}, swing.motion, {"scene.energy"}, faults);
    EXPECT_NEAR(energy.at(0)[0], 0.5 * 1.09 + 0.5, 1e-14);
    EXPECT_NEAR(energy.at(10)[0], energy.at(0)[0], 1e-8);
}

} // namespace
} // namespace simulation::testing
