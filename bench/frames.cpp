// The cost of a picture: times of Renderer::draw for crowds of 9, 100 and 500 bodies on a floor.
//
// Prints for each crowd and each way of drawing the milliseconds of the median picture, and how
// many times those of the plainest one that is. Compare the ratios: they come from one run.
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <vector>

namespace {

scene::Part part(const decltype(scene::Part::shape)& shape) {
    return {shape, {0, 0, 0}, {0, 0, 0}, {}};
}

// Boxes and balls in layers, turned a little, over a floor.
scene::Scene crowd(int count) {
    scene::Scene scene;
    const auto addShape = [&](const char* name, const scene::Part& one) {
        scene.shapeSets.emplace_back().name = name;
        scene.shapeSets.back().parts = {one};
    };
    addShape("ball", part(scene::SphereShape{0.42}));
    addShape("box", part(scene::BoxShape{{0.7, 0.7, 0.7}}));
    addShape("floor", part(scene::BoxShape{{30, 0.2, 30}}));
    const int side = std::max(2, static_cast<int>(std::ceil(std::cbrt(count))));
    for (int i = 0; i < count; ++i) {
        scene::Body& body = scene.bodies.emplace_back();
        body.name = "b" + std::to_string(i);
        body.shape = i % 2 == 0 ? "ball" : "box";
        body.initialPosition = {i % side - 0.5 * side, 0.5 + i / (side * side),
                                i / side % side - 0.5 * side};
        body.initialAttitude = geometry::fromRotationVector({0.3 * i, 0.7 * i, 0.2 * i});
        body.appearance.color = {0.3 + 0.1 * (i % 6), 0.45 + 0.1 * (i % 4), 0.4 + 0.2 * (i % 3)};
    }
    scene::Body& floor = scene.bodies.emplace_back();
    floor.name = "floor";
    floor.shape = "floor";
    floor.initialPosition = {0, -0.6, 0};
    floor.fixed = true;
    return scene;
}

struct Way {
    const char* name;
    render::Display display;
};

std::vector<Way> ways() {
    render::Display page;
    page.samples = 1;
    std::vector<Way> all{{"page, no shadows, moving", page}};
#ifndef BEFORE
    all.back().display.shadows = false;
    all.push_back({"page, moving", page});
    page.studio = true;
    all.push_back({"studio, moving", page});
    page.studio = false;
#endif
    page.samples = 4;
    all.push_back({"page, at rest", page});
#ifndef BEFORE
    page.studio = page.triad = true;
    all.push_back({"studio, at rest", page});
#endif
    return all;
}

} // namespace

int main(int count, char** arguments) {
    const bool smoke = count > 1 && std::string_view(arguments[1]) == "--smoke";
    auto made = render::Renderer::create();
    if (const auto* fault = std::get_if<std::string>(&made)) {
        std::puts(fault->c_str());
        return 1;
    }
    render::Renderer& renderer = *std::get<0>(made);
    std::puts(renderer.description().c_str());
    const render::Size size{640, 480};
    std::vector<std::byte> pixels(4U * 640U * 480U);
    for (const int bodies : {9, 100, 500}) {
        const scene::Scene scene = crowd(bodies);
        render::Drawing drawing;
        drawing.scene = &scene;
        drawing.camera = render::framed(scene, nullptr, size);
        double least = 0;
        for (const Way& way : ways()) {
            drawing.display = way.display;
            std::vector<double> times;
            const int rounds = smoke ? 2 : 60;
            for (int i = 0; i < rounds; ++i) {
                drawing.camera.rotation =
                    drawing.camera.rotation * geometry::fromRotationVector({0, 0.01, 0});
                const std::clock_t began = std::clock();
                if (!renderer.draw(drawing, {pixels, 4U * 640U, size}))
                    return 1;
                times.push_back(1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
            }
            std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
            const double median = times[static_cast<std::size_t>(rounds / 2)];
            least = least == 0 ? median : least;
            std::printf("%4d bodies  %-26s %7.2f ms  %5.2f times\n", bodies, way.name, median,
                        median / least);
        }
    }
    return 0;
}
