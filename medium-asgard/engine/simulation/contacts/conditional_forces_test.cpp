// Forces with switches of which the branches in force read nothing, and switches that motion leaves
// from rest: an arm that is steered by angles, bodies that soft contacts bear.
#include "simulation/testing.h"

#include <array>
#include <cmath>

namespace simulation::testing {
namespace {

// Two bars on stiff hinges, straight at the start; each is turned to its angle by a torque that is
// proportional to what is missing, and damped.
struct Arm {
    std::string stiffness, first, second; // torques but for the angles' names A and B
};

std::string replaced(std::string text, const std::string& name, const std::string& by) {
    for (std::size_t at = text.find(name); at != std::string::npos;
         at = text.find(name, at + by.size()))
        text.replace(at, name.size(), by);
    return text;
}

Result played(const Arm& arm, const std::string& angle, double accuracy) {
    SceneBuilder b(1, accuracy);
    for (const std::string name : {"a", "b"}) {
        b.box(name, {name == "a" ? 0.5 : 1.5, 0, 0}, {1, 0.1, 0.1});
        b.weight(name);
        scene::Link hinge;
        hinge.first = {name, Vector(-0.5, 0, 0)};
        if (name == "a")
            hinge.second = scene::PointEnd{{"0", "0", "0"}};
        else
            hinge.second = scene::BodyEnd{"a", Vector(0.5, 0, 0)};
        hinge.tightness = std::stod(arm.stiffness);
        b.scene.links.push_back(hinge);
        std::string torque = name == "a" ? arm.first : arm.second;
        for (const auto& [letter, body] : {std::pair("A", "a"), std::pair("B", "b")})
            torque = replaced(torque, letter, replaced(angle, "#", body));
        b.force(name, "0", "0", torque).couple = true;
    }
    return simulate(b.scene);
}

// Where the joints stand at 0 the angle's atan2() has no jump, and no switch.
TEST(ConditionalForces, AnArmThatIsSteeredByAnglesLeavesThemAtZero) {
    const std::array<Arm, 3> arms = {{
        {.stiffness = "1e6",
         .first = "100*(0-A)-20*a.wz-(5*(0.5-(B-A))-0.2*(b.wz-a.wz))",
         .second = "5*(0.5-(B-A))-0.2*(b.wz-a.wz)"},
        {.stiffness = "1e5",
         .first = "50*(0.3*t-A)-20*a.wz-(5*(0.5-(B-A))-2*(b.wz-a.wz))",
         .second = "5*(0.5-(B-A))-2*(b.wz-a.wz)"},
        {.stiffness = "1e4", .first = "50*(0.5-A)-5*a.wz", .second = "50*(0.5-B)-5*b.wz"},
    }};
    for (const Arm& arm : arms)
        for (const double accuracy : {1e-3, 1e-6}) {
            const Result byTangent = played(arm, "(2*atan2(#.qz,#.qw))", accuracy);
            const Result bySine = played(arm, "(2*asin(#.qz))", accuracy);
            for (std::size_t body = 0; body < 2; ++body) {
                ASSERT_FALSE(byTangent.motion->stop(body))
                    << byTangent.motion->stop(body)->sentence;
                EXPECT_LT(
                    (byTangent.motion->at(body, 1).position - bySine.motion->at(body, 1).position)
                        .norm(),
                    3 * accuracy);
            }
            EXPECT_LT(byTangent.statistics.steps, 2 * bySine.statistics.steps + 100)
                << arm.stiffness << " " << accuracy;
        }
}

// One lies on the ground and the other on it, both exactly in touch at the start: what presses
// grows like the cube of the time, and places are rounded.
TEST(ConditionalForces, SoftContactsThatAreInTouchAtTheStartAreFollowed) {
    constexpr double k = 1e4, c = 50, dt = 1e-6, finish = 0.5;
    const auto push = [](double depth, double rate) {
        return depth > 0 ? std::max(0.0, k * depth + c * rate) : 0;
    };
    using State = std::array<double, 4>; // heights, then speeds
    const auto ratesOf = [&](const State& s) {
        const double below = push(0.1 - s[0], -s[2]),
                     between = push(0.2 - (s[1] - s[0]), s[2] - s[3]);
        return State{s[2], s[3], below - between - g, between - g};
    };
    const auto moved = [](const State& s, double h, const State& rates) {
        State to = s;
        for (std::size_t i = 0; i < 4; ++i)
            to[i] += h * rates[i];
        return to;
    };
    State state{0.1, 0.3, 0, 0};
    for (int i = 0; i < static_cast<int>(finish / dt); ++i)
        state = moved(state, dt, ratesOf(moved(state, dt / 2, ratesOf(state))));

    const auto contact = [](const std::string& depth, const std::string& rate) {
        return "(" + depth + " > 0 ? max(0, 1e4*(" + depth + ") + 50*(" + rate + ")) : 0)";
    };
    const std::string below = contact("0.1-a.y", "-a.dy");
    const std::string between = contact("0.2-(b.y-a.y)", "a.dy-b.dy");
    for (const double accuracy : {1e-3, 1e-4, 1e-6}) {
        SceneBuilder b(finish, accuracy);
        b.scene.simulator.collisions = false;
        b.ball("a", {0, 0.1, 0});
        b.ball("b", {0, 0.3, 0});
        b.weight("a");
        b.weight("b");
        b.force("a", "0", below + "-" + between, "0");
        b.force("b", "0", between, "0");
        const Result result = simulate(b.scene);
        for (std::size_t body = 0; body < 2; ++body) {
            ASSERT_FALSE(result.motion->stop(body)) << result.motion->stop(body)->sentence;
            EXPECT_NEAR(result.motion->at(body, finish).position.y(), state[body], accuracy);
        }
        EXPECT_LT(result.statistics.steps, 3000u) << accuracy;
    }
}

} // namespace
} // namespace simulation::testing
