// A hand takes a body out of a motion, and the motion becomes another.
#include "gestures/throw.h"

#include "script/reader.h"
#include "text/edit.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using testing::HasSubstr;

Ground flying() {
    static script::Reader reader;
    const std::string text = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                             "body b s -init_dpos {1 0 0}\nbody wall s -init_pos {0 9 0} -fixed 1\n"
                             "trajectory way -points {{0 0 -9 0} {2 1 -9 0}}\n"
                             "body led s -init_pos {0 -9 0}\nconstrain led -pos way\n";
    const script::ReadResult read = reader.read(text);
    EXPECT_TRUE(read.usable);
    auto scene = std::make_shared<const scene::Scene>(read.scene);
    return {text, scene, simulation::simulate(*scene).motion, [](const std::string&) {},
            [](const std::string&, const std::string&) {}};
}

Sight fromFront() {
    Sight sight;
    sight.size = {400, 400};
    sight.camera.scale = 0.1;
    return sight;
}

TEST(Throw, TheHandsVelocityAndPlaceBecomeTheStart) {
    const Ground ground = flying();
    const Sight sight = fromFront();
    const auto at = [&](double x) { return sight.pixels({x, 0, 0}); };
    ASSERT_EQ(whyNotTaken(ground, 1, 0), "");
    for (const bool isThrown : {true, false}) {
        Throw body(ground, 1, 0, sight, at(1));
        EXPECT_FALSE(body.moved());
        for (int i = 0; i <= 100; ++i) // 2 m/s for half a second
            body.move(sight, at(1 + 0.01 * i), 0.005 * i);
        EXPECT_NEAR(body.poses().front().second.position.x(), 2, 0.05);
        const auto answer = body.answer(sight, isThrown ? std::optional(0.5) : std::nullopt, 0.5);
        ASSERT_TRUE(answer.possible()) << answer.reason;
        const std::string text = text::applied(ground.text, answer.edits);
        EXPECT_THAT(text, HasSubstr("-start 1"));
        script::Reader reader;
        const auto after = reader.read(text).scene;
        EXPECT_NEAR(after.bodies[0].initialPosition.x(), 2, 0.05);
        EXPECT_NEAR(after.bodies[0].initialVelocity.x(), isThrown ? 4 : 1, 0.3);
    }
}

// However the places that are told lie in the time that counts.
TEST(Throw, AHandThatMovesSteadilyThrowsWithItsVelocity) {
    const Ground ground = flying();
    const Sight sight = fromFront();
    script::Reader reader;
    for (const double late : {0.0, 0.005, 0.01, 0.015}) {
        Throw body(ground, 1, 0, sight, sight.pixels({1, 0, 0}));
        double seconds = 0;
        for (int i = 0; i <= 30; ++i) {
            seconds = 0.016 * i;
            body.move(sight, sight.pixels({1 + 2 * seconds, 0, 0}), seconds);
        }
        const auto answer = body.answer(sight, 1, seconds + late);
        ASSERT_TRUE(answer.possible()) << answer.reason;
        const auto after = reader.read(text::applied(ground.text, answer.edits)).scene;
        EXPECT_NEAR(after.bodies[0].initialVelocity.x(), 2, 0.02) << late;
    }
    Throw still(ground, 1, 0, sight, sight.pixels({1, 0, 0}));
    still.move(sight, sight.pixels({2, 0, 0}), 0.1);
    const auto answer = still.answer(sight, 1, 0.5);
    const auto after = reader.read(text::applied(ground.text, answer.edits)).scene;
    EXPECT_EQ(after.bodies[0].initialVelocity.x(), 0);
}

TEST(Throw, OneThatStandsOrIsLedIsNotTaken) {
    const Ground ground = flying();
    EXPECT_EQ(whyNotTaken(ground, 0, 0), std::nullopt); // the start
    EXPECT_EQ(whyNotTaken(ground, 1, 1), std::nullopt);
    EXPECT_THAT(whyNotTaken(ground, 1, 2).value_or(""), HasSubstr("led by the path way"));
}

} // namespace
} // namespace gestures
