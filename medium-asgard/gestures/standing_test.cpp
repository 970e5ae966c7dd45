// Bodies go on standing when their shape gets another size.
#include "gestures/standing.h"

#include "script/reader.h"

#include <gmock/gmock.h>

#include <cmath>

namespace gestures {
namespace {

// The bodies' places once the first shape is a box of these edges, by "name: x y z".
class StandingStill : public testing::Test {
protected:
    void resize(const std::string& text, const Vector& edges) {
        static script::Reader reader;
        const script::ReadResult read = reader.read(text);
        ASSERT_TRUE(read.usable) << text;
        before = read.scene;
        scene::Part part = before.shapeSets.front().parts.front();
        part.shape = scene::BoxShape{edges};
        wishes = standingStill(before, 0, {part});
    }
    [[nodiscard]] Vector wayOf(const std::string& body) const {
        for (const editing::Wish& wish : wishes) {
            const scene::Body& one = before.bodies[wish.element.index];
            if (one.name == body)
                return Vector(wish.values[0], wish.values[1], wish.values[2]) - one.initialPosition;
        }
        return Vector::Zero();
    }

    scene::Scene before;
    std::vector<editing::Wish> wishes;
};

const std::string box = "shape_set box -desc {-sub {-box {1 1 1}}}\n";
const std::string table = "shape_set top -desc {-sub {-box {4 0.2 2}}}\n";

TEST_F(StandingStill, ABoxOnTheGridGoesOnStandingThere) {
    resize(box + "body b box -init_pos {3 0.5 0}\n", {2, 0.4, 1});
    EXPECT_LT((wayOf("b") - Vector(0, -0.3, 0)).norm(), 1e-12);
    resize(box + "body b box -init_pos {3 0.8 0}\n", {2, 0.4, 1}); // it hangs in the air
    EXPECT_TRUE(wishes.empty());
}

TEST_F(StandingStill, WhatStandsOnATableGoesUpWithItsTop) {
    resize(table + box +
               "body desk top -init_pos {0 0.1 0} -fixed 1\nbody b box -init_pos {1 0.7 0}\n"
               "body c box -init_pos {1 1.7 0}\nbody d box -init_pos {-1 2 0}\n",
           {4, 0.5, 2});
    EXPECT_LT((wayOf("desk") - Vector(0, 0.15, 0)).norm(), 1e-12);
    EXPECT_LT((wayOf("b") - Vector(0, 0.3, 0)).norm(), 1e-12);
    EXPECT_LT((wayOf("c") - Vector(0, 0.3, 0)).norm(), 1e-12);
    EXPECT_TRUE(wayOf("d").isZero());
}

TEST_F(StandingStill, ABoxOnASlopeStaysOnIt) {
    const double turn = -0.3;
    const Vector up(-std::sin(turn), std::cos(turn), 0);
    const Vector at = 0.6 * up; // 0.1 and 0.5 above the middle of the slope
    resize(box + table + "body slope top -init_rot {0 0 -0.3} -init_pos {0 5 0} -fixed 1\n" +
               "body b box -init_rot {0 0 -0.3} -init_pos {" + std::to_string(at.x()) + " " +
               std::to_string(5 + at.y()) + " 0}\n",
           {1, 0.4, 1});
    EXPECT_NEAR(wayOf("b").dot(up), -0.3, 1e-6); // straight down: its other numbers stay
    EXPECT_EQ(wayOf("b").head<1>().norm() + std::abs(wayOf("b").z()), 0);
}

TEST_F(StandingStill, WhatAJointHoldsStays) {
    resize(box + "body b box -init_pos {3 0.5 0}\njoint j -type hinge -body1 b\n", {2, 0.4, 1});
    EXPECT_TRUE(wishes.empty());
}

} // namespace
} // namespace gestures
