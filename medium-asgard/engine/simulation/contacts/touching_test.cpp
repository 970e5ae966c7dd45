// Where a body touches another, and how each gap changes: a box or a ball above a floor or a ball.
#include "contacts/touching.h"

#include "contacts/colliders.h"
#include "contacts/contact_places.h"
#include "contacts/contact_sides.h"
#include "run/problem.h"
#include "simulation/testing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

constexpr double tolerance = 1e-7;

// Body 0 stands, body 1 is placed.
class Touching : public ::testing::Test {
protected:
    void build(const SceneBuilder& builder) {
        problem = std::get<std::shared_ptr<Problem>>(problemOf(builder.scene, {}));
        world.emplace(problem->scene, problem->equations, problem->shapes, 0,
                      std::vector<ContactResolution>(problem->bodies->size()));
    }
    void boxOnFloor() {
        SceneBuilder b(1);
        b.floor();
        b.box("box", {0, 1, 0}, {2, 1, 1});
        build(b);
    }
    void ballOnBall() {
        SceneBuilder b(1);
        b.ball("below", {0, 0, 0}, 1).fixed = true;
        b.ball("above", {0, 2, 0}, 1);
        build(b);
    }
    [[nodiscard]] Placed placed(std::size_t body, const Vector& position,
                                const Vector& velocity = Vector::Zero()) const {
        Placed made;
        made.index = body;
        made.record = &world->records[body];
        made.shape = &world->moving[body].shape();
        made.state = {.position = position, .velocity = velocity};
        return made;
    }
    [[nodiscard]] std::vector<Touch> touches(const Placed& body) const {
        return touchesOf(body, placed(0, world->records[0].start.position), tolerance);
    }
    std::shared_ptr<Problem> problem;
    std::optional<Colliders> world;
};

TEST_F(Touching, ABoxThatLiesFlatTouchesWithFourCorners) {
    boxOnFloor();
    const auto found = touches(placed(1, {0, 0.5, 0}, {1, -0.25, 0}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].isFlat);
    EXPECT_TRUE(found[0].isModelled);
    EXPECT_LT(distance(found[0].normal, {0, 1, 0}), 1e-15);
    ASSERT_EQ(found[0].corners.size(), 4u);
    for (const Corner& corner : found[0].corners) {
        EXPECT_NEAR(corner.gap, 0, 1e-15);
        EXPECT_NEAR(corner.rate, -0.25, 1e-15); // sliding along changes no gap
        EXPECT_NEAR(std::abs(corner.point.x()), 1, 1e-15);
    }
    EXPECT_NEAR(found[0].rate(), -0.25, 1e-15);
}

TEST_F(Touching, NothingThatIsFartherThanTheTolerance) {
    boxOnFloor();
    EXPECT_TRUE(touches(placed(1, {0, 0.5 + 1e-3, 0})).empty());
    EXPECT_EQ(touches(placed(1, {0, 0.5 - 1e-8, 0})).size(), 1u); // it overlaps by an error
}

TEST_F(Touching, ATurningBoxHasCornersThatRiseAndSink) {
    boxOnFloor();
    Placed box = placed(1, {0, 0.5, 0});
    box.state.angularVelocity = {0, 0, 2};
    for (const Touch& touch : touches(box))
        for (const Corner& corner : touch.corners) {
            EXPECT_NEAR(corner.rate, 2 * corner.point.x(), 1e-14);
        }
}

// A box tips about the edge of the equal box below, and turns a little: its edge crosses the border
// of the face in the middle, at an angle at which nothing crosses.
TEST_F(Touching, AnEdgeAlongTheBorderOfAFaceCarriesAtBothEnds) {
    SceneBuilder b(1);
    b.box("below", {0, -0.25, 0}, {0.5, 0.5, 0.5}).fixed = true;
    b.box("tips", {0, 2, 0}, {0.5, 0.5, 0.5});
    build(b);
    const Placed below = placed(0, world->records[0].start.position);
    for (const auto& [turned, aside] : {std::pair(1e-7, 0.0), {1e-7, 0.02}, {-1e-7, 0.02}}) {
        Placed box = placed(1, Vector::Zero());
        box.state.attitude =
            Eigen::AngleAxisd(turned, Vector::UnitY()) * Eigen::AngleAxisd(-1e-3, Vector::UnitZ());
        box.state.position = Vector(0.25, 0, aside) - box.state.attitude * Vector(0.25, -0.25, 0);
        TouchLimits limits;
        limits.gap = 1e-8;
        const auto found = lastingContacts(box, below, limits);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_TRUE(found[0].isModelled);
        std::vector<double> ends;
        for (const physics::ContactPoint& point : found[0].place.points)
            ends.push_back(physics::nearest(point.gap, poseOf(box), poseOf(below)).contact.z());
        std::ranges::sort(ends);
        EXPECT_THAT(ends, ::testing::Pointwise(::testing::DoubleNear(1e-6), {aside - 0.25, 0.25}));
    }
}

// A box on an equal one, shifted by less than corners are told apart: of the two pairs of edges
// that cross at a corner those count that cross within both.
TEST_F(Touching, EqualFacesTouchWhereTheirEdgesCrossWithinBoth) {
    SceneBuilder b(1);
    b.box("below", {0, -0.25, 0}, {0.5, 0.5, 0.5}).fixed = true;
    b.box("above", {0, 2, 0}, {0.5, 0.5, 0.5});
    build(b);
    const Placed below = placed(0, world->records[0].start.position);
    constexpr double shift = 2e-6;
    TouchLimits limits;
    limits.gap = 1e-8;
    for (const double x : {-shift, shift})
        for (const double z : {-shift, shift}) {
            const Placed box = placed(1, {x, 0.25, z});
            const auto found = lastingContacts(box, below, limits);
            ASSERT_EQ(found.size(), 1u);
            ASSERT_EQ(found[0].place.points.size(), 4u);
            for (const physics::ContactPoint& point : found[0].place.points) {
                const Vector at = physics::nearest(point.gap, poseOf(box), poseOf(below)).contact;
                for (const auto& [along, of] : {std::pair(at.x(), x), std::pair(at.z(), z)}) {
                    EXPECT_LE(std::abs(along), 0.25 + 1e-9);
                    EXPECT_LE(std::abs(along - of), 0.25 + 1e-9);
                }
            }
        }
}

TEST_F(Touching, ABallThatPassesAnotherNeitherPartsNorApproaches) {
    ballOnBall();
    const auto found = touches(placed(1, {0, 2, 0}, {3, 0, 0}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].round.isBall);
    ASSERT_EQ(found[0].corners.size(), 1u);
    EXPECT_NEAR(found[0].corners[0].rate, 0, 1e-15);
}

// The edge of a box goes up at one end and down at the other, under a ball at its middle.
TEST_F(Touching, ATurningEdgeUnderABallNeitherPartsNorApproaches) {
    SceneBuilder b(1);
    b.ball("ball", {0, 0, 0}, 0.5).fixed = true;
    b.box("box", {0, 2, 0}, {1, 1, 2});
    build(b);
    Placed box = placed(1, {0, -0.5 - std::sqrt(0.5), 0});
    // By 45 degrees: the middle of an edge along z is below the ball.
    box.state.attitude = geometry::Quaternion(Eigen::AngleAxisd(M_PI / 4, Vector::UnitZ()));
    box.state.angularVelocity = {3, 0, 0}; // one end of the edge up, the other down
    const auto found = touches(box);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].corners.size(), 1u);
    EXPECT_NEAR(found[0].corners[0].rate, 0, 1e-12);
}

// Two faces all but on each other: a vertex of the lower box just beside the upper box's face does
// not make that face the contact's, though it lies as far away as the edge of the upper box.
TEST_F(Touching, OfTwoFacesThatUnderWhichTheOtherLies) {
    SceneBuilder b(1);
    b.box("lower", {0, 0, 0}, {1, 1, 1}).fixed = true;
    b.box("upper", {0, 1, 0}, {1, 1, 1});
    build(b);
    constexpr double tilt = 3e-6, shift = 1e-5;
    for (const bool isUpperSupport : {false, true}) {
        Placed upper = placed(1, {0, 0, 0});
        upper.state.attitude = geometry::Quaternion(Eigen::AngleAxisd(tilt, Vector::UnitZ()));
        // Its lower left edge is lowest, on the lower box and a little to the right of its edge.
        const Vector corner = upper.state.attitude * Vector(-0.5, -0.5, 0);
        upper.state.position = Vector(-0.5 + shift, 0.5, 0.1) - corner;
        const Placed lower = placed(0, world->records[0].start.position);
        const auto found =
            isUpperSupport ? touchesOf(lower, upper, 1e-6) : touchesOf(upper, lower, 1e-6);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_LT(std::abs(found[0].normal.x()), 1e-12) << "the lower box's face, which is level";
    }
}

// A box on its edge, which juts out beyond the side of the box below: the edge is carried by its
// end above that box and by where it crosses its border. Its other end may land nowhere; of the
// faces beside the edge four vertices may.
TEST_F(Touching, AnEdgeThatJutsOutLandsNotWithItsEnd) {
    SceneBuilder b(1);
    b.box("below", {0, 0, 0}, {1, 1, 1}).fixed = true;
    b.box("box", {0, 3, 0}, {1, 1, 1});
    build(b);
    Placed box = placed(1, {0, 0.5 + std::sqrt(0.5), 0.3});
    box.state.attitude =
        geometry::Quaternion(Eigen::AngleAxisd(std::numbers::pi / 4, Vector::UnitZ()));
    const auto found = lastingContacts(box, placed(0, Vector::Zero()), {});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place.points.size(), 2u);
    std::vector<double> heights; // of the box's own vertices, above its middle
    for (const auto& landing : found[0].place.landings)
        if (landing.body == 1)
            heights.push_back((box.state.attitude * landing.piece.place).y());
    ASSERT_EQ(heights.size(), 4u);
    for (const double height : heights)
        EXPECT_NEAR(height, 0, 1e-12);
}

// A box that is tilted by less than the tolerance, whose lowest vertex lies beside the face below:
// where it touches, an edge of it goes over that face's border.
TEST_F(Touching, AVertexBesideAFaceTouchesItNot) {
    SceneBuilder b(1);
    b.box("below", {0, 0, 0}, {1, 1, 1}).fixed = true;
    b.box("box", {0, 3, 0}, {1, 1, 1});
    build(b);
    constexpr double tilt = 3e-7, beside = 0.16;
    Placed box = placed(1, {-0.1, 1 + tilt / 2, beside});
    box.state.attitude = geometry::Quaternion(Eigen::AngleAxisd(tilt, Vector::UnitX())) *
                         geometry::Quaternion(Eigen::AngleAxisd(-tilt / 10, Vector::UnitZ()));
    const auto found = touches(box);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_FALSE(found[0].corners.empty());
    for (const Corner& corner : found[0].corners) {
        EXPECT_LT(corner.point.z(), 0.5 + 1e-6);
        EXPECT_LE(corner.point.x(), 0.5 + 1e-6);
    }
}

// Axes that are next to parallel cross beyond the end of the shorter cylinder: its rim touches.
TEST_F(Touching, ARimCarriesWhereSidesWouldCrossBeyondTheirEnds) {
    SceneBuilder b(1);
    const auto cylinder = [&](const char* name, const Vector& place, double radius, double height) {
        scene::ShapeSet& set = b.scene.shapeSets.emplace_back();
        set.name = name;
        set.parts.emplace_back().shape = scene::CylinderShape{radius, height};
        scene::Body& body = b.scene.bodies.emplace_back();
        body.name = body.shape = name;
        body.initialPosition = place;
        return &body;
    };
    cylinder("below", {0, 0, 0}, 0.5, 1.2)->fixed = true;
    cylinder("wheel", {0, 3, 0}, 0.15, 0.1);
    build(b);
    constexpr double yaw = 1e-5, radii = 0.65;
    for (const double along : {-0.06, 0.03, 0.06}) { // where the sides cross, down
        const double tilt = along * yaw * yaw / radii;
        Placed wheel = placed(1, {radii, 0, 0});
        wheel.state.attitude = geometry::Quaternion(Eigen::AngleAxisd(-tilt, Vector::UnitZ())) *
                               geometry::Quaternion(Eigen::AngleAxisd(yaw, Vector::UnitX()));
        const auto found = touches(wheel);
        ASSERT_EQ(found.size(), 1u);
        ASSERT_EQ(found[0].corners.size(), 1u);
        ASSERT_TRUE(found[0].corners[0].pieces);
        using Kind = physics::SurfacePiece::Kind;
        const bool isWithin = std::abs(along) < 0.05;
        EXPECT_EQ(found[0].corners[0].pieces->body.kind, isWithin ? Kind::line : Kind::circle);
        EXPECT_NEAR(std::abs(found[0].corners[0].point.y()), isWithin ? 0.03 : 0.05, 1e-3);
        EXPECT_LT(found[0].corners[0].point.y() * along, 0);
    }
}

// A can over the edge of a box, and over the rim of a round table: it bears where the borders
// cross.
TEST_F(Touching, ARoundEndBeyondABorderBearsWhereTheBordersCross) {
    constexpr double radius = 0.04, over = 0.006; // its middle is that far within the edge
    for (const bool isRound : {false, true}) {
        SceneBuilder b(1);
        const auto add = [&](const char* name, const scene::CylinderShape& shape) {
            scene::ShapeSet& set = b.scene.shapeSets.emplace_back();
            set.name = name;
            set.parts.emplace_back().shape = shape;
            scene::Body& body = b.scene.bodies.emplace_back();
            body.name = body.shape = name;
            return &body;
        };
        if (isRound)
            add("table", scene::CylinderShape{0.5, 0.05})->fixed = true;
        else
            b.box("table", {0, 0, 0}, {1, 0.05, 1}).fixed = true;
        add("can", scene::CylinderShape{radius, 0.1})->initialPosition = {0, 3, 0};
        build(b);
        const Vector middle(0.5 - over, 0.075, 0);
        const auto found = touches(placed(1, middle));
        ASSERT_EQ(found.size(), 1u);
        int crossings = 0;
        for (const Corner& corner : found[0].corners) {
            const Vector off = corner.point - middle;
            EXPECT_LE(std::hypot(off.x(), off.z()), radius + 1e-12);
            if (!corner.pieces)
                continue;
            ++crossings;
            EXPECT_NEAR(std::hypot(off.x(), off.z()), radius, 1e-12);
            EXPECT_NEAR(isRound ? std::hypot(corner.point.x(), corner.point.z()) : corner.point.x(),
                        0.5, 1e-12);
        }
        EXPECT_EQ(crossings, 2);
    }
}

} // namespace
} // namespace simulation::testing
