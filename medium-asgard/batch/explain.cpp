#include "batch/command.h"
#include "batch/explanation_text.h"
#include "batch/input.h"
#include "batch/output.h"
#include "batch/waiting.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <map>
#include <set>

namespace batch {
namespace {

bool write(const std::string& file, const std::string& text) {
    Output output(file);
    return output.good() && output.finish(output.write(text));
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
            return refuse({failure,
                           {},
                           {scene.file + ": error: there is no body \"" + options.phasesOf +
                            "\", nor a quantity of one"}});
    }
    const simulation::Result result = simulated(scene.reading.scene, options);
    if (!result.motion || !result.explanation)
        return refuse(refusalOf(scene, result.refusal));
    const bool stopped = tell(scene, *result.motion);
    const bool jsonOnly = arguments.json && *arguments.json == "-";
    const Detail detail = arguments.all ? Detail::all : Detail::usual;
    const std::string text =
        arguments.expressions
            ? phasesText(*result.explanation, options.phasesOf)
            : explanationText(*result.explanation, detail) +
                  accuracyText(*result.explanation, scene.reading.scene.simulator.accuracy,
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
