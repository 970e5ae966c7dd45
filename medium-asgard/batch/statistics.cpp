#include "batch/statistics.h"

#include "motion/known_span.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace batch {

using Json = nlohmann::ordered_json;

namespace {

Json stopsOf(const scene::Scene& scene, const simulation::Motion& motion) {
    Json stops = Json::array();
    for (std::size_t b = 0; b < motion.bodies(); ++b)
        if (const auto stop = motion.stop(b))
            stops.push_back({{"body", scene.bodies[b].name},
                             {"time", stop->time},
                             {"sentence", stop->sentence}});
    return stops;
}

// Where all stopped as soon as they started, nothing was estimated.
bool isAnyMotion(const scene::Scene& scene, const simulation::Motion& motion) {
    bool isAny = false, isStopped = false;
    for (std::size_t b = 0; b < motion.bodies(); ++b) {
        const auto stop = motion.stop(b);
        isStopped = isStopped || stop;
        isAny = isAny || (!scene.bodies[b].fixed && !(stop && stop->time <= motion.start()));
    }
    return isAny || !isStopped;
}

} // namespace

std::string statisticsJson(const scene::Scene& scene, const simulation::Motion& motion,
                           const simulation::Statistics& s, double secondsReading) {
    const auto orNull = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    Json components = Json::array();
    for (const simulation::ComponentStatistics& c : s.componentList)
        components.push_back({{"unknowns", c.unknowns},
                              {"model", c.model},
                              {"method", c.method},
                              {"steps", c.steps},
                              {"evaluations", c.evaluations}});
    const auto estimate = isAnyMotion(scene, motion) ? s.errorEstimate : std::nullopt;
    const Json json = {{"seconds", s.seconds},
                       {"seconds_reading", secondsReading},
                       {"steps", s.steps},
                       {"rejected_steps", s.rejectedSteps},
                       {"discarded_steps", s.discardedSteps},
                       {"evaluations", s.evaluations},
                       {"equation_evaluations", s.equationEvaluations},
                       {"factorisations", s.factorisations},
                       {"pair_tests", s.pairTests},
                       {"collisions", s.collisions},
                       {"components", s.components},
                       {"largest_component", s.largestComponent},
                       {"history_bytes", s.historyBytes},
                       {"reached", simulation::knownSpan(motion).computed},
                       {"error_estimate", orNull(estimate)},
                       {"predictable_until", orNull(s.predictableUntil)},
                       {"stops", stopsOf(scene, motion)},
                       {"component_list", components}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace batch
