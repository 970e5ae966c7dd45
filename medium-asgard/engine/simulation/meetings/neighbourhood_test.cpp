// Who may meet whom, and who is near whom.
#include "meetings/neighbourhood.h"

#include "simulation/testing.h"

namespace simulation::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A floor, and three boxes above it.
scene::Scene boxes() {
    SceneBuilder b(1);
    b.floor();
    b.box("a", {0, 1, 0}, {1, 1, 1});
    b.box("b", {1, 1, 0}, {1, 1, 1});
    b.box("c", {5, 1, 0}, {1, 1, 1});
    return b.scene;
}

geometry::Box around(double x, double half = 0.6) {
    return {Vector(x - half, 0, -half), Vector(x + half, 2, half)};
}

TEST(MayMeet, NotOneGroupNorALinkNorTwoThatStand) {
    scene::Scene scene = boxes();
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies.back().name = "wall";
    scene.bodies[1].collisionGroup = scene.bodies[3].collisionGroup = 7;
    scene::Link link;
    link.first.body = "a";
    scene::BodyEnd second;
    second.body = "b";
    link.second = second;
    scene.links.push_back(link);
    const MayMeet mayMeet(scene);
    EXPECT_TRUE(mayMeet(0, 1));
    EXPECT_FALSE(mayMeet(1, 2)); // linked
    EXPECT_FALSE(mayMeet(1, 3)); // of one group
    EXPECT_TRUE(mayMeet(2, 3));
    EXPECT_FALSE(mayMeet(0, 4)); // both are fixed
    EXPECT_FALSE(mayMeet(2, 2));
}

TEST(MayMeet, TwoThatPassDoSoUntilATime) {
    MayMeet mayMeet(boxes());
    mayMeet.letPass({1, 2}, 3);
    EXPECT_TRUE(mayMeet.isPassing({1, 2}, 2));
    EXPECT_FALSE(mayMeet.isPassing({1, 2}, 3));
    EXPECT_FALSE(mayMeet.isPassing({1, 3}, 2));
}

std::vector<BodyRecord> recordsOf(const scene::Scene& scene) {
    std::vector<BodyRecord> records(scene.bodies.size());
    for (std::size_t b = 0; b < records.size(); ++b) {
        records[b].isFixed = scene.bodies[b].fixed;
        records[b].radius = 0.8;
    }
    return records;
}

class NeighbourhoodTest : public ::testing::Test {
protected:
    NeighbourhoodTest() { near.tree.put(0, {Vector(-10, -0.2, -10), Vector(10, 0, 10)}); }
    std::vector<std::size_t> put(std::size_t body, const geometry::Box& box) {
        if (!near.enterTree(body, box, false))
            return {};
        near.findPartners(body, near.tree.box(body), [](std::size_t) {});
        return near.all(body);
    }
    const scene::Scene scene = boxes();
    const std::vector<BodyRecord> records = recordsOf(scene);
    Neighbourhood near{scene, records, 1e-6};
};

TEST_F(NeighbourhoodTest, BoxesThatOverlapArePartnersOfEachOther) {
    EXPECT_THAT(put(1, around(0)), ElementsAre(0));
    EXPECT_THAT(put(2, around(1)), ElementsAre(0, 1));
    EXPECT_THAT(put(3, around(5)), ElementsAre(0));
    EXPECT_THAT(near.all(1), ElementsAre(0, 2));
    EXPECT_THAT(near.all(3), ElementsAre(0));
    EXPECT_THAT(near.all(0), IsEmpty()); // the others list a fixed body
}

// The box in the tree has some room, so that a body that hardly moves changes nothing.
TEST_F(NeighbourhoodTest, AShortWayKeepsTheBoxInTheTree) {
    (void)put(1, around(0));
    EXPECT_FALSE(near.enterTree(1, around(0.1), false));
    EXPECT_TRUE(near.enterTree(1, around(3), false));
}

TEST_F(NeighbourhoodTest, WhoGoesAwayIsNoPartnerAnyMore) {
    (void)put(1, around(0));
    (void)put(2, around(1));
    EXPECT_THAT(put(2, around(5)), ElementsAre(0));
    EXPECT_THAT(near.all(1), ElementsAre(0));
}

TEST_F(NeighbourhoodTest, WhoseMotionEndedIsMetWhereItStands) {
    (void)put(1, around(0));
    (void)put(2, around(1));
    near.leave(1);
    EXPECT_TRUE(near.hasEnded(1));
    EXPECT_THAT(near.all(2), ElementsAre(0));
    near.tree.put(1, around(0));
    near.findPartners(1, around(0), [](std::size_t) {});
    EXPECT_THAT(near.partners(1), ElementsAre(2)); // and not the floor, on which it stands
}

} // namespace
} // namespace simulation::testing
