// Values of a motion: which numbers, which sentences, and how often equations are built for them.
#include "service/offered_values.h"
#include "service/testing.h"

#include <gmock/gmock.h>

#include <cmath>

namespace service {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ScenePointer pushedBall(double p = 2) {
    return std::make_shared<const scene::Scene>(pushedBallScene(p));
}

struct Pushed {
    ScenePointer scene = pushedBall();
    simulation::MotionPointer motion = simulation::simulate(*scene).motion;
    ValueSource source;

    ValueReader reader(const std::vector<std::string>& expressions) {
        return source.reader(scene, motion, expressions);
    }
};

TEST(ValueReader, EachExpressionHasANumberOrASentence) {
    Pushed pushed;
    const ValueReader reader = pushed.reader({"b.x", "c.x", "p", "1 +", "log(1 - t)"});
    const ipc::Values read = reader.at(3);
    EXPECT_NEAR(read.values[0], 9, 1e-9);
    EXPECT_TRUE(std::isnan(read.values[1]));
    EXPECT_EQ(read.values[2], 2);
    EXPECT_THAT(read.faults, ElementsAre("", HasSubstr("\"c.x\""), "", HasSubstr("\"1 +\""),
                                         "it has no value at this time"));
    EXPECT_THAT(pushed.reader({"b.x", "b.dx"}).at(1).faults, IsEmpty());
    const ipc::Values none = reader.none("it is too late");
    EXPECT_THAT(none.faults, ElementsAre("it is too late", HasSubstr("\"c.x\""), "it is too late",
                                         HasSubstr("\"1 +\""), "it is too late"));
    EXPECT_THAT(none.values, testing::Each(testing::IsNan()));
}

TEST(OfferedValues, JointsHaveTheirCoordinatesForcesAndCouples) {
    scene::Scene scene;
    scene::Joint& pin = scene.joints.emplace_back();
    pin.name = "pin";
    pin.type = scene::JointType::hinge;
    scene::Joint& sleeve = scene.joints.emplace_back();
    sleeve.name = "sleeve";
    sleeve.type = scene::JointType::cylindrical;
    std::string all;
    for (const ipc::ValueOffer& offer : offeredValues(scene).items)
        all += offer.expression + " (" + offer.label + ") ";
    EXPECT_THAT(all, HasSubstr("pin.q (pin: angle) pin.dq (pin: angular velocity) pin.fx"));
    EXPECT_THAT(all, HasSubstr("sleeve.q2 (sleeve: length 2) sleeve.dq2 (sleeve: velocity 2)"));
    EXPECT_THAT(all, HasSubstr("pin.tz (pin: couple z)"));
}

TEST(ValueReader, FaultyNeighboursCostNoEquations) {
    Pushed pushed;
    std::vector<std::string> expressions;
    for (int i = 0; i < 200; ++i)
        expressions.push_back((i % 2 == 0 ? "b.x*" : "c.x*") + std::to_string(i));
    const ipc::Values read = pushed.reader(expressions).at(1);
    EXPECT_NEAR(read.values[10], 10, 1e-9);
    EXPECT_THAT(read.faults[11], HasSubstr("c.x"));
    EXPECT_EQ(pushed.source.built(), 1u);
}

TEST(ValueReader, EquationsAreBuiltOnceForAllExpressionsTimesAndMotions) {
    Pushed pushed;
    for (int i = 0; i < 100; ++i) {
        const double time = 0.04 * i;
        const ValueReader reader = pushed.reader({"b.x", "b.x + " + std::to_string(i)});
        EXPECT_NEAR(reader.at(time).values[0], time * time, 1e-9);
    }
    simulation::Options shorter;
    shorter.finish = 2;
    pushed.motion = simulation::simulate(*pushed.scene, shorter).motion;
    EXPECT_NEAR(pushed.reader({"b.dx"}).at(2).values[0], 4, 1e-9);
    EXPECT_EQ(pushed.source.built(), 1u);
    pushed.scene = pushedBall(3); // another text
    pushed.motion = simulation::simulate(*pushed.scene).motion;
    EXPECT_NEAR(pushed.reader({"b.dx"}).at(2).values[0], 6, 1e-9);
    EXPECT_EQ(pushed.source.built(), 2u);
}

TEST(ValueReader, NewExpressionsWithoutEndDoNotFillTheMemory) {
    Pushed pushed;
    for (int i = 0; i < 45; ++i) {
        std::vector<std::string> expressions;
        for (int k = 0; k < 1000; ++k)
            expressions.push_back("b.x + " + std::to_string(1000 * i + k));
        EXPECT_NEAR(pushed.reader(expressions).at(1).values[7], 1000 * i + 8, 1e-6);
    }
    EXPECT_EQ(pushed.source.built(), 3u);
}

} // namespace
} // namespace service
