// Pixels of a renderer, and more than one renderer.
#include "render/test_renderer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace render {
namespace {

TEST_F(RendererTest, AnEmptySceneIsTheBackground) {
    EXPECT_EQ(draw().drawn(), 0);
    drawing_.display.background = {0, 0, 0};
    const Picture black = draw();
    EXPECT_EQ(black.count([&](int x, int y) { return black.at(x, y) == 0; }), 320 * 240);
}

TEST_F(RendererTest, TheTopRowComesFirst) {
    addBody(scene_, sphere(0.2), {0, 0.6, 0}, red);
    addBody(scene_, sphere(0.2), {0.6, -0.6, 0}, blue);
    const Picture picture = draw();
    EXPECT_TRUE(isRed(picture, 160, 48));
    EXPECT_TRUE(isBlue(picture, 232, 192));
}

TEST_F(RendererTest, RowsKeepTheirStride) {
    addBody(scene_, sphere(0.5), {0.2, 0.1, 0}, red);
    const Picture tight = draw();
    for (std::size_t padding : {64U, 6U}) { // 6: no whole number of pixels
        const Picture wide = draw({320, 240}, padding);
        EXPECT_EQ(wide.count([&](int x, int y) { return wide.at(x, y) != tight.at(x, y); }), 0);
        for (int y = 0; y < 240; ++y)
            for (std::size_t i = 0; i < padding; ++i)
                ASSERT_EQ(wide.bytes[static_cast<std::size_t>(y) * wide.stride + 4 * 320 + i],
                          std::byte{0x5A});
    }
}

TEST_F(RendererTest, TheSameDrawingHasTheSamePixels) {
    addBody(scene_, sphere(0.5), {0.2, 0.1, 0}, red);
    addBody(scene_, box({1, 0.5, 0.2}), {-0.3, 0.1, 0.3}, blue).appearance.transparency = 0.4;
    drawing_.display.grid = drawing_.display.axes = true;
    const Picture first = draw();
    draw({100, 77}); // another size in between leaves nothing behind
    EXPECT_EQ(first.bytes, draw().bytes);
}

// However near one looks at what stands above the ground, and from whatever side.
TEST_F(RendererTest, TheGridIsDrawnInNoTimeAtAnyScale) {
    addBody(scene_, sphere(0.5), {0, 10, 0}, red);
    drawing_.display.grid = true;
    drawing_.camera.center = {0, 10, 0};
    const auto began = std::chrono::steady_clock::now();
    for (const bool studio : {true, false})
        for (const bool orthographic : {true, false})
            for (const double angle : {0.02, 0.15, 1.5})
                for (const double scale : {1e3, 1e6, 1e9, 1e14, 1e30}) {
                    drawing_.display.studio = studio;
                    drawing_.camera.orthographic = orthographic;
                    drawing_.camera.rotation = geometry::fromRotationVector(Vector(angle, 0.3, 0));
                    drawing_.camera.scale = scale;
                    draw();
                }
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::minutes(2)); // 1 s, alone
}

// A point far from the origin is as steady as one at it.
TEST_F(RendererTest, DistanceFromTheOriginChangesNothing) {
    addBody(scene_, box({0.8, 0.5, 0.3}), {0, 0, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.3, 0.4, 0.1));
    const Picture here = draw();
    const Vector far(1e7, -3e7, 2e7);
    scene_.bodies[0].initialPosition = far;
    drawing_.camera.center = far;
    const Picture there = draw();
    EXPECT_LT(
        there.count([&](int x, int y) { return std::abs(there.red(x, y) - here.red(x, y)) > 8; }),
        20);
}

TEST_F(RendererTest, MoreSamplesThanThereAreAreClamped) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red);
    drawing_.display.samples = 64;
    EXPECT_TRUE(isRed(draw(), 160, 120));
    EXPECT_GE(renderer_->maximumSamples(), 1);
    EXPECT_GE(renderer_->maximumSize(), 2048);
    EXPECT_FALSE(renderer_->description().empty());
}

TEST_F(RendererTest, ImagesThatDoNotHoldThePictureAreRefused) {
    Picture picture({32, 32});
    Image tooShort = picture.image();
    tooShort.pixels = tooShort.pixels.first(tooShort.pixels.size() - 1);
    EXPECT_FALSE(renderer_->draw(drawing_, tooShort));
    Image tooNarrow = picture.image();
    tooNarrow.stride = 100;
    EXPECT_FALSE(renderer_->draw(drawing_, tooNarrow));
    Image empty = picture.image();
    empty.size = {0, 32};
    EXPECT_FALSE(renderer_->draw(drawing_, empty));
}

// Several windows of one process have renderers of their own.
TEST_F(RendererTest, RenderersDoNotDisturbEachOther) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red);
    const Picture before = draw();
    auto second = Renderer::create();
    ASSERT_EQ(second.index(), 0U);
    Picture other({50, 50});
    EXPECT_TRUE(std::get<0>(second)->draw(drawing_, other.image()));
    EXPECT_EQ(before.bytes, draw().bytes);
    std::get<0>(second).reset();
    EXPECT_EQ(before.bytes, draw().bytes);
}

} // namespace
} // namespace render
