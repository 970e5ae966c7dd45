#include "batch/statistics.h"

#include <nlohmann/json.hpp>

namespace batch {

std::string statisticsJson(const simulation::Statistics& s, double secondsReading) {
    using Json = nlohmann::ordered_json;
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
                       {"reached", s.reached},
                       {"error_estimate", orNull(s.errorEstimate)},
                       {"predictable_until", orNull(s.predictableUntil)},
                       {"component_list", components}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace batch
