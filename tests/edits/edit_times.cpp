// How long does an edit take? CPU time of the least of many, and the counts behind it.
//
//     edit_times                 one of 1000 independent components, and Figure 4.6's scene
#include "resimulation/resimulation.h"
#include "run/cpu_seconds.h"
#include "script/reader.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace {

using scene::Scene;
using ScenePointer = std::shared_ptr<const Scene>;

// Balls far from each other, each with a weight and a drag.
Scene thousand(std::size_t count, bool integrated) {
    Scene scene;
    scene.simulator.finish = 5;
    scene::ShapeSet ball{"ball", {}, {}, {}};
    ball.parts.resize(1);
    ball.parts[0].shape = scene::SphereShape{0.5};
    scene.shapeSets = {ball};
    for (std::size_t i = 0; i < count; ++i) {
        scene::Body& body = scene.bodies.emplace_back();
        body.name = "ball" + std::to_string(i);
        body.shape = "ball";
        body.initialPosition = {100.0 * static_cast<double>(i % 32), 0,
                                100.0 * static_cast<double>(i / 32)};
        body.initialVelocity = {1, 2, 0};
        scene::Force& force = scene.forces.emplace_back();
        force.body = body.name;
        if (integrated)
            force.kind = scene::ComponentForce{
                {"0", "-9.81*" + body.name + ".mass - 0.1*" + body.name + ".dy", "0"}};
        else
            force.kind = scene::GravitationalForce{{0, -9.81, 0}};
    }
    return scene;
}

struct Times {
    double all = 1e9, scratch = 1e9;
    std::string work;
    std::size_t steps = 0, scratchSteps = 0;
};

// `edit` makes the n-th version.
template <typename Edit> Times measured(const Scene& first, const Edit& edit) {
    Times times;
    simulation::Resimulation kept;
    (void)kept.update(std::make_shared<const Scene>(first));
    for (int i = 0; i < 30; ++i) {
        Scene scene = first;
        edit(scene, i);
        const auto edited = std::make_shared<const Scene>(scene);
        const double begin = simulation::cpuSeconds();
        const auto result = kept.update(edited);
        times.all = std::min(times.all, simulation::cpuSeconds() - begin);
        times.work = kept.work().print();
        times.steps = result.statistics.steps;
        if (i < 3) {
            const double from = simulation::cpuSeconds();
            const auto scratch = simulation::simulate(scene);
            times.scratch = std::min(times.scratch, simulation::cpuSeconds() - from);
            times.scratchSteps = scratch.statistics.steps;
        }
    }
    return times;
}

void print(const std::string& name, const Times& t) {
    std::printf("%-36s edit %8.3f ms, %5zu steps; from scratch %9.3f ms, %6zu steps; %s\n",
                name.c_str(), 1e3 * t.all, t.steps, 1e3 * t.scratch, t.scratchSteps,
                t.work.c_str());
}

} // namespace

int main() {
    for (const bool integrated : {false, true}) {
        const Scene scene = thousand(1000, integrated);
        const std::string kind = integrated ? "integrated, " : "closed form, ";
        print("1000 bodies, " + kind + "velocity", measured(scene, [](Scene& s, int i) {
                  s.bodies[500].initialVelocity.x() = 1.1 + 0.01 * i;
              }));
        print("1000 bodies, " + kind + "colour", measured(scene, [](Scene& s, int i) {
                  s.bodies[500].appearance.color = scene::Color{0.01 * i, 0, 0};
              }));
        print("1000 bodies, " + kind + "add one", measured(scene, [](Scene& s, int i) {
                  s.bodies.push_back(s.bodies[3]);
                  s.bodies.back().name = "new" + std::to_string(i);
                  s.bodies.back().initialPosition.x() = -500;
              }));
        const Scene alone = thousand(1, integrated);
        print("1 body, " + kind + "velocity", measured(alone, [](Scene& s, int i) {
                  s.bodies[0].initialVelocity.x() = 1.1 + 0.01 * i;
              }));
    }
    script::Reader reader;
    std::stringstream text;
    text << std::ifstream(SOURCE_DIR "/samples/pend.al").rdbuf();
    const Scene pend = reader.read(text.str()).scene;
    print("pend.al, the ball's velocity", measured(pend, [](Scene& s, int i) {
              s.bodies[2].initialVelocity.x() = -3.01 + 0.001 * i;
          }));
    print("pend.al, a rod's mass",
          measured(pend, [](Scene& s, int i) { s.bodies[0].mass = 10.1 + 0.001 * i; }));
    print("pend.al, the ball's colour", measured(pend, [](Scene& s, int i) {
              s.bodies[2].appearance.color = scene::Color{0.01 * i, 0, 0};
          }));
}
