// What stands around bodies in a picture: ground, grid, shadows, sky.
#include "render/test_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace render {
namespace {

TEST_F(RendererTest, TheGroundLiesUnderTheScene) {
    addBody(scene_, sphere(0.3), {0, 0.5, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.5, 0, 0));
    const int bare = draw().drawn();
    drawing_.display.grid = true;
    const Picture ground = draw();
    EXPECT_GT(ground.drawn(), bare + 2000);
    EXPECT_EQ(ground.at(160, 4), 0xFFFFFFU); // nothing over it
    // Discreet: its lines are light.
    EXPECT_EQ(ground.count([&](int x, int y) {
        return !isRed(ground, x, y) && ground.blue(x, y) < 90 && y > 160;
    }),
              0);
}

// The grid is seen through a box that stands on it: its lines lie below the top face.
TEST_F(RendererTest, TheGridIsUnderALoneBoxAndNotOnIt) {
    addBody(scene_, box({1, 1, 1}), {0, 0.4, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.34, 0, 0));
    drawing_.camera.scale = 0.5;
    const Picture bare = draw();
    drawing_.display.grid = true;
    const Picture grid = draw();
    const Eigen::Vector2d top = toPixels(drawing_.camera, grid.size, {0, 0.9, 0});
    int onIt = 0;
    for (int x = -20; x <= 20; ++x)
        for (int y = -2; y <= 2; ++y) {
            const int px = static_cast<int>(top.x()) + x, py = static_cast<int>(top.y()) + y;
            onIt += grid.at(px, py) != bare.at(px, py) ? 1 : 0;
        }
    EXPECT_EQ(onIt, 0);
}

TEST_F(RendererTest, BodiesShadeWhatIsBehindThemFromTheSun) {
    addBody(scene_, box({3, 0.1, 3}), {0, -0.5, 0}, {0.8, 0.8, 0.8}).fixed = true;
    addBody(scene_, box({0.4, 0.4, 0.4}), {0, 0.2, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.9, 0, 0));
    drawing_.camera.scale = 0.6;
    drawing_.display.shadows = false;
    for (const int samples : {1, 4}) {
        drawing_.display.samples = samples;
        drawing_.display.shadows = false;
        const Picture bare = draw();
        drawing_.display.shadows = true;
        const Picture shaded = draw();
        const int dark =
            shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 20; });
        const int light =
            shaded.count([&](int x, int y) { return shaded.red(x, y) > bare.red(x, y) + 2; });
        EXPECT_GT(dark, 150) << samples;
        EXPECT_LT(dark, 2500) << samples;
        EXPECT_EQ(light, 0) << samples;
        // Nothing shades itself: the lit faces of the box are as they were.
        const Eigen::Vector2d top = toPixels(drawing_.camera, shaded.size, {0, 0.4, 0});
        const int x = static_cast<int>(top.x()), y = static_cast<int>(top.y());
        EXPECT_EQ(shaded.at(x, y), bare.at(x, y)) << samples;
    }
}

// A body far behind makes no shadow in front coarser.
TEST_F(RendererTest, AShadowCloseUpIsFineWhateverIsBehind) {
    addBody(scene_, box({3, 0.1, 3}), {0, -0.5, 0}, {0.8, 0.8, 0.8}).fixed = true;
    addBody(scene_, box({0.3, 0.3, 0.3}), {-0.1, -0.3, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.6, 0, 0));
    drawing_.camera.center = Vector(0, -0.4, 0);
    drawing_.camera.scale = 2;
    drawing_.display.samples = 4;
    const Picture alone = draw();
    addBody(scene_, sphere(20), {150, -40, -300}, red).fixed = true;
    const Picture together = draw();
    const int other = together.count([&](int x, int y) {
        return x < 200 && std::abs(together.green(x, y) - alone.green(x, y)) > 25;
    });
    EXPECT_LT(other, 120);
}

TEST_F(RendererTest, ABallShadesNoDotsOnItself) {
    addBody(scene_, sphere(0.8), {0, 0, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.34, -0.48, 0));
    drawing_.display.samples = 4;
    drawing_.display.shadows = false;
    const Picture bare = draw();
    drawing_.display.shadows = true;
    const Picture shaded = draw();
    EXPECT_EQ(shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 4; }), 0);
}

TEST_F(RendererTest, ShadowsFallOnTheGroundOfASceneWithoutAFloor) {
    addBody(scene_, sphere(0.3), {0, 0.3, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.7, 0, 0));
    drawing_.camera.scale = 0.7;
    drawing_.display.grid = true;
    drawing_.display.shadows = false;
    const Picture bare = draw();
    drawing_.display.shadows = true;
    const Picture shaded = draw();
    EXPECT_GT(shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 20; }),
              100);
}

// A board whose face is the ground: where it ends, shadows fall on the grid as without it.
TEST_F(RendererTest, ShadowsFallOnTheGridBesideAFloorThatEnds) {
    const auto shadedPixels = [&] {
        drawing_.display.shadows = false;
        const Picture bare = draw();
        drawing_.display.shadows = true;
        const Picture shaded = draw();
        return shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 20; });
    };
    addBody(scene_, box({0.8, 0.1, 0.8}), {-0.5, -0.05, 0}, blue).fixed = true;
    addBody(scene_, sphere(0.2), {-0.5, 0.2, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.7, 0, 0));
    drawing_.camera.scale = 0.5;
    drawing_.display.grid = true;
    const int onTheBoard = shadedPixels();
    addBody(scene_, sphere(0.2), {0.4, 0.3, 0}, red);
    EXPECT_GT(shadedPixels(), onTheBoard + 50);
}

TEST_F(RendererTest, AStudioHasASkyAndAHorizonLightOrDark) {
    addBody(scene_, sphere(0.1), {0, 0, 0}, red);
    drawing_.display.studio = true;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(-0.1, 0, 0));
    const Picture light = draw();
    EXPECT_GT(light.red(20, 20), 180);
    EXPECT_GT(light.blue(20, 5), light.red(20, 5) + 8); // the sky is bluer than the ground
    EXPECT_LT(light.blue(20, 235), light.red(20, 235) + 8);
    drawing_.display.background = {0.1, 0.1, 0.1};
    const Picture dark = draw();
    EXPECT_LT(dark.green(20, 20), 90);
    EXPECT_LT(dark.green(20, 235), 60);
    EXPECT_EQ(draw().bytes, dark.bytes);
}

// The body that one looks at closely stands high above it.
TEST_F(RendererTest, TheGroundIsSeenFarBelow) {
    addBody(scene_, sphere(0.05), {0, 10, 0}, red);
    addBody(scene_, sphere(0.05), {0, 0.05, 0}, red);
    drawing_.display.studio = true;
    drawing_.camera.center = Vector(0, 10, 0);
    for (const double scale : {0.5, 10.0})
        for (const double slope : {0.15, 0.35, 1.2}) {
            drawing_.camera.scale = scale;
            drawing_.camera.rotation = geometry::fromRotationVector(Vector(slope, 0.2, 0));
            drawing_.display.grid = false;
            const Picture bare = draw();
            drawing_.display.grid = true;
            const Picture grid = draw();
            EXPECT_GT(grid.count([&](int x, int y) { return grid.at(x, y) != bare.at(x, y); }), 800)
                << scale << " " << slope;
        }
}

// Its own colour stays.
TEST_F(RendererTest, AnEndlessFloorIsDarkInADarkPicture) {
    scene::Part half;
    half.shape = scene::PlaneShape{};
    addBody(scene_, half, {0, 0, 0}, red).fixed = true;
    scene_.bodies.back().appearance.color.reset();
    addBody(scene_, sphere(0.2), {0, 0.2, 0}, blue);
    drawing_.display.studio = true;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.4, 0, 0));
    EXPECT_GT(draw().green(30, 200), 140);
    drawing_.display.background = {0.1, 0.1, 0.1};
    EXPECT_LT(draw().green(30, 200), 90);
    EXPECT_GT(draw().green(30, 200), 30);
    scene_.bodies.front().appearance.color = scene::Color{0.8, 0.8, 0.8};
    EXPECT_GT(draw().green(30, 200), 140);
}

class GridOnAFloor : public RendererTest {
protected:
    // A floor, which a ball stands on; the pixels from `top` down that the grid changes by more
    // than `least` are to be more than `most`, on light paper and dark.
    void expectSeen(std::vector<double> papers, std::vector<double> shades, int top, int least,
                    int most) {
        scene_.bodies.front().fixed = true;
        addBody(scene_, sphere(0.2), {0, 0.2, 0}, blue);
        drawing_.display.studio = true;
        drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.6, 0, 0));
        for (const double paper : papers)
            for (const double shade : shades) {
                drawing_.display.background = {paper, paper, paper};
                scene_.bodies.front().appearance.color = scene::Color{shade, shade, shade};
                drawing_.display.grid = false;
                const Picture bare = draw({640, 480});
                drawing_.display.grid = true;
                const Picture grid = draw({640, 480});
                EXPECT_GT(grid.count([&](int x, int y) {
                    return y >= top && std::abs(grid.green(x, y) - bare.green(x, y)) > least;
                }),
                          most)
                    << shade << " on " << paper;
            }
    }
};

TEST_F(GridOnAFloor, IsSeenInAnyColour) {
    scene::Part half;
    half.shape = scene::PlaneShape{};
    addBody(scene_, half, {0, 0, 0}, red);
    expectSeen({1.0, 0.1}, {0.1, 0.35, 0.5, 0.65, 0.95}, 0, 25, 3000);
}

TEST_F(GridOnAFloor, IsSeenBesideOneThatEnds) {
    addBody(scene_, box({0.8, 0.1, 0.8}), {0, -0.05, 0}, {});
    drawing_.camera.scale = 0.3;
    expectSeen({0.95, 0.1}, {0.1, 0.5, 0.95}, 401, 20, 300);
}

TEST_F(RendererTest, AnEndlessFloorReachesTheHorizon) {
    scene::Part half;
    half.shape = scene::PlaneShape{};
    addBody(scene_, sphere(0.2), {0, 0.2, 0}, blue);
    addBody(scene_, half, {0, 0, 0}, red).fixed = true;
    drawing_.display.studio = true;
    for (const double slope : {0.1, 0.18}) {
        drawing_.camera.rotation = geometry::fromRotationVector(Vector(slope, 0, 0));
        const Size size{320, 240};
        const Picture picture = draw(size);
        const int horizon =
            static_cast<int>(toPixels(drawing_.camera, size, Vector(0, 0, -1e7)).y());
        ASSERT_GT(horizon, 0);
        for (const int x : {3, 100, 316})
            for (const int below : {5, 20})
                EXPECT_TRUE(isRed(picture, x, horizon + below)) << slope << " " << x;
        EXPECT_FALSE(isRed(picture, 3, horizon - 5));
    }
}

// A table stands on the ground, or over it; a slab that the ground would cut is a floor.
TEST_F(RendererTest, AFixedTableTakesTheGridNowhere) {
    drawing_.display.grid = true;
    const auto groundWith = [&](const scene::Part& part, const Vector& place, bool isFixed) {
        scene_ = {};
        addBody(scene_, part, place, blue).fixed = isFixed;
        static_cast<void>(draw());
        return renderer_->surroundings().ground.value();
    };
    const scene::Part table = box({2, 0.1, 1});
    for (const bool isFixed : {false, true}) {
        const GroundPlane under = groundWith(table, {0, 0.5, 0}, isFixed);
        EXPECT_NEAR(under.height, 0, 1e-9) << isFixed;
        const GroundPlane wall = groundWith(box({0.1, 2, 1}), {0, 1, 0}, isFixed);
        EXPECT_EQ(wall.up, Vector(0, 1, 0)) << isFixed;
    }
    EXPECT_NEAR(groundWith(table, {0, -0.05, 0}, true).height, 0, 1e-6);
    EXPECT_NEAR(groundWith(table, {0, -2, 0}, true).height, -1.95, 1e-6);
    scene::Part half;
    half.shape = scene::PlaneShape{};
    EXPECT_NEAR(groundWith(half, {0, 0.3, 0}, true).height, 0.3, 1e-6);
}

// Another motion may have another best side and another lowest point: while one edits, neither the
// shadows nor the grid follow it. Framed anew, the grid stays where it still lies below all.
TEST_F(RendererTest, TheGroundAndTheSunThatAreKeptStay) {
    drawing_.display.grid = true;
    using Keeps = Renderer::Keeps;
    std::optional<Renderer::Surroundings> last;
    const auto drawsAll = [&](Keeps keeps) {
        std::vector<std::byte> pixels(std::size_t{4} * 320 * 240);
        EXPECT_TRUE(
            renderer_->draw(drawing_, {pixels, std::size_t{4} * 320, {320, 240}}, &last, keeps));
        return *last;
    };
    const auto draws = [&](double height, Keeps keeps) {
        scene_ = {};
        addBody(scene_, sphere(0.5), {0, height, 0}, blue);
        return drawsAll(keeps);
    };
    Renderer::Surroundings before = draws(3, Keeps::nothing);
    ASSERT_GT(before.ground->height, 1); // near the one body
    before.sun = Vector(-before.sun.x(), before.sun.y(), before.sun.z());
    last = before;
    EXPECT_EQ(draws(0.5, Keeps::all).ground->height, before.ground->height);
    EXPECT_EQ(draws(0.5, Keeps::all).sun, before.sun);
    drawing_.display.grid = false;
    EXPECT_EQ(draws(0.5, Keeps::all).ground->height, before.ground->height); // for later
    drawing_.display.grid = true;
    EXPECT_EQ(draws(3.5, Keeps::whereItFits).ground->height, before.ground->height);
    EXPECT_EQ(draws(0.5, Keeps::whereItFits).ground->height, 0);
    EXPECT_EQ(draws(3, Keeps::nothing).ground->height, before.ground->height);
    EXPECT_NE(last->sun, before.sun);
    last = before;
    addBody(scene_, sphere(0.5), {3, 0, 0}, blue);
    scene::Force weight;
    weight.kind = scene::GravitationalForce{{0, 0, -9.81}};
    scene_.forces = {weight};
    EXPECT_NE(drawsAll(Keeps::all).sun, before.sun); // z is up now
}

// The grid stands still in the world: the same lines are seen wherever the view's middle is.
TEST_F(RendererTest, TheGridStaysWhereItIsWhenTheViewMoves) {
    addBody(scene_, sphere(0.05), {0, 0, 0}, red);
    drawing_.display.grid = drawing_.display.studio = true;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(M_PI / 2, 0, 0)); // from above
    drawing_.camera.orthographic = true;
    const Picture before = draw();
    drawing_.camera.position = {0.5, 0, 0}; // 60 pixels
    const Picture after = draw();
    int same = 0, lines = 0;
    for (int x = 80; x < 240; ++x) {
        const bool line = before.red(x, 30) < before.red(x + 1, 30) - 4;
        lines += line ? 1 : 0;
        same += line && after.red(x + 60, 30) < after.red(x + 61, 30) - 4 ? 1 : 0;
    }
    EXPECT_GT(lines, 3);
    EXPECT_GE(same, lines - 1);
}

} // namespace
} // namespace render
