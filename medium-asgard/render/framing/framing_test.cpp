#include "framing/extent.h"
#include "framing/framing.h"
#include "framing/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

scene::Force fallingAlong(const std::string& body, const Vector& acceleration) {
    scene::Force force;
    force.body = body;
    force.kind = scene::GravitationalForce{acceleration};
    return force;
}

TEST(Up, IsAgainstWhatMostBodiesFallAlong) {
    scene::Scene scene;
    EXPECT_EQ(upOf(scene), Vector::UnitY());
    scene.forces = {fallingAlong("a", {0, 0, -9.81})};
    EXPECT_EQ(upOf(scene), Vector::UnitZ());
    scene::Force written;
    written.kind = scene::ComponentForce{{"0", "-10 * b1.mass", "0.0"}, scene::Frame::world};
    scene.forces = {written};
    EXPECT_EQ(upOf(scene), Vector::UnitY());
    // Friction that its author wrote with a mass is no fall.
    scene::Force friction;
    friction.kind = scene::ComponentForce{{"-0.3 * 1e1 * b1.mass * sign(b1.dx)", "0", "0"},
                                          scene::Frame::world};
    scene.forces = {friction, friction, written};
    EXPECT_EQ(upOf(scene), Vector::UnitY());
    // A couple is no fall, nor is a push without mass.
    written.couple = true;
    scene.forces = {written, fallingAlong("a", {-1, 0, 0})};
    EXPECT_EQ(upOf(scene), Vector::UnitX());
}

// Every point of the bodies' outlines over the motion.
void expectAllShown(const scene::Scene& scene, const simulation::MotionPointer& motion,
                    const Camera& camera, Size size) {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        for (double t = motion->start(); t <= motion->finish(); t += motion->finish() / 50)
            for (const Ball& ball : outlineOf(scene, scene.bodies[body])) {
                const Vector p = motion->shapePose(body, t).toWorld(ball.center);
                const Eigen::Vector2d pixels = toPixels(camera, size, p);
                EXPECT_GT(pixels.minCoeff(), 0);
                EXPECT_LT(pixels.x(), size.width);
                EXPECT_LT(pixels.y(), size.height);
            }
}

TEST(Framed, AFlatMotionIsSeenStraightOn) {
    scene::Scene scene;
    addBody(scene, box({1, 1, 1}), {0, 0, 0}, {});
    const auto motion =
        std::make_shared<GivenMotion>(3, std::vector<GivenMotion::Law>{[](double t) {
                                          return placed({4 * t, t * t, 7});
                                      }});
    const Camera camera = framed(scene, motion, {640, 480});
    EXPECT_TRUE(camera.rotation.isApprox(Quaternion::Identity(), 1e-9));
    expectAllShown(scene, motion, camera, {640, 480});
}

TEST(Framed, AMotionInSpaceIsSeenFromAboveWithUpwardsUp) {
    scene::Scene scene;
    addBody(scene, sphere(0.5), {0, 0, 0}, {});
    scene.forces = {fallingAlong("body0", {0, 0, -1})};
    const auto motion =
        std::make_shared<GivenMotion>(6, std::vector<GivenMotion::Law>{[](double t) {
                                          return placed({3 * std::cos(t), 3 * std::sin(t), t});
                                      }});
    for (Size size : {Size{640, 480}, Size{300, 900}, Size{1200, 200}}) {
        const Camera camera = framed(scene, motion, size);
        const Vector up = camera.rotation * Vector::UnitZ();
        EXPECT_NEAR(up.x(), 0, 1e-9);
        EXPECT_GT(up.y(), 0.9);
        EXPECT_GT(up.z(), 0.2); // its upper side is turned to the eye
        expectAllShown(scene, motion, camera, size);
    }
}

TEST(Framed, FillsMostOfThePicture) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 0, 0}, {});
    const auto motion =
        std::make_shared<GivenMotion>(1, std::vector<GivenMotion::Law>{[](double t) {
                                          return placed({20 * t, 0, 0});
                                      }});
    const Size size{640, 480};
    const Camera camera = framed(scene, motion, size);
    const double left = toPixels(camera, size, {-1, 0, 0}).x();
    const double right = toPixels(camera, size, {21, 0, 0}).x();
    EXPECT_NEAR(left, size.width - right, 2);
    EXPECT_GT(right - left, 0.8 * size.width);
}

// A floor of a kilometre does not make the balls on it invisible.
TEST(Framed, AWideFloorIsShownOnlyNearTheMotion) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 1, 0}, {});
    addBody(scene, box({1000, 1, 1000}), {0, -0.5, 0}, {}).fixed = true;
    const auto motion = std::make_shared<GivenMotion>(
        1, std::vector<GivenMotion::Law>{[](double t) {
                                             return placed({2 * t, 1 + t, t});
                                         },
                                         [](double) {
                                             return placed({0, -0.5, 0});
                                         }});
    const Extent extent = extentOf(scene, motion.get());
    EXPECT_FALSE(extent.moves[1]);
    EXPECT_LT(extent.size, 12);
    EXPECT_NEAR(extent.lowest, -1, 0.41);
}

TEST(Framed, AFlatterPictureShowsWhatATallOneShowed) {
    const std::vector<Ball> balls{{{0, 1.2, 0}, 0.1}, {{0, -0.5, 0}, 0.2}, {{9, 0, 0}, 0.1}};
    const Camera camera;
    const Size tall{600, 640}, flat{600, 300};
    ASSERT_TRUE(isWithin(camera, tall, balls[0]));
    ASSERT_FALSE(isWithin(camera, flat, balls[0]));
    const Camera kept = keeping(camera, tall, flat, balls);
    EXPECT_TRUE(isWithin(kept, flat, balls[0]));
    EXPECT_TRUE(isWithin(kept, flat, balls[1]));
    EXPECT_GT(kept.scale, 0.6);                            // not further away than that needs
    EXPECT_EQ(keeping(camera, tall, tall, balls), camera); // nor for what was not seen
    EXPECT_EQ(keeping(camera, flat, tall, balls), camera);
}

// The ball is half a metre wide and falls as far.
TEST(Framed, ATableOfTwoMetresIsShownWholeUnderASmallBall) {
    scene::Scene scene;
    addBody(scene, sphere(0.25), {-0.4, 0.86, 0.2}, {});
    addBody(scene, box({2, 0.1, 1}), {0, 0.25, 0.1}, {}).fixed = true;
    const auto motion = std::make_shared<GivenMotion>(
        1, std::vector<GivenMotion::Law>{[](double t) {
                                             return placed({-0.4, 0.86 - 0.31 * t, 0.2});
                                         },
                                         [](double) {
                                             return placed({0, 0.25, 0.1});
                                         }});
    for (const Size size : {Size{640, 480}, Size{480, 640}})
        expectAllShown(scene, motion, framed(scene, motion, size), size);
}

// A stand that is not much larger than what moves on it is no floor.
TEST(Framed, ABodyThatStandsBelowTheMotionIsShownWhole) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 1, 0}, {});
    addBody(scene, box({2, 8, 2}), {1, -4, 0}, {}).fixed = true;
    const auto motion = std::make_shared<GivenMotion>(
        1, std::vector<GivenMotion::Law>{[](double t) {
                                             return placed({3 * t, 1, 0});
                                         },
                                         [](double) {
                                             return placed({1, -4, 0});
                                         }});
    EXPECT_NEAR(extentOf(scene, motion.get()).box.min().y(), -8, 1e-9);
    expectAllShown(scene, motion, framed(scene, motion, {640, 480}), {640, 480});
}

// A motion works out once for a time what all bodies share, and forgets it: where contacts are
// many, it takes a hundred times as long to read body after body.
TEST(Framed, AMotionIsReadTimeAfterTime) {
    scene::Scene scene;
    double last = 0;
    int back = 0;
    std::vector<GivenMotion::Law> laws;
    for (int i = 0; i < 8; ++i) {
        addBody(scene, sphere(1), Vector(4 * i, 0, 0), {});
        laws.push_back([&, i](double t) {
            back += t < last ? 1 : 0;
            last = t;
            return placed({4.0 * i + t, 0, 0});
        });
    }
    const GivenMotion motion(10, laws);
    static_cast<void>(extentOf(scene, &motion));
    EXPECT_LT(back, 3); // times, not bodies
}

// Without anything that catches them, all bodies fall for as long as they are computed.
TEST(Framed, TheGroundStaysWhereBodiesStartThatFallOff) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 3, 0}, {});
    scene::Force weight;
    weight.body = scene.bodies[0].name;
    weight.kind = scene::GravitationalForce{{0, -10, 0}};
    scene.forces.push_back(weight);
    const auto falling = [](double finish) {
        return std::make_shared<GivenMotion>(finish, std::vector<GivenMotion::Law>{[](double t) {
                                                 return placed({0, 3 - 5 * t * t, 0});
                                             }});
    };
    EXPECT_NEAR(extentOf(scene, falling(10).get()).lowest, 2, 1e-9);
    EXPECT_NEAR(extentOf(scene, falling(1).get()).lowest, -3, 1e-9); // as far as one sees
}

// A ball falls 490 m beside a box that is fixed, which does not catch it: both are seen.
TEST(Framed, WhatDropsOutOfSightIsSeenBesideItsStart) {
    scene::Scene scene;
    addBody(scene, sphere(0.5), {0, 0.5, 0}, {});
    addBody(scene, box({1, 1, 1}), {2, 0.4, 0}, {}).fixed = true;
    scene.forces = {fallingAlong(scene.bodies[0].name, {0, -9.8, 0})};
    const auto stands = [](double) { return placed({2, 0.4, 0}); };
    const GivenMotion falls(10, {[](double t) {
                                     return placed({0, 0.5 - 4.9 * t * t, 0});
                                 },
                                 stands});
    const Extent extent = extentOf(scene, &falls);
    EXPECT_NEAR(extent.lowest, -0.1, 1e-9);
    EXPECT_TRUE(extent.moves[0]);
    EXPECT_LT(extent.size, 8);
    EXPECT_LT(extent.box.min().y(), -2); // its fall is seen
    EXPECT_FALSE(extent.planeNormal.has_value());
    EXPECT_GT(extentOfAll(scene, &falls).size, 480);
    // It comes up again: nothing drops out of sight.
    const GivenMotion swings(10, {[](double t) {
                                      return placed({0, 200 * std::cos(2 * t) - 200, 0});
                                  },
                                  stands});
    EXPECT_GT(extentOf(scene, &swings).size, 390);
    // It lies on something that moves.
    const GivenMotion lies(10, {[](double t) {
                                    return placed({0, std::max(0.5 - 4.9 * t * t, -200.0), 0});
                                },
                                stands});
    EXPECT_GT(extentOf(scene, &lies).size, 200);
    // A floor without an end is far below, and the motion ends before.
    scene::Part half;
    half.shape = scene::PlaneShape{};
    addBody(scene, half, {0, -900, 0}, {}).fixed = true;
    const GivenMotion isCaught(10, {[](double t) {
                                        return placed({0, 0.5 - 4.9 * t * t, 0});
                                    },
                                    stands,
                                    [](double) {
                                        return placed({0, -900, 0});
                                    }});
    EXPECT_GT(extentOf(scene, &isCaught).size, 480);
}

// A table in the plane x y, whose balls stand on it; a wall beside a ball is none.
// A wide table stands beside the fall, fixed or not: as much of the fall is seen.
TEST(Framed, AFallIsSeenTheSameBesideWhatStands) {
    scene::Scene scene;
    addBody(scene, sphere(0.5), {0, 0.5, 0}, {});
    addBody(scene, box({4, 1, 2}), {3, 0.4, 0}, {});
    scene.forces = {fallingAlong(scene.bodies[0].name, {0, -9.8, 0})};
    const GivenMotion falls(10, {[](double t) {
                                     return placed({0, 0.5 - 4.9 * t * t, 0});
                                 },
                                 [](double) {
                                     return placed({3, 0.4, 0});
                                 }});
    const double free = extentOf(scene, &falls).box.min().y();
    scene.bodies[1].fixed = true;
    EXPECT_LT(free, -4);
    EXPECT_EQ(extentOf(scene, &falls).box.min().y(), free);
}

TEST(Framed, WhereNothingFallsATableIsTheGround) {
    scene::Scene scene;
    addBody(scene, sphere(0.1), {0, 0, 0.11}, {});
    addBody(scene, box({2, 3, 0.1}), {0, 0, -0.05}, {}).fixed = true;
    EXPECT_EQ(extentOf(scene, nullptr).ground, Vector(0, 0, 1));
    scene.bodies[0].initialPosition.z() = 0.5;
    EXPECT_EQ(extentOf(scene, nullptr).ground, Vector(0, 1, 0));
    scene.bodies[0].initialPosition = {1.2, 0, 0.11};
    EXPECT_EQ(extentOf(scene, nullptr).ground, Vector(0, 1, 0));
}

TEST(Framed, TheGroundLiesWhereAFloorCatchesWhatFallsFar) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 3, 0}, {});
    addBody(scene, sphere(1), {0, -50, 0}, {});
    scene.bodies[1].fixed = true;
    scene::Force weight;
    weight.body = scene.bodies[0].name;
    weight.kind = scene::GravitationalForce{{0, -10, 0}};
    scene.forces.push_back(weight);
    const auto law = [](double t) { return placed({0, std::max(3 - 5 * t * t, -48.0), 0}); };
    const GivenMotion motion(10, {law, [](double) { return placed({0, -50, 0}); }});
    const Extent extent = extentOf(scene, &motion);
    EXPECT_LE(extent.lowest, -49);
    EXPECT_TRUE(extent.lowestStands);
}

TEST(Framed, WhatFliesOffDoesNotMakeTheRestTooSmallToSee) {
    scene::Scene scene;
    for (int i = 0; i < 3; ++i)
        addBody(scene, sphere(1), Vector(5 * i, 0, 0), {});
    const auto stays = [](double x) {
        return [x](double t) { return placed({x + std::sin(t), std::cos(t), 0}); };
    };
    const auto motion = std::make_shared<GivenMotion>(
        10, std::vector<GivenMotion::Law>{stays(0), stays(5), [](double t) {
                                              return placed({10 + 50 * t, 0, 0});
                                          }});
    const Extent extent = extentOf(scene, motion.get());
    EXPECT_LT(extent.size, 20);
    EXPECT_GE(extent.box.max().x(), 11); // where it starts is shown
    // A body alone is followed all the way.
    scene.bodies.erase(scene.bodies.begin(), scene.bodies.begin() + 2);
    const auto alone =
        std::make_shared<GivenMotion>(10, std::vector<GivenMotion::Law>{[](double t) {
                                          return placed({50 * t, 0, 0});
                                      }});
    EXPECT_NEAR(extentOf(scene, alone.get()).size, 502, 1);
}

TEST(Framed, ASceneWithoutMotionOrBodiesIsFramedToo) {
    scene::Scene scene;
    const Camera nothing = framed(scene, nullptr, {640, 480});
    EXPECT_GT(nothing.scale, 0);
    addBody(scene, box({2, 2, 2}), {50, 60, 70}, {});
    const Camera camera = framed(scene, nullptr, {640, 480});
    EXPECT_LT((camera.center - Vector(50, 60, 70)).norm(), 1);
}

// The silhouette of all balls just fills the picture, in either projection.
TEST(Framed, AnOrthographicPictureIsFilledToo) {
    scene::Scene scene;
    addBody(scene, box({4, 1, 2}), {7, 0, 0}, {});
    const Extent extent = extentOf(scene, nullptr);
    const Size size{640, 480};
    for (const bool orthographic : {false, true}) {
        const Camera camera =
            fitted(extent, facing({0.5, 0.4, 1}, Vector::UnitY()), size, orthographic);
        EXPECT_EQ(camera.orthographic, orthographic);
        Eigen::AlignedBox2d seen;
        for (const Ball& ball : extent.balls)
            seen.extend(toPixels(camera, size, ball.center));
        EXPECT_NEAR(seen.sizes().x(), 0.88 * 640, 1) << orthographic;
        EXPECT_NEAR(seen.center().x(), 320, 1);
        EXPECT_NEAR(seen.center().y(), 240, 1);
    }
}

TEST(Framed, NowIsWhatStandsThereNowFixedBodiesIncluded) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 0, 0}, {});
    addBody(scene, box({2, 2, 2}), {-20, 0, 0}, {}).fixed = true;
    scene::Part half;
    half.shape = scene::PlaneShape{};
    addBody(scene, half, {0, -1, 0}, {}).fixed = true;
    const auto stands = [](double x, double y) {
        return [x, y](double) { return placed({x, y, 0}); };
    };
    const auto motion = std::make_shared<GivenMotion>(
        10, std::vector<GivenMotion::Law>{[](double t) {
                                              return placed({t, 0, 0});
                                          },
                                          stands(-20, 0), stands(0, -1)});
    const Extent now = extentAt(scene, motion.get(), 5);
    EXPECT_NEAR(now.box.max().x(), 6, 1e-9);
    EXPECT_NEAR(now.box.min().x(), -21, 1e-9);
    const Extent ball = extentAt(scene, motion.get(), 5, {0});
    EXPECT_NEAR(ball.box.min().x(), 4, 1e-9);
    EXPECT_NEAR(ball.size, 2, 1e-9);
    // A half space alone has no size.
    EXPECT_NEAR(extentAt(scene, motion.get(), 5, {2}).size, 2, 1e-9);
    // All of the motion: the box that stands apart, too, which the picture at first leaves out.
    EXPECT_GT(extentOf(scene, motion.get()).box.min().x(), -10);
    EXPECT_NEAR(extentOfAll(scene, motion.get()).box.min().x(), -21, 1e-9);
    EXPECT_NEAR(extentOfAll(scene, motion.get()).box.max().x(), 11, 1e-9);
}

TEST(Framed, TheSunComesOverTheLeftShoulder) {
    for (const Vector& up : {Vector(0, 1, 0), Vector(0, 0, 1)}) {
        Extent extent;
        extent.up = up;
        const Vector inView = bestAttitude(extent) * sunOf(extent);
        EXPECT_LT(inView.x(), -0.2);
        EXPECT_GT(inView.y(), 0.4);
        EXPECT_GT(inView.z(), 0.4);
        EXPECT_NEAR(inView.norm(), 1, 1e-12);
    }
}

TEST(Framed, BodiesThatGetNowhereAtAllAreSkipped) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 0, 0}, {});
    addBody(scene, sphere(1), {0, 0, 0}, {});
    const auto motion = std::make_shared<GivenMotion>(
        1, std::vector<GivenMotion::Law>{
               [](double t) {
                   return placed({2 * t, t, 0});
               },
               [](double) { return placed(Vector::Constant(std::nan(""))); }});
    const Camera camera = framed(scene, motion, {640, 480});
    EXPECT_TRUE(camera.center.allFinite());
    EXPECT_TRUE(std::isfinite(camera.scale));
}

} // namespace
} // namespace render
