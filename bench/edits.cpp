// From text to motion, and from an edit to motion: what an author waits for. Rows as all programs'
// (measurement.h); seconds are processor time of this process, but for reading, which happens in
// another one and is timed by the clock on the wall.
//
//     bench_edits SCENE.al [--smoke] [--budget SECONDS]       Figure 4.6's scene
#include "equations.h"
#include "measurement.h"
#include "shared_scenes.h"

#include "resimulation/resimulation.h"
#include "script/reader.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

namespace {

using namespace bench;
using ScenePointer = std::shared_ptr<const scene::Scene>;

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

scene::Scene sceneOf(script::Reader& reader, const std::string& text) {
    script::ReadResult reading = reader.read(text);
    if (!reading.usable) {
        std::fprintf(stderr, "bench_edits: %s\n", reading.diagnostics.at(0).message.c_str());
        std::exit(1);
    }
    return std::move(reading.scene);
}

// Each run on a scene that was not seen before: the body stands a little elsewhere.
Time edits(const Measurement& m, const scene::Scene& scene, std::size_t body,
           std::string& workDone) {
    simulation::Resimulation simulation;
    (void)simulation.update(std::make_shared<const scene::Scene>(scene));
    int edit = 0;
    return m.timeOf([&] {
        auto edited = std::make_shared<scene::Scene>(scene);
        edited->bodies[body].initialPosition.x() += 1e-3 * ++edit;
        const double taken = seconds([&] { (void)simulation.update(ScenePointer(edited)); });
        workDone = std::to_string(simulation.work().solved.size()) + " bodies solved " +
                   std::to_string(simulation.work().kept) + " kept";
        return taken;
    });
}

void figure46(const Measurement& m, script::Reader& reader, const std::string& text) {
    const Time reading = m.timeOf([&] {
        const double begin = wallSeconds();
        (void)sceneOf(reader, text);
        return wallSeconds() - begin;
    });
    m.add({"Figure 4.6", "reading", 0, 0, reading, "wall"});
    const scene::Scene scene = sceneOf(reader, text);
    Time whole, first;
    whole = m.timeOf([&] { return seconds([&] { (void)simulation::simulate(scene); }); });
    first = m.timeOf([&] {
        double motion = 0;
        const double begin = cpuSeconds();
        simulation::Observer observer;
        observer.progress = [&](const simulation::MotionPointer&) {
            if (motion == 0)
                motion = cpuSeconds() - begin;
        };
        (void)simulation::simulate(scene, {}, observer);
        return motion;
    });
    m.add({"Figure 4.6", "first motion to see", 0, 0, first, ""});
    m.add({"Figure 4.6", "all motion", 0, 0, whole, ""});
    std::string done;
    const Time edit = edits(m, scene, 0, done);
    m.add({"Figure 4.6", "motion of an edit", 0, 0, edit, done});
}

// An edit to one of a thousand components, beside that component alone.
void thousand(const Measurement& m, script::Reader& reader) {
    const int count = m.smoke() ? 10 : 1000;
    const scene::Scene scene = sceneOf(reader, s3Scene(count, 1));
    scene::Scene one = scene;
    const auto middle = static_cast<std::size_t>(count / 2);
    one.bodies = {scene.bodies[middle]};
    one.forces = {scene.forces[middle]};
    std::string done;
    const Time all = edits(m, scene, middle, done);
    m.add({"1000 components", "motion of an edit to one", 0, 0, all, done});
    const Time alone = m.timeOf([&] { return seconds([&] { (void)simulation::simulate(one); }); });
    m.add({"1000 components", "that one alone", 0, 0, alone, ""});
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: bench_edits SCENE.al [--smoke] [--budget SECONDS]\n", stderr);
        return 2;
    }
    const Measurement m("edits", argc - 1, argv + 1);
    std::ostringstream text;
    text << std::ifstream(argv[1]).rdbuf();
    script::Reader reader;
    figure46(m, reader, text.str());
    thousand(m, reader);
    return 0;
}
