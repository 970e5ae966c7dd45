// Drags of bodies that joints hold.
#include "gestures/handle_drag.h"
#include "gestures/handle_meaning.h"

#include "script/reader.h"

#include <gmock/gmock.h>

#include <cmath>

namespace gestures {
namespace {

using ::testing::HasSubstr;

struct Dragged {
    std::string text, words;
    bool isPossible = false;
    std::shared_ptr<const scene::Scene> scene;
    [[nodiscard]] const scene::Body& body(const std::string& name) const {
        return *scene::findBody(*scene, name);
    }
};

std::shared_ptr<const scene::Scene> sceneOf(const std::string& text) {
    static script::Reader reader;
    const script::ReadResult read = reader.read(text);
    EXPECT_TRUE(read.usable) << text;
    return std::make_shared<const scene::Scene>(read.scene);
}

// Seen along z; the body is taken beside its middle, and moved in two steps.
Dragged drag(const std::string& text, std::size_t body, const Vector& off, const Vector& to,
             const std::optional<HandleDrag::Along>& along = std::nullopt, bool snaps = false,
             const std::vector<std::size_t>& company = {}) {
    const auto scene = sceneOf(text);
    render::Camera camera;
    camera.scale = 0.1;
    const Sight sight{camera, {800, 800}};
    Dragged made;
    const Ground ground{text, scene, nullptr, [](const std::string&) {},
                        [&](const std::string& now, const std::string&) { made.text = now; }};
    render::Handle handle;
    handle.element = body;
    handle.base = handle.place = scene->bodies[body].initialPosition;
    const Eigen::Vector2d from = sight.pixels(handle.place + off), target = sight.pixels(to);
    HandleDrag drag(ground, sight, handle, from);
    drag.setCompany(company);
    drag.setUpright();
    drag.setAlong(along);
    if (snaps)
        drag.setSnaps(1);
    drag.move((from + target) / 2);
    drag.move(target);
    made.words = drag.words();
    made.isPossible = drag.answer().possible();
    drag.finish();
    made.scene = sceneOf(made.text);
    return made;
}

Vector pointOf(const Dragged& made, const std::string& body, const Vector& offset) {
    const scene::Body& one = made.body(body);
    return one.initialPosition + one.initialAttitude * offset;
}

const std::string bob = "shape_set ball -desc {-sub {-sphere 0.3}}\n"
                        "body bob ball -init_pos {1 -2 0}\n";
const std::string pendulum = bob + "joint hinge -type hinge -body1 bob -offset1 {0 2 0}\n";

TEST(Joined, APendulumIsPulledAsideByWholeDegreesAboutItsPivot) {
    const Dragged made = drag(pendulum, 0, {0, 0, 0}, {3, -2, 0}); // past 45 degrees
    EXPECT_LT((pointOf(made, "bob", {0, 2, 0}) - Vector(1, 0, 0)).norm(), 1e-12) << made.text;
    const Vector way(std::sin(M_PI / 4), -std::cos(M_PI / 4), 0);
    EXPECT_LT((made.body("bob").initialPosition - Vector(1, 0, 0) - 2 * way).norm(), 1e-12);
    EXPECT_THAT(made.words, HasSubstr("turned by 45 degrees, as its joints allow"));
    EXPECT_THAT(made.text, HasSubstr("joint hinge -type hinge -body1 bob -offset1 {0 2 0}\n"));
    // Once more, and back: the pivot is where it was.
    const Dragged back = drag(made.text, 0, {0, 0, 0}, {1, -3, 0});
    EXPECT_LT((back.body("bob").initialPosition - Vector(1, -2, 0)).norm(), 1e-12) << back.text;
}

TEST(Joined, AVelocityAtTheStartTurnsWithThePendulum) {
    const Dragged made = drag("shape_set ball -desc {-sub {-sphere 0.3}}\n"
                              "body bob ball -init_pos {1 -2 0} -init_dpos {2 0 0} -init_drot "
                              "{0 0 1}\njoint hinge -type hinge -body1 bob -offset1 {0 2 0}\n",
                              0, {0, 0, 0}, {5, 0, 0});
    EXPECT_LT((made.body("bob").initialVelocity - Vector(0, 2, 0)).norm(), 1e-9) << made.text;
    EXPECT_LT((made.body("bob").initialAngularVelocity - Vector(0, 0, 1)).norm(), 1e-9);
}

TEST(Joined, AlongAnAxisItMovesWithItsPivot) {
    for (const std::string pivot : {"", " -offset2 {1 0 0}"}) {
        const std::string text = pendulum.substr(0, pendulum.size() - 1) + pivot + "\n";
        const Dragged made = drag(text, 0, {0, 0, 0}, {2, -1, 0}, HandleDrag::Along{0});
        EXPECT_LT((made.body("bob").initialPosition - Vector(2, -2, 0)).norm(), 1e-12);
        EXPECT_TRUE(made.body("bob").initialAttitude.isApprox(geometry::Quaternion::Identity()));
        EXPECT_EQ(made.text.find("-offset2 {2 0 0}") != std::string::npos, !pivot.empty());
    }
}

// A ball, a pendulum on the world, and a ball that hangs on a body that goes along, too.
TEST(Joined, SeveralAreDraggedByOneWayWithWhatHoldsThem) {
    const std::string text =
        pendulum + "body free ball -init_pos {4 1 2}\n"
                   "body post ball -fixed 1 -init_pos {-3 0 0}\n"
                   "body low ball -init_pos {-3 -2 0}\n"
                   "joint h -type hinge -body1 low -offset1 {0 2 0} -body2 post -offset2 {0 0 0}\n"
                   "body stays ball -init_pos {0 5 0}\n";
    const Dragged made = drag(text, 1, {0.1, 0, 0}, {5.1, 3, 2}, std::nullopt, false, {0, 2, 3});
    const Vector way(1, 2, 0);
    const auto before = sceneOf(text);
    for (const std::string name : {"bob", "free", "post", "low"})
        EXPECT_LT((made.body(name).initialPosition - way -
                   scene::findBody(*before, name)->initialPosition)
                      .norm(),
                  1e-9)
            << name << made.text;
    EXPECT_EQ(made.body("stays").initialPosition, Vector(0, 5, 0));
    EXPECT_THAT(made.text, HasSubstr("-offset2 {0 0 0}\n")); // of a body that goes along
    EXPECT_THAT(made.words, HasSubstr("with 3 more"));
}

// A straight chain, whose end is pulled aside by one move: it comes to the hand while that rests.
TEST(Joined, ALongChainComesToTheHandThatRests) {
    constexpr int count = 30;
    std::string text = "shape_set link -desc {-sub {-box {0.05 0.2 0.05}}}\n";
    for (int i = 0; i < count; ++i) {
        const std::string name = "b" + std::to_string(i);
        text += "body " + name + " link -init_pos {0 " + std::to_string(-0.2 * i) + " 0}\njoint j" +
                std::to_string(i) + " -type ball -body1 " + name + " -offset1 {0 0.1 0}" +
                (i == 0 ? "" : " -body2 b" + std::to_string(i - 1) + " -offset2 {0 -0.1 0}") + "\n";
    }
    const auto scene = sceneOf(text);
    render::Camera camera;
    camera.scale = 0.1;
    const Sight sight{camera, {800, 800}};
    const Ground ground{text, scene, nullptr, [](const std::string&) {},
                        [](const std::string&, const std::string&) {}};
    render::Handle handle;
    handle.element = count - 1;
    handle.base = handle.place = scene->bodies[count - 1].initialPosition;
    HandleDrag drag(ground, sight, handle, sight.pixels(handle.place));
    drag.setUpright();
    const Vector hand = Vector(4, -2, 0);
    drag.move(sight.pixels(hand));
    const double after = (drag.place() - hand).norm();
    EXPECT_GT(after, 0.1); // else the test tests nothing
    int times = 0;
    while (drag.goOn() && ++times < 200) {
    }
    EXPECT_LT(times, 200);
    EXPECT_LT((drag.place() - hand).norm(), std::min(0.05, after / 2)) << after << " " << times;
    EXPECT_FALSE(drag.goOn());
}

TEST(Joined, ACarMovesAsAWholeAndAWheelOnTheWorldTurnsByItsRim) {
    const std::string car = "shape_set box -desc {-sub {-box {4 1 1}}}\n"
                            "shape_set wheel -desc {-sub {-sphere 0.5}}\n"
                            "body chassis box\nbody front wheel -init_pos {1.5 -0.5 0}\n"
                            "body back wheel -init_pos {-1.5 -0.5 0}\n"
                            "joint f -type hinge -body1 front -body2 chassis\n"
                            "joint b -type hinge -body1 back -body2 chassis\n";
    const Dragged made = drag(car, 0, {1.8, 0, 0}, {2.8, 3, 0});
    EXPECT_LT((made.body("chassis").initialPosition - Vector(1, 3, 0)).norm(), 1e-9);
    EXPECT_LT((made.body("front").initialPosition - Vector(2.5, 2.5, 0)).norm(), 1e-9);
    EXPECT_LT((made.body("back").initialPosition - Vector(-0.5, 2.5, 0)).norm(), 1e-9);
    EXPECT_THAT(made.words, HasSubstr("with all that is joined to it"));
    const std::string wheel = "shape_set wheel -desc {-sub {-sphere 0.5}}\nbody w wheel\n"
                              "joint axle -type hinge -body1 w -offset1 {0 0 0}\n";
    const Dragged turned = drag(wheel, 0, {0.4, 0, 0}, {0, 0.4, 0});
    EXPECT_LT(turned.body("w").initialPosition.norm(), 1e-9);
    EXPECT_NEAR(geometry::toRotationVector(turned.body("w").initialAttitude).z(), M_PI / 2, 1e-9);
    const Dragged moved = drag(wheel, 0, {0, 0, 0}, {1, 1, 0});
    EXPECT_LT((moved.body("w").initialPosition - Vector(1, 1, 0)).norm(), 1e-9);
}

TEST(Joined, ASupportThatIsFixedTakesAlongWhatHangsOnIt) {
    const Dragged made =
        drag("shape_set ball -desc {-sub {-sphere 0.3}}\nbody top ball -fixed 1\n"
             "body bob ball -init_pos {0 -2 0}\n"
             "joint hinge -type hinge -body1 bob -offset1 {0 2 0} -body2 top -offset2 {0 0 0}\n",
             0, {0, 0, 0}, {1, 2, 0});
    EXPECT_LT((made.body("bob").initialPosition - Vector(1, 0, 0)).norm(), 1e-9) << made.text;
}

TEST(Joined, ASliderGoesAlongItsLineToRoundPlaces) {
    const Dragged made =
        drag("shape_set ball -desc {-sub {-sphere 0.3}}\nbody b ball -init_pos {0 1 0}\n"
             "joint rail -type slider -body1 b -axis {1 0 0}\n",
             0, {0, 0, 0}, {2.5, 4, 0});
    EXPECT_LT((made.body("b").initialPosition - Vector(2.5, 1, 0)).norm(), 0.02) << made.text;
    EXPECT_EQ(made.body("b").initialPosition.y(), 1);
}

TEST(Joined, WhatNothingLetsGoIsMovedWithWhatHoldsIt) {
    const Dragged made = drag(bob + "joint pin -type fixed -body1 bob -offset2 {1 -2 0}\n", 0,
                              {0, 0, 0}, {2, -1, 0});
    EXPECT_TRUE(made.isPossible) << made.words;
    EXPECT_LT((made.body("bob").initialPosition - Vector(2, -1, 0)).norm(), 1e-9) << made.text;
    EXPECT_THAT(made.text, HasSubstr("-offset2 {2 -1 0}"));
}

TEST(Joined, AlongAnAxisRopesAndPointsOfBodiesThatStayGoAlong) {
    const Dragged hung = drag(bob + "rope r -points {{bob {0 0 0}} {1 0 0}} -length 2\n", 0,
                              {0, 0, 0}, {2, -1, 0}, HandleDrag::Along{0});
    EXPECT_THAT(hung.text, HasSubstr("{{bob {0 0 0}} {2 0 0}}")) << hung.words;
    EXPECT_LT((hung.body("bob").initialPosition - Vector(2, -2, 0)).norm(), 1e-9);
    const Dragged held = drag(bob + "body top ball -fixed 1 -init_pos {1 0 0}\n"
                                    "joint j -type ball -body1 top -body2 bob -offset2 {0 2 0}\n",
                              0, {0, 0, 0}, {2, -1, 0}, HandleDrag::Along{0});
    EXPECT_THAT(held.text, HasSubstr("-offset1 {1 0 0}")) << held.words;
}

TEST(Joined, MoreBodiesThanAHandPullsAreNotTornApart) {
    std::string chain = "shape_set ball -desc {-sub {-sphere 0.3}}\n";
    for (int i = 0; i < 42; ++i)
        chain += "body b" + std::to_string(i) + " ball -init_pos {0 " + std::to_string(-i) +
                 " 0}\njoint j" + std::to_string(i) + " -type ball -body1 b" + std::to_string(i) +
                 " -offset1 {0 0.5 0}" +
                 (i == 0 ? std::string() : " -body2 b" + std::to_string(i - 1)) + "\n";
    const Dragged refused = drag(chain, 1, {0, 0, 0}, {1, -1, 0});
    EXPECT_FALSE(refused.isPossible);
    EXPECT_THAT(refused.words, HasSubstr("\"b1\" hangs together with 41 other bodies"));
    EXPECT_EQ(refused.text, chain);
    const Dragged moved = drag(chain, 1, {0, 0, 0}, {1, -1, 0}, HandleDrag::Along{0});
    EXPECT_TRUE(moved.isPossible) << moved.words;
    EXPECT_NEAR(moved.body("b41").initialPosition.x(), 1, 1e-9);
}

TEST(Joined, CoordinatesThatStayMayBeComputed) {
    const Dragged made = drag("set L 2\nshape_set ball -desc {-sub {-sphere 0.3}}\n"
                              "body bob ball -init_pos \"0 [expr {-$L}] 0\"\n"
                              "joint rail -type slider -body1 bob -axis {1 0 0}\n",
                              0, {0, 0, 0}, {2, -1, 0});
    EXPECT_TRUE(made.isPossible) << made.words;
    EXPECT_NEAR(made.body("bob").initialPosition.x(), 2, 0.05) << made.text;
    EXPECT_THAT(made.text, HasSubstr("[expr {-$L}] 0\""));
}

TEST(Joined, WhatCouldTurnAndDoesNotComesToRoundPlaces) {
    const Dragged made = drag("shape_set ball -desc {-sub {-sphere 0.3}}\nbody b ball\n"
                              "joint table -type planar -body1 b -axis {0 0 1}\n",
                              0, {0, 0, 0}, {2.02, 1.03, 0}, std::nullopt, true);
    EXPECT_LT((made.body("b").initialPosition - Vector(2, 1, 0)).norm(), 1e-9) << made.text;
    EXPECT_THAT(made.words, ::testing::Not(HasSubstr("degrees")));
}

TEST(Joined, AKeyTurnsAPendulum) {
    const auto scene = sceneOf(pendulum);
    render::Camera camera;
    camera.scale = 0.1;
    std::string made;
    const Ground ground{pendulum, scene, nullptr, [](const std::string&) {},
                        [&](const std::string& now, const std::string&) { made = now; }};
    render::Handle handle;
    handle.base = handle.place = scene->bodies[0].initialPosition;
    HandleDrag drag(ground, {camera, {800, 800}}, handle, std::nullopt);
    drag.nudge({2, 0});
    drag.finish();
    EXPECT_GT(sceneOf(made)->bodies[0].initialPosition.x(), 1.01) << made;
}

struct Turned {
    std::string text, words;
};

// By a ring, about the middle of a bar that reaches from the body's origin to 4 along x.
Turned turn(const std::string& text, std::size_t body, int axis, double quarters) {
    const auto scene = sceneOf(text);
    render::Camera camera;
    camera.scale = 0.1;
    const Sight sight{camera, {800, 800}};
    Turned made;
    const Ground ground{text, scene, nullptr, [](const std::string&) {},
                        [&](const std::string& now, const std::string&) { made.text = now; }};
    render::Handle handle;
    handle.kind = render::HandleKind::orientation;
    handle.element = body;
    handle.frame = {scene->bodies[body].initialPosition, scene->bodies[body].initialAttitude};
    handle.base = handle.place = handle.frame.toWorld({2, 0, 0});
    handle.perUnit = 1;
    const Eigen::Vector2d middle = sight.pixels(handle.base);
    const auto at = [&](double angle) {
        return Eigen::Vector2d(middle + 100 * Eigen::Vector2d(std::cos(angle), -std::sin(angle)));
    };
    HandleDrag drag(ground, sight, handle, at(0));
    drag.setTurns(axis);
    for (int k = 1; k <= 10; ++k)
        if (axis == 2)
            drag.move(at(quarters * M_PI / 20 * k));
        else // seen from the side
            drag.move(at(0) + Eigen::Vector2d(0, 15 * quarters * k));
    made.words = drag.words();
    drag.finish();
    return made;
}

const std::string bar = "shape_set bar -desc {-sub {-pos {2 0 0} -box {4 0.4 0.4}}}\n"
                        "body b bar -init_pos {0 3 0}\n";

TEST(Joined, ARingTurnsAHingedBodyAboutItsHingeOnly) {
    const std::string hinged = bar + "joint h -type hinge -body1 b -offset1 {0 0 0} -offset2 "
                                     "{0 3 0} -axis {0 0 1}\n";
    const Turned made = turn(hinged, 0, 2, 3);
    EXPECT_THAT(made.text, HasSubstr("body b bar -init_pos {0 3 0} -init_rot {0 0 "));
    EXPECT_THAT(made.words, HasSubstr("turned by 270 degrees about z, as its joints allow"));
    const Turned across = turn(hinged, 0, 0, 1);
    EXPECT_EQ(across.text, hinged);
    EXPECT_EQ(across.words, "\"b\" is held by joint \"h\": it does not turn so about x.");
    const Turned alone = turn(bar, 0, 2, 1); // about its middle
    EXPECT_THAT(alone.text, HasSubstr("-init_pos {2 1 0}"));
}

TEST(Joined, ATextThatPlacesABodyWithOthersDoesNotPlaceItAlone) {
    const auto isAlone = [](const std::string& position) {
        const std::string text = "shape_set s -desc {-sub {-sphere 1}}\nset h 3\nbody b s " +
                                 position + "\nbody c s -init_pos \"0 $h 3\"\n";
        return isPlacedAlone(editing::Mapper(text, sceneOf(text)), 0);
    };
    EXPECT_TRUE(isAlone("-init_pos {0 3 0}"));
    EXPECT_TRUE(isAlone(""));
    EXPECT_FALSE(isAlone("-init_pos \"0 $h 0\""));
    EXPECT_FALSE(isAlone("-init_pos \"[expr {$h * $h}] 0 0\""));
}

} // namespace
} // namespace gestures
