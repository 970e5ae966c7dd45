// Balls whose contact passes from one feature to the next: off the edge of a table, fast or slowly,
// round its corner, over crests and seams. Right values by formulas, at accuracies 1e-2 to 1e-10.
#include "simulation/testing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

constexpr std::array<double, 5> accuracies{1e-2, 1e-4, 1e-6, 1e-8, 1e-10};

// Integral over [0, 1] by Simpson's rule.
template <class Function> double integral(const Function& f) {
    constexpr int halves = 2000;
    double sum = f(0.0) + f(1.0);
    for (int i = 1; i < halves; ++i)
        sum += (i % 2 == 1 ? 4 : 2) * f(static_cast<double>(i) / halves);
    return sum / (3 * halves);
}

// A ball goes round an edge in the plane, from over it with speed v, and leaves where the edge
// would have to pull. theta is the angle from the vertical:
//     (r theta')^2 = v^2 + 2 g r (1 - cos(theta))      leaves at r theta'^2 = g cos(theta)
struct Round {
    double radius, speed;
    [[nodiscard]] double rateAt(double theta) const {
        return std::sqrt(speed * speed + 2 * g * radius * (1 - std::cos(theta))) / radius;
    }
    [[nodiscard]] double end() const {
        return std::acos(std::min(1.0, 2.0 / 3 + speed * speed / (3 * g * radius)));
    }
    [[nodiscard]] double timeTo(double theta) const {
        return theta * integral([&](double s) { return 1 / rateAt(s * theta); });
    }
    // The centre `time` after it was over the edge, which lies at 0.
    [[nodiscard]] Vector at(double time) const {
        double theta = end();
        const double leaves = timeTo(theta);
        for (int i = 0; i < 50 && time < leaves; ++i)
            theta = i == 0 ? speed * time / radius : theta + (time - timeTo(theta)) * rateAt(theta);
        const double flight = std::max(time - leaves, 0.0);
        const Vector out(std::sin(theta), std::cos(theta), 0), along(out.y(), -out.x(), 0);
        return radius * out + along * (radius * rateAt(theta) * flight) +
               Vector(0, -g / 2 * flight * flight, 0);
    }
};

struct Rolling {
    double radius, speed;
};

class OffATable : public ::testing::TestWithParam<Rolling> {};

// Whatever counts as touching: the face bears until the centre is over the edge.
TEST_P(OffATable, ABallLeavesWhereItsCentrePassesTheEdge) {
    const auto [radius, speed] = GetParam();
    const Round round{radius, speed};
    const double reaches = 0.5 / speed, finish = reaches + round.timeTo(round.end()) + 0.5;
    for (const double accuracy : accuracies) {
        SceneBuilder b(finish, accuracy);
        b.box("table", {-2, -0.1, 0}, {4, 0.2, 2}).fixed = true;
        scene::Body& ball = b.ball("ball", {-0.5, radius, 0}, radius);
        ball.restitution = 0;
        ball.initialVelocity = {speed, 0, 0};
        b.weight("ball");
        const Result result = simulate(b.scene);
        EXPECT_FALSE(result.motion->stop(1)) << accuracy;
        EXPECT_TRUE(result.motion->impacts().empty()) << accuracy;
        for (int i = 0; i <= 20; ++i) {
            const double t = reaches + (finish - reaches) * i / 20;
            EXPECT_LT(distance(result.motion->at(1, t).position, round.at(t - reaches)),
                      (speed * speed > g * radius ? 1e-12 : 0.5 * accuracy + 1e-12))
                << accuracy << " at " << t;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Speeds, OffATable,
                         ::testing::Values(Rolling{0.1, 1.5}, Rolling{0.1, 5}, Rolling{1, 4},
                                           Rolling{0.02, 1}, Rolling{0.1, 0.5}, Rolling{1, 0.5},
                                           Rolling{0.1, 0.98}, Rolling{0.1, 1}));

// Over the corner of a table it goes round a vertex as round an edge; past it at a slant, fast, it
// flies from where its centre passes the edge.
TEST(OffATablesCorner, ABallGoesAsOffItsEdge) {
    for (const double speed : {0.5, 1.5})
        for (const double accuracy : accuracies) {
            const Round round{0.1, speed};
            const Vector along = Vector(1, 0, 1).normalized();
            const double reaches = 0.5 / speed, finish = reaches + 0.5;
            SceneBuilder b(finish, accuracy);
            b.box("table", {-2, -0.1, -2}, {4, 0.2, 4}).fixed = true;
            scene::Body& ball = b.ball("ball", Vector(0, 0.1, 0) - 0.5 * along);
            ball.restitution = 0;
            ball.initialVelocity = speed * along;
            b.weight("ball");
            const Result result = simulate(b.scene);
            EXPECT_TRUE(result.motion->impacts().empty()) << accuracy;
            for (const double t : {0.1, 0.3, 0.5}) {
                const Vector place = round.at(t);
                EXPECT_LT(distance(result.motion->at(1, reaches + t).position,
                                   Vector(0, place.y(), 0) + place.x() * along),
                          0.5 * accuracy + 1e-11)
                    << speed << " " << accuracy << " at " << t;
            }
        }
}

// A floor to x = 0, and from there a plane that rises or falls.
SceneBuilder floorAndSlope(double finish, double accuracy, double angle) {
    SceneBuilder b(finish, accuracy);
    b.box("floor", {-2, -0.1, 0}, {4, 0.2, 2}).fixed = true;
    const auto turn = geometry::fromRotationVector({0, 0, angle});
    scene::Body& slope = b.box("slope", turn * Vector(2, -0.1, 0), {4, 0.2, 2});
    slope.initialAttitude = turn;
    slope.fixed = true;
    return b;
}

// A ball of 0.1 that comes to the crest at 0.3 and goes down a slope beyond.
struct Over {
    double angle = 0.35;
    Round round{0.1, 0.3};
    Vector down{std::cos(angle), -std::sin(angle), 0}, up{std::sin(angle), std::cos(angle), 0};
    double around = round.timeTo(angle), fast = 0.1 * round.rateAt(angle); // as it leaves the edge
};
const Over slowly;

// Slowly over the crest: round the edge, down the slope, at all accuracies; and the same way up.
TEST(Crest, ABallGoesRoundItFromFaceToFaceAndBack) {
    const auto& [angle, round, down, up, around, fast] = slowly;
    const Round upwards{0.1, 0.8};
    const double aroundUp = upwards.timeTo(angle), fastUp = 0.1 * upwards.rateAt(angle);
    for (const double accuracy : accuracies) {
        SceneBuilder b = floorAndSlope(1.2, accuracy, -angle);
        scene::Body& ball = b.ball("ball", {-0.15, 0.1, 0});
        ball.restitution = 0;
        ball.initialVelocity = {0.3, 0, 0};
        scene::Body& back = b.ball("back", {0, 0, 0.5});
        back.restitution = 0;
        back.initialVelocity = -(fastUp + g * std::sin(angle) * 0.2) * down;
        back.initialPosition +=
            0.1 * up + (fastUp * 0.2 + g / 2 * std::sin(angle) * 0.2 * 0.2) * down;
        b.weight("ball");
        b.weight("back");
        const Result result = simulate(b.scene);
        EXPECT_TRUE(result.motion->impacts().empty()) << accuracy;
        for (const double t : {0.2, 0.4, 0.6}) {
            const double after = 0.5 + around + t;
            EXPECT_LT(
                distance(result.motion->at(2, 0.5 + around / 2).position, round.at(around / 2)),
                0.5 * accuracy + 1e-11)
                << accuracy;
            EXPECT_LT(distance(result.motion->at(2, after).position,
                               0.1 * up + (fast * t + g / 2 * std::sin(angle) * t * t) * down),
                      0.5 * accuracy + 1e-11)
                << accuracy << " at " << t;
            EXPECT_LT(
                distance(result.motion->at(3, 0.2 + aroundUp + t).position, {-0.8 * t, 0.1, 0.5}),
                0.5 * accuracy + 1e-11)
                << accuracy << " back, at " << t;
        }
    }
}

// Up a slope so slowly over its upper edge that it would be back within half a second, could the
// slope hold it there: between two looks.
TEST(Crest, ASlowBallPassesItOnItsWayUpToo) {
    const auto& [angle, round, down, up, around, fast] = slowly;
    for (const double accuracy : accuracies) {
        SceneBuilder b = floorAndSlope(1.2, accuracy, -angle);
        scene::Body& ball =
            b.ball("ball", 0.1 * up + (fast * 0.2 + g / 2 * std::sin(angle) * 0.2 * 0.2) * down);
        ball.restitution = 0;
        ball.initialVelocity = -(fast + g * std::sin(angle) * 0.2) * down;
        b.weight("ball");
        const Result result = simulate(b.scene);
        EXPECT_TRUE(result.motion->impacts().empty()) << accuracy;
        for (const double t : {0.2, 0.4, 0.6})
            EXPECT_LT(distance(result.motion->at(2, 0.2 + around + t).position, {-0.3 * t, 0.1, 0}),
                      0.5 * accuracy + 1e-11)
                << accuracy << " at " << t;
    }
}

// Onto a slope and back onto the floor: what is across the new face is lost each time.
TEST(Foot, OfASlopeTakesWhatIsAcrossIt) {
    const double angle = 0.35, lost = std::cos(angle), pull = g * std::sin(angle);
    const double foot = -0.1 * std::tan(angle / 2), reaches = (0.5 + foot) / 1.5;
    const Vector uphill(std::cos(angle), std::sin(angle), 0);
    const double back = 2 * 1.5 * lost / pull;
    for (const double accuracy : accuracies) {
        SceneBuilder b = floorAndSlope(2, accuracy, angle);
        scene::Body& ball = b.ball("ball", {-0.5, 0.1, 0});
        ball.restitution = 0;
        ball.initialVelocity = {1.5, 0, 0};
        b.weight("ball");
        const Result result = simulate(b.scene);
        EXPECT_EQ(result.motion->impacts().size(), 2u) << accuracy;
        for (const double t : {0.1, 0.4, 0.6})
            EXPECT_LT(distance(result.motion->at(2, reaches + t).position,
                               Vector(foot, 0.1, 0) + (1.5 * lost * t - pull / 2 * t * t) * uphill),
                      0.1 * accuracy + 1e-11)
                << accuracy << " at " << t;
        EXPECT_LT(distance(result.motion->at(2, reaches + back + 0.4).position,
                           {foot - 0.4 * 1.5 * lost * lost, 0.1, 0}),
                  0.1 * accuracy + 1e-11)
            << accuracy;
    }
}

// Nothing of it is felt, with weight or without, whatever the speed, and however small the gap.
TEST(BallsAndSeams, AreRolledOver) {
    for (const double speed : {1e-3, 0.5, 3.0})
        for (const double gap : {0.0, 1e-12, 1e-9})
            for (const double restitution : {0.0, 0.5, 1.0})
                for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10})
                    for (const bool isHeavy : {true, false}) {
                        SceneBuilder b(1 / speed, accuracy);
                        b.box("first", {-2, -0.1, 0}, {4, 0.2, 2}).fixed = true;
                        b.box("second", {2 + gap, -0.1, 0}, {4, 0.2, 2}).fixed = true;
                        scene::Body& ball = b.ball("ball", {-0.5, 0.1, 0.3});
                        ball.restitution = restitution;
                        ball.initialVelocity = {speed, 0, 0};
                        if (isHeavy)
                            b.weight("ball");
                        const Result result = simulate(b.scene);
                        EXPECT_FALSE(result.motion->stop(2));
                        EXPECT_LT(
                            distance(result.motion->at(2, 1 / speed).position, {0.5, 0.1, 0.3}),
                            1e-9)
                            << speed << " " << gap << " " << restitution << " " << accuracy;
                    }
}

TEST(Wall, OnTheFloorStopsABallOrSendsItBack) {
    for (const double restitution : {0.0, 0.5, 1.0})
        for (const double accuracy : accuracies) {
            SceneBuilder b(2, accuracy);
            b.box("floor", {0, -0.1, 0}, {8, 0.2, 2}).fixed = true;
            b.box("wall", {1.5, 0.5, 0}, {1, 1, 2}).fixed = true;
            scene::Body& ball = b.ball("ball", {-0.1, 0.1, 0});
            ball.restitution = restitution;
            ball.initialVelocity = {1, 0, 0};
            b.weight("ball");
            const Result result = simulate(b.scene);
            EXPECT_EQ(result.motion->impacts().size(), 1u) << accuracy;
            EXPECT_LT(distance(result.motion->at(2, 2).position, {0.9 - restitution, 0.1, 0}),
                      1e-11)
                << accuracy;
        }
}

// In a groove between two planes at 30 degrees a ball keeps half of its speed each time that it
// goes over to the other plane, and lies still after (1 + 2) times the first way down. What lies
// still costs nothing more, at any accuracy.
TEST(BallInAGroove, HalvesItsSpeedEachTimeAndLiesStill) {
    const double angle = std::numbers::pi / 6, pull = g * std::sin(angle);
    const double first = std::sqrt(2 / pull), fastest = pull * first;
    const auto placeAt = [&](double t) { // along the planes, on either side
        if (t < first)
            return -1 + pull / 2 * t * t;
        t -= first;
        double speed = fastest / 2, side = 1;
        for (int i = 0; i < 60; ++i, t -= 2 * speed / pull, speed /= 2, side = -side)
            if (t < 2 * speed / pull)
                return side * (speed * t - pull / 2 * t * t);
        return 0.0;
    };
    for (const double accuracy : accuracies) {
        SceneBuilder b(20, accuracy);
        for (const double side : {-1.0, 1.0}) {
            const auto turn = geometry::fromRotationVector({0, 0, side * angle});
            scene::Body& plane =
                b.box(side < 0 ? "left" : "right", turn * Vector(side * 3, -0.5, 0), {6, 1, 4});
            plane.initialAttitude = turn;
            plane.fixed = true;
        }
        scene::Body& ball =
            b.ball("ball", {-std::cos(angle), std::sin(angle) + 0.1 / std::cos(angle), 0});
        ball.restitution = 0;
        b.weight("ball");
        const Result result = simulate(b.scene);
        for (const double t : {0.3, 0.9, 1.4, 1.7, 1.85, 1.9, 1.93, 3.0, 20.0}) {
            const double along = placeAt(t);
            EXPECT_LT(distance(result.motion->at(2, t).position,
                               {along * std::cos(angle),
                                std::abs(along) * std::sin(angle) + 0.1 / std::cos(angle), 0}),
                      0.1 * accuracy + 2e-9)
                << accuracy << " at " << t;
        }
        EXPECT_LT(result.motion->at(2, 20).velocity.norm(), 1e-12) << accuracy;
        EXPECT_LT(result.statistics.pairTests, 2000u) << accuracy;
        EXPECT_LT(result.motion->impacts().size(), 40u) << accuracy;
    }
}

} // namespace
} // namespace simulation::testing
