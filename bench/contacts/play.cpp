#include "play.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>

namespace bench::contacts {
namespace {

// Seconds of one run.
double longest(const Case& scene) { return scene.bodies.size() < 100 ? 1 : 5; }

struct Run {
    double taken = 0, reached = 0;
    long steps = 0;
    bool whole = true;
    std::vector<std::vector<Place>> places;
};

// Stepping is watched every hundredth of the span.
Run play(const Case& scene, World& world) {
    constexpr int pieces = piecesOfRun;
    Run run;
    const double end = scene.times.back();
    std::size_t next = 0;
    for (int i = 1; i <= pieces && run.whole; ++i) {
        run.taken += seconds([&] { world.advance(end / pieces); });
        run.reached = end * i / pieces;
        if (next < scene.times.size() && run.reached >= scene.times[next] - 1e-9) {
            std::vector<Place> places;
            for (std::size_t b = 0; b < scene.bodies.size(); ++b)
                places.push_back(world.centre(b));
            run.places.push_back(std::move(places));
            ++next;
        }
        run.whole = i == pieces || run.taken < longest(scene);
    }
    run.steps = world.steps();
    return run;
}

// Whether finer parameters are worth a run.
bool playOne(const Measurement& m, const Case& scene, const Way& way, double parameter) {
    Run run;
    bool can = true;
    std::string note;
    try {
        const Time time = m.timeOf([&] {
            const std::unique_ptr<World> world = way.build(scene, parameter);
            can = world != nullptr;
            if (can)
                run = play(scene, *world);
            return run.taken;
        });
        if (!can)
            return false;
        note = std::to_string(run.steps) + " steps";
        if (!run.whole)
            note += "; cut off at " + std::to_string(run.reached) + " s";
        m.add({scene.name, way.setting, parameter, worstDistance(scene, run.places), time, note});
    } catch (const std::exception&) {
        m.add({scene.name,
               way.setting,
               parameter,
               std::numeric_limits<double>::quiet_NaN(),
               {},
               "stopped with an error"});
        return true;
    }
    return run.whole && run.taken < longest(scene) / 5;
}

} // namespace

double springCouple(const Joint& hinge, double angle) {
    return -hinge.stiffness * std::remainder(angle - hinge.rest, 2 * std::numbers::pi);
}

long stepsIn(double span, double step) {
    return std::max(1L, std::lround(std::ceil(span / step * (1 - 1e-9))));
}

void playAll(const Measurement& m, const std::vector<Way>& ways) {
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    for (const Case& scene : allCases(m.smoke())) {
        if (!m.wants(scene.name))
            continue;
        for (const Way& way : ways)
            if (std::ranges::none_of(way.lacks, [&](Feature f) { return scene.needs(f); }))
                for (const double parameter : m.sweep(way.parameters))
                    if (!playOne(m, scene, way, parameter))
                        break;
    }
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
}

} // namespace bench::contacts
