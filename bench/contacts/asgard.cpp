// Our engine on the cases of contact and joints, from the text that a teacher writes.
//
//     bench_asgard_contacts --text CASE        prints that text
#include "driver.h"
#include "play.h"
#include "scene_text.h"

#include <cstdio>
#include <cstring>

namespace {

using namespace bench;
using namespace bench::contacts;

constexpr double longest = 20; // seconds of one run

int print(const char* name) {
    for (const Case& scene : allCases(false))
        if (scene.name == name) {
            std::fputs(sceneText(scene).c_str(), stdout);
            return 0;
        }
    std::fprintf(stderr, "There is no case \"%s\".\n", name);
    return 2;
}

void play(Driver& driver, const Case& scene) {
    const std::size_t first = scene.planes.size(); // they are the first bodies of the text
    const auto errorOf = [&](const simulation::Motion& motion) {
        std::vector<std::vector<Place>> places;
        for (const double time : scene.times) {
            std::vector<Place>& now = places.emplace_back();
            for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
                const auto p = motion.at(first + b, time).position;
                now.push_back({p.x(), p.y(), p.z()});
            }
        }
        return worstDistance(scene, places);
    };
    const std::vector<double> accuracies =
        scene.bodies.size() < 20 ? std::vector<double>{1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10}
                                 : std::vector<double>{1e-3, 1e-6};
    driver.run(scene.name, driver.read(sceneText(scene)), accuracies, errorOf, longest);
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::strcmp(argv[1], "--text") == 0)
        return print(argv[2]);
    const Measurement m("asgard", argc, argv);
    Driver driver(m);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    for (const Case& scene : allCases(m.smoke()))
        if (m.wants(scene.name))
            play(driver, scene);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
