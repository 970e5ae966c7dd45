// The cost of a picture: times of Renderer::draw for crowds of 9, 100 and 500 bodies on a floor.
//
//     bench_frames [--size WIDTHxHEIGHT]
//
// Prints for each crowd and each way of drawing the milliseconds of the median picture, of the
// processor and by the clock (a graphics card leaves the processor idle), and how many times those
// of the plainest one that is by the clock. Compare the ratios: they come from one run.
#include "render/renderer.h"

#include <algorithm>
#include <chrono>
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

double median(std::vector<double>& times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
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
    render::Size size{640, 480};
    if (count > 2 && std::string_view(arguments[1]) == "--size" &&
        std::sscanf(arguments[2], "%dx%d", &size.width, &size.height) != 2) {
        std::puts("--size wants WIDTHxHEIGHT, for example 1920x1080");
        return 2;
    }
    const std::size_t stride = 4U * static_cast<std::size_t>(size.width);
    std::vector<std::byte> pixels(stride * static_cast<std::size_t>(size.height));
    for (const int bodies : {9, 100, 500}) {
        const scene::Scene scene = crowd(bodies);
        render::Drawing drawing;
        drawing.scene = &scene;
        drawing.camera = render::framed(scene, nullptr, size);
        double least = 0;
        for (const Way& way : ways()) {
            drawing.display = way.display;
            std::vector<double> processor;
            std::vector<double> clock;
            const int rounds = smoke ? 2 : 60;
            for (int i = 0; i < rounds; ++i) {
                drawing.camera.rotation =
                    drawing.camera.rotation * geometry::fromRotationVector({0, 0.01, 0});
                const std::clock_t began = std::clock();
                const auto start = std::chrono::steady_clock::now();
                if (!renderer.draw(drawing, {pixels, stride, size}))
                    return 1;
                const std::chrono::duration<double, std::milli> taken =
                    std::chrono::steady_clock::now() - start;
                processor.push_back(1e3 * static_cast<double>(std::clock() - began) /
                                    CLOCKS_PER_SEC);
                clock.push_back(taken.count());
            }
            const double byClock = median(clock);
            least = least == 0 ? byClock : least;
            std::printf("%4d bodies  %-26s %7.2f ms  processor %7.2f ms  %5.2f times\n", bodies,
                        way.name, byClock, median(processor), byClock / least);
        }
    }
    return 0;
}
