// A renderer and a scene for it, for the tests.
#pragma once

#include "drawing/test_picture.h"
#include "framing/test_scenes.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

namespace render {

inline const scene::Color red{0.9, 0.1, 0.1}, blue{0.1, 0.2, 0.9}, green{0.1, 0.8, 0.2};

class RendererTest : public testing::Test {
protected:
    void SetUp() override {
        auto made = Renderer::create();
        ASSERT_TRUE(std::holds_alternative<std::unique_ptr<Renderer>>(made))
            << std::get<std::string>(made);
        renderer_ = std::move(std::get<0>(made));
        drawing_.scene = &scene_;
        // Bare bodies: what the tests count.
        drawing_.display.grid = drawing_.display.trails = false;
    }

    Picture draw(Size size = {320, 240}, std::size_t padding = 0) {
        Picture picture(size, padding);
        EXPECT_TRUE(renderer_->draw(drawing_, picture.image()));
        return picture;
    }

    std::unique_ptr<Renderer> renderer_;
    scene::Scene scene_;
    Drawing drawing_;
};

inline bool isRed(const Picture& p, int x, int y) { return p.red(x, y) > p.green(x, y) + 20; }
inline bool isBlue(const Picture& p, int x, int y) { return p.blue(x, y) > p.red(x, y) + 20; }

} // namespace render
