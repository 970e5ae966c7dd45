#include "batch/command.h"
#include "batch/explanation_text.h"
#include "batch/input.h"
#include "batch/output.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace batch {
namespace {

bool write(const std::string& file, const std::string& text) {
    Output output(file);
    return output.good() &&
           output.finish(std::fwrite(text.data(), 1, text.size(), output.stream()) == text.size());
}

// Each reason why a motion ended, once. True when there is one.
bool tellStops(const SceneText& scene, const simulation::Motion& motion) {
    std::set<std::string> said;
    for (std::size_t body = 0; body < motion.bodies(); ++body)
        if (const auto stop = motion.stop(body); stop && said.insert(stop->sentence).second)
            std::fprintf(stderr, "%s: error: %s\n", scene.file.c_str(), stop->sentence.c_str());
    return !said.empty();
}

// A body, or a body and one of its quantities: "rod1", "rod1.x".
bool isNamed(const scene::Scene& scene, const std::string& name) {
    const auto end = std::min(name.rfind('.'), name.size());
    return std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
        return body.name == name || body.name == name.substr(0, end);
    });
}

int explain(const SceneText& scene, const ExplainArguments& arguments,
            const std::map<std::string, double>& parameters) {
    simulation::Options options;
    options.explain = true;
    options.parameters = parameters;
    if (arguments.expressions) {
        options.phasesOf = *arguments.expressions;
        if (!isNamed(scene.reading.scene, options.phasesOf))
            return refuse({failure, scene.file + ": error: there is no body \"" + options.phasesOf +
                                        "\", nor a quantity of one\n"});
    }
    const simulation::Result result = simulation::simulate(scene.reading.scene, options);
    if (!result.motion || !result.explanation) {
        std::string all;
        for (const std::string& sentence : result.refusal)
            all += scene.file + ": error: " + sentence + "\n";
        return refuse({failure, all});
    }
    for (const std::string& note : result.motion->notes())
        std::fprintf(stderr, "%s: warning: %s\n", scene.file.c_str(), note.c_str());
    const bool stopped = tellStops(scene, *result.motion);
    const bool jsonOnly = arguments.json && *arguments.json == "-";
    const std::string text = arguments.expressions
                                 ? phasesText(*result.explanation, options.phasesOf)
                                 : explanationText(*result.explanation) +
                                       accuracyText(scene.reading.scene.simulator.accuracy,
                                                    result.motion->errorEstimate());
    if (!jsonOnly && !write("-", text))
        return failure;
    if (arguments.json && !write(*arguments.json, explanationJson(*result.explanation)))
        return failure;
    return stopped ? failure : success;
}

} // namespace

int explainCommand(script::Reader& reader, const ExplainArguments& arguments) {
    const auto opened = openScene(reader, arguments.scene, arguments.set);
    if (const auto* refusal = std::get_if<Refusal>(&opened))
        return refuse(*refusal);
    const auto& [scene, values] = std::get<OpenScene>(opened);
    return explain(scene, arguments, values);
}

} // namespace batch
