#include "physics/crushing.h"

#include <gmock/gmock.h>

namespace physics {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A floor, two blocks on it, one on the other, and a press above: bodies 0 to 3.
class UnderAPress : public ::testing::Test {
protected:
    UnderAPress() {
        for (const int k : {0, 1, 2, 3}) {
            ImpactBody body;
            body.centre = {0, k - 0.5, 0};
            if (k == 1 || k == 2) {
                body.inverseMass = 0.1 * k;
                body.inverseInertia = Vector(1, 2, 3).asDiagonal();
            }
            bodies_.push_back(body);
        }
        bodies_[3].velocity = {0, -0.2, 0};
        for (const std::size_t upper : {1u, 2u, 3u})
            for (const double x : {-0.5, 0.5})
                contacts_.push_back({.first = upper,
                                     .second = upper - 1,
                                     .point = {x, static_cast<double>(upper) - 1, 0},
                                     .normal = {0, 1, 0}});
    }
    [[nodiscard]] Crushing found() const { return crushingOf(bodies_, contacts_, joints_); }

    std::vector<ImpactBody> bodies_;
    std::vector<ImpactContact> contacts_;
    std::vector<ImpactRow> joints_;
};

TEST_F(UnderAPress, AllContactsOfTheChainAreTold) {
    EXPECT_THAT(found().contacts, ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(found().joints, IsEmpty());
    EXPECT_THAT(found().pressed, ElementsAre(1, 2));
    EXPECT_THAT(found().between, ElementsAre(0, 3));
}

// The press is held at its place, and may turn.
TEST_F(UnderAPress, ABodyThatIsHeldInPartGivesNoWay) {
    bodies_[3].inverseInertia = Vector(1, 2, 3).asDiagonal();
    EXPECT_THAT(found().pressed, ElementsAre(1, 2));
    EXPECT_THAT(found().between, ElementsAre(0, 3));
}

TEST_F(UnderAPress, ABlockBesideTheChainHasNoPartInIt) {
    bodies_.push_back(bodies_[2]);
    bodies_[4].velocity = {0, -1, 0};
    bodies_[4].centre = {3, 0.5, 0};
    contacts_.push_back({.first = 4, .second = 0, .point = {3, 0, 0}, .normal = {0, 1, 0}});
    EXPECT_THAT(found().contacts, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(UnderAPress, AWayOutIsRoom) {
    bodies_[3].velocity = {0.2, 0, 0};
    EXPECT_THAT(found().contacts, IsEmpty()) << "it moves across";
    bodies_[3].velocity = {0, -0.2, 0};
    contacts_.erase(contacts_.begin(), contacts_.begin() + 2);
    EXPECT_THAT(found().contacts, IsEmpty()) << "there is no floor";
}

// A wedge under the press gives way to the side.
TEST_F(UnderAPress, AnAskewContactIsRoom) {
    for (const std::size_t contact : {2u, 3u})
        contacts_[contact].normal = Vector(0.1, 1, 0).normalized();
    EXPECT_THAT(found().contacts, IsEmpty());
}

// Friction holds a blunt wedge fast, and not a sharp one.
TEST_F(UnderAPress, ABluntWedgeIsCrushedBySidesThatGrip) {
    for (const std::size_t contact : {2u, 3u})
        contacts_[contact].normal = Vector(0.1, 1, 0).normalized();
    for (ImpactContact& contact : contacts_)
        contact.friction = 0.2;
    EXPECT_THAT(found().contacts, IsEmpty());
    const Crushing gripped = crushingOf(bodies_, contacts_, joints_, Sides::grip);
    EXPECT_THAT(gripped.pressed, ElementsAre(1, 2));
    EXPECT_THAT(gripped.between, ElementsAre(0, 3));
    for (ImpactContact& contact : contacts_)
        contact.friction = 0.02;
    EXPECT_THAT(crushingOf(bodies_, contacts_, joints_, Sides::grip).contacts, IsEmpty());
    for (ImpactContact& contact : contacts_)
        contact.friction = 1;
    bodies_[3].velocity = {0, 0.2, 0};
    EXPECT_THAT(crushingOf(bodies_, contacts_, joints_, Sides::grip).contacts, IsEmpty())
        << "the press goes up";
}

// The same with a press of a mass, which a joint drives.
TEST_F(UnderAPress, AJointThatDrivesThePressHasAPartInIt) {
    bodies_[3].inverseMass = 1;
    EXPECT_THAT(found().contacts, IsEmpty());
    joints_.push_back({{{.body = 3, .linear = {1, 0, 0}}}});
    joints_.push_back({{{.body = 3, .linear = {0, 1, 0}}}});
    EXPECT_THAT(found().contacts, ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(found().joints, ElementsAre(1));
    EXPECT_THAT(found().pressed, ElementsAre(1, 2));
    EXPECT_THAT(found().between, ElementsAre(0, 3));
}

} // namespace
} // namespace physics
